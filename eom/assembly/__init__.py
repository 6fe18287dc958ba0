"""Matrices of the linear equations of motion, a file an idea; what they mean is in docs/theory.md."""
