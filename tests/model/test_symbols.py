"""Matrices in symbols: they are the numeric ones at any values, and the formulas of textbooks."""

from collections.abc import Sequence

import numpy as np
import pytest
import sympy
from sympy.physics import mechanics

import eom
from eom.model.symbolic import SymbolicAssembly
from tests.vehicles.shipped import LINEAR, vehicle

FULL = ("M", "C", "K", "V", "J", "Jn", "H", "H_slip", "D_slip", "F", "G")
REDUCED = ("E", "A", "B", "B_rate")
# closed loops in space, whose solution in hundreds of symbols has no end: these are asked for some
SOME = {
    "double_wishbone_car": ("U", "chassis.mass", "k_f"),
    "strut_suspension": ("U", "C_x", "chassis.mass", "k_s"),
}


def assert_matrices(own: SymbolicAssembly, numeric: eom.model.Assembly, names: Sequence[str], digits: float) -> None:
    """The matrices at the values of another assembly are those of that assembly."""
    descriptor = numeric.descriptor
    for name in names:
        expected = np.asarray(getattr(descriptor if name in REDUCED else numeric.matrices, name))
        got = own.numbers(getattr(own, name), numeric)
        assert got.shape == expected.shape
        scale = np.max(np.abs(expected), initial=0.0)
        np.testing.assert_allclose(got, expected, rtol=0.0, atol=digits * scale + 1e-300, err_msg=name)


@pytest.mark.parametrize("name", LINEAR)
def test_at_the_trim_matrices_in_symbols_are_the_numeric_ones_and_preloads_satisfy_their_equations(name: str) -> None:
    car = vehicle(name)
    own = eom.assemble(car, symbols=SOME.get(name, "all"))
    # exact arithmetic against double precision
    assert_matrices(own, own.numeric, (*FULL, *REDUCED), 1e-12)
    point = own.point(own.numeric)
    largest = max((abs(float(point[symbol])) for symbol in own.preloads.values()), default=0.0)
    for equation in own.equilibrium:
        rest = (equation.lhs - equation.rhs).xreplace(point)
        # preloads are floats of double precision; moments in a suspension are their products with arms of metres
        assert abs(float(rest)) <= 1e-9 * max(largest, 1.0)


CHANGED: dict[str, dict[str, str | float]] = {
    "b_train_yaw_roll": {
        "U": "70 km/h",
        "h_r": 0.8,
        "gravity": 9.81,
        "tractor_frame.mass": 7000.0,
        "semitrailer_1.K_r": 1.5e6,
        "semitrailer_2_axles.inertia.xx": 900.0,
        "trailer_1.cornering": 5.0e5,
    },
    "b_train_yaw_plane": {"U": 15.0, "semitrailer_1_frame.at.x": -6.0, "drive.cornering": 3e5},
    "full_car": {"car_body.mass": 1500.0, "t_f": 0.8, "h": 0.6},
    "motorcycle": {"U": 12.0, "tilt": 0.4, "rear_frame.mass": 200.0},
}


@pytest.mark.parametrize("name", CHANGED)
def test_other_values_of_the_symbols_give_the_matrices_of_the_vehicle_with_these_values(name: str) -> None:
    car = vehicle(name)
    own = eom.assemble(car, symbols="all")
    other = eom.assemble(car.with_values(**CHANGED[name]))
    assert other.pivots == own.numeric.pivots
    assert_matrices(own, other, (*FULL, *REDUCED), 1e-12)


@pytest.mark.parametrize("name", ["b_train_yaw_plane", "motorcycle", "quarter_car", "truck_full_trailer"])
def test_where_statics_tells_every_load_its_formula_holds_at_other_values(name: str) -> None:
    car = vehicle(name)
    own = eom.assemble(car, symbols="all")
    changed: dict[str, str | float] = {name: 1.1 * car.values[name] for name in own.symbols if name.endswith(".mass")}
    other = eom.assemble(car.with_values(**changed))
    point = own.point(other)
    parameters = {symbol: point[symbol] for symbol in own.symbols.values()}
    assert set(own.formulas) == set(own.preloads.values())
    assert own.formulas
    for load, formula in own.formulas.items():
        assert float(formula.xreplace(parameters).evalf(20)) == pytest.approx(float(point[load]), rel=1e-11)


def test_where_springs_share_a_load_the_equations_determine_it() -> None:
    own = eom.assemble(vehicle("full_car"), symbols=("car_body.mass",))
    unknown = list(own.preloads.values())
    point = own.point(own.numeric)
    numbers = {symbol: value for symbol, value in point.items() if symbol not in unknown}
    system = [(equation.lhs - equation.rhs).xreplace(numbers) for equation in own.equilibrium]
    (solution,) = sympy.linsolve(system, unknown)
    for symbol, value in zip(unknown, solution, strict=True):
        assert not value.free_symbols
        assert float(value) == pytest.approx(float(point[symbol]), rel=1e-9)


