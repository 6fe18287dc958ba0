"""The B-train's file with other supports, or without what only wheels that spin have."""

import re

from tests.vehicles.shipped import text

TRIDEM = "tridem: {body: axles, support: {at: [-11.5, 0, h_r]}, roll_stiffness: K_t, track: 1.65 m}"
OWN_WEIGHT = """tridem: {body: axles, support: {at: [-6.97300, 0, h_r]}, roll_stiffness: K_t, track: 1.65 m}
    connectors:
      level: {type: support, body: axles, at: [-6.97300, 0, h_r], carries: [pitch]}"""


def own_weight(file: str) -> str:
    """Each semitrailer held vertically and in pitch below its whole-mass centre; hitches carry no weight."""
    changed = file.replace(TRIDEM, OWN_WEIGHT).replace("carries: [x, y, z]", "carries: [x, y]")
    assert changed.count("carries: [x, y]") == 2
    assert OWN_WEIGHT in changed
    return changed


def without_spins(file: str) -> str:
    """Wheels whose spins are no states, and which therefore have no longitudinal slip."""
    changed = re.sub(r"(, |\n +)(spin_inertia: \d+|longitudinal: [\d.]+ kN)", "", file)
    assert "spin_inertia" not in changed.split("parameters:", maxsplit=1)[1]
    assert "longitudinal" not in changed
    return changed


def linear_tyres(file: str) -> str:
    """Tyres whose stiffness does not follow their load."""
    changed = re.sub(r"(, |\n +)nonlinear: (&law )?(\{[^}]*\}|\*law)", "", file)
    assert "nonlinear" not in changed
    return changed


B_TRAIN = text("b_train")
