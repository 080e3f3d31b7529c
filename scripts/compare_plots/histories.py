"""The upper panels of compare.png for runs in two and three dimensions: what changes with time."""
import math

from compare_plots.picture import MOST_MARKERS, Profiles, line_style
from compare_plots.work_precision import compares_work
from run_plots.flow import observed
from run_plots.reading import label, read_columns, read_dimension, read_summary, read_time

MOST_PANELS = 4
DRIFT = "relative drift of energy"


def values_of(history, name):
    """A column, or how far the energy has gone from its first value; NaN where it has not."""
    if name != DRIFT:
        return history[name]
    energy = history["energy"]
    return [abs(value / (energy[0] or math.nan) - 1) or math.nan for value in energy]


def last_snapshots(member):
    return sorted((member.folder / "snapshots").glob("*.hdf"))[-1:]


def live_in_space(table):
    """Whether the members have no line along which their fields could be drawn."""
    return any(read_dimension(path) > 1 for member in table.finest()
               for path in last_snapshots(member))


class Histories(Profiles):
    """The histories of the members that reached the end, at the finest resolution."""

    shown = "histories up to"

    def __init__(self, table):
        self.table, self.members, self.exact = table, table.finest(), {}
        self.snapshots = {k: (read_time(*last_snapshots(member)),
                              read_columns(member.folder / "history.csv"))
                          for k, member in enumerate(self.members) if not member.failed}
        summary = read_summary(self.members[min(self.snapshots, default=0)].folder)
        groups = [observed(shot[1], summary) for shot in self.snapshots.values()]
        names = [name for columns in (groups[0].values() if groups else ()) for name in columns]
        self.fields = [name for name in names
                       if all(name in shot[1] for shot in self.snapshots.values())][:MOST_PANELS]
        if compares_work(table):
            self.fields = [DRIFT] + self.fields[:MOST_PANELS - 1]

    def draw(self, axes, name, summary):
        for k, (_, history) in self.snapshots.items():
            every = math.ceil(len(history["time"]) / MOST_MARKERS)
            axes.plot(history["time"], values_of(history, name), markevery=every, zorder=3,
                      **line_style(k, len(self.members), 1.0))
        if name == DRIFT or name.endswith("_error"):
            axes.set_yscale("log")
        axes.set_ylabel(name)
        axes.set_xlabel(label("t", "s", summary))
        axes.grid(color="0.92")
