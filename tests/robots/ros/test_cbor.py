"""CBOR of bridges: what they send is read, whatever else there is in CBOR is refused soon."""

import cbor2
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.robots.ros.cbor import INT8_ARRAY, LARGEST_REST, read_cbor

TEXTS = st.text(max_size=8)
VALUES = st.recursive(
    st.none() | st.booleans() | st.integers(-(2**63), 2**63 - 1) | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(TEXTS, inner, max_size=4),
    max_leaves=12,
)


@given(st.dictionaries(TEXTS, VALUES, max_size=4))
def test_what_a_bridge_may_say_is_read_as_it_is(said: object) -> None:
    assert read_cbor(cbor2.dumps(said)) == said


@pytest.mark.parametrize("tag", [*range(6), 28, 30, *range(35, 38), 52, 54, 100, 258, 260, 261, 1004, 43000])
def test_tags_that_would_become_more_than_values_are_refused(tag: int) -> None:
    with pytest.raises(ValueError, match="semantic tag"):
        read_cbor(cbor2.dumps({"a": cbor2.CBORTag(tag, b"\x01")}))


def test_a_reference_to_itself_is_refused() -> None:
    with pytest.raises(ValueError):
        read_cbor(bytes.fromhex("d81c81d81d00"))


def test_the_cells_of_a_large_map_are_kept_whole() -> None:
    cells = bytes(range(256)) * (LARGEST_REST // 128)
    read = read_cbor(
        cbor2.dumps({"op": "publish", "msg": {"data": cbor2.CBORTag(INT8_ARRAY, cells), "n": 1}})
    )
    assert read["msg"]["data"].value == cells and read["msg"]["n"] == 1


def test_a_large_message_that_is_no_map_is_refused() -> None:
    with pytest.raises(ValueError, match="beside the cells of a map"):
        read_cbor(cbor2.dumps({"op": "publish", "msg": [0] * (LARGEST_REST + 9)}))


@given(st.binary(max_size=64))
def test_any_bytes_are_read_or_refused(payload: bytes) -> None:
    try:
        read_cbor(payload)
    except ValueError:
        return
