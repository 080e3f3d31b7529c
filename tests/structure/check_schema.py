#!/usr/bin/python3
"""Every scenario fits the JSON Schema that mote prints, and wrong ones do not: MOTE SCENARIOS."""
import copy
import json
import pathlib
import subprocess
import sys

import jsonschema
import yaml


def wrong_ones(good):
    """Copies of a good scenario, each with one mistake."""
    def changed(change):
        scenario = copy.deepcopy(good)
        change(scenario)
        return scenario

    yield "unknown key", changed(lambda s: s.update(partcles={}))
    yield "missing key", changed(lambda s: s.pop("particles"))
    yield "unknown key in a section", changed(lambda s: s["time"].update(stop=1))
    yield "negative count", changed(lambda s: s["particles"].update(count=-1))
    yield "text for a section", changed(lambda s: s.update(domain="here"))
    yield "unknown model", changed(lambda s: s["model"].update(type="solid"))
    yield "unknown kernel", changed(lambda s: s.update(operator={"family": "sph", "kernel": "x"}))
    yield "kernel for mps", changed(lambda s: s.update(operator={"family": "mps", "kernel": "lucy"}))


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    schema = json.loads(subprocess.run([program, "schema"], capture_output=True, check=True).stdout)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    files = sorted(folder.rglob("*.yaml"))
    assert files, f"no scenarios in {folder}"
    for file in files:
        scenario = yaml.safe_load(file.read_text())
        errors = [f"{file}: {error.message}" for error in validator.iter_errors(scenario)]
        assert not errors, "\n".join(errors)
    for what, scenario in wrong_ones(scenario):
        assert not validator.is_valid(scenario), f"the schema accepts: {what}"
    print(f"{len(files)} scenarios fit the schema, 8 wrong ones do not")


if __name__ == "__main__":
    main()
