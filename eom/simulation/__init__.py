"""Simulation: a model over time, with inputs, sampled blocks, events; what it gives is a `Run`."""

from eom.simulation.batch import simulate_many
from eom.simulation.blocks import Block
from eom.simulation.case import Case
from eom.simulation.channels import Channels, Event
from eom.simulation.inputs import Constant, Sine, Steps, Table
from eom.simulation.interrupted import RunInterrupted
from eom.simulation.run import Run
from eom.simulation.run_file import load_run
from eom.simulation.running import simulate
from eom.simulation.runs import Runs
from eom.simulation.sensors import Sensor

__all__ = [
    "Block",
    "Case",
    "Channels",
    "Constant",
    "Event",
    "Run",
    "RunInterrupted",
    "Runs",
    "Sensor",
    "Sine",
    "Steps",
    "Table",
    "load_run",
    "simulate",
    "simulate_many",
]
