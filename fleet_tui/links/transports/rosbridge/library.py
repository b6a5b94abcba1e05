"""roslibpy, imported without OpenSSL: autobahn needs that for Twisted alone, and it costs each start 10 MB of
memory and 50 ms. TLS is Python's own.
"""

import sys

_found = sys.modules.setdefault("OpenSSL", None)  # type: ignore[arg-type]  # None: importing it fails
import roslibpy  # noqa: E402  # only now is OpenSSL absent
from roslibpy.comm import comm_asyncio  # noqa: E402  # only now is OpenSSL absent

if _found is None:
    del sys.modules["OpenSSL"]

__all__ = ["comm_asyncio", "roslibpy"]
