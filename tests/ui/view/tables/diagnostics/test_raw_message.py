"""A message as it came is shown for reading: nothing hidden without saying so, nothing unsafe, bounded."""

import json

import cbor2
import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.model.counters import HEAD, Raw, TopicCounter
from fleet_tui.ui.view.tables.diagnostics.raw_message import (
    LONGEST_COPY,
    MOST_LINES,
    SHOWN_ITEMS,
    copied,
    raw_lines,
    raw_table,
)
from tests.support.fleets import T0
from tests.support.hostile_text import TEXTS, harmless

PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**53), 2**53) | st.text(max_size=20),
    lambda inner: (
        st.lists(inner, max_size=SHOWN_ITEMS) | st.dictionaries(st.text(max_size=5), inner, max_size=4)
    ),
    max_leaves=30,
)


def raw(msg: object, size: int | None = None) -> Raw:
    payload = json.dumps({"op": "publish", "topic": "/x", "msg": msg}).encode()
    return Raw(payload, False, T0, size or len(payload))


def test_json_with_indents_without_the_envelope() -> None:
    lines = raw_lines(raw({"header": {"stamp": {"secs": 1}}, "data": 4.5, "ok": True, "none": None}))
    assert lines == (
        "{",
        '  "header": {',
        '    "stamp": {',
        '      "secs": 1',
        "    }",
        "  },",
        '  "data": 4.5,',
        '  "ok": true,',
        '  "none": null',
        "}",
    )


@given(PLAIN)
def test_what_is_short_is_the_very_json(msg: object) -> None:
    shown = "\n".join(raw_lines(raw(msg)))
    if all(letter.isprintable() and letter.isascii() for letter in json.dumps(msg, ensure_ascii=False)):
        assert json.loads(shown) == msg


def test_long_lists_are_cut_and_that_is_said() -> None:
    lines = raw_lines(raw({"data": list(range(1000)), "orders": [{"id": n} for n in range(40)]}))
    assert '  "data": [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, … 988 more of 1,000],' in lines
    assert "    … 28 more of 40" in lines


def test_a_binary_message_says_how_long_its_array_is() -> None:
    frame = {"op": "publish", "topic": "/map", "msg": {"data": cbor2.CBORTag(72, b"\xff" * 5000)}}
    payload = cbor2.dumps(frame)
    lines = raw_lines(Raw(payload, True, T0, len(payload)))
    assert lines == ("{", '  "data": … 5,000 bytes, CBOR tag 72', "}")


def test_of_a_message_that_was_not_kept_whole_the_head_is_shown() -> None:
    lines = raw_lines(Raw(b'{"op":"publish","topic":"/map"'.ljust(HEAD), False, T0, 3_600_000))
    assert lines[0] == "… 3.6 MB, only the first 4.1 kB kept"
    assert lines[1].startswith('{"op":"publish"')
    lines = raw_lines(Raw(b"\xa3\x62op", True, T0, 3_600_000))
    assert lines[1] == "a3 62 6f 70"


@pytest.mark.parametrize(
    "payload",
    [b"{", b"", b"\xff\xfe", b"[" * 100_000, b'{"a":' * 5000 + b"1" + b"}" * 5000, cbor2.dumps(10**5000)],
)
@pytest.mark.parametrize("is_binary", [False, True])
def test_what_nobody_can_read_is_shown_as_it_is(payload: bytes, is_binary: bool) -> None:
    lines = raw_lines(Raw(payload, is_binary, T0, len(payload)))
    assert len(lines) <= MOST_LINES + 1 and all(map(harmless, lines))


@given(st.binary(max_size=300), st.booleans())
def test_any_bytes_are_shown(payload: bytes, is_binary: bool) -> None:
    it = Raw(payload, is_binary, T0, len(payload))
    assert all(map(harmless, raw_lines(it)))
    assert all(map(harmless, copied(it)[0].split("\n")))


@given(TEXTS)
def test_texts_in_it_are_harmless(words: str) -> None:
    assert all(map(harmless, raw_lines(raw({words: [words, {"a": words}]}))))


def test_thousands_of_lines_are_bounded_and_that_is_said() -> None:
    lines = raw_lines(raw({str(n): n for n in range(5000)}))
    assert len(lines) == MOST_LINES + 1 and "first 1,000 lines only" in lines[-1]


def test_a_copy_is_whole_where_the_view_is_not() -> None:
    text, said = copied(raw({"data": list(range(100))}))
    assert json.loads(text) == {"data": list(range(100))} and said == f"{len(text):,} characters"
    text, said = copied(raw({"data": list(range(50_000))}))
    assert len(text) == LONGEST_COPY and said.startswith("the first 50,000 of ")


def test_the_title_says_whose_how_old_and_what_is_wrong() -> None:
    topic = TopicCounter("/robot_0/battery")
    payload = b'{"op":"publish","topic":"/robot_0/battery","msg":{"percent":4}}'
    topic.count_frame(payload, False, T0)
    table = raw_table(topic, topic.last, "missing `data`", T0 + 1.5)
    title = "".join(part for part, _ in table.title)
    assert title == "Raw /robot_0/battery  1.5 s ago, 63 B of JSON  bad"
    assert table.rows[0].runs[0][0] == "▲ missing `data`"
    assert raw_table(topic, None, "", T0).empty == "nothing received yet"
    assert raw_table(topic, None, "bad", T0).empty == "no bad message"


def test_nan_and_infinity_as_bridges_write_them_are_only_shown() -> None:
    payload = b'{"op":"publish","msg":{"data":NaN}}'
    assert raw_lines(Raw(payload, False, T0, len(payload))) == (payload.decode(),)
    assert msgspec.json.decode(copied(raw({"data": None}))[0]) == {"data": None}
