"""The frame that proves to a rosauth server that a client knows its secret."""

import hashlib

import msgspec

# Seconds of the requested session. rosauth checks it only once, when the connection begins.
SESSION = 86_400


def auth(secret: str, client: str, dest: str, rand: str, now: int) -> bytes:
    """Return the frame that proves to a rosauth server, at Unix second `now`, that we know its secret.

    Source: ROSBRIDGE_PROTOCOL.md (auth) and rosauth's ros_mac_authentication: SHA-512 over the secret and the
    fields as they are sent.
    """
    level, end = "operator", now + SESSION
    mac = hashlib.sha512(f"{secret}{client}{dest}{rand}{now}{level}{end}".encode()).hexdigest()
    fields = {"mac": mac, "client": client, "dest": dest, "rand": rand, "t": now, "level": level, "end": end}
    return msgspec.json.encode({"op": "auth", **fields})
