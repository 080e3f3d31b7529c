"""The paths of a few bodies in space, and the history of the run."""
import matplotlib.pyplot as plt
import numpy as np

from run_plots.flow import EXACT, draw_histories, observed
from run_plots.reading import FlowSnapshot, label, read_columns

MOST_PATHS = 20
FLAT = 1e-9  # of the widest extent: a motion in a plane
WIDTH, CURVES = 7.0, 2.2  # inches, of the figure and of a row of curves


def has_orbits(shown):
    """Whether the bodies are points without a size, and few enough to be told apart."""
    snapshot = FlowSnapshot(shown, ())
    return snapshot.spacing == 0 and len(snapshot.position) <= MOST_PATHS


def planes_of(paths):
    """The planes of two axes in which the paths are shown: x and y, and x and z if they use it."""
    extent = np.ptp(paths, axis=(0, 1))
    flat = len(extent) == 2 or extent[2] <= FLAT * extent.max()
    return [(0, 1)] if flat else [(0, 1), (0, 2)]


def draw_paths(axes, paths, plane, summary, exact):
    """Through the snapshots, with a dot where each body is at the end, and a circle where it should
    be."""
    for k in range(paths.shape[1]):
        line, = axes.plot(*paths[:, k, plane].T, linewidth=0.8)
        axes.plot(*paths[-1, k, plane], "o", markersize=4, color=line.get_color(),
                  label=f"body {k + 1}")
    if exact is not None:
        axes.scatter(*exact[:, plane].T, zorder=3, label="exact places", **EXACT)
    axes.set_aspect("equal", "datalim")
    axes.set_xlabel(label("xyz"[plane[0]], "m", summary))
    axes.set_ylabel(label("xyz"[plane[1]], "m", summary))
    axes.grid(color="0.92")


def draw_orbits(folder, snapshots, shown, summary, exact):
    until = snapshots[:snapshots.index(shown) + 1]
    paths = np.array([FlowSnapshot(path, ()).position for path in until])
    history = read_columns(folder / "history.csv")
    kinds, planes = observed(history, summary), planes_of(paths)
    curves = CURVES * -(-len(kinds) // 2)
    figure = plt.figure(figsize=(WIDTH * (1.4 if len(planes) > 1 else 1), WIDTH + curves),
                        layout="constrained")
    above, below = figure.subfigures(2, 1, height_ratios=(WIDTH, max(curves, 0.01)))
    for axes, plane in zip(above.subplots(1, len(planes), squeeze=False).flat, planes):
        draw_paths(axes, paths, plane, summary, exact)
    above.axes[0].legend(fontsize=7, frameon=False)
    draw_histories(below, history, kinds, paths.shape[2], summary)
    return figure
