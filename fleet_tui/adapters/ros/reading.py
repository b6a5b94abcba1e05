"""From a frame to what it means. Any thread may read: nothing here changes but what was heard."""

import re
from collections.abc import Callable, Mapping

from fleet_tui.adapters.ros import operations, robot_words
from fleet_tui.adapters.ros.operations import topic_of
from fleet_tui.adapters.subscriptions import Wanted
from fleet_tui.config.profile import Profile
from fleet_tui.config.schema import Link, link_key
from fleet_tui.errors import WireError
from fleet_tui.model import events
from fleet_tui.model.bounds import brief
from fleet_tui.model.counters import LinkCounter, Raw, TopicCounter

ROSOUT, DIAGNOSTICS = "/rosout", "/diagnostics"
WORTH_A_PROCESS = 4 * 2**20
"""Bytes of a JSON map from which on it is decoded in a process of its own: smaller ones take less time than
that process takes to start."""

DecodeApart = Callable[[Profile, str, str, bytes], events.GridReceived]

# As a CBOR map begins: the key, then its text, shorter than 24 bytes or than 256.
_CBOR_TOPIC = re.compile(rb"\x65topic(?:([\x60-\x77])|\x78(.))", re.DOTALL)
# Facts whose parts are read one by one: what is wrong with one comes with the others.
_IN_PARTS = events.QueueReported, events.GraphReceived, events.LabelsReceived


class Reading:
    """Reads the frames of one bridge."""

    def __init__(
        self,
        link: str,
        bridge: Link,
        profile: Profile,
        wanted: Mapping[str, Wanted],
        decode_apart: DecodeApart,
        warn: Callable[[str], None] = lambda _text: None,
    ) -> None:
        """`decode_apart` decodes a large map elsewhere, and raises WireError; `warn` logs a line."""
        self._link = link
        self._bridge = bridge
        self._profile = profile
        self._wanted = wanted
        self._decode_apart, self._warn = decode_apart, warn
        self.maps_heard: set[str] = set()
        """Topics of maps of which one has come on this connection."""
        self.count_anew()

    def count_anew(self) -> None:
        """Begin to count, as if nothing had come."""
        asked = [
            TopicCounter(topic, one.robot, one.kind.key, one.kind.per_floor, one.kind.heavy)
            for topic, one in self._wanted.items()
        ]
        # Large frames are read beside the loop: one count in a million may be lost, but nobody waits.
        self.counter = LinkCounter(self._link, [*asked, TopicCounter(ROSOUT), TopicCounter(DIAGNOSTICS)])

    def read(
        self, payload: bytes, is_binary: bool, at: float
    ) -> events.Event | operations.ServiceResponse | operations.Fragment | None:
        """One frame as what it means."""
        self.counter.all.take(len(payload), at)
        if len(payload) > WORTH_A_PROCESS and not is_binary:
            wanted = self._wanted.get(topic_of(payload))
            if wanted is not None and wanted.kind.heavy:
                return self._read_apart(wanted, payload, at)
        try:
            operation = operations.decode_cbor(payload) if is_binary else operations.decode(payload)
        except WireError as problem:
            self.counter.failed(str(problem), payload, is_binary, at)
            return events.FrameRejected(self._link, str(problem))
        match operation:
            case operations.Publish(topic, msg):
                counter = self.counter.topics.get(topic)
                if counter is None:
                    return None
                counter.heard(payload, is_binary, at)
                return self._translate(counter, msg, at)
            case operations.Status(level, text):
                self._warn(f"the bridge says ({brief(level)}): {brief(text)}")
                return events.FrameRejected(self._link, f"the bridge says: {text}")
        return operation

    def _read_apart(self, wanted: Wanted, payload: bytes, at: float) -> events.Event:
        topic = wanted.subscription.topic
        counter = self.counter.topics[topic]
        counter.heard(payload, False, at)
        try:
            event = self._decode_apart(self._profile, wanted.robot, wanted.floor, payload)
        except WireError as problem:
            counter.failed(str(problem))
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}")
        self.maps_heard.add(topic)
        return event

    def _translate(self, counter: TopicCounter, msg: object, at: float) -> events.Event | None:
        topic = counter.topic
        wanted = self._wanted.get(topic)
        try:
            if wanted is None:
                self._overhear(topic, msg, at)
                return None
            event = wanted.kind.translate(wanted.robot, wanted.floor, msg, at)
        except WireError as problem:
            counter.failed(str(problem))
            return events.MessageRejected(wanted.robot, f"{topic}: {problem}") if wanted else None
        if isinstance(event, _IN_PARTS) and event.fault:
            counter.failed(event.fault)
        if wanted.kind.heavy:
            self.counter.keep_one_map(counter)
            self.maps_heard.add(topic)
        return event

    def _overhear(self, topic: str, msg: object, at: float) -> None:
        """What changes nothing in the picture."""
        if topic == ROSOUT:
            line = robot_words.log_line(msg, at)
            self.counter.take_log(line)
            if (about := robot_words.complaint(line)) and about[0] in self.counter.topics:
                self._warn(f"the bridge did not subscribe {brief(about[0])}: {about[1]}")
                self.counter.topics[about[0]].not_subscribed = f"the bridge says: {about[1]}"
        else:
            self.counter.take_health(robot_words.diagnoses(msg, at))

    def too_large(self, head: bytes, is_binary: bool, size: int, at: float) -> events.Event:
        """A message that was passed over, with its size and the key that lets it in."""
        topic = _cbor_topic(head) if is_binary else topic_of(head)
        self.counter.dropped += 1
        text = (
            f"a message of {size / 1e6:.1f} MB is over the limit of {self._bridge.max_message_mb:g} MB:"
            f" raise {link_key(self._link)}.max_message_mb"
        )
        wanted = self._wanted.get(topic)
        if wanted is None:
            return events.FrameRejected(self._link, text)
        self.counter.topics[topic].failed(text, Raw(head, is_binary, at, size))
        self.maps_heard.add(topic)
        return events.MessageRejected(wanted.robot, f"{topic}: {text}")


def _cbor_topic(head: bytes) -> str:
    found = _CBOR_TOPIC.search(head)
    if found is None:
        return ""
    length = found.group(1)[0] - 0x60 if found.group(1) else found.group(2)[0]
    return head[found.end() : found.end() + length].decode(errors="replace")
