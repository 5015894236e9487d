"""``python -m pyemtr.multiway DIR --out DIR``, which is the command ``pyemtr-align``."""

import sys

from .command import main

if __name__ == "__main__":
    sys.exit(main())
