"""values.png: computed and exact values along a line; maps of the error in a plane."""
import math
import sys
import textwrap

import numpy
from matplotlib.colors import LogNorm
from matplotlib.lines import Line2D

from study_plots.reading import read_points, in_order
from study_plots.drawing import (
    plain, hollow, label, make_grid, arrange, add_legend, add_bar, stroke, operator_handles,
    save, COLOURS)

QUANTITIES = ("gradient", "laplacian")  # that have a picture of their values


def view_of(exact, computed):
    """Limits that show all values, but at most half the range of the exact ones beyond them."""
    exact, computed = exact[numpy.isfinite(exact)], computed[numpy.isfinite(computed)]
    if not exact.size:
        exact = computed if computed.size else numpy.zeros(1)
    low, high = exact.min(), exact.max()
    span = high - low if high - low > 1e-9 * abs(high + low) else abs(high) or 1.0
    low, high = (max(low - 0.5 * span, min([low, *computed])),
                 min(high + 0.5 * span, max([high, *computed])))
    margin = 0.05 * (high - low) or 0.1 * span
    return low - margin, high + margin


def draw_outside(axes, x, values, limits, colour):
    """Arrows on the edges of the view where values lie beyond; how many there are."""
    low, high = limits
    for beyond, edge, marker in ((values > high, high, "^"), (values < low, low, "v")):
        axes.plot(x[beyond], numpy.full(beyond.sum(), edge), linestyle="none", marker=marker,
                  markersize=5, color=colour, clip_on=False, zorder=4)
    return int(((values > high) | (values < low)).sum())


