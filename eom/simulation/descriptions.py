"""What signals are, in words."""

from eom.simulation.channels import owner_and_quantity

QUANTITIES = {
    "ax": "longitudinal acceleration",
    "ay": "lateral acceleration",
    "speed": "forward speed",
    "x": "place along x",
    "y": "place along y",
    "z": "place along z",
    "roll": "roll angle",
    "pitch": "pitch angle",
    "yaw": "heading",
    "v_x": "velocity forward",
    "v_y": "velocity to the left",
    "v_z": "velocity upward",
    "roll_rate": "roll rate",
    "pitch_rate": "pitch rate",
    "yaw_rate": "yaw rate",
    "sideslip": "sideslip angle",
    "articulation": "articulation angle",
    "alpha": "slip angle",
    "slip_angle": "slip angle that acts",
    "kappa": "longitudinal slip",
    "spin": "speed of rotation",
    "Fx": "longitudinal force",
    "Fy": "lateral force",
    "Fz": "normal load",
    "Mz": "aligning moment",
    "ltr": "load transfer ratio",
    "steer": "steer angle",
    "brake_pressure": "brake pressure",
    "brake_torque": "brake torque",
    "roll_moment": "roll moment",
    "yaw_moment": "yaw moment",
}


def described(name: str) -> str:
    """A signal in words; its name where nothing is known of its quantity."""
    owner, quantity = owner_and_quantity(name)
    if name == "drive_torque":
        return "drive torque of all driven wheels"
    base, counted, origin = quantity.partition("_from_")
    if base not in QUANTITIES or not owner:
        return name
    return f"{QUANTITIES[base]} of {owner}{f' counted from {origin}' if counted else ''}"
