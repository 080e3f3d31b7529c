"""errors.png: errors against resolution, or of each layout."""
import math

from matplotlib.lines import Line2D

from study_plots.reading import in_order
from study_plots.drawing import (
    plain, style, make_grid, arrange, add_legend, stroke, operator_handles, save)

ZERO_NOTE = "on the lower edge: the error is 0"
INFINITE_NOTE = "on the upper edge: not finite"


def log_limits(values):
    """Limits of a logarithmic axis around the positive values, a decade at least."""
    values = [value for value in values if 0 < value < math.inf]
    low, high = (min(values), max(values)) if values else (0.1, 1)
    middle, half = math.sqrt(low) * math.sqrt(high), max(math.log10(high / low) * 1.12, 1) / 2
    return middle * 10 ** -half, middle * 10 ** half


def on_axis(errors, limits):
    """The errors with 0 on the lower edge of the axis and what is not finite on the upper."""
    low, high = limits
    return [high if not math.isfinite(e) else e if e > 0 else low for e in errors]


def edge_handles(rows):
    """Words on the errors that a logarithmic axis cannot show, if there are any."""
    notes = [(ZERO_NOTE, any(row["error"] == 0 for row in rows)),
             (INFINITE_NOTE, any(not math.isfinite(row["error"]) for row in rows))]
    return [Line2D([], [], linestyle="none", label=note) for note, holds in notes if holds]


def draw_slopes(axes, rows, orders):
    """Thin lines of these orders from the largest error at the widest spacing."""
    low, high = (pick(row["resolution"] for row in rows) for pick in (min, max))
    start = max((row["error"] for row in rows
                 if row["resolution"] == low and 0 < row["error"] < math.inf), default=None)
    for order, pattern in orders.items() if start and high > low else ():
        axes.plot([1 / low, 1 / high], [start, start * (low / high) ** order], color="0.55",
                  linewidth=0.8, linestyle=pattern, zorder=1)


def draw_convergence_panel(axes, rows, operators, limits, orders):
    """Error against spacing, with the order between the two finest beside each marker."""
    resolutions = sorted({row["resolution"] for row in rows})
    axes.set(xscale="log", yscale="log", ylim=limits)
    if len(resolutions) > 1:
        margin = (resolutions[-1] / resolutions[0]) ** 0.08
        axes.set_xlim(1 / (resolutions[-1] * margin), margin / resolutions[0])
    draw_slopes(axes, rows, orders)
    handles = []
    for k, name in enumerate(operators):
        own = [row for row in rows if row["operator"] == name]
        if own:
            order = f"{float(own[-1]['order']):.1f}" if own[-1]["order"] else "–"
            order = "0.0" if order == "-0.0" else order.replace("-", "−")
            handles += axes.plot([1 / row["resolution"] for row in own],
                                 on_axis([row["error"] for row in own], limits), clip_on=False,
                                 label=order, zorder=3, **stroke(k, 1.2),
                                 **style(k, len(operators)))
    shown = resolutions[::-math.ceil(len(resolutions) / 6)]
    axes.set_xticks([1 / n for n in shown], [f"1/{n}" for n in shown], minor=False)
    axes.set_xticks([], minor=True)
    axes.grid(color="0.92")
    axes.legend(handles=handles, title="order", loc="upper left", bbox_to_anchor=(1, 1.04),
                title_fontsize=7, fontsize=7, frameon=False, handlelength=1.2, borderpad=0.1)


def slopes_of(rows):
    steep = any(row["order"] and float(row["order"]) > 3 for row in rows)
    return {1: ":", 2: "--", 4: "-."} if steep else {1: ":", 2: "--"}


