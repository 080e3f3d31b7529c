"""The fields of a run along the line against the exact curve."""
import matplotlib.pyplot as plt

from run_plots.reading import label, read_columns, read_snapshot

FIELDS = ("density", "velocity")


def draw_field(axes, name, start, end, exact, summary):
    (_, first, units), (time, last, _) = start, end
    axes.plot(first["position"], first[name], color="0.6", linestyle="--", linewidth=1,
              label="start")
    if name in exact:
        axes.plot(exact["position"], exact[name], color="C0", linewidth=1.5, label="exact")
    error = summary.get("errors", {}).get(name)
    note = f" (relative L2 error {error['l2']:.1e})" if error and exact else ""
    axes.plot(last["position"], last[name], linestyle="none", marker="o", markersize=3.5,
              color="C3", label=f"mote, t = {time:g}{note}")
    axes.set_ylabel(label(name, units[name], summary))
    axes.grid(color="0.9")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1), ncol=3, fontsize=8, frameon=False)


def draw_line(folder, snapshots, shown, summary):
    """The figure; the exact curve is the one of the last frame, so it is drawn for that alone."""
    start, end = read_snapshot(snapshots[0]), read_snapshot(shown)
    exact = read_columns(folder / "exact.csv") if shown == snapshots[-1] else {}
    fields = [name for name in FIELDS if name in end[1]]
    figure, rows = plt.subplots(len(fields), 1, sharex=True, figsize=(7, 6), squeeze=False)
    for (axes,), name in zip(rows, fields):
        draw_field(axes, name, start, end, exact, summary)
    rows[-1][0].set_xlabel(label("x", "m", summary))
    return figure
