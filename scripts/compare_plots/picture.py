"""compare.png: fields at the end above, errors against resolution below."""
import math
from functools import partial

from matplotlib.lines import Line2D
from matplotlib.ticker import NullFormatter

from run_plots.reading import label, read_columns, read_snapshot, read_summary
from study_plots.drawing import (
    COLOURS, add_legend, arrange, make_grid, plain, save, stroke, style)
from study_plots.errors import ZERO_NOTE, log_limits, on_axis

USUAL_FIELDS = ("velocity", "density")  # where there is no exact solution
MOST_MARKERS = 41  # on a profile
MOST_RESOLUTIONS = 7  # named on an axis
MOST_IN_PANEL = 14  # lines of a legend
EXACT = {"color": "black", "linewidth": 1, "label": "exact"}
NOT_DRAWN = {"color": "0.4", "marker": "x", "markersize": 6, "linestyle": "none"}
SLOPE = {"color": "0.5", "linewidth": 0.9, "linestyle": "--", "label": "order 2"}


def line_style(k, count, width):
    """Of line k, never black, which is the exact curve; later markers are smaller."""
    coloured = len(COLOURS) - 1
    k, count = k + k // coloured, count + (count - 1) // coloured
    return {**stroke(k, width), **style(k, count, 6.5, 3.0), "markerfacecolor": "none",
            "markeredgewidth": 0.9}


class Profiles:
    """The last snapshots of the members that reached the end, at the finest resolution."""

    shown = "fields at"

    def __init__(self, table):
        self.table, self.members = table, table.finest()
        self.snapshots = {k: read_snapshot(max((member.folder / "snapshots").glob("*.hdf")))
                          for k, member in enumerate(self.members) if not member.failed}
        self.exact = next((columns for columns in (
            read_columns(self.members[k].folder / "exact.csv") for k in self.snapshots) if columns),
            {})
        self.fields = [name for name in table.fields if name != "position"] or [
            name for name in USUAL_FIELDS
            if not self.snapshots or all(name in shot[1] for shot in self.snapshots.values())]

    def draw(self, axes, name, summary):
        unit = ""
        for k, (_, fields, units) in self.snapshots.items():
            unit, every = units[name], math.ceil(len(fields["position"]) / MOST_MARKERS)
            axes.plot(fields["position"], fields[name], markevery=every, zorder=3,
                      **line_style(k, len(self.members), 0.7))
        if name in self.exact:
            axes.plot(self.exact["position"], self.exact[name], zorder=4, **EXACT)
        if not self.snapshots:
            axes.text(0.5, 0.5, "no member reached the end", transform=axes.transAxes, ha="center")
        axes.set_ylabel(label(name, unit, summary))
        axes.set_xlabel(label("x", "m", summary))
        axes.grid(color="0.92")

    def handles(self):
        """A line for each member; a cross where nothing of it is drawn."""
        exact = [Line2D([], [], **EXACT)] if self.exact else []
        styles = [NOT_DRAWN if all(member.failed for member in line)
                  else line_style(k, len(self.members), 1)
                  for k, line in enumerate(self.table.lines.values())]
        return exact + [Line2D([], [], label=plain(self.table.words(values)), **of_line)
                        for values, of_line in zip(self.table.lines, styles)]


def add_slope(axes, ends, start, power):
    """From the largest error at the coarsest end, as an error of order 2 falls."""
    coarse, fine = ends
    axes.plot([coarse, fine], [start, start * (fine / coarse) ** power], zorder=1, **SLOPE)


def draw_errors(axes, field, table, summary):
    """The L2 error of every line against resolution, and a slope of order 2."""
    lines = [[m for m in members if not math.isnan(m.error(field))]
             for members in table.lines.values()]
    limits = log_limits([member.error(field) for line in lines for member in line])
    axes.set(xscale="log", yscale="log", ylim=limits)
    for k, line in enumerate(lines):
        axes.plot([member.resolution for member in line],
                  on_axis([member.error(field) for member in line], limits), clip_on=False,
                  zorder=3, **line_style(k, len(lines), 1.2))
    resolutions = table.resolutions()
    start = max((member.error(field) for line in lines for member in line
                 if member.resolution == resolutions[0]), default=0)
    if start > 0 and table.refinement != "time.tolerance":
        add_slope(axes, (resolutions[0], resolutions[-1]), start,
                  2 if table.refinement == "time.step" else -2 / summary.get("dimension", 1))
    shown = resolutions[::-math.ceil(len(resolutions) / MOST_RESOLUTIONS)]
    axes.set_xticks(shown, [f"{value:g}" for value in shown])
    axes.set_xticks([], minor=True)
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.set_ylabel(f"relative L2 error of {field} [–]")
    axes.set_xlabel({"particles.count": "particles [–]", "time.tolerance": "tolerance [–]"}.get(
        table.refinement, label("time step", "s", summary)))
    axes.grid(color="0.92")


def subtitle(table, profiles):
    words = []
    if profiles.snapshots:
        times = sorted({shot[0] for shot in profiles.snapshots.values()})
        words.append(profiles.shown + " " + ", ".join(f"t = {time:g}" for time in times))
    if table.refinement:
        words[-1:] = [" ".join(words[-1:] + [f"with the finest {table.refinement}"])]
    if table.keys:
        words.append("compared: " + ", ".join(table.keys))
    return "; ".join(words)


def note_handles(table, below):
    """What the error panels have beside the members."""
    columns = [panel.keywords.get("column") or f"{panel.keywords['field']}_l2" for panel in below]
    errors = [member.size(column) for members in table.lines.values() for member in members
              for column in columns]
    slope = [Line2D([], [], **SLOPE)] if any(panel.func is draw_errors for panel in below) else []
    return slope + ([Line2D([], [], linestyle="none", label=ZERO_NOTE)] if 0 in errors else [])


def place_legend(figure, free, handles):
    """In the free panel of the upper row, if there is one that is large enough, or below all."""
    if free is not None and len(handles) <= MOST_IN_PANEL:
        free.legend(handles=handles, loc="center left", fontsize=8, frameon=False,
                    bbox_to_anchor=(-0.12, 0.5))
    else:
        add_legend(figure, handles)


def error_panels(table):
    """One for each field, if the members differ in resolution."""
    fields = sorted(table.fields, key="position".__eq__) if table.refinement else []
    return [partial(draw_errors, field=field, table=table) for field in fields]


def draw(folder, table, profiles, below):
    """Profiles above, and the panels `below`, which take axes and the summary."""
    # The first that has one: a run that was killed does not.
    summary = read_summary(min((member.folder for member in profiles.members),
                               key=lambda own: not (own / "summary.json").exists()))
    figure, grid = make_grid(2 if below else 1, max(len(profiles.fields), len(below), 1))
    arrange(figure, grid, (4.2, 2.9), (0.85, 0.6))
    for axes, name in zip(grid[0], profiles.fields):
        profiles.draw(axes, name, summary)
    for axes, panel in zip(grid[-1], below):
        panel(axes, summary=summary)
    for axes in grid[-1][len(below):] if below else ():
        axes.axis("off")
    free = list(grid[0][len(profiles.fields):])
    for axes in free:
        axes.axis("off")
    place_legend(figure, free[0] if free else None,
                 profiles.handles() + note_handles(table, below))
    save(figure, f"{summary['name']}\n{subtitle(table, profiles)}", folder / "compare.png", 0.12)
