"""The Magic Formula 6.1 and 5.2: coefficients, and equations part by part.

The equations are written once and run twice: on NumPy arrays, and compiled (`eom.tyre.kernel`). Numbers of equations
with an E are those of Pacejka, Tire and Vehicle Dynamics, 3rd edition, 2012, chapter 4.3.2; those with an A are of
Besselink, Schmeitz, Pacejka, Vehicle System Dynamics 48, 2010. Turn slip is left out: all its factors are one.
"""
