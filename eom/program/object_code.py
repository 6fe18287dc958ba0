"""LLVM's text as machine code that is kept in files: made once, loaded again without the compiler of the text."""

import threading
from collections.abc import Callable
from functools import cache
from importlib import import_module
from typing import Any

from eom.program.cache import kept, key

ENTRY = "entry"
"""Name of the function that is called."""
LOADED: dict[str, Any] = {}
"""What holds the machine code of this process, by the name of its file; nothing is ever taken out."""
LOADING = threading.Lock()


def target() -> Any:
    """The machine that this runs on, as LLVM knows it; what is made with it owns it."""
    llvm = import_module("llvmlite.binding")
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    processor = {"cpu": llvm.get_host_cpu_name(), "features": llvm.get_host_cpu_features().flatten()}
    kind = llvm.Target.from_triple(llvm.get_process_triple())
    return kind.create_target_machine(**processor, opt=3, codemodel="jitdefault", jit=True)


@cache
def processor() -> str:
    """What machine code depends on besides its text."""
    llvm = import_module("llvmlite.binding")
    return f"{llvm.get_process_triple()} {llvm.get_host_cpu_name()} {llvm.get_host_cpu_features().flatten()}"


def address(name: str, text: Callable[[], str]) -> int:
    """Address of the function `ENTRY` of a text, which is asked for if the cache has no machine code of that name."""
    file = f"{name}_{key(processor())}.o"
    with LOADING:
        if file not in LOADED:
            LOADED[file] = loaded(kept(file, lambda: object_code(text())))
    return int(LOADED[file].get_function_address(ENTRY))


def loaded(code: bytes) -> Any:
    """What holds machine code in memory that can be called as long as it lives."""
    llvm = import_module("llvmlite.binding")
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), target())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine


def object_code(text: str) -> bytes:
    """The machine code of a text as it stands: programs have nothing left to leave out, and numba did that to loops."""
    code: bytes = target().emit_object(import_module("llvmlite.binding").parse_assembly(text))
    return code
