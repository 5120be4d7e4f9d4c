"""Runs functions of an ELF image on an emulated core and counts their cycles."""

__version__ = "0.1.0"
