"""Ibex, simulated from its source: cycles that are counted, not estimated."""

from microbrdf_counter.ibex.simulator import CLOCK_MODEL, CORE, Ibex, build

__all__ = ["CLOCK_MODEL", "CORE", "Ibex", "build"]
