"""Tyres: slips, load and camber to forces and moments; .tir files, fitting, derivatives."""

from eom.tyre.mf_coefficients import MagicFormula52, MagicFormula61
from eom.tyre.tir import TirFile, read_tir
from eom.tyre.tir_write import write_tir

__all__ = ["MagicFormula52", "MagicFormula61", "TirFile", "read_tir", "write_tir"]
