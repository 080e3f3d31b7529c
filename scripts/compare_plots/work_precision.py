"""Panels of compare.png for integrators: what accuracy costs, in evaluations of the forces."""
import math
from functools import partial

from compare_plots.picture import line_style
from study_plots.drawing import plain
from study_plots.errors import log_limits, on_axis

ENERGY = "energy"


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


def draw_work(axes, column, words, table, summary=None):
    """A curve for every method as its step or tolerance changes, or a point with its name."""
    lines = [[m for m in members if m.evaluations > 0 and not math.isnan(m.size(column))]
             for members in table.lines.values()]
    limits = log_limits([member.size(column) for line in lines for member in line])
    axes.set(xscale="log", yscale="log", ylim=limits)
    for k, (values, line) in enumerate(zip(table.lines, lines)):
        work = [member.evaluations for member in line]
        height = on_axis([member.size(column) for member in line], limits)
        axes.plot(work, height, clip_on=False, zorder=3, **line_style(k, len(lines), 1.2))
        if len(line) == 1:
            axes.annotate(plain(", ".join(values)), (work[0], height[0]), xytext=(5, 3),
                          textcoords="offset points", fontsize=6.5, zorder=4)
    axes.margins(x=0.12)
    axes.set_ylabel(words)
    axes.set_xlabel("evaluations of the forces [–]")
    axes.grid(color="0.92")
