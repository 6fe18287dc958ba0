"""Hand-derived vehicle models, in SAE axes, with the names and matrices of S. Zhu's thesis.

Functions of a parameter set: referees of the generator, models to design controllers and drivers with, and examples to
learn from. They use nothing of the rest of `eom` but its exception.
"""

from eom.closed_form import axes as axes
from eom.closed_form import b_train_nonlinear as b_train_nonlinear
from eom.closed_form import b_train_yaw_plane as b_train_yaw_plane
from eom.closed_form import b_train_yaw_roll as b_train_yaw_roll
from eom.closed_form import brakes as brakes
from eom.closed_form import driver as driver
from eom.closed_form import tractor_semitrailer as tractor_semitrailer
from eom.closed_form import tractor_semitrailer_nonlinear as tractor_semitrailer_nonlinear
from eom.closed_form import wheel_loads as wheel_loads
from eom.closed_form.b_train_parameters import BTrainBraked as BTrainBraked
from eom.closed_form.b_train_parameters import BTrainYawPlane as BTrainYawPlane
from eom.closed_form.b_train_roll_parameters import BTrainYawRoll as BTrainYawRoll
from eom.closed_form.magic_formula import magic_formula as magic_formula
from eom.closed_form.state_space import StateSpace as StateSpace
from eom.closed_form.tractor_semitrailer_parameters import TractorSemitrailer as TractorSemitrailer
from eom.closed_form.tyre_derivatives import tyre_derivatives as tyre_derivatives
