"""Laws 4, 5 and 7 on the shipped vehicles."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import eom
from tests.assembly.systems import linear, moved
from tests.vehicles.shipped import LINEAR, NAMES, TRAINS, vehicle


@pytest.mark.parametrize("name", NAMES)
def test_building_twice_gives_identical_matrices_and_changes_nothing(name: str) -> None:
    car = vehicle(name)
    before = repr(car.system), dict(car.values)
    first, second = eom.linearise(car), eom.linearise(car)
    again = eom.linearise(vehicle(name))
    for matrix in "ABCD":
        assert np.array_equal(getattr(first, matrix), getattr(second, matrix))
        assert np.array_equal(getattr(first, matrix), getattr(again, matrix))
    assert (repr(car.system), dict(car.values)) == before


@pytest.mark.parametrize("name", NAMES)
def test_cyclic_coordinates_have_roots_of_exactly_zero(name: str) -> None:
    model = eom.linearise(vehicle(name))
    modes = model.modes()
    count = len(model.cyclic)
    assert np.all(modes.eigenvalues[:count] == 0.0)
    outside = np.setdiff1d(np.arange(len(model.A)), model.cyclic)
    assert np.all(model.A[outside][:, list(model.cyclic)] == 0.0)
    # LAPACK's permutation isolates them as well: the whole matrix has these exact zeros too
    assert np.sum(np.linalg.eigvals(model.A) == 0.0) >= count


@pytest.mark.parametrize("name", TRAINS)
def test_trains_have_position_and_heading_as_cyclic_coordinates(name: str) -> None:
    model = eom.linearise(vehicle(name))
    assert [model.states[k] for k in model.cyclic] == ["tractor_frame.y", "tractor_frame.yaw"]


@pytest.mark.parametrize("name", NAMES)
def test_reduced_equations_satisfy_every_constraint(name: str) -> None:
    assembly = eom.assemble(vehicle(name))
    N = len(assembly.M)
    p, w = assembly.R[:N], assembly.R[N:]
    size = max(1.0, float(np.max(np.abs(assembly.R))))
    # rounding of one linear solve, relative to the largest entry
    assert np.max(np.abs(assembly.J @ p), initial=0.0) < 1e-12 * size
    assert np.max(np.abs(assembly.J @ (w - assembly.V @ p)), initial=0.0) < 1e-11 * size
    assert np.max(np.abs(assembly.Jn @ w), initial=0.0) < 1e-12 * size
    reactions = np.vstack([assembly.J, assembly.Jn])
    assert np.max(np.abs(reactions @ assembly.L[N:]), initial=0.0) < 1e-12 * size


@pytest.mark.parametrize("name", LINEAR)
def test_the_descriptor_form_has_the_state_spaces_roots(name: str) -> None:
    """The ratio of det(s E - A) to det(s I - A) is one number for all s, also where E is singular for want of mass."""
    assembly = eom.assemble(vehicle(name))
    E, A, _, _ = assembly.descriptor
    model = eom.linearise(assembly)
    ratios = []
    for s in (0.3 + 4.4j, 1.1 - 9.0j, 6.0 + 2.0j):
        sign_1, size_1 = np.linalg.slogdet(s * E - A)
        sign_2, size_2 = np.linalg.slogdet(s * np.eye(len(model.A)) - model.A)
        ratios.append((sign_1 / sign_2, size_1 - size_2, abs(size_1) + abs(size_2)))
    for sign, size, scale in ratios[1:]:
        # rounding of two determinants
        assert abs(sign - ratios[0][0]) < 1e-8
        assert abs(size - ratios[0][1]) < 1e-9 * scale


@pytest.mark.parametrize("name", ["quarter_car", "b_train_yaw_roll", "full_car", "four_bar", "a_train"])
def test_without_dampers_and_tyres_energy_is_kept(name: str) -> None:
    system = vehicle(name).system
    conservative = system._replace(
        slip=(),
        elastic=tuple(item._replace(damping=(0.0, 0.0)) for item in system.elastic),
        bodies=tuple(body._replace(velocity=(0.0, 0.0, 0.0)) for body in system.bodies),
        outputs=(),
        inputs=(),
    )
    model = linear(conservative).model
    roots = np.linalg.eigvals(model.A)
    # double zero roots of free motions split by the square root of rounding
    assert np.max(np.abs(roots.real)) < 1e-6 * np.max(np.abs(roots))


@pytest.mark.parametrize("name", LINEAR)
def test_turning_the_drawing_with_everything_on_it_changes_no_root_and_no_transfer_function(name: str) -> None:
    system = vehicle(name).system
    rotation = Rotation.from_euler("zyx", [37.0, 20.0, -11.0], degrees=True).as_matrix()
    turned = moved(system, rotation, np.array([3.0, -2.0, 5.0]))
    responses = []
    for item in (system, turned):
        A, B, C, D = linear(item).model
        s = 2j * np.pi * 0.4
        responses.append(C @ np.linalg.solve(s * np.eye(len(A)) - A, B) + D)
    scale = np.max(np.abs(responses[0]), axis=1, keepdims=True)
    # other pivots, hence other rounding
    assert np.max(np.abs(responses[0] - responses[1]) / scale) < 1e-9
