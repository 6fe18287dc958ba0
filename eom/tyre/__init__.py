"""Tyres: slips, load and camber to forces and moments; .tir files, fitting, derivatives."""
