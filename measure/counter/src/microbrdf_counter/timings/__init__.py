"""How many cycles an instruction takes, core by core, with zero wait states.

Each table names the manual that it is taken from. Figures are estimates: they know neither
contention on a bus nor a flash that is slower than the core.
"""

from microbrdf_counter.timings.cortex_m0 import CortexM0, CortexM0Plus
from microbrdf_counter.timings.cortex_m3 import CortexM3
from microbrdf_counter.timings.cortex_m4 import CortexM4F
from microbrdf_counter.timings.timing import Timing

__all__ = ["TIMINGS", "CortexM0", "CortexM0Plus", "CortexM3", "CortexM4F", "Timing"]

#: Every table by the name that a report gives it, sorted by the target that is run for it.
TIMINGS: dict[str, dict[str, Timing]] = {
    "thumbv6m-none-eabi": {
        "cortex-m0": CortexM0(multiply=1),
        "cortex-m0 (32-cycle multiplier)": CortexM0(multiply=32),
        "cortex-m0plus": CortexM0Plus(multiply=1),
        "cortex-m0plus (32-cycle multiplier)": CortexM0Plus(multiply=32),
    },
    "thumbv7m-none-eabi": {"cortex-m3": CortexM3()},
    "thumbv7em-none-eabihf": {"cortex-m4f": CortexM4F()},
}