def draw_line_panel(axes, tables, operators, name):
    """All operators on one layout of a line against the exact curve; words on what lies outside."""
    exact, computed = (numpy.concatenate([table[name + end] for table in tables.values()])
                       for end in ("_exact", "_computed"))
    limits, outside, broken = view_of(exact, computed), [], []
    for k, operator in enumerate(operators):
        table = tables.get(operator)
        if table is None:
            continue
        order = numpy.argsort(table["x"], kind="stable")
        x, values = table["x"][order], table[name + "_computed"][order]
        axes.plot(x, table[name + "_exact"][order], color="0.35", linewidth=1.8, zorder=1)
        step = max(1, x.size * len(tables) // 320)
        axes.plot(x, values, markevery=(k * step // len(operators), step), zorder=3,
                  **stroke(k, 0.6 if step > 1 else 0), **hollow(k, len(operators)))
        count = draw_outside(axes, x, values, limits, COLOURS[k % len(COLOURS)])
        outside += [f"{operator}\u00a0{count}"] if count else []
        count = int((~numpy.isfinite(values)).sum())
        broken += [f"{operator}\u00a0{count}"] if count else []
    axes.set_ylim(limits)
    axes.grid(color="0.92")
    words = [f"arrows: outside the view, of {x.size} points: " + ", ".join(outside)] * bool(outside)
    return words + ["not finite: " + ", ".join(broken)] * bool(broken)


def draw_line_values(tables, quantities, units):
    """Layouts down, quantities across, all operators in each panel."""
    layouts, operators = (in_order(key[k] for key in tables) for k in (0, 1))
    figure, grid = make_grid(len(layouts), len(quantities))
    most_words = 0
    for layout, line in zip(layouts, grid):
        for axes, (quantity, (name,)) in zip(line, quantities.items()):
            own = {key[1]: table for key, table in tables.items() if key[0] == layout}
            words = draw_line_panel(axes, own, operators, name)
            words = "\n".join(textwrap.fill(text, 88) for text in words)
            lines = words.count("\n") + 1 if words else 0
            most_words = max(most_words, lines)
            axes.set_title(plain(f"{quantity}, {layout}"), fontsize=9, loc="left",
                           pad=8 + 9.5 * lines)
            axes.annotate(plain(words), (0, 1), xytext=(0, 6), xycoords="axes fraction",
                          textcoords="offset points", fontsize=7, linespacing=1.1)
            axes.set_ylabel(label(quantity, units, 1 + QUANTITIES.index(quantity)))
    arrange(figure, grid, (5, 2), (0.8, 0.6 + 0.13 * most_words))
    for axes in grid[-1]:
        axes.set_xlabel(label("x", units))
    most = max(table["x"].size for table in tables.values())
    exact = Line2D([], [], color="0.35", linewidth=1.8, label="exact")
    add_legend(figure, [exact] + operator_handles(
        operators, hollow, 0.6 if most * len(operators) >= 640 else 0))
    return figure, 0.4 + 0.13 * most_words


def middle_slab(table, centre=None):
    """Which points of a box lie in the layer, a spacing thick, of the point nearest the centre."""
    x, y, z = (table[name] for name in "xyz")
    if centre is None:
        centre = 0.5 * (z.min() + z.max())
    near = z[numpy.argmin(numpy.abs(z - centre))]
    spacing = numpy.cbrt(numpy.ptp(x) * numpy.ptp(y) * numpy.ptp(z) / z.size)
    return numpy.abs(z - near) <= 0.5 * spacing


def cut(tables, centre=None):
    """The tables cut down to a slab if they have a z, and words on it."""
    first = next(iter(tables.values()))
    if "z" not in first:
        return tables, ""
    chosen = middle_slab(first, centre)
    z = first["z"][chosen]
    words = f"\nthe {z.size} of {chosen.size} points from z = {z.min():.3g} to {z.max():.3g}"
    return {key: {name: values[chosen] for name, values in table.items()}
            for key, table in tables.items()}, words


def errors_of(tables, names):
    """|computed - exact| of a vector at every point, relative to the largest |exact| if not 0."""
    size = numpy.sqrt(sum(next(iter(tables.values()))[n + "_exact"] ** 2 for n in names))
    scale = numpy.nanmax(size, initial=0)
    words = "relative error [–]" if 0 < scale < math.inf else "error, not relative"
    return {key: numpy.sqrt(sum((table[n + "_computed"] - table[n + "_exact"]) ** 2 for n in names))
            / (scale if 0 < scale < math.inf else 1) for key, table in tables.items()}, words


def log_norm(values, share_below=0.0):
    """Colours over the positive values but a share of the smallest, and a decade at least."""
    values = values[(values > 0) & numpy.isfinite(values)]
    high = values.max() if values.size else 1.0
    low = max(numpy.quantile(values, share_below), 1e-16 * high) if values.size else 0.1
    return LogNorm(min(low, high / 10), high)


def shape_of(table):
    """Height over width of a plane of points, for panels neither too tall nor too flat."""
    width, height = numpy.ptp(table["x"]), numpy.ptp(table["y"])
    return min(max(height / width, 0.4), 2) if width > 0 and height > 0 else 1


def draw_map(axes, table, values, norm, width):
    """Coloured points in a plane, as large as their spacing; crosses where not finite.

    Gives the points as drawn, and their diameter.
    """
    x, y = table["x"], table["y"]
    extent = max(numpy.ptp(x), numpy.ptp(y) / shape_of(table)) or 1.0
    spacing = math.sqrt((numpy.ptp(x) or extent) * (numpy.ptp(y) or extent) / x.size)
    size = min(max(width * 72 * spacing / extent * 1.2, 1), 8)
    shown = numpy.isfinite(values)
    colours = numpy.maximum(values[shown], norm.vmin)
    points = axes.scatter(x[shown], y[shown], c=colours, s=size ** 2, norm=norm, cmap="viridis",
                          linewidths=0)
    axes.plot(x[~shown], y[~shown], linestyle="none", marker="x", color="#D55E00", markersize=4)
    ratio = numpy.ptp(y) / (numpy.ptp(x) or 1.0)
    axes.set_aspect("equal" if 0.4 <= ratio <= 2 else "auto")
    axes.tick_params(labelsize=7)
    return points, size


def label_outer(axes, left, bottom, units):
    """Coordinates on the outer panels only."""
    axes.tick_params(labelleft=left, labelbottom=bottom)
    axes.set_ylabel(label("y", units) if left else "", fontsize=8)
    axes.set_xlabel(label("x", units) if bottom else "", fontsize=8)


def draw_plane_values(tables, quantities, units):
    """Maps of the error: a block of panels for each quantity, a panel for each operator."""
    columns = math.ceil(len(tables) / math.ceil(len(tables) / 4))
    lines, width = math.ceil(len(tables) / columns), 2.6
    shape = shape_of(next(iter(tables.values())))
    figure, grid = make_grid(lines * len(quantities), columns)
    arrange(figure, grid, (width, width * shape), (0.15, 0.6))
    for block, (quantity, names) in enumerate(quantities.items()):
        panels = grid[block * lines:(block + 1) * lines]
        errors, text = errors_of(tables, names)
        together = numpy.concatenate(list(errors.values()))
        norm = log_norm(together, 0.01)
        for axes in panels.flat[len(tables):]:
            axes.axis("off")
        for k, (key, table) in enumerate(tables.items()):
            axes = panels.flat[k]
            points, _ = draw_map(axes, table, errors[key], norm, width)
            finite = errors[key][numpy.isfinite(errors[key])]
            words = f"largest {finite.max(initial=0):.1e}"
            words += f", × not finite: {errors[key].size - finite.size}" * (
                finite.size < errors[key].size)
            axes.set_title(plain(f"{key[1]}\n{words}"), fontsize=8)
            label_outer(axes, k % columns == 0, k + columns >= len(tables), units)
            if block + 1 < len(quantities):
                axes.set_xlabel("")
        add_bar(figure, points, panels, f"{quantity}: {text}",
                "min" if (together < norm.vmin).any() else "neither")
    return figure, 0.4


def drawable_quantities(columns):
    """Gradient and Laplacian with the names of their components, where the table has them."""
    components = [f"gradient_{axis}" for axis in "xyz"]
    found = {"gradient": [name for name in components if name + "_exact" in columns],
             "laplacian": ["laplacian"] * ("laplacian_exact" in columns)}
    return {quantity: names for quantity, names in found.items() if names}


def chosen_cases(rows, layout, resolution):
    """{layout: resolution} to draw: the highest that each has unless told."""
    cases = in_order((row["layout"], row["resolution"]) for row in rows)
    wanted = [case for case in cases if layout in (None, case[0]) and resolution in (None, case[1])]
    if not wanted:
        known = ", ".join(f"{name} {count}" for name, count in cases)
        sys.exit(f"no such layout and resolution; there are: {known}")
    return {name: max(n for other, n in wanted if other == name) for name, _ in wanted}


def draw_values(folder, heading, cases):
    path = folder / "points.csv"
    header = path.open(encoding="utf-8").readline().rstrip().split(",") if path.exists() else []
    quantities, line = drawable_quantities(header), "y" not in header
    if not line:
        cases = dict([list(cases.items())[-1]])
    starts = tuple(f"{layout},{resolution}," for layout, resolution in cases.items())
    tables = read_points(path, starts, "[xyz]|(gradient.*|laplacian)_(computed|exact)")
    if not quantities or not tables:
        return
    if line:
        figure, above = draw_line_values(tables, quantities, heading[1])
        counts = in_order(str(n) for n in cases.values())
        words = f"computed at the points and exact, n = {', '.join(counts)}"
    else:
        (layout, resolution), = cases.items()
        tables, slab = cut(tables)
        figure, above = draw_plane_values(tables, quantities, heading[1])
        words = f"|computed − exact| / max |exact|, {layout}, n = {resolution}{slab}"
    save(figure, f"{heading[0]}\n{words}", folder / "values.png", above)
