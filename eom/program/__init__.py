"""Equations as a program: traced once from functions that NumPy runs, then machine code, or NumPy over many cases."""