def symbol(own: SymbolicAssembly, *names: str) -> tuple[sympy.Symbol, ...]:
    """Symbols of parameters."""
    return tuple(own.symbols[name] for name in names)


def test_a_quarter_car_has_the_matrices_of_textbooks() -> None:
    own = eom.assemble(vehicle("quarter_car"), symbols="all")
    assert own.numeric.independent == ("sprung.z", "unsprung.z", "sprung.v_z", "unsprung.v_z")
    m_s, m_u, k_s, c_s, k_t, c_t = symbol(own, "sprung.mass", "unsprung.mass", "k_s", "c_s", "k_t", "c_t")
    mass = sympy.diag(m_s, m_u)
    stiffness = sympy.Matrix([[k_s, -k_s], [-k_s, k_s + k_t]])
    damping = sympy.Matrix([[c_s, -c_s], [-c_s, c_s + c_t]])
    assert sympy.diag(sympy.eye(2), mass) == own.E
    assert sympy.Matrix(sympy.BlockMatrix([[sympy.zeros(2), sympy.eye(2)], [-stiffness, -damping]])) == own.A
    assert sympy.Matrix([0, 0, 0, k_t]) == own.B
    assert own.B_rate == sympy.Matrix([0, 0, 0, c_t])


def test_a_pendulum_on_a_cart_has_the_equations_that_lagrange_gives() -> None:
    own = eom.assemble(vehicle("pendulum_cart"), symbols="all")
    assert own.numeric.independent == ("cart.x", "pendulum.pitch", "cart.v_x", "pendulum.pitch_rate")
    M, m, b, inertia, arm, g = symbol(own, "M", "m", "b", "I", "l", "gravity")
    x, angle = mechanics.dynamicsymbols("x angle")
    frame, origin = mechanics.ReferenceFrame("N"), mechanics.Point("O")
    origin.set_vel(frame, 0)
    turned = frame.orientnew("P", "Axis", (angle, frame.y))
    pivot = origin.locatenew("pivot", x * frame.x)
    pivot.set_vel(frame, x.diff() * frame.x)
    centre = pivot.locatenew("centre", arm * turned.z)
    centre.v2pt_theory(pivot, frame, turned)
    cart = mechanics.Particle("cart", pivot, M)
    rod = mechanics.RigidBody("rod", centre, turned, m, (mechanics.inertia(turned, 0, inertia, 0), centre))
    rod.potential_energy = m * g * arm * sympy.cos(angle)
    friction = [(pivot, -b * x.diff() * frame.x)]
    lagrange = mechanics.LagrangesMethod(
        mechanics.Lagrangian(frame, cart, rod), [x, angle], forcelist=friction, frame=frame
    )
    lagrange.form_lagranges_equations()
    at_rest = {angle: 0, x.diff(): 0, angle.diff(): 0}
    mass, forcing = (part.subs(at_rest) for part in (lagrange.mass_matrix, lagrange.forcing.jacobian([x, angle])))
    rates = lagrange.forcing.jacobian([x.diff(), angle.diff()]).subs(at_rest)
    assert sympy.simplify(own.E[2:, 2:] - mass) == sympy.zeros(2)
    assert sympy.simplify(own.A[2:, :2].xreplace(own.formulas) - forcing) == sympy.zeros(2)
    assert sympy.simplify(own.A[2:, 2:] - rates) == sympy.zeros(2)


def test_only_the_parameters_that_were_asked_for_are_symbols() -> None:
    own = eom.assemble(vehicle("b_train_yaw_plane"), symbols=("U", "drive.cornering"))
    U, C = symbol(own, "U", "drive.cornering")
    assert own.D_slip[1, 1] == C / U
    assert own.D_slip[0, 0] == 424000 / U
    assert own.A.free_symbols == {U, C}


def test_one_name_may_stand_alone() -> None:
    assert eom.assemble(vehicle("quarter_car"), symbols="k_s").A.free_symbols == {sympy.Symbol("k_s")}


def test_a_computed_parameter_is_expressed_by_those_that_it_is_computed_from_unless_named() -> None:
    car = eom.loads("name: x\nparameters: {m: 2 kg, w: m*gravity_0, gravity_0: 9.81}\n" + FALLING)
    m, g, w = (sympy.Symbol(name) for name in ("m", "gravity_0", "w"))
    assert eom.assemble(car, symbols="all").F[2, 0] == g * m
    assert eom.assemble(car, symbols=("w",)).F[2, 0] == w


FALLING = """
bodies: {box: {mass: m, at: [0, 0, 0]}}
connectors:
  guide: {type: rigid_point, between: [box, ground], at: [0, 0, 0], forces: 2, moments: 3, axis: [0, 0, 1]}
actuators: {lift: {body: box, along: [0, 0, 1], gain: w}}
"""


