"""What ``eom simulate`` is asked for: a run file and options over it, every mistake at once."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from eom.cli.request import positive
from eom.cli.settings import UsageError
from eom.cli.simulate_inputs import read_inputs
from eom.driver import KINDS
from eom.errors import DescriptionError
from eom.model.linear import LinearModel
from eom.simulation.blocks import Block
from eom.simulation.equations import Model
from eom.simulation.inputs import Input
from eom.simulation.request import METHODS
from eom.simulation.run_file import load_run
from eom.simulation.run_spec import RunFile
from eom.vehicle.validate import did_you_mean

SAMPLE = 0.01
"""Time between samples of the results [s] where nothing is said, as `eom.simulate` has it."""


class Options(NamedTuple):
    """The options as given; None or empty where they are not."""

    run: Path | None
    inputs: list[str]
    duration: str | None
    speed: str | None
    sample: str | None
    method: str | None
    step: str | None
    out: Path | None


class Plan(NamedTuple):
    """What `eom.simulate` takes, in SI units; ``origin`` says which run file it is from."""

    inputs: Mapping[str, Input]
    duration: float
    speed: float | None
    blocks: tuple[Block, ...]
    wires: Mapping[str, str]
    sample: float
    method: str
    step: float | None
    origin: Mapping[str, str]


def understood(model: Model, options: Options) -> Plan:
    """The plan that a run file and options over it make for a model; raises `UsageError` with every mistake."""
    mistakes: list[str] = []
    file = None
    if options.run is not None:
        try:
            file = load_run(options.run, KINDS, model)
        except DescriptionError as error:
            mistakes += str(error).splitlines()
    inputs = read_inputs(options.inputs, model, mistakes)
    duration = positive("--duration", options.duration, "s", mistakes)
    speed = positive("--speed", options.speed, "m/s", mistakes)
    sample = positive("--sample", options.sample, "s", mistakes)
    step = positive("--step", options.step, "s", mistakes)
    method = options.method or (file.method if file else "automatic")
    plan = Plan(
        inputs={**(file.inputs if file else {}), **inputs},
        duration=duration or (file.duration if file else 0.0),
        speed=speed or (file.speed if file else None),
        blocks=file.blocks if file else (),
        wires=file.wires if file else {},
        sample=sample or (file and file.sample) or SAMPLE,
        method=method,
        # another method than the file's rk4 finds its steps itself
        step=step or (file.step if file and method == "rk4" else None),
        origin={"run_file": file.file, "run_sha256": file.digest} if file else {},
    )
    mistakes += missing(options)
    mistakes += contradictions(options, plan, model, file)
    # a run file that could not be read may have said what the others go with
    if options.run is None or file is not None:
        mistakes += unfitting(options, plan, file)
    if mistakes:
        raise UsageError("\n".join(mistakes))
    return plan


def missing(options: Options) -> Iterator[str]:
    """Sentences for what a run without a file needs."""
    if options.run is None and options.duration is None:
        yield "--duration is missing: without a run file say how long, such as --duration 8s"


def contradictions(options: Options, plan: Plan, model: Model, file: RunFile | None) -> Iterator[str]:
    """Sentences for options that name nothing known, or that the model does not take."""
    if plan.method not in METHODS:
        yield f"--method {plan.method}: expected {', '.join(METHODS)}{did_you_mean(plan.method, METHODS)}"
    what = "goes with axles that have nonlinear tyres; a linear model has the speed of its trim, which is set in the "
    if isinstance(model, LinearModel) and options.speed is not None:
        yield f"--speed {options.speed}: {what}vehicle file or by --set"
    elif isinstance(model, LinearModel) and file is not None and file.speed is not None:
        yield str(file.source.mistake(("speed",), f"{what}vehicle file or by --set"))


def unfitting(options: Options, plan: Plan, file: RunFile | None) -> Iterator[str]:
    """Sentences for values that do not go with each other."""
    if plan.method == "rk4" and plan.step is None and options.step is None:
        if file is not None and options.method is None:
            yield str(file.source.mistake(("method",), "rk4 needs a step, such as 'step: 1 ms'"))
        else:
            yield "--method rk4 needs a step, such as --step 1ms"
    if plan.method != "rk4" and options.step is not None:
        yield f"--step {options.step}: goes with --method rk4: other methods find their steps themselves"
    if plan.duration and plan.sample > plan.duration and (options.sample or (file and file.sample)):
        yield f"time between samples of {plan.sample:g} s: longer than the duration of {plan.duration:g} s"
