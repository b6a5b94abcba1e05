"""amqtt as a program of its own, with the access of a test: `python -m tests.support.amqtt_broker FILE`."""

import asyncio
import json
import ssl
import sys
from pathlib import Path
from typing import Any

from amqtt.broker import Broker
from amqtt.contexts import Action
from amqtt.plugins.base import BaseAuthPlugin, BaseTopicPlugin
from paho.mqtt.client import topic_matches_sub

ACCESS: dict[str, Any] = json.loads(Path(sys.argv[1]).read_text())


class KnownUsers(BaseAuthPlugin):  # type: ignore[misc]  # of a library without types
    async def authenticate(self, *, session: Any) -> bool:
        return not ACCESS["users"] or [session.username, session.password] in ACCESS["users"]


class GrantedTopics(BaseTopicPlugin):  # type: ignore[misc]  # of a library without types
    async def topic_filtering(self, *, session: Any = None, topic: Any = None, action: Any = None) -> bool:
        if action is Action.SUBSCRIBE:
            return not (ACCESS["refused"] and _covers(ACCESS["refused"], topic))
        is_free = action is not Action.PUBLISH or not ACCESS["writable"]
        return is_free or topic.rpartition("/")[2] in ACCESS["writable"]


def _covers(pattern: str, subscription: str) -> bool:
    """Tell whether a pattern has all that is subscribed to: its wildcards match those."""
    return bool(topic_matches_sub(pattern, subscription))


class TlsBroker(Broker):  # type: ignore[misc]  # of a library without types
    """A broker that demands the certificate which amqtt only asks for."""

    @staticmethod
    def _create_ssl_context(listener: Any) -> ssl.SSLContext:
        context: ssl.SSLContext = Broker._create_ssl_context(listener)
        context.verify_mode = ssl.CERT_REQUIRED
        return context


async def serve() -> None:
    listener: dict[str, Any] = {"type": "tcp", "bind": f"127.0.0.1:{ACCESS['port']}"}
    if ACCESS["tls"]:
        cert, key, issuer = ACCESS["tls"]
        listener |= {"ssl": True, "certfile": cert, "keyfile": key, "cafile": issuer}
    plugins: dict[str, dict[str, str]] = {
        f"{__name__}.{one.__name__}": {} for one in (KnownUsers, GrantedTopics)
    }
    await TlsBroker({"listeners": {"default": listener}, "plugins": plugins}).start()
    await asyncio.Event().wait()


if __name__ == "__main__":
    asyncio.run(serve())
