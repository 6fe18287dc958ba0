"""Many bodies: sparse matrices along a tree of joints are the dense ones by complete pivoting.

Both are exact algebra of well-conditioned small systems: characteristic polynomials and loads agree to 1e-9.
"""

from pathlib import Path

import numpy as np
import pytest

import eom
from eom.assembly import pivots as choice
from eom.assembly.algebra import Algebra
from eom.assembly.matrices import Matrices, assemble_matrices
from eom.assembly.pivots import choose_coordinates, complete
from eom.assembly.reduction import full
from eom.assembly.sparse import SPARSE
from eom.assembly.state_space import StateSpace, state_space
from eom.report.summary import summary
from eom.vehicle.elements import GROUND, Constraint, Elastic, System, Vector
from tests.assembly.systems import EMPTY, X, Y, Z, body, characteristic, diagonal, line, linear, measure, point, push
from tests.assembly.systems import transfer as transfer_function

RELATIVE = 1e-9
RATES = (0.3 + 2.0j, -0.2 + 5.0j, 1.5 + 0.0j)


def ladder(rungs: int, *, speed: float = 0.0, doubled: bool = False) -> System:
    """Two chains of hinged bodies side by side, tied by ball-ended rods, so that every rung closes a loop."""
    velocity: Vector = (speed, 0.0, 0.0)
    inertia = diagonal(0.1, 0.2, 0.25)
    bodies = tuple(
        body(f"b{k}_{side}", (k + 0.5, float(side), 0.1 * k), 1.0 + 0.1 * k, inertia, velocity)
        for k in range(rungs)
        for side in (0, 1)
    )
    joints: list[Constraint] = []
    springs: list[Elastic] = []
    for k in range(rungs):
        for side in (0, 1):
            here, place = 2 * k + side, (float(k), float(side), 0.1 * k - 0.05)
            before = here - 2 if k else GROUND
            joints.append(Constraint(point((here, before), place, 3, 2, Y if k % 2 else Z, f"hinge {here}"), k == 0))
            twist = point((here, before), place, moments=1, axis=Y if k % 2 else Z, name=f"spring {here}")
            springs.append(
                Elastic(twist, (0.0, 400.0 + here), (0.0, 2.0)) if k else Elastic(twist, (0.0, 1e3), (0.0, 0.0))
            )
        if k % 2:
            rod = line((2 * k, 2 * k + 1), (k + 0.5, 0.0, 0.1 * k + 0.2), (k + 0.5, 1.0, 0.1 * k + 0.25), f"rod {k}")
            joints += [Constraint(rod)] * (2 if doubled else 1)
    last = len(bodies) - 1
    return EMPTY._replace(
        bodies=bodies,
        gravity=(0.0, 0.0, -9.81),
        constraints=tuple(joints),
        elastic=tuple(springs),
        inputs=(push(last, bodies[last].centre, X),),
        outputs=(measure(last, bodies[last].centre, Z), measure(0, bodies[0].centre, Y, "acceleration")),
    )


def by(system: System, algebra: Algebra) -> tuple[Matrices, StateSpace]:
    """Matrices and model of a system by an algebra, with the pivots that go with its size."""
    pivots = choose_coordinates(system, algebra)
    matrices = assemble_matrices(system, pivots, algebra)
    return matrices, state_space(system, matrices, *complete(system, matrices, pivots))


@pytest.mark.parametrize(("speed", "doubled"), [(0.0, False), (12.0, False), (0.0, True)])
def test_tree_and_sparse_give_what_complete_pivoting_and_dense_give(
    speed: float, doubled: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At rest, moving, and with joints that repeat each other."""
    system = ladder(5, speed=speed, doubled=doubled)
    few = linear(system)
    monkeypatch.setattr(choice, "MANY_BODIES", 0)
    matrices, model = by(system, SPARSE)
    for name in ("M", "C", "K", "V", "J", "H"):
        expected = getattr(few.matrices, name)
        np.testing.assert_allclose(full(getattr(matrices, name)), expected, atol=RELATIVE * np.max(np.abs(expected)))
    statics, expected_statics = matrices.statics, few.matrices.statics
    size = np.max(np.abs(expected_statics.reactions))
    np.testing.assert_allclose(statics.reactions, expected_statics.reactions, atol=RELATIVE * size)
    np.testing.assert_allclose(statics.tensions, expected_statics.tensions, atol=RELATIVE * size)
    assert statics.indefinite.tolist() == expected_statics.indefinite.tolist()
    assert len(model.A) == len(few.model.A)
    for s in RATES:
        np.testing.assert_allclose(characteristic(model.A, s), characteristic(few.model.A, s), rtol=1e-8)
        np.testing.assert_allclose(transfer_function(model, s), transfer_function(few.model, s), rtol=1e-8)


def chain_text(count: int, *, twice: bool = False) -> str:
    """A file with a chain of hinged bodies under torsion springs."""
    lines = ["name: chain", "gravity: 9.81", "bodies:"]
    lines += [f"  b{k}: {{mass: 1, at: [{k}.5, 0, 0], inertia: {{xx: 0.1, yy: 0.2, zz: 0.2}}}}" for k in range(count)]
    lines.append("connectors:")
    for k in range(count):
        ends = f"between: [b{k}, {f'b{k - 1}' if k else 'ground'}]"
        hinge = f"{{type: rigid_point, {ends}, at: [{k}, 0, 0], forces: 3, moments: 2, axis: [0, 1, 0]}}"
        lines += [f"  h{k}: {hinge}"] + ([f"  again{k}: {hinge}"] if twice and k == 3 else [])
        lines.append(f"  s{k}: {{type: torsion_spring, {ends}, ends: [[{k}, 0, 0], [{k}, 1, 0]], stiffness: 1e6}}")
    return "\n".join(lines) + "\n"


def test_a_file_of_many_bodies_is_checked_built_and_told_apart(tmp_path: Path) -> None:
    """Seventy bodies: the last hinge's spring carries the last body, the first one all of them."""
    vehicle = eom.loads(chain_text(70))
    assembly = eom.assemble(vehicle)
    model = eom.linearise(assembly)
    assert model.A.shape == (140, 140)
    tensions = dict(zip(assembly.elastic_rows, assembly.matrices.statics.tensions, strict=True))
    largest = 9.81 * 70 * 35
    # levers of up to seventy bodies cost as many digits as the cube of their number has
    np.testing.assert_allclose(abs(tensions["s0"]), largest, rtol=1e-7)
    np.testing.assert_allclose(abs(tensions["s69"]), 9.81 * 0.5, atol=1e-7 * largest)
    E, A, _, _ = assembly.descriptor
    np.testing.assert_allclose(np.linalg.solve(E, A), model.A, atol=1e-7 * np.max(np.abs(model.A)))
    assert eom.write_module(assembly, tmp_path).exists()
    assert "none redundant" in summary(assembly)
    assert "5 redundant (h3 with again3)" in summary(eom.assemble(eom.loads(chain_text(70, twice=True))))
