"""``python -m microbrdf_receiver`` is ``microbrdf-receive``."""

import sys

from .cli import main

sys.exit(main())
