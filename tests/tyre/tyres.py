"""Random tyres of every model: plausible, and free of shifts unless a test adds them."""

from typing import Any

from hypothesis import strategies as st

from eom.tyre import Dugoff, Linear, MagicFormula, MagicFormula61, Tyre

LOAD = 4000.0


def between(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False)


wheel = {"rolling_resistance": between(0.0, 0.02), "radius": between(0.2, 0.6), "trail": between(0.0, 0.06)}
linear = st.builds(
    Linear,
    nominal_load=st.just(LOAD),
    cornering=between(2e4, 2e5),
    longitudinal=between(2e4, 2e5),
    camber=between(0.0, 5e3),
    **wheel,
)
dugoff = st.builds(
    Dugoff,
    nominal_load=st.just(LOAD),
    cornering=between(2e4, 2e5),
    longitudinal=between(2e4, 2e5),
    friction=between(0.3, 1.2),
    **wheel,
)


def magic(combined: str, softest: float, friction: tuple[float, float]) -> st.SearchStrategy[MagicFormula]:
    return st.builds(
        MagicFormula,
        nominal_load=st.just(LOAD),
        C_x=between(1.05, 1.9),
        C_y=between(1.05, 1.6),
        C_y_load=between(-0.02, 0.02),
        mu_x=between(*friction),
        mu_x_load=between(-0.1, 0.0),
        mu_y=between(*friction),
        mu_y_load=between(-0.1, 0.0),
        k_x=between(softest, 30.0),
        k_x_load=between(-1.0, 1.0),
        k_x_load2=between(-0.2, 0.2),
        k_y=between(softest, 30.0),
        k_y_load=between(-3.0, 0.0),
        k_y_load2=between(-0.2, 0.2),
        k_gamma=between(0.0, 1.5),
        E_x=between(-1.0, 0.5),
        E_y=between(-2.0, 0.5),
        E_y_load=between(-0.1, 0.1),
        combined=st.just(combined),
        **wheel,
    )


# the default weighting is for tyres of passenger cars; with any others the set of forces need not be convex
ellipse, cosine = magic("ellipse", 5.0, (0.3, 1.2)), magic("cosine", 12.0, (0.8, 1.1))


@st.composite
def plain_61(draw: st.DrawFn) -> MagicFormula61:
    """A version 6.1 tyre without any shift or asymmetry."""
    ranges = {
        "PCX1": (1.1, 1.8), "PDX1": (0.8, 1.1), "PDX2": (-0.1, 0.0), "PEX1": (-1.0, 0.6), "PKX1": (15.0, 40.0),
        "PKX2": (-1.0, 1.0), "PKX3": (-0.3, 0.3), "PCY1": (1.1, 1.6), "PDY1": (0.8, 1.1), "PDY2": (-0.2, 0.0),
        "PEY1": (-1.5, 0.4), "PKY1": (-30.0, -12.0), "PKY2": (1.3, 3.0), "PKY4": (1.8, 2.0), "PKY6": (-1.2, 0.0),
        "RBX1": (8.0, 13.0), "RBX2": (-12.0, 12.0), "RCX1": (0.9, 1.1), "RBY1": (8.0, 13.0), "RBY2": (0.0, 12.0),
        "RCY1": (0.9, 1.1), "QBZ1": (6.0, 12.0), "QBZ10": (0.0, 1.0), "QCZ1": (1.0, 1.3), "QDZ1": (0.05, 0.15),
        "QEZ1": (-3.0, 0.3), "QSX3": (0.0, 0.1), "QSY1": (0.005, 0.02), "QSY3": (0.0, 0.005), "QSY7": (0.0, 1.0),
        "QSY8": (-0.5, 0.0),
    }  # fmt: skip
    numbers: dict[str, Any] = {name: draw(between(*limits)) for name, limits in ranges.items()}
    return MagicFormula61(FNOMIN=LOAD, UNLOADED_RADIUS=0.32, **numbers)


nonlinear: st.SearchStrategy[Tyre] = st.one_of(dugoff, ellipse, cosine, plain_61())
any_tyre: st.SearchStrategy[Tyre] = st.one_of(linear, nonlinear)
loads = between(0.1 * LOAD, 2.0 * LOAD)
angles, ratios, leans = between(-0.6, 0.6), between(-0.99, 1.0), between(-0.2, 0.2)
