"""Tyres: linear ones by their stiffnesses, and the nonlinear laws that they may follow."""

from typing import Annotated, Any, Literal, Self

from pydantic import Discriminator, Field, GetJsonSchemaHandler, Tag, model_validator
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from eom.vehicle.parts import Strict, as_mapping
from eom.vehicle.quantity import CorneringStiffness, Damping, Force, Length, Plain, Stiffness

SUFFIX = ".tir"
# coefficients of the law that other numbers of the file settle
FOLLOWS = {
    "k_x": "follows from 'longitudinal' at the load of the trim",
    "k_y": "follows from 'cornering' at the load of the trim",
    "nominal_load": "is the load of the trim",
    "trail": "stands beside 'nonlinear', as the tyre's 'trail'",
    "rolling_resistance": "stands beside 'nonlinear', as the tyre's 'rolling_resistance'",
    "radius": "is the 'radius' of the axle",
}


class Law(Strict):
    """A nonlinear law, fitted to the tyre's stiffnesses at the load of the trim."""

    @model_validator(mode="before")
    @classmethod
    def _follows(cls, value: Any) -> Any:
        given = as_mapping(value)
        if said := [f"'{key}' {why}" for key, why in FOLLOWS.items() if key in given]:
            message = f"{', and '.join(said)}: leave it out here"
            raise ValueError(message)
        return value


class MagicFormulaLaw(Law):
    """The Magic Formula of Zhu's thesis: ``friction`` along and across, further coefficients by their names."""

    kind: Literal["magic_formula"]
    friction: Plain | None = None
    combined: Literal["ellipse", "cosine"] = "ellipse"
    C_x: Plain | None = None
    C_x_load: Plain | None = None
    mu_x: Plain | None = None
    mu_x_load: Plain | None = None
    k_x_load: Plain | None = None
    k_x_load2: Plain | None = None
    E_x: Plain | None = None
    E_x_load: Plain | None = None
    C_y: Plain | None = None
    C_y_load: Plain | None = None
    mu_y: Plain | None = None
    mu_y_load: Plain | None = None
    k_y_load: Plain | None = None
    k_y_load2: Plain | None = None
    E_y: Plain | None = None
    E_y_load: Plain | None = None
    k_gamma: Plain | None = None
    RBX1: Plain | None = None
    RBX2: Plain | None = None
    RCX1: Plain | None = None
    RBY1: Plain | None = None
    RBY2: Plain | None = None
    RCY1: Plain | None = None

    @model_validator(mode="after")
    def _friction_both_ways(self) -> Self:
        if self.friction is None and (self.mu_x is None or self.mu_y is None):
            message = "needs 'friction', or 'mu_x' and 'mu_y'"
            raise ValueError(message)
        if None not in {self.friction, self.mu_x, self.mu_y}:
            message = "has 'mu_x' and 'mu_y', which leave nothing to 'friction': leave that out"
            raise ValueError(message)
        return self


class DugoffLaw(Law):
    """Dugoff's tyre: one coefficient of friction."""

    kind: Literal["dugoff"]
    friction: Plain


class FileLaw(Strict):
    """The Magic Formula of a ``.tir`` file, which stands beside the vehicle file or below it."""

    kind: Literal["tir"]
    file: str = Field(max_length=500)

    @model_validator(mode="after")
    def _is_tir(self) -> Self:
        if not self.file.lower().endswith(SUFFIX):
            message = f"'file' names a {SUFFIX} file"
            raise ValueError(message)
        return self


NonlinearLaw = Annotated[MagicFormulaLaw | DugoffLaw | FileLaw, Field(discriminator="kind")]


class Tyre(Strict):
    """A tyre: stiffness of each wheel, or of the axle's two wheels together.

    ``longitudinal`` is its force per unit of longitudinal slip; ``relaxation`` the length over which its side force
    builds up. ``camber`` is its side force per angle of the wheel's lean, ``rolling_resistance`` its resisting force
    per load. With ``nonlinear`` the stiffnesses are those at small slip and the load of the trim.
    """

    per: Literal["wheel", "axle"]
    cornering: CorneringStiffness
    camber: CorneringStiffness | None = None
    trail: Length | None = None
    relaxation: Length | None = None
    longitudinal: Force | None = None
    vertical_stiffness: Stiffness | None = None
    vertical_damping: Damping | None = None
    rolling_resistance: Plain | None = None
    nonlinear: NonlinearLaw | None = None

    @model_validator(mode="after")
    def _one_camber_thrust(self) -> Self:
        if self.camber is not None and self.nonlinear is not None:
            message = (
                "has 'camber' besides 'nonlinear': camber thrust is the law's own there, 'k_gamma' of magic_formula"
            )
            raise ValueError(message)
        return self

    @property
    def rich(self) -> bool:
        """Whether it has what only a wheel of its own can show."""
        return self.nonlinear is not None or self.rolling_resistance is not None


class FileTyre(Tyre):
    """A tyre whose file tells its stiffnesses, but for those that are given here."""

    cornering: CorneringStiffness | None = None  # type: ignore[assignment]

    @model_validator(mode="after")
    def _no_second_resistance(self) -> Self:
        if self.rolling_resistance is not None:
            message = "has 'rolling_resistance' besides its file, which says it: change it there"
            raise ValueError(message)
        return self


def tells_tyre(value: object) -> str:
    """Whether a tyre is one of a file, or one whose stiffnesses the vehicle file gives."""
    from_file = isinstance(value, FileTyre) or as_mapping(as_mapping(value).get("nonlinear")).get("kind") == "tir"
    return "from_file" if from_file else "fitted"


class AnyOf:
    """Marker of a union whose members an editor may take for each other: a file's tyre may have all keys of others."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """The union without the demand that exactly one member fits."""
        found = handler(schema)
        return {"anyOf" if key == "oneOf" else key: value for key, value in found.items()}


AnyTyre = Annotated[
    Annotated[Tyre, Tag("fitted")] | Annotated[FileTyre, Tag("from_file")], Discriminator(tells_tyre), AnyOf()
]
