"""Generated modules: importable Python of one vehicle, its parameters alive, that needs NumPy alone."""

from eom.codegen.module import module_text as module_text
from eom.codegen.module import write_module as write_module
