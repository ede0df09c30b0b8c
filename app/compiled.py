"""The engine as it is compiled, whose cache is made once an installation.

Run as a module it makes the cache, as `make run`, `make test` and the image do. Processes for
calculations read it as they start; where there is none, or a broken one, the first of them makes
it, and the others wait for that.
"""

import fcntl
import logging

LOG = logging.getLogger("khv.compiled")


def load() -> None:
    """Calculate with the compiled engine from now on: read from its cache or compiled now, in
    memory where it cannot be written; without numba with the engine as it is.
    """
    from core.output import compiled

    with open(__file__) as lock:

        def say(text: str) -> None:
            LOG.warning(text)
            fcntl.flock(lock, fcntl.LOCK_EX)

        try:
            compiled.load(say)
        except ImportError:
            LOG.warning("numba is not installed: the load sharing is calculated fifty times slower")
        else:
            _turn()


def _turn() -> None:
    """Call the loops over pins in holes, which are compiled with their first call."""
    from core.hertz import ElasticMaterial
    from core.output.elasticity import LinearLaw
    from core.output.mechanism import Mechanism
    from core.output.over_turn import over_turn
    from core.output.real_mechanism import RealMechanism
    from core.tolerance.study import Evaluation, Study, tolerance_study
    from core.tolerance.tolerances import Tolerances

    steel = ElasticMaterial(210e9, 0.3)
    real = RealMechanism(
        mechanism=Mechanism.evenly_spaced(pins=3, satellites=1, ratio=18.0),
        pin_circle_radius=0.02,
        pin_radius=0.003,
        eccentricity=0.0015,
        contact_length=0.01,
        law=LinearLaw(5e7),
        pin_material=steel,
        hole_material=steel,
    )
    assert over_turn(real=real, output_torque=30.0).lost_motion > 0
    asked = Evaluation(("peak_force",), 30.0, positions=4)
    tolerance_study(Study(real, Tolerances(pin_position=1e-5), asked, samples=2))


if __name__ == "__main__":
    logging.basicConfig(level=logging.INFO, format="%(message)s")
    load()
