"""Every screen in every language at 80x24: no English left, no word of the frame cut."""

import re
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.simulator.server import RosbridgeServer
from fleet_tui.ui.languages import ENGLISH, use_language
from fleet_tui.ui.view.help.pages import legend
from tests.support.catalogues import LANGUAGES, translations
from tests.support.console_pilot import Console, console
from tests.support.nav2_site import nav2_ready, nav2_site
from tests.support.scenario import plant
from tests.support.watched_store import config_of

pytestmark = pytest.mark.nightly

_DATA = (
    "base packing dispatch store receiving charger lift consumidores laundry floor robot rosbridge"
    " root esc enter tab pgup pgdn for wait carry until end idle name unit start mapping hall bridge"
    " roslaunch launch service morning routine arm record save docs fleet tui type msg theta data"
    " space left right up down position orientation elevator kitchen"
)
DATA = frozenset(_DATA.split(" "))
"""Names of the simulated fleet, keys, and what is typed or in a file as it is."""
OWN_WORDS = re.compile(r"robot_\d: |: (WARN|ERROR) |REJECTED|simulator|[\d:]{8} +[A-Z]+ ")
"""A line with what a robot itself says, or of the log."""
EXAMPLE = re.compile(
    r"[ │]*(order|clear|pause|resume|cancel|claim|close|note|save|settle|goto|localise|robot_\d) "
)
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
    "history": ("H",),
    "robots of the history": ("H", "2"),
    "batteries of the history": ("H", "3"),
    "alarms of the history": ("H", "4"),
    "places of the history": ("H", "5"),
    "filter": ("tab", "/"),
    "goal": ("G",),
    "pose": ("I",),
    "mapping": ("N",),
}
IN_TROUBLE = {
    "why": ("w",),
    "robot page": ("i",),
    "menu of an alarm": ("tab", "tab", "enter"),
    "next": ("!", "w"),
    "its page": ("i",),
    "refused": ("o", "B", "a", "s", "enter", "S", "t", "o", "enter"),
    "all": ("P",),
    "all paused": ("P", "y"),
    "alarms wide": ("tab", "tab", "="),
}
OF_NAV2 = {
    "why": ("w",),
    "robot page": ("i",),
    "commands": ("?", "tab", "tab", "tab"),
    "mapping": ("N",),
    "pose": ("I", "enter"),
    "goal": ("G", "enter"),
    "order": ("o", "B", "a", "s", "enter", "S", "t", "o", "enter", "enter"),
    "pause": ("p",),
    "paused": ("w",),
    "health": ("d", "5"),
}
SLIDING = ("diagnostics", "topics")
"""Screens whose rows slide: they are wider than 80 cells in English, too."""


@pytest.fixture(autouse=True)
def english_again() -> Iterator[None]:
    legend.cache_clear()
    yield
    use_language(ENGLISH)
    legend.cache_clear()


def words(text: str) -> set[str]:
    """The words of a text; what has figures or signs in it is none."""
    if re.match(
        r"(order|clear|pause|resume|cancel|claim|close|note|save|settle|goto|localise|robot_\d) ",
        text.strip(" │"),
    ):
        text = re.split(r"   |  +(?=\S+ \S+ )", text.strip(" │"), maxsplit=1)[-1]
    text = re.sub(r"\b[a-z]+:", "", text)  # names in a filter
    found = (word.strip(".,:;!?()[]'\"/") for word in re.sub(r"\{\w+\}", " ", text).split())
    return {word.casefold() for word in found if len(word) > 2 and word.isalpha()}


@lru_cache
def english(language: str) -> set[str]:
    """The words of the messages that the language does not have."""
    messages = translations(language)
    own = set().union(*(words(text) for text in messages.values()))
    return set().union(*map(words, messages)) - own - DATA


def told(found: Mapping[str, list[str]]) -> str:
    return "\n".join(f"{name}: {line}" for name, lines in found.items() for line in lines)


def untranslated(it: Console, language: str) -> list[str]:
    """The lines with such a word."""
    lines = (line.strip(" │") for line in it.text.splitlines() if not OWN_WORDS.search(line))
    return [line for line in lines if words(line) & english(language)]


def cut_words(it: Console) -> list[str]:
    """The lines with a word that is cut."""
    return [line.strip(" │") for line in it.text.splitlines() if "…" in line and not OWN_WORDS.search(line)]


async def seen(it: Console, keys: Iterable[str] = ()) -> None:
    """Press keys, and wait until all is painted that they led to."""
    await it.press(*keys)
    it.app.main.tick()
    await it.settled()


async def close(it: Console) -> None:
    for _ in range(4):
        await it.press("escape")


@pytest.mark.parametrize("language", LANGUAGES)
async def test_no_screen_has_english_left(server: RosbridgeServer, language: str) -> None:
    use_language(language)
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        left = {"main": untranslated(it, language)}
        for name, keys in SCREENS.items():
            await seen(it, keys)
            left[name] = untranslated(it, language)
            await close(it)
        assert told(left) == ""


@pytest.mark.parametrize("language", [ENGLISH, *LANGUAGES])
async def test_no_word_of_the_frame_is_cut(server: RosbridgeServer, language: str) -> None:
    use_language(language)
    async with console(config_of(server.url, 2, 2), (80, 24)) as it:
        cut = {"main": cut_words(it)}
        for name, keys in SCREENS.items():
            await seen(it, keys)
            cut[name] = [] if name in SLIDING else cut_words(it)
            await close(it)
        assert told(cut) == ""


@pytest.mark.parametrize("language", LANGUAGES)
async def test_trouble_is_told_without_english(server: RosbridgeServer, language: str) -> None:
    use_language(language)
    plant(server, "obstacle:robot_0,battery:robot_1,refuse:robot_1")
    config = config_of(server.url, 2, 2)
    limits = replace(config.alarms, obstacle_after=0.1, pause_after=0.1, no_answer_after=1.0)
    async with console(replace(config, alarms=limits), (80, 24)) as it:
        await it.until(lambda state: len(state.alarms) > 1)
        it.app.main.tick()
        left = {"main": untranslated(it, language)}
        for name, keys in IN_TROUBLE.items():
            await it.press(*keys)
            await it.until(lambda state: all(record.is_decided for record in state.commands))
            await seen(it)
            left[name] = untranslated(it, language)
            await close(it)
        assert told(left) == ""


@pytest.mark.parametrize("language", LANGUAGES)
async def test_robots_with_nav2_are_told_about_without_english(tmp_path: Path, language: str) -> None:
    use_language(language)
    async with nav2_site(tmp_path, rate=10.0) as site, console(site.config, (80, 24), wait=False) as it:
        await it.until(nav2_ready)
        left = {"main": untranslated(it, language)}
        for name, keys in OF_NAV2.items():
            await seen(it, keys)
            left[name] = untranslated(it, language)
            await close(it)
        assert told(left) == ""
