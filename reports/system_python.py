"""Restarts a script with Debian's Python if the current one lacks numpy or matplotlib."""

import importlib.util
import os
import sys

PYTHON = "/usr/bin/python3"
MARK = "TDBD_STARTED_AGAIN"


def require(*modules):
    """Returns if all modules are installed. Otherwise restarts the script once, or exits with a message that names the missing modules."""
    missing = [m for m in modules if importlib.util.find_spec(m) is None]
    if not missing:
        return
    if MARK not in os.environ and os.path.exists(PYTHON):
        os.environ[MARK] = "1"
        sys.stdout.flush()
        os.execv(PYTHON, [PYTHON, *sys.argv])
    print(f"{os.path.basename(sys.argv[0])}: found a python without {', '.join(missing)} ({sys.executable}), expected {PYTHON} with the "
          "modules that bash scripts/setup installs", file=sys.stderr)
    sys.exit(2)
