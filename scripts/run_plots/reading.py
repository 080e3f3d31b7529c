"""What a run leaves in its folder, and how its fields are called on axes."""
import csv
import json

import h5py
import numpy as np


def read_time(path):
    with h5py.File(path) as file:
        return float(file["mote"].attrs["time"])


def read_dimension(path):
    with h5py.File(path) as file:
        return int(file["mote"].attrs["dimension"])


def read_text(attributes, name):
    return attributes[name].decode().rstrip("\0")


def read_snapshot(path):
    """Time, position, the fields by name, and their SI units, of a run on a line."""
    with h5py.File(path) as file:
        group = file["mote"]
        fields = {name: values[...].ravel() for name, values in group["state"].items()}
        units = {name: read_text(values.attrs, "unit") for name, values in group["state"].items()}
        return float(group.attrs["time"]), fields, units


class FlowSnapshot:
    """The particles of a run in space: places, some fields, and which of them are fluid;
    corners of the bodies that have no particles."""

    def __init__(self, path, names):
        with h5py.File(path) as file:
            group = file["mote"]
            state = group["state"]
            self.spacing = float(group.attrs["spacing"])
            self.position = state["position"][...]
            kinds = read_text(group.attrs, "body_kinds").splitlines()
            fluid = np.array([kind == "fluid" for kind in kinds])
            self.fluid = fluid[state["body"][...].astype(int)]
            outlines = group.get("outlines", {})
            self.outlines = [outlines[number][...] for number in outlines]
            self.fields = {name: state[name][...] for name in names if name in state}
            self.units = {name: read_text(state[name].attrs, "unit") for name in self.fields}


def read_columns(path):
    """A CSV file as columns by name; none if there is no such file."""
    if not path.exists():
        return {}
    with path.open() as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]} if rows else {}


def read_exact_places(folder, summary):
    """Where some of the particles should be at the end, a row each; none of a run that broke off,
    or without such a solution."""
    columns = {} if "failure" in summary else read_columns(folder / "exact.csv")
    axes = [columns[name] for name in ("position_x", "position_y", "position_z") if name in columns]
    return np.transpose(axes) if axes else None


def read_summary(folder):
    """The certificate; what can be said without one for a run that has not ended."""
    path = folder / "summary.json"
    return json.loads(path.read_text()) if path.exists() else {"name": folder.name}


def label(name, unit, summary):
    """The name with its unit; with `units: none` the numbers are in units of the user's own. Pure
    numbers have the unit 1."""
    if unit == "1":
        return f"{name} [–]"
    return f"{name} [{unit if summary.get('units') == 'SI' else 'own units'}]"
