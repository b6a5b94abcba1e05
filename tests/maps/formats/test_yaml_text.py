"""YAML for graphs: names as text, and files that want to harm."""

import math
from typing import Any

import pytest
import yaml
from hypothesis import given

from fleet_tui.maps.formats import yaml_text
from fleet_tui.maps.formats.yaml_text import flow, parse_yaml, settled
from fleet_tui.text.errors import GraphError
from tests.support.graph_files import VALUES


def test_what_looks_like_a_number_is_text_until_it_is_settled() -> None:
    tree = parse_yaml("{a: yes, b: 007, c: 1e3, d: '1', e: 1, f: true, g: ~, h: .inf, i: 0x1F, j: -2.5}")
    assert tree["a"] == "yes" and tree["b"] == "007" and tree["c"] == "1e3"
    assert settled(tree) == {
        "a": "yes",
        "b": "007",
        "c": 1000.0,
        "d": "1",
        "e": 1,
        "f": True,
        "g": None,
        "h": math.inf,
        "i": "0x1F",
        "j": -2.5,
    }


@given(VALUES)
def test_what_is_written_is_read_by_us_and_by_others(value: Any) -> None:
    text = f"a: {flow(value)}"
    assert settled(parse_yaml(text)) == {"a": value}
    assert yaml.safe_load(text) == {"a": value}


def test_numbers_that_are_none() -> None:
    assert flow([math.inf, -math.inf, 1e-7, 1e16, 1.5e300]) == "[.inf, -.inf, 1.0e-07, 1.0e+16, 1.5e+300]"
    assert flow(math.nan) == ".nan" and yaml.safe_load("1.0e-07") == 1e-7


def test_anchors_are_the_same_value() -> None:
    assert settled(parse_yaml("a: &o {x: 1}\nb: *o\nc: [*o, *o]")) == {
        "a": {"x": 1},
        "b": {"x": 1},
        "c": [{"x": 1}, {"x": 1}],
    }


BOMB = "a: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{new}: &{new} [{', '.join([f'*{old}'] * 10)}]\n"
    for old, new in zip("abcdefgh", "bcdefghi", strict=True)
)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (BOMB, "over 3,000,000 values: split the file"),
        ("a: &x [1, *x]", "line 1: alias \\*x within its own value"),
        ("a: *x", "alias"),
        ("\na: !!python/object/apply:os.system [ls]", "line 2: tag .*not supported: remove it"),
        ("a: !!str 1", "line 1: tag 'tag:yaml.org,2002:str'"),
        ("a: ! 1", "line 1: tag '!'"),
        ("[" * 50 + "]" * 50, "line 1: nested more than 40 deep"),
        ("a: 1\nb: 2\na: 3", "line 3: key 'a' twice: remove one"),
        ("a: 1\n---\nb: 2", "line 2: a second document"),
        ("a: 1\nb: [1, 2\nc: 3", "not YAML: .* in line"),
        ("? [a]\n: b", "line 1: a key must be text"),
        ("a: \x00", "not YAML"),
        ("a: \x1b[2J", "not YAML"),
        ("- a\n\tb", "not YAML: .* in line 2"),
        ("'" + "x" * 10, "not YAML"),
    ],
)
def test_bad_files(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        parse_yaml(text)


def test_without_the_fast_parser_it_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(yaml_text, "_PARSER", yaml.SafeLoader)
    assert settled(parse_yaml("a: [1, yes, '2']")) == {"a": [1, "yes", "2"]}
    with pytest.raises(GraphError, match="not YAML"):
        parse_yaml("a: \x1b")
