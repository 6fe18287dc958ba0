"""What is suspicious about the coefficients of a tyre."""
