"""What a run leaves in its folder, and how its fields are called on axes."""
import csv
import json

import h5py


def read_snapshot(path):
    """Time, position, the fields by name, and their SI units."""
    with h5py.File(path) as file:
        group = file["mote"]
        fields = {name: values[...].ravel() for name, values in group["state"].items()}
        units = {name: values.attrs["unit"].decode().rstrip("\0")
                 for name, values in group["state"].items()}
        return float(group.attrs["time"]), fields, units


def read_columns(path):
    """A CSV file as columns by name; none if there is no such file."""
    if not path.exists():
        return {}
    with path.open() as file:
        rows = list(csv.DictReader(file))
    return {name: [float(row[name]) for row in rows] for name in rows[0]} if rows else {}


def read_summary(folder):
    """The certificate; what can be said without one for a run that has not ended."""
    path = folder / "summary.json"
    return json.loads(path.read_text()) if path.exists() else {"name": folder.name}


def label(name, unit, summary):
    """The name with its unit; with `units: none` the numbers are in units of the user's own."""
    return f"{name} [{unit if summary.get('units') == 'SI' else 'own units'}]"
