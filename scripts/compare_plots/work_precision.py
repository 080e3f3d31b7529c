"""Panels of compare.png for integrators: what accuracy costs, in evaluations of the forces."""
import math
from functools import partial

from compare_plots.picture import line_style
from study_plots.drawing import plain
from study_plots.errors import log_limits, on_axis

ENERGY = "energy"
NAME_SIZE = 6.5  # points


def compares_work(table):
    """Whether integrators stand against each other, and have counted what they did."""
    return "time.integrator" in table.all_keys and any(
        member.evaluations > 0 for members in table.lines.values() for member in members)


def columns_of(table):
    """Errors and drifts that are worth a panel: the column of compare.csv, and words for it."""
    columns = [(f"{field}_l2", f"relative L2 error of {field} [–]") for field in table.fields]
    return columns + [(f"{ENERGY}_drift", "relative drift of energy [–]")] * (
        f"{ENERGY}_drift" in table.columns)


def work_panels(table):
    return [partial(draw_work, column=column, words=words, table=table)
            for column, words in columns_of(table)]


def add_names(axes, named):
    """A name beside each point, towards the middle of the axes, and above one that is there."""
    axes.autoscale_view()
    to_points = 72 / axes.figure.dpi
    left, right = (to_points * x for x in axes.bbox.intervalx)
    taken = []
    for name, point in sorted(named, key=lambda item: item[1][1]):
        x, y = to_points * axes.transData.transform(point)
        is_right = x > (left + right) / 2
        length = 0.55 * NAME_SIZE * len(name)
        start, height = x - is_right * length, y
        while any(abs(height - other) < NAME_SIZE and begin < start + length and start < end
                  for begin, end, other in taken):
            height += 1
        taken.append((start, start + length, height))
        axes.annotate(plain(name), point, xytext=(-5 if is_right else 5, height - y - 2),
                      ha="right" if is_right else "left", textcoords="offset points",
                      fontsize=NAME_SIZE, zorder=4)


def draw_work(axes, column, words, table, summary=None):
    """A curve for every method as its step or tolerance changes, or a point with its name."""
    lines = [[m for m in members if m.evaluations > 0 and not math.isnan(m.size(column))]
             for members in table.lines.values()]
    limits = log_limits([member.size(column) for line in lines for member in line])
    axes.set(xscale="log", yscale="log", ylim=limits)
    named = []
    for k, (values, line) in enumerate(zip(table.lines, lines)):
        work = [member.evaluations for member in line]
        height = on_axis([member.size(column) for member in line], limits)
        axes.plot(work, height, clip_on=False, zorder=3, **line_style(k, len(lines), 1.2))
        if len(line) == 1:
            named.append((", ".join(values), (work[0], height[0])))
    axes.margins(x=0.12)
    add_names(axes, named)
    axes.set_ylabel(words)
    axes.set_xlabel("evaluations of the forces [–]")
    axes.grid(color="0.92")
