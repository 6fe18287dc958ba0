"""From the law of a tyre to the tyre: its stiffnesses fitted at a normal load."""

from collections.abc import Callable, Mapping

from eom.tyre.dugoff import Dugoff
from eom.tyre.interface import Tyre
from eom.tyre.linear import Linear
from eom.tyre.magic_formula import MagicFormula
from eom.tyre.tir.file import read_tir
from eom.vehicle.elements import TyreLaw

COMBINED = ("ellipse", "cosine")


def linear_tyre(law: TyreLaw, load: float, radius: float) -> Tyre:
    """The tyre at a load [N], on a wheel of a radius [m]."""
    own = {"cornering": law.cornering, "longitudinal": law.longitudinal, "camber": law.camber}
    return Linear(**common(law, load, radius), **own)


def magic_formula_tyre(law: TyreLaw, load: float, radius: float) -> Tyre:
    """The tyre with the law's stiffnesses at a load [N], on a wheel of a radius [m]."""
    given = dict(law.coefficients)
    form = COMBINED[int(given.pop("combined", 0.0))]
    # a wheel whose spin is no state has no longitudinal slip, whatever its stiffness
    own = {"k_y": law.cornering / load, "k_x": (law.longitudinal or law.cornering) / load}
    return MagicFormula(**common(law, load, radius), **own, **given, combined=form)  # type: ignore[arg-type]


def dugoff_tyre(law: TyreLaw, load: float, radius: float) -> Tyre:
    """The tyre at a load [N], on a wheel of a radius [m]."""
    own = {"cornering": law.cornering, "longitudinal": law.longitudinal or law.cornering}
    return Dugoff(**common(law, load, radius), **own, **dict(law.coefficients))


def file_tyre(law: TyreLaw, load: float, radius: float) -> Tyre:  # noqa: ARG001  measured as it is
    """The tyre of the law's file, which says its load and radius itself."""
    return read_tir(law.file).tyre


def common(law: TyreLaw, load: float, radius: float) -> dict[str, float]:
    """What all simple tyres have."""
    return {
        "nominal_load": load,
        "trail": law.trail,
        "rolling_resistance": law.rolling_resistance,
        "radius": radius,
    }


KINDS: Mapping[str, Callable[[TyreLaw, float, float], Tyre]] = {
    "linear": linear_tyre,
    "magic_formula": magic_formula_tyre,
    "dugoff": dugoff_tyre,
    "tir": file_tyre,
}
