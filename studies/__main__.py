"""`python -m studies` is the command `matpoint`."""

import sys

from studies.command_line import main

sys.exit(main())
