"""errors.png of a study of interpolation: errors against eccentricity, a panel for each division."""
from study_plots.reading import in_order
from study_plots.drawing import (
    hollow, make_grid, arrange, add_legend, stroke, operator_handles, save)
from study_plots.errors import edge_handles, log_limits, on_axis

UNITS = {"position": "a", "velocity": "√(μ/a)"}


def draw_panel(axes, rows, paths, limits):
    """One division of the period, all paths."""
    for k, path in enumerate(paths):
        own = [row for row in rows if row["path"] == path]
        axes.plot([row["eccentricity"] for row in own],
                  on_axis([row["error"] for row in own], limits), clip_on=False, zorder=3,
                  **stroke(k, 1.2), **hollow(k, len(paths)))
    axes.set(yscale="log", ylim=limits, xlim=(0, 1), xticks=(0, 0.2, 0.4, 0.6, 0.8))
    axes.grid(color="0.92")


def draw_interpolation(folder, heading, table):
    """Position above, velocity below; divisions across, on the same axis."""
    rows = [{"path": row["path"], "sub_intervals": int(row["sub_intervals"]), "quantity": quantity,
             "eccentricity": float(row["eccentricity"]), "error": float(row[quantity])}
            for row in table for quantity in UNITS]
    divisions, paths = (in_order(row[key] for row in rows) for key in ("sub_intervals", "path"))
    figure, grid = make_grid(len(UNITS), len(divisions))
    arrange(figure, grid, (2.4, 2.6), (0.15, 0.2))
    for line, (quantity, unit) in zip(grid, UNITS.items()):
        measured = [row for row in rows if row["quantity"] == quantity]
        limits = log_limits([row["error"] for row in measured])
        for axes, division in zip(line, divisions):
            own = [row for row in measured if row["sub_intervals"] == division]
            draw_panel(axes, own, paths, limits)
            axes.tick_params(labelleft=axes is line[0], labelbottom=axes in grid[-1])
        line[0].set_ylabel(f"error of {quantity} / {unit} [–]")
    for axes, division in zip(grid[0], divisions):
        axes.set_title(f"{division} sub-intervals", fontsize=9)
    for axes in grid[-1]:
        axes.set_xlabel("eccentricity [–]")
    add_legend(figure, operator_handles(paths, hollow, 1.2) + edge_handles(rows))
    save(figure, f"{heading[0]}\nlargest errors of interpolation over one period",
         folder / "errors.png")
