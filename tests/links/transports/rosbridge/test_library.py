"""Modules that importing roslibpy brings along."""

import subprocess
import sys

IMPORTS = """
import sys
from fleet_tui.links.transports.rosbridge import connection
assert "autobahn" in sys.modules
print(*{"OpenSSL", "cryptography"} & set(sys.modules))
from OpenSSL import SSL
assert SSL.Error
"""


def test_no_second_tls_library_is_imported_but_others_may_import_it() -> None:
    assert subprocess.check_output([sys.executable, "-c", IMPORTS], text=True) == "\n"
