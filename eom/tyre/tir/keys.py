"""Keys of .tir files: the section of each coefficient, other spellings, and what is known but not modelled."""

import dataclasses
from collections.abc import Mapping
from typing import Any

from eom.tyre.mf import conditions, force_coefficients, moment_coefficients, ranges, scaling
from eom.tyre.mf.coefficients import MagicFormula52, MagicFormula61

Tyre = MagicFormula61 | MagicFormula52

# per section the classes whose fields stand in it, in the order in which a file is written
SECTIONS: Mapping[str, tuple[type, ...]] = {
    "MODEL": (conditions.ModelSpeeds,),
    "DIMENSION": (conditions.Dimension,),
    "OPERATING_CONDITIONS": (conditions.OperatingConditions,),
    "VERTICAL": (conditions.Vertical, conditions.Vertical61),
    "STRUCTURAL": (conditions.Structural,),
    "CONTACT_PATCH": (conditions.Contact52,),
    "INFLATION_PRESSURE_RANGE": (ranges.InflationPressureRange,),
    "VERTICAL_FORCE_RANGE": (ranges.VerticalForceRange,),
    "LONG_SLIP_RANGE": (ranges.LongSlipRange,),
    "SLIP_ANGLE_RANGE": (ranges.SlipAngleRange,),
    "INCLINATION_ANGLE_RANGE": (ranges.InclinationAngleRange,),
    "SCALING_COEFFICIENTS": (scaling.Scaling, scaling.Scaling61, scaling.Scaling52),
    "LONGITUDINAL_COEFFICIENTS": (
        force_coefficients.Longitudinal,
        force_coefficients.Longitudinal61,
        force_coefficients.Longitudinal52,
    ),
    "OVERTURNING_COEFFICIENTS": (moment_coefficients.Overturning, moment_coefficients.Overturning61),
    "LATERAL_COEFFICIENTS": (force_coefficients.Lateral, force_coefficients.Lateral61, force_coefficients.Lateral52),
    "ROLLING_COEFFICIENTS": (moment_coefficients.RollingResistance, moment_coefficients.RollingResistance61),
    "ALIGNING_COEFFICIENTS": (moment_coefficients.Aligning, moment_coefficients.Aligning61),
}
HEADERS = frozenset({"MDI_HEADER", "HEADER"})
# sections that programs know and that hold nothing of the tyre
OTHER_SECTIONS = frozenset({"TURNSLIP_COEFFICIENTS", "INERTIA", "TIRE_CONDITIONS"})
SECTION_OF: Mapping[str, str] = {
    name: section
    for section, owners in SECTIONS.items()
    for owner in owners
    for name in (item.name for item in dataclasses.fields(owner))
}
CLASSES: tuple[type[Tyre], ...] = (MagicFormula61, MagicFormula52)
FIELDS: Mapping[type[Tyre], Mapping[str, "dataclasses.Field[Any]"]] = {
    version: {item.name: item for item in dataclasses.fields(version) if item.name in SECTION_OF} for version in CLASSES
}

ALIASES: Mapping[str, str] = {"LFZ0": "LFZO", "LKYG": "LKYC", "IP": "INFLPRES", "IP_NOM": "NOMPRES"}

# keys that say how a file is to be handled, and nothing of the tyre
HANDLING = (
    "TYPE FUNCTION_NAME USER_SUB_ID N_TIRE_STATES SWITCH_INTEG HMAX_LOCAL TIME_SWITCH_INTEG ROAD_INCREMENT "
    "ROAD_DIRECTION MFSAFE1 MFSAFE2 MFSAFE3 MESSAGES"
)
WITHOUT_MEANING = frozenset(HANDLING.split())

# what neither version of the equations has here, by subject
NOT_MODELLED: Mapping[str, str] = {
    "turn slip": "LMP PDXP1 PDXP2 PDXP3 PKYP1 PDYP1 PDYP2 PDYP3 PDYP4 PHYP1 PHYP2 PHYP3 PHYP4 PECP1 PECP2 QDTP1 "
    "QCRP1 QCRP2 QBRP1 QDRP1 QDRP2 TURNSLIP",
    "mass and inertia": "MASS IXX IYY BELT_MASS BELT_IXX BELT_IYY GRAVITY",
    "the belt as a body": "YAW_STIFFNESS FREQ_LONG FREQ_LAT FREQ_YAW FREQ_WINDUP DAMP_LONG DAMP_LAT DAMP_YAW "
    "DAMP_WINDUP DAMP_RESIDUAL DAMP_VLOW Q_BVX Q_BVT PCMZ1 BELT_DYNAMICS MBELT QTZ1 LGYR DYNAMIC_STIFFNESS "
    "DYNAMIC_DAMPING",
    "contact patch and uneven road": "Q_RA1 Q_RA2 Q_RB1 Q_RB2 ELLIPS_SHIFT ELLIPS_LENGTH ELLIPS_HEIGHT ELLIPS_ORDER "
    "ELLIPS_MAX_STEP ELLIPS_NWIDTH ELLIPS_NLENGTH ENV_C1 ENV_C2 CONTACT_MODEL",
    "loaded radius with camber": "Q_FZ3 Q_CAM Q_CAM1 Q_CAM2 Q_CAM3 Q_FCY2 Q_FYS1 Q_FYS2 Q_FYS3 "
    "MC_CONTOUR_A MC_CONTOUR_B",
    "contact of the rim": "BOTTOM_OFFST BOTTOM_STIFF BOTTOMING_RADIUS",
    "PAC2002's own, which the forces here lack": "LKG LIP QPX1 QPY1 QPY2 QPZ1 QPZ2",
    "PAC2002's own, which the relaxation lengths here lack": "PTX4 PTY3",
    "VERTICAL_STIFFNESS is not scaled by it": "LCZ",
    "the friction ellipse in combined slip, which is as the coefficients of combined slip say": "FE_METHOD",
    "ply steer": "PLYSTEER",
}
SUBJECT_OF: Mapping[str, str] = {key: subject for subject, keys in NOT_MODELLED.items() for key in keys.split()}


def fields_of(version: type[Tyre]) -> Mapping[str, "dataclasses.Field[Any]"]:
    """The numbers of a version by name: coefficients and limits."""
    return FIELDS[version]


def unit_of(item: "dataclasses.Field[Any]") -> str:
    """The unit that a file's [UNITS] bear on; empty for pure numbers, as all coefficients of the equations are."""
    return str(item.metadata.get("limit_unit", item.metadata.get("unit", "")))


def is_coefficient(name: str) -> bool:
    """Whether a number of a tyre is a coefficient of the equations of its forces."""
    return SECTION_OF[name].endswith("COEFFICIENTS")
