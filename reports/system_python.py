"""The scripts need Debian's numpy and matplotlib. Started by another python, which lacks them, a script starts again by Debian's."""

import importlib.util
import os
import sys

PYTHON = "/usr/bin/python3"
MARK = "TDBD_STARTED_AGAIN"


def require(*modules):
    """Returns if all modules are there; otherwise starts the script again, once, or ends with a message that names the missing ones."""
    missing = [m for m in modules if importlib.util.find_spec(m) is None]
    if not missing:
        return
    if MARK not in os.environ and os.path.exists(PYTHON):
        os.environ[MARK] = "1"
        sys.stdout.flush()
        os.execv(PYTHON, [PYTHON, *sys.argv])
    sys.exit(f"{sys.argv[0]}: found a python without {', '.join(missing)} ({sys.executable}), expected {PYTHON} after bash scripts/setup")
