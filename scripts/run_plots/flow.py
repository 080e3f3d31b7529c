"""The particles of a run in two or three dimensions, and its history."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap

from run_plots.raster import Raster
from run_plots.reading import FlowSnapshot, label, read_columns

COLOURS = {"speed": "viridis", "pressure": "coolwarm", "vorticity": "RdBu_r"}
NOT_OBSERVED = ("time", "step", "kinetic_energy", "potential_energy", "compression_energy",
                "viscous_power", "highest_speed", "removed",
                "volume_error", "divergence", "iterations", "residual", "solver_share",
                "angular_momentum", "vortices", "impulse_x", "impulse_y",
                "angular_impulse", "sheet_circulation", "collisions")  # nor what is conserved
# Units of readings that are what their names say.
OWN_UNITS = {"hamiltonian": "m⁴/s²", "second_moment": "m²", "separation": "m", "angle": "rad",
             "rotation_rate": "1/s", "magnitude": "m³/s", "virial_ratio": "1", "slip": "m/s",
             "crossings": "1", "courant_number": "1", "share_inside": "1"}
ERROR = "relative error"
OUTLIERS = 0.2  # per cent of the particles at each end whose colour may be that of the limit
STRAGGLERS = 2  # per cent of bodies beyond each end of an axis that are not shown
SLANT = 0.35  # how far one metre away goes up and to the right in the view of three dimensions
SLIMMEST = 1 / 20  # height over width of a panel, or width over height
EXACT = {"s": 22, "facecolors": "none", "edgecolors": "black", "linewidths": 0.8}
WIDTH = 7.0  # inches


def colour_limits(name, values):
    """Speeds from 0, vorticity to both sides of it; a few outliers do not take the colours from all
    others."""
    values = values[np.isfinite(values)]
    low, high = np.percentile(values, (OUTLIERS, 100 - OUTLIERS)) if len(values) else (0, 1)
    low = 0 if name == "speed" else low
    if name == "vorticity":
        high = max(abs(low), abs(high))
        low = -high
    return (low, high) if high > low else (low - 0.5, low + 0.5)


def fields_of(snapshot):
    """Values and units of what is drawn."""
    velocity = snapshot.fields["velocity"]
    with np.errstate(over="ignore"):  # the snapshot before a failure may hold any numbers
        speed = np.hypot.reduce(velocity, axis=1)
    fields = {"speed": (speed, snapshot.units["velocity"])}
    if "pressure" in snapshot.fields:
        fields["pressure"] = (snapshot.fields["pressure"], snapshot.units["pressure"])
    if snapshot.fields.get("vorticity", np.empty((0, 0))).ndim == 1:  # a number in a plane
        fields["vorticity"] = (snapshot.fields["vorticity"], snapshot.units["vorticity"])
    return fields


def window(snapshot, places):
    """Corners around the places; bodies in unbounded space may leave it, one by one."""
    outside = STRAGGLERS if "potential" in snapshot.fields else 0
    return np.percentile(places, (outside, 100 - outside), axis=0)


def widened(lower, upper, slimmest):
    """Corners no closer along one axis than this share of the other's length, nor than rounding."""
    least = max(slimmest * (upper - lower).max(), 1e-12 * np.abs([lower, upper]).max())
    lacking = np.maximum(0, least - (upper - lower)) / 2
    return lower - lacking, upper + lacking


class Panel:
    """Particles in a plane: which of them, where, and how far away each is; and where some of them
    should be, if that is known."""

    def __init__(self, snapshot, chosen, places, axes_names, depth=None, exact=None):
        self.chosen, self.places, self.depth = chosen, places[chosen], depth
        self.axes_names, self.radius, self.exact = axes_names, snapshot.spacing / 2, exact
        self.fluid = snapshot.fluid[chosen]
        self.outlines = snapshot.outlines
        lower, upper = window(snapshot, self.places)
        # A few vortices may stand in a line.
        slimmest = 1 / 2 if "vorticity" in snapshot.fields else SLIMMEST
        self.raster = Raster(*widened(lower - self.radius, upper + self.radius, slimmest))
        if snapshot.spacing < 16 * self.raster.pixel:  # gaps of single pixels would make patterns
            self.radius = snapshot.spacing / 2 ** 0.5

    def draw(self, axes, name, values, unit, summary):
        """Fluid in the colours of the values, walls in grey."""
        limits, own = colour_limits(name, values[self.chosen][self.fluid]), values[self.chosen]
        self.show(axes, ~self.fluid, np.zeros(len(own)), ListedColormap(["0.6"]), (0, 1))
        drawn = self.show(axes, self.fluid, own, COLOURS[name], limits)
        for corners in self.outlines:
            axes.fill(*corners.T, color="0.6", linewidth=0)
        if self.exact is not None:
            self.show_exact(axes)
        bar = axes.figure.colorbar(drawn, cax=axes.inset_axes((1.02, 0, 0.025, 1)),
                                   extend="max" if name == "speed" else "both", extendfrac=0.03)
        bar.set_label(label(name, unit, summary))
        axes.set_xlabel(label(self.axes_names[0], "m", summary))
        axes.set_ylabel(label(self.axes_names[1], "m", summary))

    def show_exact(self, axes):
        limits = axes.get_xlim(), axes.get_ylim()
        axes.scatter(*self.exact.T, label="exact places", **EXACT)
        axes.set(xlim=limits[0], ylim=limits[1])
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), fontsize=8, frameon=False)

    def show(self, axes, which, values, colours, limits):
        image = self.raster.discs(self.places[which], values[which], self.radius,
                                  None if self.depth is None else self.depth[self.chosen][which])
        return axes.imshow(image, origin="lower", extent=self.raster.extent, cmap=colours,
                           vmin=limits[0], vmax=limits[1], interpolation="nearest", aspect="equal")


