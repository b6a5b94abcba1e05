"""The rationalisation table: every alarm has its class, and the documentation says the same."""

import re
from pathlib import Path

from fleet_tui.model.alarm import class_of
from fleet_tui.situation.alarms.classes import CLASSES
from fleet_tui.situation.alarms.floods import FLOODS
from fleet_tui.situation.facts import FACTS

SOURCES = Path(__file__).parents[3] / "fleet_tui" / "situation"


def test_every_kind_of_alarm_has_a_class() -> None:
    sources = "".join(path.read_text() for path in SOURCES.rglob("*.py"))
    kinds = set(re.findall(r'Condition\(\s*[\w."]+,\s*"([\w-]+)"', sources)) | {
        "command",
        "many commands",
        "frames",
    }
    kinds |= {f"many {kind}" for kind in FLOODS} | {kind.name for kind in FACTS if kind.alarm}
    assert {class_of(kind) for kind in kinds} == set(CLASSES)


def test_the_documentation_has_the_same_table() -> None:
    text = (Path(__file__).parents[3] / "docs" / "alarms.md").read_text()
    for name, one in CLASSES.items():
        cells = (f"`{name}`", *one[:4], f"{one.minutes:g} min")
        assert f"| {' | '.join(cells)} |" in text
