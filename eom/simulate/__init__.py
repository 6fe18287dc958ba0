"""Simulation: a model over time, with inputs, sampled blocks, events; what it gives is a `Run`."""

from eom.simulate.blocks import Block
from eom.simulate.channels import Channels, Event
from eom.simulate.inputs import Constant, Sine, Steps, Table
from eom.simulate.run import Run
from eom.simulate.run_file import load_run
from eom.simulate.sensors import Sensor
from eom.simulate.simulate import RunInterrupted, simulate

__all__ = [
    "Block",
    "Channels",
    "Constant",
    "Event",
    "Run",
    "RunInterrupted",
    "Sensor",
    "Sine",
    "Steps",
    "Table",
    "load_run",
    "simulate",
]