def panels_of(snapshot, fields, exact):
    """What is drawn: a panel, the name of its field, and a title, one after the other."""
    position = snapshot.position
    if position.shape[1] == 2:
        plane = Panel(snapshot, np.full(len(position), True), position, ("x", "y"), exact=exact)
        return [(plane, name, "") for name in fields]
    away = position[:, 1]
    first, last = window(snapshot, away[snapshot.fluid])
    middle = (first + last) / 2

    def near(places):
        return np.abs(places[:, 1] - middle) < snapshot.spacing

    def slanted(places):
        return places[:, [0, 2]] + SLANT * (places[:, [1]] - away.min())

    exact_near, exact_slanted = ((None, None) if exact is None
                                 else (exact[near(exact)][:, [0, 2]], slanted(exact)))
    section = Panel(snapshot, near(position), position[:, [0, 2]], ("x", "z"), away, exact_near)
    view = Panel(snapshot, snapshot.fluid, slanted(position),
                 ("x, and y aslant", "z, and y aslant"), away, exact_slanted)
    return ([(section, name, f"section at y = {middle:.3g}") for name in fields]
            + [(view, "speed", "all, seen from the side")])


def quantity_of(column):
    """What a probe's column is, by its name; a place is that of a surface or a front."""
    if column in OWN_UNITS:
        return column
    if column.startswith("centre"):
        return "place"
    if column.endswith("_error"):
        return ERROR
    for field in ("pressure", "velocity", "density"):
        if f"_{field}" in column:
            return field
    ends = {"max": "speed", "rms": "speed", "x": "force", "y": "force", "z": "force"}
    return ends.get(column.rsplit("_")[-1], "place")


def with_errors(history):
    """What stays as it is becomes an error, which a curve can show, and is left out if it is of no
    interest: that all tracers are inside."""
    shown = {}
    for name, values in history.items():
        if name.endswith("_kept"):
            shown[name.removesuffix("_kept") + "_error"] = [abs(1 - value) for value in values]
        elif name != "share_inside" or min(values) < 1:
            shown[name] = values
    return shown


def observed(history, summary):
    """The columns of probes by what they are, behind the kinetic energy; no profiles."""
    known = {*NOT_OBSERVED, *summary.get("conservation", {})}
    groups = {"kinetic_energy": ["kinetic_energy"]} if "kinetic_energy" in history else {}
    for name in history if "conservation" in summary else ():
        if name not in known and not name.rsplit("_")[-1].isdigit():
            groups.setdefault(quantity_of(name), []).append(name)
    return groups


def unit_of(quantity, dimension):
    """In a plane all is per length of the third dimension."""
    per_length = "/m" if dimension == 2 else ""
    hamiltonian = OWN_UNITS["hamiltonian"] if dimension == 2 else "m⁵/s²"
    return {**OWN_UNITS, "hamiltonian": hamiltonian, "kinetic_energy": "J" + per_length,
            "force": "N" + per_length, "pressure": "Pa", "density": "kg/m³", "velocity": "m/s", "speed": "m/s", "place": "m"}[quantity]


def draw_history(axes, history, columns, text, summary):
    for name in columns:
        axes.plot(history["time"], history[name], linewidth=1, label=name)
    axes.set_xlabel(label("t", "s", summary))
    axes.set_ylabel(text)
    if text.startswith(ERROR) and any(value > 0 for name in columns for value in history[name]):
        axes.set_yscale("log", nonpositive="mask")
    axes.grid(color="0.9")
    if len(columns) > 1 or not text.startswith(columns[0]):
        axes.legend(fontsize=7, frameon=False)


def arrange(panels, kinds):
    """A figure whose panels stand side by side if they are tall, above the curves."""
    shape = [panel.raster.rows / panel.raster.columns for panel, _, _ in panels]
    columns = len(panels) if max(shape) > 0.8 else 1
    height = sum(WIDTH * own / columns + 0.5 for own in shape[::columns])
    curves = 2.2 * -(-len(kinds) // 2)
    figure = plt.figure(figsize=(WIDTH * (1.4 if columns > 1 else 1), height + curves + 0.6),
                        layout="constrained")
    above, below = figure.subfigures(2, 1, height_ratios=(height, max(curves, 0.01)))
    pictures = above.subplots(-(-len(panels) // columns), columns, squeeze=False).flat
    return figure, pictures, below


def draw_histories(figure, history, kinds, dimension, summary):
    """A panel for each kind of what was observed, two in a row."""
    if not kinds:
        return
    grid = figure.subplots(-(-len(kinds) // 2), min(2, len(kinds)), squeeze=False)
    for axes, (kind, columns) in zip(grid.flat, kinds.items()):
        text = (f"{ERROR} [–]" if kind == ERROR
                else label(kind, unit_of(kind, dimension), summary))
        draw_history(axes, history, columns, text, summary)
    for axes in grid.flat[len(kinds):]:
        axes.axis("off")


def draw_flow(folder, shown, summary, exact):
    """The figure: speed and pressure of the particles, some exact places, and the history of the
    run."""
    snapshot = FlowSnapshot(shown, ("velocity", "pressure", "vorticity", "potential"))
    fields = fields_of(snapshot)
    panels = panels_of(snapshot, fields, exact)
    history = with_errors(read_columns(folder / "history.csv"))
    kinds = observed(history, summary)
    figure, pictures, below = arrange(panels, kinds)
    for axes, (panel, name, title) in zip(pictures, panels):
        panel.draw(axes, name, *fields[name], summary)
        axes.set_title(title, fontsize=9)
    draw_histories(below, history, kinds, snapshot.position.shape[1], summary)
    return figure
