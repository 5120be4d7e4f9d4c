"""``python -m microbrdf_counter``."""

import sys

from microbrdf_counter.cli import main

sys.exit(main())
