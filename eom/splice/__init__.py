"""Tyres spliced into the multibody part: trim, nonlinear equations, their linear closure (thesis 3.3.2.2)."""
