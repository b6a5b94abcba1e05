"""Every screen in every language at 80x24: no English left, no word of the frame cut."""

import re
from collections.abc import Iterator
from functools import lru_cache

import pytest

from fleet_tui.languages import ENGLISH, use_language
from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.text.language import read_catalogue
from fleet_tui.view.help.legend import legend
from tests.support.console_pilot import Console, console
from tests.support.screen_texts import ROOT
from tests.support.watched_store import config_of

LANGUAGES = sorted(path.stem for path in (ROOT / "locales").glob("*.po"))
_DATA = (
    "base packing dispatch store receiving charger lift consumidores laundry floor robot rosbridge"
    " root esc enter tab pgup pgdn for wait carry until end idle name unit start mapping hall bridge"
    " roslaunch launch service morning routine arm record save docs fleet tui type msg theta data"
    " space left right up down position orientation"
)
DATA = frozenset(_DATA.split(" "))
"""Names of the simulated fleet, keys, and what is typed or in a file as it is."""
EXAMPLE = re.compile(r"[ │]*(order|clear|pause|resume|cancel|claim|close|note|save|settle|goto|robot_\d) ")
"""The begin of an example of a typed command, which is in English."""
SCREENS = {
    "order form": ("o",),
    "why": ("w",),
    "help": ("?",),
    "keys": ("?", "tab"),
    "legend": ("?", "tab", "tab"),
    "commands": ("?", "tab", "tab", "tab"),
    "palette": (":",),
    "robot page": ("i",),
    "question": ("x",),
    "menu of a robot": ("tab", "enter"),
    "menu of an order": ("tab", "tab", "tab", "enter"),
    "simple": ("s",),
    "audit": ("L",),
    "programs": ("J",),
    "routines": ("B",),
    "editor": ("E",),
    "diagnostics": ("d",),
    "topics": ("d", "2"),
    "raw": ("d", "3"),
    "log": ("d", "4"),
    "health": ("d", "5"),
    "console": ("d", "6"),
    "filter": ("tab", "/"),
    "goal": ("G",),
    "pose": ("I",),
    "mapping": ("N",),
}


@pytest.fixture(autouse=True)
def english_again() -> Iterator[None]:
    legend.cache_clear()
    yield
    use_language(ENGLISH)
    legend.cache_clear()


def words(text: str) -> set[str]:
    """The words of a text; what has figures or signs in it is none."""
    if re.match(
        r"(order|clear|pause|resume|cancel|claim|close|note|save|settle|goto|robot_\d) ", text.strip(" │")
    ):
        text = re.split(r"   |  +(?=\S+ \S+ )", text.strip(" │"), maxsplit=1)[-1]
    text = re.sub(r"\b[a-z]+:", "", text)  # names in a filter
    found = (word.strip(".,:;!?()[]'\"/") for word in re.sub(r"\{\w+\}", " ", text).split())
    return {word.casefold() for word in found if len(word) > 2 and word.isalpha()}


@lru_cache
def english(language: str) -> set[str]:
    """The words of the messages that the language does not have."""
    messages = read_catalogue((ROOT / "locales" / f"{language}.po").read_text(encoding="utf-8"))
    own = set().union(*(words(text) for text in messages.values()))
    return set().union(*map(words, messages)) - own - DATA


def untranslated(it: Console, language: str) -> list[str]:
    """The lines with such a word."""
    return [line.strip(" │") for line in it.text.splitlines() if words(line) & english(language)]


@pytest.mark.parametrize("language", LANGUAGES)
async def test_no_screen_has_english_left(server: RosbridgeServer, language: str) -> None:
    use_language(language)
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        left = {"main": untranslated(it, language)}
        for name, keys in SCREENS.items():
            await it.press(*keys)
            left[name] = untranslated(it, language)
            for _ in range(4):
                await it.press("escape")
        assert not any(left.values()), "\n".join(
            f"{name}: {line}" for name, lines in left.items() for line in lines
        )


SLIDING = ("diagnostics", "topics")
"""Screens whose rows slide: they are wider than 80 cells in English, too."""


def cut_words(it: Console) -> list[str]:
    """The lines with a word that is cut."""
    return [line.strip(" │") for line in it.text.splitlines() if "…" in line]


@pytest.mark.parametrize("language", [ENGLISH, *LANGUAGES])
async def test_no_word_of_the_frame_is_cut(server: RosbridgeServer, language: str) -> None:
    use_language(language)
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        cut = {"main": cut_words(it)}
        for name, keys in SCREENS.items():
            await it.press(*keys)
            cut[name] = [] if name in SLIDING else cut_words(it)
            for _ in range(4):
                await it.press("escape")
        assert not any(cut.values()), "\n".join(
            f"{name}: {line}" for name, lines in cut.items() for line in lines
        )
