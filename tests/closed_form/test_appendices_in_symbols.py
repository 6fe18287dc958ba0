"""Law 3 in symbols: the equations that the generator derives are those of Appendices A and D, for all values.

As in `tests.closed_form.test_generator`, x = X z are the thesis's states (SAE axes) by the generated ones (ISO 8855),
and inputs change their sign. The generated equations E dz/dt = A z + B u become the thesis's, M dx/dt = P x + H u, by
row operations L: L E = M X, L A = P X and L B = H. A generated equation of motion is the sum of all forces and moments
on a motion that the couplings allow; the thesis sums them otherwise, and L says how.
"""

import sympy
from sympy.polys.matrices import DomainMatrix

import eom
from eom.closed_form import BTrainYawPlane, TractorSemitrailer, b_train_yaw_plane, tractor_semitrailer
from eom.model.symbolic import SymbolicAssembly
from tests.vehicles.shipped import vehicle

Rows = dict[str, sympy.Matrix]


def rows_of(own: SymbolicAssembly) -> Rows:
    """For each generated state or its equation the row that picks it."""
    names = own.numeric.independent
    unit = sympy.eye(len(names))
    return {name: unit[k, :] for k, name in enumerate(names)}


def columns(own: SymbolicAssembly, names: list[str]) -> sympy.Matrix:
    """Generated columns of inputs, which turn or push the other way in SAE axes."""
    inputs = [item.name for item in own.numeric.system.inputs]
    return sympy.Matrix.hstack(*(-own.B[:, inputs.index(name)] for name in names))


def assert_same_equations(
    own: SymbolicAssembly, maps: tuple[sympy.Matrix, sympy.Matrix], hand: list[sympy.Matrix], inputs: list[str]
) -> None:
    """M X dz/dt = P X z + H u is L times the generated equations, identically in every symbol; maps are X and L."""
    (X, L), (M, P, H) = maps, hand
    # what springs and joints carry cancels against the weights that it balances
    A, B = own.A.xreplace(own.formulas), columns(own, inputs)
    for generated, written in ((own.E, M * X), (A, P * X), (B, H)):
        pair = [DomainMatrix.from_Matrix(sympy.Matrix(matrix)) for matrix in (L * generated, written)]
        ours, theirs = (matrix.to_field() for matrix in pair[0].unify(pair[1]))
        assert (ours - theirs).to_Matrix().is_zero_matrix


def symbol(own: SymbolicAssembly, name: str) -> sympy.Expr:
    """The symbol of a parameter; one of value zero is zero."""
    return own.symbols.get(name, sympy.S.Zero)


def sae_states(own: SymbolicAssembly, frames: dict[int, str], U: sympy.Symbol) -> Rows:
    """Sideslip and yaw rate of each unit, and the tractor's by its own states; the sign is that of SAE axes."""
    z = rows_of(own)
    rates = {i: z[f"{frame}.yaw_rate"] for i, frame in frames.items()}
    return {f"psi_dot_{i}": -rate for i, rate in rates.items()} | {"beta_1": -z[f"{frames[1]}.v_y"] / U}


def test_the_tractor_semitrailer_has_appendix_a() -> None:
    own = eom.assemble(vehicle("tractor_semitrailer_yaw_plane"), symbols="all")
    U = own.symbols["U"]
    a11, l_c21 = -symbol(own, "tractor_frame.at.x"), -symbol(own, "semitrailer_frame.at.x")
    p = TractorSemitrailer(
        m1=symbol(own, "tractor_frame.mass"),
        m2=symbol(own, "semitrailer_frame.mass"),
        I_zz1=symbol(own, "tractor_frame.inertia.zz"),
        I_zz2=symbol(own, "semitrailer_frame.inertia.zz"),
        a11=a11,
        b12=-symbol(own, "axle_2.x") - a11,
        b23=-symbol(own, "axle_3.x") - l_c21,
        l_c1=-symbol(own, "fifth_wheel.at.tractor.x") - a11,
        l_c21=l_c21,
        C_f11=symbol(own, "front.cornering"),
        C_r12=symbol(own, "rear.cornering"),
        C_r23=symbol(own, "trailer.cornering"),
    )
    frames = {1: "tractor_frame", 2: "semitrailer_frame"}
    x, z = sae_states(own, frames, U), rows_of(own)
    articulation = z["semitrailer_frame.yaw"] - z["tractor_frame.yaw"]
    # the order of (3.6)
    X = sympy.Matrix.vstack(x["psi_dot_1"], x["psi_dot_2"] - x["psi_dot_1"], x["beta_1"], -articulation)
    # the generated motions are all units sideways, the tractor's yaw, the semitrailer's: the thesis has the same three
    dynamic = [z["tractor_frame.v_y"], z["tractor_frame.yaw_rate"], z["semitrailer_frame.yaw_rate"]]
    # it takes the semitrailer's acceleration from (3.3c), whose rate of articulation is a state by itself
    carried = [p.m2 * U * arm * articulation for arm in (1, -p.l_c1, -p.l_c21)]
    L = sympy.Matrix.vstack(*(-row - own_part for row, own_part in zip(dynamic, carried, strict=True)), -articulation)
    M, P, H1, H2, H3 = (sympy.Matrix(matrix.tolist()) for matrix in tractor_semitrailer.matrices(p, U))
    hand = [M, P, sympy.Matrix.hstack(H1, H2, H3)]
    assert_same_equations(own, (X, L), hand, ["axle_1.steer", "axle_2.steer", "axle_3.steer"])


