"""Start the console from this single file. Any Python can read this module, to say which one is needed."""

import sys

PYTHON, MACHINE, NAME = "@PYTHON@", "@MACHINE@", "@NAME@"
GOT = ".".join(map(str, sys.version_info[:2]))

if GOT != PYTHON:
    sys.stderr.write(
        "fleet-tui: this file needs Python " + PYTHON + " and was started by Python " + GOT + ".\n"
        "Start it with: python" + PYTHON + " " + sys.argv[0] + "\n"
        "Without that Python: install it beside yours, without root by: uv python install " + PYTHON + "\n"
        "Or take the file of a release that names yours in place of py"
        + PYTHON.replace(".", "")
        + ", from py311"
        " on.\n"
    )
    sys.exit(2)

from unpacking import start  # noqa: E402  # other Pythons cannot read it

start(NAME, MACHINE)
