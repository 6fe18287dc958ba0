"""Coefficients of a tyre from stiffnesses and measurements."""
