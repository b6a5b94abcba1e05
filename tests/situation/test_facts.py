"""The table of facts: its words are written in it alone."""

import ast
from pathlib import Path

import pytest

import fleet_tui
from fleet_tui.situation.facts import AGE_UNKNOWN, LATE_LINK


@pytest.mark.parametrize("word", [LATE_LINK.word, AGE_UNKNOWN.word])
def test_words_of_the_table_are_written_only_there(word: str) -> None:
    modules = [
        path
        for path in Path(fleet_tui.__file__).parent.rglob("*.py")
        if word in path.read_text(encoding="utf-8")
    ]
    written = {
        path.name
        for path in modules
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and word in node.value
    }
    assert written == {"facts.py"}
