"""Inputs of ``eom simulate`` that the command line gives as ``NAME=KIND``."""

from collections.abc import Iterable, Mapping

import numpy as np

from eom.analysis.signals import unknown
from eom.cli.request import frequency, number, positive
from eom.simulation.inputs import Constant, Input, Sine, Steps
from eom.simulation.wiring import Named
from eom.vehicle.validate import did_you_mean

FORMS = {
    "sine": ("sine:AMPLITUDE:FREQUENCY[:START[:CYCLES]]", (2, 4)),
    "step": ("step:VALUE[:START]", (1, 2)),
}
"""How each kind is written, and the least and the largest number of its parts."""
KINDS = f"a value, {' or '.join(form for form, _ in FORMS.values())}"
EXAMPLE = "axle_1.steer=sine:1.79deg:0.4Hz"


def read_inputs(texts: Iterable[str], model: Named, mistakes: list[str]) -> Mapping[str, Input]:
    """Inputs by name, in SI units; a sentence for every mistake joins *mistakes*."""
    found: dict[str, Input] = {}
    named: set[str] = set()
    for text in texts:
        name, _, kind = (part.strip() for part in text.partition("="))
        if not (name and kind):
            mistakes.append(f"--input {text}: expected NAME=KIND, KIND being {KINDS}, such as {EXAMPLE}")
            continue
        if name in named:
            mistakes.append(f"--input {name}: is given twice")
        named.add(name)
        if name not in model.inputs:
            mistakes.append(f"--{unknown('input', name, model.inputs)}")
        item = read_kind(f"--input {text}:", kind, unit_of(name, model), mistakes)
        if item is not None:
            found[name] = item
    return found


def unit_of(name: str, model: Named) -> str:
    """Unit of an input; ``*`` if the model has none of this name."""
    return model.input_units[model.inputs.index(name)] if name in model.inputs else "*"


def read_kind(who: str, kind: str, unit: str, mistakes: list[str]) -> Input | None:
    """What changes as a text says, in a unit; None with a mistake."""
    word, *parts = (part.strip() for part in kind.split(":"))
    if word not in FORMS:
        if parts:
            mistakes.append(f"{who} expected {KINDS}{did_you_mean(word, FORMS)}")
            return None
        value = number(f"{who} value", word, unit, mistakes)
        return None if value is None else Constant(value)
    form, (least, most) = FORMS[word]
    if not (least <= len(parts) <= most and all(parts)):
        mistakes.append(f"{who} expected {form}")
        return None
    return read_sine(who, parts, unit, mistakes) if word == "sine" else read_step(who, parts, unit, mistakes)


def read_sine(who: str, parts: list[str], unit: str, mistakes: list[str]) -> Sine | None:
    """One cycle from the start on, unless the parts say otherwise."""
    amplitude = number(f"{who} amplitude", parts[0], unit, mistakes)
    often = frequency(f"{who} frequency", parts[1], mistakes)
    start = number(f"{who} start", parts[2], "s", mistakes) if len(parts) > 2 else 0.0
    cycles = positive(f"{who} cycles", parts[3], "", mistakes) if len(parts) > 3 else 1.0
    if amplitude is None or often is None or start is None or cycles is None:
        return None
    return Sine(amplitude, often, start, cycles)


def read_step(who: str, parts: list[str], unit: str, mistakes: list[str]) -> Steps | None:
    """A value from an instant on, from the start unless the parts say otherwise."""
    value = number(f"{who} value", parts[0], unit, mistakes)
    start = number(f"{who} start", parts[1], "s", mistakes) if len(parts) > 1 else 0.0
    return None if value is None or start is None else Steps(np.array([start]), np.array([value]))
