"""Whatever stands in the file, a config comes of it or words."""

import json
from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.config.load import load
from fleet_tui.errors import ConfigError

TABLES = ("rosbridge", "links", "floors", "robots", "operator", "keys", "ui", "alarms", "profile", "path")
ENTRIES = ("name", "url", "map", "size", "link", "refusals", "topics", "fields", "order", "offline_after")
KEYS = st.text(max_size=5) | st.sampled_from(TABLES) | st.sampled_from(ENTRIES)
SCALARS = st.one_of(
    st.text(st.characters(exclude_categories=["Cs", "Cc"]), max_size=8).map(lambda text: json.dumps(text)),
    st.integers(-(10**30), 10**30).map(str),
    st.floats().map(repr),
    st.sampled_from(["true", "false", "2020-01-01", "07:32:00", '"("', '"a{9999999999999}"', '"ws://[::1"']),
)
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
