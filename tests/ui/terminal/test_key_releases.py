"""Key releases of the kitty keyboard protocol, as its documentation writes them."""

import pytest
from textual import events
from textual._xterm_parser import XTermParser
from textual.drivers import linux_driver
from textual.message import Message

from fleet_tui.ui.terminal.key_releases import (
    ALWAYS,
    WITH_RELEASES,
    KeyReleased,
    ReleaseParser,
    parse_releases,
    tell_releases,
)


def told(typed: str) -> list[tuple[bool, str]]:
    """Releases of keys, and their names."""
    found = list[Message]()
    for event in ReleaseParser().feed(typed):
        found.append(event)
    return [
        (isinstance(one, KeyReleased), one.key) for one in found if isinstance(one, events.Key | KeyReleased)
    ]


@pytest.mark.parametrize(
    ("typed", "keys"),
    [
        ("\x1b[119;1:3u", [(True, "w")]),
        ("\x1b[119;1:1;119u", [(False, "w")]),
        ("\x1b[119;1:2;119u", [(False, "w")]),
        ("\x1b[119;;119u\x1b[119;1:2;119u\x1b[119;1:3u", [(False, "w"), (False, "w"), (True, "w")]),
        ("\x1b[1;1:3A", [(True, "up")]),
        ("\x1b[27;1:3u", [(True, "escape")]),
        ("\x1b[119;5:3u", [(True, "ctrl+w")]),
        ("w", [(False, "w")]),
    ],
)
def test_each_kind_of_event_is_told_as_what_it_is(typed: str, keys: list[tuple[bool, str]]) -> None:
    assert told(typed) == keys


def test_what_has_no_event_type_is_parsed_as_before() -> None:
    for typed in ("\x1b[119;;119u", "\x1b[A", "\x1b[1;5C", "a\x1b[97;2;65u"):
        assert [str(one) for one in ReleaseParser().feed(typed)] == [
            str(one) for one in XTermParser().feed(typed)
        ]


def test_textuals_own_parser_still_needs_this_one() -> None:
    with pytest.raises(ValueError, match="1:3"):
        list(XTermParser().feed("\x1b[119;1:3u"))


class SomeDriver(linux_driver.LinuxDriver):
    """A driver that has started, without a terminal."""

    def __init__(self) -> None:
        self.sent = list[str]()
        self._writer_thread = object()  # type: ignore[assignment]  # only asked whether there is one

    def write(self, data: str) -> None:
        self.sent.append(data)


def test_the_flags_are_changed_in_place_and_back() -> None:
    parse_releases()
    driver = SomeDriver()
    tell_releases(driver, True)
    tell_releases(driver, False)
    assert driver.sent == [f"\x1b[={WITH_RELEASES};1u", f"\x1b[={ALWAYS};1u"]
    asked = (
        linux_driver.KITTY_DISAMBIGUATE_ESCAPE_CODES
        | linux_driver.KITTY_REPORT_ALL_KEYS
        | linux_driver.KITTY_REPORT_ASSOCIATED_TEXT
    )
    assert (asked, asked | linux_driver.KITTY_REPORT_EVENT_TYPES) == (ALWAYS, WITH_RELEASES)
    driver._writer_thread = None
    tell_releases(driver, True)
    tell_releases(None, True)
    assert len(driver.sent) == 2
