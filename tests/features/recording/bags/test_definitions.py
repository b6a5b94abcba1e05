"""Definitions of messages in a bag: read or refused, and never code."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.features.recording.bags.convert import Framer
from fleet_tui.features.recording.bags.definitions import typestore
from fleet_tui.features.recording.bags.opening import BagError
from tests.support.bag_frames import LINE, Connection
from tests.support.bags import made

HOSTILE = {
    "a field that is code": "int32 x):\n  import os\n",
    "no name": "int32 \n",
    "a name that is no name": "int32 a-b c\nint32 'x'",
    "it lacks": "Other one",
    "itself": "T again",
    "endless": "string[999999999] x",
    "of endless": f"A[1000] a\n{LINE}\nMSG: p/A\nB[1000] b\n{LINE}\nMSG: p/B\nstring[1000] c",
    "a head that is code": f'int32 x\nq/A a\n{LINE}\nMSG: q/A"):\n  evil\nint32 a',
    "long": "# x\n" * 200_000,
}


@pytest.mark.parametrize("text", HOSTILE.values(), ids=HOSTILE)
def test_a_hostile_definition_never_becomes_code(text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rosbags.typesys.store.exec", None, raising=False)
    with pytest.raises(BagError) as raised:
        typestore(Connection("p/msg/T", text))
    assert "definition" in str(raised.value) and "\n" not in str(raised.value)


@pytest.mark.parametrize("name", ["p/msg/T'); evil(", "T", "p/msg/T\n", "__import__('os')", ""])
def test_a_hostile_type_never_becomes_code(name: str) -> None:
    with pytest.raises(BagError, match="definition"):
        typestore(Connection(name, "int32 x"))


@given(st.text(st.sampled_from("int32 foat[]<=5xyz_/#\"'()\n=:;\\{}T\t"), max_size=60))
def test_any_definition_is_read_or_refused(text: str) -> None:
    try:
        store = typestore(Connection("p/msg/T", text))
    except BagError as problem:
        assert "\n" not in str(problem)
    else:
        store.get_msgdef("p/msg/T")


IDL = """module p { module msg {
  struct Inner { string words; };
  struct T { int32 x; sequence<p::msg::Inner> all; };
}; };"""


@pytest.mark.parametrize("text", [IDL, f"{LINE}\nIDL: p/msg/T\n{IDL}"])
def test_a_definition_may_be_idl(text: str) -> None:
    store = typestore(Connection("p/msg/T", text, "IDL"))
    msg = made(store, "p/msg/T", {"x": 5, "all": [{"words": "a"}]})
    framer = Framer(store, "p/msg/T", "/a", False, as_cbor=False)
    assert framer.frame(bytes(store.serialize_cdr(msg, "p/msg/T"))).endswith(
        b'"msg":{"x":5,"all":[{"words":"a"}]}}'
    )


@pytest.mark.parametrize("name", ["x: int = evil()", "import os", "1x", "", "ä"])
def test_whatever_idl_is_taken_for_never_becomes_code(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    from rosbags.interfaces import Nodetype

    read = {"p/msg/T": ([("int32", "A", "evil()")], [(name, (Nodetype.BASE, ("int32", 0)))])}
    monkeypatch.setattr("rosbags.typesys.get_types_from_idl", lambda _text: read)
    with pytest.raises(BagError, match="without a plain name"):
        typestore(Connection("p/msg/T", "", "IDL"))


def test_without_a_definition_standard_types_are_known_and_others_named() -> None:
    """As in a bag of ROS 2 Humble."""
    assert typestore(Connection("geometry_msgs/msg/PoseStamped", "", "NONE")).get_msgdef(
        "std_msgs/msg/Header"
    )
    with pytest.raises(
        BagError, match="definition of oh_ressources/msg/ActionQueue is not in the bag: record as"
    ):
        typestore(Connection("oh_ressources/msg/ActionQueue", "", "NONE"))


def test_a_constant_is_no_field() -> None:
    store = typestore(
        Connection("p/msg/T", 'string NAME=a "quoted" # thing\nint8 A = 5\nint8 b # = 5\nint8 c 7')
    )
    assert [name for name, _ in store.fielddefs["p/msg/T"][1]] == ["b", "c"]
