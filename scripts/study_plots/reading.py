"""The tables of a study."""
import array
import csv
import re
import sys

import numpy


def read_heading(folder):
    """Name and units of the study: study.yaml is written first, study.md last."""
    for name, pattern in (("study.yaml", r'^name: "?([^"\n]+)'), ("study.md", r"^# (.+)")):
        path = folder / name
        text = path.read_text(errors="replace")[:10000] if path.exists() else ""
        found = re.search(pattern, text, re.MULTILINE)
        if found:
            return found[1], "SI" if re.search(r"\bunits: \"?SI\b", text) else "none"
    return folder.resolve().name, "none"


def read_rows(folder):
    """The rows of study.csv; none for a study that ended at the check-up of its points."""
    path = folder / "study.csv"
    if not path.exists() and not (folder / "check_up.csv").exists():
        sys.exit(f"{folder}: there is no study.csv")
    if not path.exists():
        return []
    with path.open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def with_numbers(rows):
    """Rows of a study of operators with numbers for what are numbers."""
    return [{**row, "resolution": int(row["resolution"]), "error": float(row["error"])}
            for row in rows]


def read_points(path, starts, wanted):
    """The wanted columns of the rows with one of the starts: {(layout, operator): {name: values}}.

    Names have no commas in them, and most rows of a long file are not wanted.
    """
    if not path.exists():
        return {}
    tables = {}
    with path.open(encoding="utf-8") as file:
        header = file.readline().rstrip("\n").split(",")
        names = [name for name in header if re.fullmatch(wanted, name)]
        columns, operator = [header.index(name) for name in names], header.index("operator")
        for line in file:
            if line.startswith(starts):
                cells = line.split(",")
                table = tables.setdefault((cells[0], cells[operator]), array.array("d"))
                table.extend([float(cells[k]) for k in columns])
    return {key: dict(zip(names, numpy.array(table).reshape(-1, len(names)).T))
            for key, table in tables.items()}


def in_order(items):
    return list(dict.fromkeys(items))
