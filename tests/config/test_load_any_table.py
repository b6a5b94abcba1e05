"""Whatever stands in the file, a config comes of it or words."""

import json
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.load import load
from fleet_tui.text.errors import ConfigError
from fleet_tui.ui.themes import BASE, load_themes, read_theme
from fleet_tui.ui.view.roles import StyleRole

TABLES = (
    "rosbridge",
    "links",
    "floors",
    "robots",
    "operator",
    "keys",
    "ui",
    "alarms",
    "profile",
    "programs",
    "path",
)
ENTRIES = (
    "name",
    "url",
    "map",
    "size",
    "link",
    "refusals",
    "topics",
    "fields",
    "order",
    "offline_after",
    "unit",
    "start",
    "needs",
)
KEYS = st.text(max_size=5) | st.sampled_from(TABLES) | st.sampled_from(ENTRIES)
SCALARS = st.one_of(
    st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=8).map(lambda text: json.dumps(text)),
    st.integers(-(10**30), 10**30).map(str),
    st.floats().map(repr),
    st.sampled_from(["true", "false", "2020-01-01", "07:32:00", '"("', '"a{9999999999999}"', '"ws://[::1"']),
)
THEME_KEYS = KEYS | st.sampled_from(["dark", "base", "inks", "color", "on", "bold", *BASE, "wall", "label"])
THEMES = load_themes()[0]
VALUES: st.SearchStrategy[str] = st.recursive(
    SCALARS,
    lambda inner: (
        st.lists(inner, max_size=3).map(lambda parts: f"[{', '.join(parts)}]")
        | st.dictionaries(KEYS, inner, max_size=4).map(
            lambda table: (
                "{" + ", ".join(f"{json.dumps(key)} = {value}" for key, value in table.items()) + "}"
            )
        )
    ),
    max_leaves=8,
)


@given(st.dictionaries(KEYS, VALUES, max_size=6))
def test_any_table_is_a_config_or_refused_in_words(table: dict[str, str]) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "config.toml"
        lines = (f"{json.dumps(key)} = {value}" for key, value in table.items())
        path.write_text("\n".join(lines), encoding="utf-8")
        try:
            load(path)
        except ConfigError as refused:
            assert refused.problems and all(refused.problems)


@given(st.dictionaries(THEME_KEYS, VALUES | st.just('"#000000"') | st.just('{wall = "#fffff0"}'), max_size=5))
def test_any_table_is_a_theme_or_refused_in_words(table: dict[str, str]) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "theme.toml"
        lines = (f"{json.dumps(key)} = {value}" for key, value in table.items())
        path.write_text("\n".join(lines), encoding="utf-8")
        try:
            theme = read_theme(path, THEMES)
        except ConfigError as refused:
            assert refused.problems and all(refused.problems)
        else:
            assert theme.textual() and set(theme.styles()) == set(StyleRole)


@given(st.binary(max_size=60) | st.text(max_size=60).map(lambda text: text.encode("utf-8", "surrogatepass")))
def test_any_bytes_are_a_config_and_a_theme_or_refused_in_words(content: bytes) -> None:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "any.toml"
        path.write_bytes(content)
        for read in (load, lambda path: read_theme(path, THEMES)):
            try:
                read(path)
            except ConfigError as refused:
                assert refused.problems and all(refused.problems)


BOMBS = {
    "parts": ("a" + ".a" * 200_000 + " = 1", "more than 30 parts"),
    "quoted parts": ("[" + "'a b'." * 60_000 + "a]", "more than 30 parts"),
    "deep": ("x = " + "[" * 400_000, "recursion"),
    "digits": ("x = " + "9" * 400_000, "Exceeds the limit"),
    "long": ("#" * 600_000, "over 500,000 bytes"),
    "twice": ("[a]\n" * 100_000, "twice"),
}


@pytest.mark.parametrize("name", list(BOMBS))
def test_a_bomb_is_refused_soon(tmp_path: Path, name: str) -> None:
    content, says = BOMBS[name]
    path = tmp_path / "bomb.toml"
    path.write_text(content)
    for read in (load, lambda path: read_theme(path, THEMES)):
        with pytest.raises(ConfigError, match=says):
            read(path)


def test_many_floors_are_checked_soon(tmp_path: Path) -> None:
    path = tmp_path / "config.toml"
    path.write_text(
        "".join(f"[[floors]]\nname = 'f{n}'\n" for n in range(10_000)) + "[[robots]]\nname = 'r'\n"
    )
    assert len(load(path).floors) == 10_000
