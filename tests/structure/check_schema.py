#!/usr/bin/python3
"""Every scenario and study fits the JSON Schema that mote prints, and wrong ones do not.

check_schema.py MOTE SCENARIOS
"""
import copy
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml


def changer(good):
    """A function that returns the good file with one change."""
    def changed(change):
        file = copy.deepcopy(good)
        change(file)
        return file

    return changed


def wrong_scenarios(good):
    """Copies of a good scenario, each with one mistake."""
    changed = changer(good)
    yield "unknown key", changed(lambda s: s.update(partcles={}))
    yield "missing key", changed(lambda s: s.pop("model"))
    yield "unknown key in a section", changed(lambda s: s["time"].update(stop=1))
    yield "negative count", changed(lambda s: s["particles"].update(count=-1))
    yield "text for a section", changed(lambda s: s.update(domain="here"))
    yield "unknown model", changed(lambda s: s["model"].update(type="solid"))
    yield "unknown kernel", changed(lambda s: s.update(operator={"family": "sph", "kernel": "x"}))
    yield "one value to vary", changed(lambda s: s.update(compare={"vary": {"operator": "mps"}}))
    yield "no value to vary", changed(lambda s: s.update(compare={"vary": {"operator": []}}))
    yield "unknown norm", changed(lambda s: s.update(compare={"expect": [{"norm": "l3"}]}))
    yield "kernel for mps", changed(lambda s: s.update(operator={"family": "mps", "kernel": "lucy"}))


def wrong_studies(good):
    """Copies of a good study, each with one mistake."""
    changed = changer(good)
    yield "unknown key", changed(lambda s: s.update(layout=[]))
    yield "missing key", changed(lambda s: s.pop("operators"))
    yield "no operators", changed(lambda s: s.update(operators=[]))
    yield "a word for the operators", changed(lambda s: s.update(operators="mps"))
    yield "unknown key in an item", changed(lambda s: s["operators"].append({"familly": "mps"}))
    yield "unknown layout", changed(lambda s: s["layouts"].append({"type": "square"}))
    yield "unknown quantity", changed(lambda s: s.update(quantities=["slope"]))
    yield "operators and interpolation", changed(lambda s: s.update(interpolation={}))


def wrong_stationary(good):
    """Copies of a good file of a model without time, each with one mistake."""
    changed = changer(good)
    yield "unknown key", changed(lambda s: s.update(time={"end": 1}))
    yield "missing key", changed(lambda s: s.pop("particles"))
    yield "unknown potential", changed(lambda s: s["model"].update(potential="box"))
    yield "one node", changed(lambda s: s["particles"].update(count=1))


def check(program, of, files, wrong_ones):
    """Checks the schema of one kind of file; returns how many good and wrong ones there were."""
    printed = subprocess.run([program, "schema", of], capture_output=True, check=True).stdout
    schema = json.loads(printed)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    assert files, f"there is no {of}"
    for file in files:
        good = yaml.safe_load(file.read_text())
        errors = [f"{file}: {error.message}" for error in validator.iter_errors(good)]
        assert not errors, "\n".join(errors)
    wrong = list(wrong_ones(good))
    for what, file in wrong:
        assert not validator.is_valid(file), f"the schema of a {of} accepts: {what}"
    print(f"{of}: {len(files)} fit the schema, {len(wrong)} wrong ones do not")


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    files = sorted(folder.rglob("*.yaml"))
    studies = [file for file in files if file.parent.name == "studies"]
    stationary = [file for file in files if file.parent.name == "quantum"]
    scenarios = [file for file in files if file not in studies + stationary]
    check(program, "scenario", scenarios, wrong_scenarios)
    check(program, "study", studies, wrong_studies)
    check(program, "stationary", stationary, wrong_stationary)


if __name__ == "__main__":
    main()
