"""Files of tyre coefficients, `.tir`: read, noted, refused, written."""
