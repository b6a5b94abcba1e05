"""From a frame to what it means. Any thread may read: nothing here changes but what was heard."""

import logging
import re
from collections.abc import Mapping

from fleet_tui.config.profile import Profile
from fleet_tui.config.schema import Link, link_key
from fleet_tui.errors import WireError
from fleet_tui.link.map_process import WORTH_A_PROCESS, decode_apart, topic_of
from fleet_tui.link.subscriptions import Wanted
from fleet_tui.model import events
from fleet_tui.model.bounds import brief
from fleet_tui.rosbridge import operations

LOG = logging.getLogger(__name__)

# As a CBOR map begins: the key, then its text, shorter than 24 bytes or than 256.
_CBOR_TOPIC = re.compile(rb"\x65topic(?:([\x60-\x77])|\x78(.))", re.DOTALL)


class Reading:
    """Reads the frames of one bridge."""

    def __init__(self, link: str, bridge: Link, profile: Profile, wanted: Mapping[str, Wanted]) -> None:
        self._link = link
        self._bridge = bridge
        self._profile = profile
        self._wanted = wanted
        self.maps_heard: set[str] = set()
        """Topics of maps of which one has come on this connection."""

    def read(
        self, payload: bytes, is_binary: bool, at: float
    ) -> events.Event | operations.ServiceResponse | None:
        """One frame as what it means."""
        if len(payload) > WORTH_A_PROCESS and not is_binary:
            wanted = self._wanted.get(topic_of(payload))
            if wanted is not None and wanted.kind.heavy:
                return self._read_apart(wanted, payload)
        try:
            operation = operations.decode_cbor(payload) if is_binary else operations.decode(payload)
        except WireError as problem:
            return events.FrameRejected(self._link, str(problem))
        match operation:
            case operations.Publish(topic, msg):
                return self._translate(topic, msg, at)
            case operations.Status(level, text):
                LOG.warning("the bridge says (%s): %s", brief(level), brief(text))
                return events.FrameRejected(self._link, f"the bridge says: {text}")
        return operation

    def _read_apart(self, wanted: Wanted, payload: bytes) -> events.Event:
        topic = wanted.subscription.topic
        try:
            event = decode_apart(self._profile, wanted.robot, wanted.floor, payload)
        except WireError as problem:
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}")
        self.maps_heard.add(topic)
        return event

    def _translate(self, topic: str, msg: object, at: float) -> events.Event | None:
        wanted = self._wanted.get(topic)
        if wanted is None:
            return None
        try:
            event = wanted.kind.translate(wanted.robot, wanted.floor, msg, at)
        except WireError as problem:
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}")
        if wanted.kind.heavy:
            self.maps_heard.add(topic)
        return event

    def too_large(self, head: bytes, is_binary: bool, size: int) -> events.Event:
        """A message that was passed over, with its size and the key that lets it in."""
        topic = _cbor_topic(head) if is_binary else topic_of(head)
        text = (
            f"a message of {size / 1e6:.1f} MB is over the limit of {self._bridge.max_message_mb:g} MB:"
            f" raise {link_key(self._link)}.max_message_mb"
        )
        wanted = self._wanted.get(topic)
        if wanted is None:
            return events.FrameRejected(self._link, text)
        self.maps_heard.add(topic)
        return events.MessageRejected(wanted.robot, f"{topic}: {text}")


def _cbor_topic(head: bytes) -> str:
    found = _CBOR_TOPIC.search(head)
    if found is None:
        return ""
    length = found.group(1)[0] - 0x60 if found.group(1) else found.group(2)[0]
    return head[found.end() : found.end() + length].decode(errors="replace")
