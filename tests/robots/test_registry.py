"""The registry: every kind has what a console needs of it, imported only when it is used."""

import subprocess
import sys

import pytest

from fleet_tui.robots.adapter import Site
from fleet_tui.robots.discovery import Listed
from fleet_tui.robots.profile import Profile
from fleet_tui.robots.registry import DEFAULT_KIND, KINDS, kind_of


@pytest.mark.parametrize("name", KINDS)
def test_every_kind_is_whole(name: str) -> None:
    kind = KINDS[name]
    adapter = kind.adapter(Profile(kind=name), Site())
    assert adapter.kind.name == name
    assert adapter.names.vocabulary is kind.vocabulary
    assert not kind.discover(Listed({}, {})).robots
    assert list(adapter.feeds("r1", ["hall"])) and adapter.kind.reports


def test_settings_are_those_of_kinds_that_have_some() -> None:
    assert {name for name, kind in KINDS.items() if kind.settings} == {"nav2", "move_base", "vda5050"}


def test_a_profile_is_of_the_kind_it_says_else_of_its_name_else_of_the_usual_one() -> None:
    assert kind_of(Profile(kind="nav2", name="old")) == "nav2"
    assert kind_of(Profile(name="move_base")) == "move_base"
    assert kind_of(Profile()) == DEFAULT_KIND


def test_a_fleet_of_one_kind_does_not_wait_for_the_others() -> None:
    program = (
        "import sys; from fleet_tui.robots.registry import KINDS; KINDS['nav2'].adapter\n"
        "print([name for name in sys.modules if 'oh_ressources' in name or 'move_base' in name])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"
