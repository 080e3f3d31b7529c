#!/usr/bin/python3
"""The dam break of benchmark-peers in PySPH, from the same particles.

pysph_dam_break.py CASE POINTS RESULT [PySPH's own options]

CASE is a JSON file with dimension, spacing, density, sound_speed, gravity, alpha, step, and steps
before and under the clock. POINTS is what `mote export` writes; body 0 is the fluid. Steps are
timed one by one, without what comes before the first.
"""
import json
import pathlib
import sys
import time

import numpy
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array_wcsph
from pysph.solver.application import Application
from pysph.sph.integrator import PECIntegrator
from pysph.sph.scheme import WCSPHScheme

H_DX = 1.3


def arrays_of(case, points):
    """The particle arrays `fluid` and `wall`."""
    with open(points) as file:
        names = file.readline().strip().split(",")
        columns = dict(zip(names, numpy.loadtxt(file, delimiter=",", unpack=True)))
    arrays = []
    for name, chosen in (("fluid", columns["body"] == 0), ("wall", columns["body"] != 0)):
        place = {axis: columns[axis][chosen] for axis in "xyz"[:case["dimension"]]}
        arrays.append(get_particle_array_wcsph(
            name=name, **place, m=case["density"] * case["spacing"]**case["dimension"],
            h=H_DX * case["spacing"], rho=columns["density"][chosen]))
    return arrays


class DamBreak(Application):
    """WCSPH as PySPH has it, with one evaluation a step."""

    def initialize(self):
        self.case = json.loads(pathlib.Path(CASE).read_text())
        self.ends = []

    def create_particles(self):
        particles = arrays_of(self.case, POINTS)
        self.scheme.setup_properties(particles)
        return particles

    def create_scheme(self):
        case = self.case
        down = {"g" + "xyz"[case["dimension"] - 1]: -case["gravity"]}
        return WCSPHScheme(["fluid"], ["wall"], dim=case["dimension"], rho0=case["density"],
                           c0=case["sound_speed"], h0=H_DX * case["spacing"], hdx=H_DX,
                           alpha=case["alpha"], beta=0.0, gamma=7.0, hg_correction=True, **down)

    def configure_scheme(self):
        case = self.case
        self.scheme.configure_solver(kernel=WendlandQuintic(dim=case["dimension"]),
                                     integrator_cls=PECIntegrator, dt=case["step"],
                                     tf=1.0, adaptive_timestep=False)

    def post_step(self, solver):
        self.ends.append(time.perf_counter())


def main():
    case = json.loads(pathlib.Path(CASE).read_text())
    app = DamBreak(fname="dam_break")
    app.run(sys.argv[4:] + ["--openmp", "--disable-output", "--quiet",
                            "--max-steps", str(case["warm_steps"] + case["timed_steps"])])
    fluid = app.particles[0]
    speed = float(numpy.sqrt(fluid.u**2 + fluid.v**2 + fluid.w**2).max())
    result = {"particles": sum(array.get_number_of_particles() for array in app.particles),
              "steps": len(app.ends) - case["warm_steps"],
              "seconds": app.ends[-1] - app.ends[case["warm_steps"] - 1],
              "time": app.solver.t, "highest_speed": speed}
    pathlib.Path(RESULT).write_text(json.dumps(result))


if __name__ == "__main__":
    CASE, POINTS, RESULT = sys.argv[1:4]
    main()
