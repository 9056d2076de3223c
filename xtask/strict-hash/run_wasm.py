"""Runs a WebAssembly program in the Python package wasmtime: `python3 run_wasm.py PROGRAM.wasm [ARGUMENT]...`.

It stands in for the command `wasmtime run --dir=.`: the program opens files of the present folder alone, writes to this
process's stdout and stderr, and its exit code is that of this process (1 when it traps).
"""

import sys

from wasmtime import Engine, ExitTrap, Linker, Module, Store, WasiConfig

wasi = WasiConfig()
wasi.argv = sys.argv[1:]
wasi.inherit_stdout()
wasi.inherit_stderr()
wasi.preopen_dir(".", ".")
engine = Engine()
store = Store(engine)
store.set_wasi(wasi)
linker = Linker(engine)
linker.define_wasi()
program = linker.instantiate(store, Module.from_file(engine, sys.argv[1]))
try:
    program.exports(store)["_start"](store)
except ExitTrap as end:
    sys.exit(end.code)
