"""The frame of rosauth: the digest that its server computes, and nothing of the secret itself."""

import hashlib
import json

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.links.transports.rosbridge.connection import SESSION, auth

WORDS = st.text(st.characters(codec="ascii", categories=["L", "N"]), min_size=6, max_size=20)


@given(WORDS, WORDS, st.integers(0, 2**33))
def test_it_is_what_the_server_computes(secret: str, rand: str, now: int) -> None:
    frame = json.loads(auth(f"!{secret}", "console", "bridge", rand, now))
    fields = ("client", "dest", "rand", "t", "level", "end")
    text = f"!{secret}" + "".join(str(frame[name]) for name in fields)
    assert frame["op"] == "auth" and frame["end"] == now + SESSION
    assert frame["mac"] == hashlib.sha512(text.encode()).hexdigest()
    assert f"!{secret}" not in json.dumps(frame)
