"""``python -m theditor``: the same as the command ``theditor``."""

import sys

from theditor.cli import main

sys.exit(main())
