"""The equations of a vehicle whose tyres are spliced in, with all that they tell, from the same evaluation."""

from typing import Any

from eom.splice.limits import all_margins
from eom.splice.outputs import all_outputs
from eom.splice.rates import evaluate, rates_of


def spliced(x: Any, u: Any, numbers: Any) -> tuple[Any, Any, Any]:
    """Rates, margins of limits and outputs at a state; *numbers* are those of a model and of its signals."""
    model, signals = numbers
    found = evaluate(x, u, model)
    return rates_of(found, u, model), all_margins(found, model, signals), all_outputs(found, u, model, signals)
