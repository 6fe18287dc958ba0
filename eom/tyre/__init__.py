"""Tyres: slips, load and camber to forces and moments; .tir files, fitting, derivatives."""

from eom.tyre.dugoff import Dugoff as Dugoff
from eom.tyre.fitting.least_squares import Fit as Fit
from eom.tyre.fitting.least_squares import fit as fit
from eom.tyre.fitting.stiffness import fit_stiffness as fit_stiffness
from eom.tyre.interface import Forces as Forces
from eom.tyre.interface import Tyre as Tyre
from eom.tyre.inverse import slip_angle_for as slip_angle_for
from eom.tyre.kernel import Kernel as Kernel
from eom.tyre.kernel import compile_forces as compile_forces
from eom.tyre.linear import Linear as Linear
from eom.tyre.magic_formula import MagicFormula as MagicFormula
from eom.tyre.mf.coefficients import MagicFormula52 as MagicFormula52
from eom.tyre.mf.coefficients import MagicFormula61 as MagicFormula61
from eom.tyre.mf.relaxation import Relaxation as Relaxation
from eom.tyre.mf.relaxation import relaxation_lengths as relaxation_lengths
from eom.tyre.slip import slip_of_thesis as slip_of_thesis
from eom.tyre.slip import slips as slips
from eom.tyre.slip import thesis_slip as thesis_slip
from eom.tyre.slopes import Slopes as Slopes
from eom.tyre.slopes import slopes as slopes
from eom.tyre.stack import stack as stack
from eom.tyre.suspicion.rules import suspicions as suspicions
from eom.tyre.tir.file import TirFile as TirFile
from eom.tyre.tir.file import read_tir as read_tir
from eom.tyre.tir.write import write_tir as write_tir