def test_the_b_train_has_appendix_d() -> None:
    own = eom.assemble(vehicle("b_train_yaw_plane"), symbols="all")
    U = own.symbols["U"]
    a11, l_c21, l_c3 = (-symbol(own, f"{unit}_frame.at.x") for unit in ("tractor", "semitrailer_1", "semitrailer_2"))
    C1, C2, C4, C7 = (symbol(own, f"{tyre}.cornering") for tyre in ("steer", "drive", "trailer_1", "trailer_2"))
    axle = {k: -symbol(own, f"axle_{k}.x") for k in range(1, 10)}
    p = BTrainYawPlane(
        **{f"m{i}": symbol(own, f"{frame}.mass") for i, frame in FRAMES.items()},
        **{f"I_zz{i}": symbol(own, f"{frame}.inertia.zz") for i, frame in FRAMES.items()},
        **{f"C{k}": C for k, C in enumerate((C1, C2, C2, C4, C4, C4, C7, C7, C7), start=1)},
        **{f"b1{k}": axle[k] - a11 for k in (2, 3)},
        **{f"b2{k}": axle[k] - l_c21 for k in (4, 5, 6)},
        **{f"b3{k}": axle[k] - l_c3 for k in (7, 8, 9)},
        a11=a11,
        l_c1=-symbol(own, "fifth_wheel_1.at.tractor.x") - a11,
        l_c21=l_c21,
        l_c22=-symbol(own, "fifth_wheel_2.at.semitrailer_1.x") - l_c21,
        l_c3=l_c3,
    )
    x, z = sae_states(own, FRAMES, U), rows_of(own)
    # lateral velocities of both sides of a coupling are the same in inertial axes: U psi + v - l psi_dot (3.15), (3.16)
    yaw = {i: -z[f"{frame}.yaw"] for i, frame in FRAMES.items()}
    for i, ahead, behind in ((1, p.l_c1, p.l_c21), (2, p.l_c22, p.l_c3)):
        lever = ahead * x[f"psi_dot_{i}"] + behind * x[f"psi_dot_{i + 1}"]
        x[f"beta_{i + 1}"] = x[f"beta_{i}"] + yaw[i] - yaw[i + 1] - lever / U
    X = sympy.Matrix.vstack(*(x[name] for name in b_train_yaw_plane.STATES))
    sideways, *turns = (-z[f"{FRAMES[i]}.{name}"] for i, name in ((1, "v_y"), *((i, "yaw_rate") for i in FRAMES)))
    # a unit that yaws by itself drags those behind it along; the thesis lets it yaw about its front coupling instead
    operations = [turns[0] + p.l_c1 * sideways, sideways, turns[1] + p.l_c21 * sideways, turns[2]]
    couplings = [yaw[2] - yaw[1], yaw[3] - yaw[2]]
    J, K, L, T, V = (sympy.Matrix(matrix.tolist()) for matrix in b_train_yaw_plane.matrices(p, U))
    steer = [f"axle_{k}.steer" for k in (1, *range(4, 10))]
    moments = ["semitrailer_1.yaw_moment", "semitrailer_2.yaw_moment"]
    # J dx/dt = - K x - L delta_11 - T u_s - V u_M
    hand = [J, -K, -sympy.Matrix.hstack(L, T, V)]
    assert_same_equations(own, (X, sympy.Matrix.vstack(*operations, *couplings)), hand, [*steer, *moments])


FRAMES = {1: "tractor_frame", 2: "semitrailer_1_frame", 3: "semitrailer_2_frame"}