def test_zero_is_structure_unless_it_is_asked_for() -> None:
    car = vehicle("b_train_yaw_plane")
    assert "tractor_frame.at.y" not in eom.assemble(car, symbols="all").symbols
    assert eom.assemble(car, symbols=("tractor_frame.at.y",)).J.free_symbols == {sympy.Symbol("tractor_frame.at.y")}


def test_unknown_symbols_are_told_all_at_once() -> None:
    with pytest.raises(eom.DescriptionError) as caught:
        eom.assemble(vehicle("bicycle"), symbols=("u", "speed", "rear_wheel.at.z"))
    first, second, third = str(caught.value).splitlines()
    assert "no symbol for 'rear_wheel.at.z': it is computed from r_rear" in first
    assert "no symbol for 'speed': there is no such parameter" in second
    assert "no symbol for 'u': there is no such parameter" in third


def test_building_twice_gives_the_same_matrices_and_changes_nothing() -> None:
    car = vehicle("car_trailer")
    before = dict(car.values)
    first, second = (eom.assemble(car, symbols="all") for _ in range(2))
    assert all(getattr(first, name) == getattr(second, name) for name in (*FULL, *REDUCED))
    assert first.equilibrium == second.equilibrium
    assert dict(car.values) == before


MEMBRANE = """
name: sheet
bodies:
  a: {mass: 1, at: [0, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}
  b: {mass: 1, at: [1, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}
  c: {mass: 1, at: [0, 1, 0], inertia: {xx: 1, yy: 1, zz: 1}}
connectors:
  sheet: {type: triangle, between: [a, b, c], corners: [[0, 0, 0], [1, 0, 0], [0, 1, 0]],
          thickness: 1 mm, modulus: 1e9, poisson: 0.3}
"""


def test_membranes_are_refused_by_name() -> None:
    with pytest.raises(eom.DescriptionError, match=r"sheet.*has no symbolic form"):
        eom.assemble(eom.loads(MEMBRANE), symbols="all")


BALANCED = """
name: box on a rail and a spring
gravity: 9.8
parameters: {m: 5 kg, F: 49 N, c: 0, b: 0, k: 200}
bodies: {box: {mass: m, at: [0.2, 0, 0], inertia: {xx: 1, yy: 1, zz: 1}}}
connectors:
  rail: {type: rigid_point, between: [box, ground], at: [0, 0, 0], forces: 2, moments: 2, axis: [0, 0, 1]}
  spring: {type: spring, between: [box, ground], ends: [[0, 0, 0], [0, 0, -1]], stiffness: k, damping: c, inertance: b}
  twist: {type: flex_point, between: [box, ground], at: [0, 0, 0], moments: 1, axis: [0, 0, 1],
          angular_stiffness: 10}
loads: {lift: {body: box, at: [0.2, 0, 0], force: [0, 0, F]}}
"""


@pytest.mark.parametrize("changed", [{"F": 30.0}, {"c": 3.0}, {"b": 2.0}, {"F": 10.0, "c": 1.0, "b": 1.0}])
def test_what_is_zero_at_the_trim_by_its_values_alone_is_kept(changed: dict[str, str | float]) -> None:
    box = eom.loads(BALANCED)
    own = eom.assemble(box, symbols=("m", "F", "c", "b", "k", "gravity"))
    assert "spring.preload" in own.preloads
    assert_matrices(own, eom.assemble(box.with_values(**changed)), (*FULL, *REDUCED), 1e-12)


ZEROS = ("b_train_yaw_plane", "car_trailer", "full_car", "truck_full_trailer")


@pytest.mark.parametrize("name", ZEROS)
def test_zero_places_asked_for_by_name_hold_at_other_values(name: str) -> None:
    car = vehicle(name)
    zeros = [key for key, value in car.values.items() if value == 0.0 and key.endswith("frame.at.y")]
    zeros = zeros or [key for key, value in car.values.items() if value == 0.0 and ".at." in key][:1]
    own = eom.assemble(car, symbols=zeros[:1])
    other = eom.assemble(car.with_values(**{zeros[0]: 0.1}))
    # exact arithmetic against double precision
    assert_matrices(own, other, FULL, 1e-11)


def test_other_values_that_load_what_carried_nothing_are_refused() -> None:
    car = vehicle("full_car", gravity=0.0)
    own = eom.assemble(car, symbols=("gravity",))
    with pytest.raises(eom.EomError, match="carry a load with these values, but none at the trim of the symbols"):
        own.numbers(own.K, eom.assemble(car.with_values(gravity=9.8)))


def test_no_symbols_are_symbolic_matrices_too() -> None:
    assert not eom.assemble(vehicle("quarter_car"), symbols=()).A.free_symbols


def test_wheels_have_no_symbolic_form_and_say_so() -> None:
    with pytest.raises(eom.DescriptionError, match=r"axles.front: has no symbolic form: slopes of its tyre"):
        eom.assemble(vehicle("b_train"), symbols="all")
