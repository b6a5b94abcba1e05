"""JSON of graph files."""

import json

import pytest

from fleet_tui.maps.formats.json_text import parse_json, quoted, to_json
from fleet_tui.text.errors import GraphError


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ('{"a":\n\n NaN}', "not JSON: invalid character in line 3"),
        ('{"a": 1', "not JSON: Input data was truncated"),
        ("[" * 100_000, "nested too deep"),
        ('{"a": ' * 100_000, "nested too deep"),
        ('{"a": "\\ud800"}', "not JSON"),
    ],
)
def test_bad_files(text: str, problem: str) -> None:
    with pytest.raises(GraphError, match=problem):
        parse_json(text)


def test_texts_that_yaml_would_refuse_are_escaped() -> None:
    text = "é\x7f\x85\u2028\ufeff\x1b"
    assert quoted(text) == '"é\\u007f\\u0085\\u2028\\ufeff\\u001b"'
    assert json.loads(quoted(text)) == text


def test_floats_keep_their_point() -> None:
    assert to_json({"a": 1.0, "b": 1}) == '{\n  "a": 1.0,\n  "b": 1\n}\n'