def draw_convergence(rows, operators, files):
    """A panel for each layout, down, and each quantity, across."""
    layouts, quantities = (in_order(row[key] for row in rows) for key in ("layout", "quantity"))
    orders = slopes_of(rows)
    figure, grid = make_grid(len(layouts), len(quantities))
    size = 3.3 if len(quantities) < 3 else 2.4, max(2, 0.15 * len(operators) + 0.2)
    arrange(figure, grid, size, (1.0, 0.75))
    for column, quantity in enumerate(quantities):
        limits = log_limits([row["error"] for row in rows if row["quantity"] == quantity])
        for line, layout in enumerate(layouts):
            axes = grid[line][column]
            own = [row for row in rows if (row["layout"], row["quantity"]) == (layout, quantity)]
            axes.set_title(plain(f"{quantity}, {layout}"), fontsize=9)
            if not own:
                axes.axis("off")
                continue
            draw_convergence_panel(axes, own, operators, limits, orders)
            if layout in files or line == len(layouts) - 1 or layouts[line + 1] in files:
                axes.set_xlabel("1/points [–]" if layout in files else "spacing/side along x [–]")
            if column == 0:
                axes.set_ylabel("relative error [–]")
    slopes = [Line2D([], [], color="0.55", linewidth=0.8, linestyle=pattern, label=f"order {order}")
              for order, pattern in orders.items()]
    add_legend(figure, operator_handles(operators, linewidth=1.2) + slopes + edge_handles(rows))
    return figure


def draw_comparison_panel(axes, rows, layouts, operators):
    """Errors at one resolution: the layouts across, the operators side by side in each."""
    limits = log_limits([row["error"] for row in rows])
    for k, name in enumerate(operators):
        own = [row for row in rows if row["operator"] == name]
        shift = 0.8 * ((k + 0.5) / len(operators) - 0.5)
        axes.plot([layouts.index(row["layout"]) + shift for row in own],
                  on_axis([row["error"] for row in own], limits), linestyle="none", clip_on=False,
                  zorder=3, **style(k, len(operators), 6.5, 6.5))
    for k in range(0, len(layouts), 2):
        axes.axvspan(k - 0.5, k + 0.5, color="0.955", zorder=0)
    counts = {row["layout"]: row["resolution"] for row in rows}
    axes.set(yscale="log", ylim=limits, xlim=(-0.5, len(layouts) - 0.5))
    axes.set_xticks(range(len(layouts)), [plain(f"{name}\nn = {counts.get(name, '–')}")
                                          for name in layouts], fontsize=8)
    axes.grid(axis="y", color="0.88")


def draw_comparison(rows, operators, files):
    """A panel for each quantity, with one resolution for each layout."""
    layouts, quantities = (in_order(row[key] for row in rows) for key in ("layout", "quantity"))
    longest = max(len(name) for name in layouts)
    width = min(max(len(layouts) * max(0.8, 0.13 * len(operators), 0.075 * longest), 2.6), 24)
    lines = math.ceil(len(quantities) / max(1, min(len(quantities), int(14 / width))))
    columns = math.ceil(len(quantities) / lines)
    figure, grid = make_grid(lines, columns)
    arrange(figure, grid, (width, 2.5), (0.75, 0.8))
    what = "points" if files.issuperset(layouts) else "points along x"
    if files and not files.issuperset(layouts):
        what += ", of a file all points"
    for axes in grid.flat[len(quantities):]:
        axes.axis("off")
    for k, (axes, quantity) in enumerate(zip(grid.flat, quantities)):
        draw_comparison_panel(axes, [row for row in rows if row["quantity"] == quantity], layouts,
                              operators)
        axes.set_title(quantity, fontsize=9)
        if k + columns >= len(quantities):
            axes.set_xlabel(f"layout (n: {what})")
        if k % columns == 0:
            axes.set_ylabel("relative error [–]")
    add_legend(figure, operator_handles(operators) + edge_handles(rows))
    return figure


def draw_errors(folder, heading, rows, files):
    norms = in_order(row["norm"] for row in rows)
    norm = "l2" if "l2" in norms else norms[0]
    rows = [row for row in rows if row["norm"] == norm]
    operators = in_order(row["operator"] for row in rows)
    cases = {(row["layout"], row["resolution"]) for row in rows}
    several = len(cases) > len({layout for layout, _ in cases})
    figure = (draw_convergence if several else draw_comparison)(rows, operators, files)
    save(figure, f"{heading[0]}\nrelative errors of the operators, norm {norm}",
         folder / "errors.png")
