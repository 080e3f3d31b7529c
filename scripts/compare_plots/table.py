"""compare.csv: the members of a comparison, sorted into lines of the picture."""
import csv
import math
import sys

REFINEMENT = ("particles.count", "time.step", "time.tolerance")
FALLING = REFINEMENT[1:]  # finer where they are smaller


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


class Member:
    """A row of the table with its own folder."""

    def __init__(self, folder, row, keys, refinement):
        self.folder, self.row = folder / row["folder"], row
        self.values = [row[key] for key in keys if key != refinement]
        self.resolution = self.read_resolution(refinement)

    def read_resolution(self, refinement):
        """Particles, or the step; an expression in the file is known by what came of it."""
        if refinement is None:
            return math.nan
        given = number(self.row[refinement])
        if not math.isnan(given) or refinement == "time.tolerance":
            return given
        if refinement == "particles.count":
            return number(self.row["particles"])
        return number(self.row["time"]) / (number(self.row["steps"]) or math.nan)

    def error(self, field):
        return number(self.row[f"{field}_l2"])

    def size(self, column):
        """The magnitude of an error or a drift."""
        return abs(number(self.row[column]))

    @property
    def evaluations(self):
        return number(self.row["evaluations"])

    @property
    def failed(self):
        return bool(self.row["failure"])


class Table:
    """Members in lines: those that differ in resolution alone, the coarsest first."""

    def __init__(self, folder, rows, columns):
        keys = self.all_keys = columns[:columns.index("time")]
        self.columns = columns
        found = [key for key in REFINEMENT
                 if key in keys and len({row[key] for row in rows}) > 1]
        self.refinement = found[0] if found else None
        self.keys = [key for key in keys if key != self.refinement]
        self.fields = [name[:-3] for name in columns if name.endswith("_l2")]
        self.lines = {}
        for row in rows:
            member = Member(folder, row, keys, self.refinement)
            self.lines.setdefault(tuple(member.values), []).append(member)
        for members in self.lines.values():
            members.sort(key=lambda m: m.resolution, reverse=self.refinement in FALLING)

    def words(self, values):
        """The values of a line, and which of its members failed when."""
        failed = [(member.row["time"], f" ({member.resolution:g})" * bool(self.refinement))
                  for member in self.lines[values] if member.failed]
        times = ", ".join(f"{float(time):.4g}{at}" for time, at in failed if time)
        lost = ", ".join(f"no result{at}" for time, at in failed if not time)
        words = [f"failed at t = {times}"] * bool(times) + [lost] * bool(lost)
        return ": ".join([", ".join(values) or "mote"] + ["; ".join(words)] * bool(words))

    def resolutions(self):
        """All there are, the coarsest first."""
        return sorted({member.resolution for members in self.lines.values() for member in members},
                      reverse=self.refinement in FALLING)

    def finest(self):
        return [members[-1] for members in self.lines.values()]


def read_table(folder):
    path = folder / "compare.csv"
    if not path.exists():
        sys.exit(f"{folder}: there is no compare.csv")
    with path.open(encoding="utf-8", newline="") as file:
        reader = csv.DictReader(file)
        rows = list(reader)
    if not rows:
        sys.exit(f"{path}: no member has ended")
    return Table(folder, rows, reader.fieldnames)
