"""check_up.png: how good the neighbourhoods of a user's own points are."""
import numpy
from matplotlib.colors import Normalize

from study_plots.reading import read_points
from study_plots.drawing import plain, make_grid, arrange, add_bar, save, COLOURS
from study_plots.errors import log_limits
from study_plots.values import cut, log_norm, shape_of, draw_map, label_outer

ENOUGH_COVERED = 0.75  # a free plane leaves a half, a lattice nearly 1
MOST_COVERED = 1.5  # end of the colours: points in a heap cover their supports many times
MOST_CHECKED = 4  # operators side by side in the check-up


CHECKED = {"covered": "support covered [–]", "condition": "condition [–]"}


def bad_points(table, name):
    """Which points are bad, and the words for it."""
    if name == "covered":
        return ~(table[name] >= ENOUGH_COVERED), f"covered < {ENOUGH_COVERED}"
    return ~numpy.isfinite(table[name]), "condition infinite"


def check_norm(tables, name):
    together = numpy.concatenate([table[name] for table in tables.values()])
    if name == "condition":
        return log_norm(together)
    if "y" not in next(iter(tables.values())):
        return Normalize(0, 1.08 * max(1, numpy.nanmax(together, initial=0)))
    return Normalize(0, MOST_COVERED)


def draw_check_line(axes, table, name, norm):
    """The check-up along a line; what is infinite on the upper edge."""
    if name == "condition":
        axes.set_yscale("log")
    limits = (norm.vmin, norm.vmax)
    limits = log_limits(limits) if name == "condition" else limits
    shown = numpy.where(numpy.isfinite(table[name]), table[name], limits[1])
    axes.plot(table["x"], shown, linestyle="none", marker="o", markersize=3, color=COLOURS[0],
              clip_on=False)
    axes.set_ylim(limits)
    axes.grid(color="0.92")
    return shown


def draw_check_panel(axes, table, whole, name, norm, width):
    """One quantity of the check-up for one operator; the points as drawn, if it is a map."""
    (bad, words), (bad_of_all, _) = bad_points(table, name), bad_points(whole, name)
    words += f": {bad.sum()} of {bad.size}" + (
        f", in all {bad_of_all.sum()} of {bad_of_all.size}"
        if bad_of_all.size > bad.size else " points")
    line = "y" not in table
    values = numpy.where(numpy.isfinite(table[name]), table[name], norm.vmax)
    height = draw_check_line(axes, table, name, norm) if line else table["y"]
    points, size = (None, 6.5) if line else draw_map(axes, table, values, norm, width)
    ring, = axes.plot(table["x"][bad], height[bad], linestyle="none", marker="o",
                      markersize=max(4, size), markerfacecolor="none", color="#D55E00",
                      markeredgewidth=0.9, zorder=5, clip_on=False,
                      label=words)
    axes.legend(handles=[ring], loc="lower center", bbox_to_anchor=(0.5, 1), fontsize=8,
                frameon=False, borderpad=0.1)
    return points


def worst_height(tables):
    """Where to cut a box: through the middle one of the points without a parabola, if any."""
    heights = [z for table in tables.values() if "z" in table
               for z in table["z"][bad_points(table, "condition")[0]]]
    return sorted(heights)[len(heights) // 2] if heights else None


def draw_check_up(folder, heading, layout):
    """Covered and condition, down, of the first operators, across."""
    path = folder / "check_up.csv"
    tables = read_points(path, f"{layout},", "[xyz]|covered|condition")
    if not tables:
        return
    left_out = len(tables) - MOST_CHECKED
    tables = dict(list(tables.items())[:MOST_CHECKED])
    wholes = tables
    tables, slab = cut(tables, worst_height(tables))
    first = next(iter(tables.values()))
    line, width = "y" not in first, 3.0
    figure, grid = make_grid(2, len(tables))
    arrange(figure, grid, (width, 2 if line else width * shape_of(first)), (0.3, 0.5))
    for row, (name, text) in zip(grid, CHECKED.items()):
        norm = check_norm(tables, name)
        for k, (axes, (key, table)) in enumerate(zip(row, tables.items())):
            points = draw_check_panel(axes, table, wholes[key], name, norm, width)
            label_outer(axes, k == 0, name == "condition", heading[1])
            if line:
                axes.set_ylabel(text if k == 0 else "", fontsize=8)
        if not line:
            add_bar(figure, points, row, text, "max" if name == "covered" else "neither")
    for axes, key in zip(grid[0], tables):
        axes.set_title(plain(key[1]), fontsize=9, pad=20)
    more = f"; {left_out} more operators are in check_up.csv" if left_out > 0 else ""
    save(figure, f"{heading[0]}\ncheck-up of the points, {layout}{slab}{more}",
         folder / "check_up.png", 0.6)
