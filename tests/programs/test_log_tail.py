"""Logs: bounded in lines and bytes, whatever comes."""

import asyncio

from hypothesis import given
from hypothesis import strategies as st

from fleet_tui.programs.log_tail import LONGEST_LINE, MOST_LINES, LogTail
from tests.support.polling import until


def texts(tail: LogTail) -> list[str]:
    return [text for _, text in tail.lines]


@given(st.lists(st.sampled_from([b"a", b"\n", b"\xff", b"\r\n", b"\x1b[31m", b"e\n"])))
def test_lines_do_not_depend_on_where_blocks_end(parts: list[bytes]) -> None:
    one, several = LogTail(), LogTail()
    one.put(b"".join(parts))
    for part in parts:
        several.put(part)
    assert texts(one) == texts(several)


def test_it_keeps_the_newest_lines_numbered() -> None:
    tail = LogTail()
    tail.put(b"".join(b"%d\n" % n for n in range(MOST_LINES * 2)))
    tail.put(b"last\n")
    assert len(tail.lines) == MOST_LINES and texts(tail)[-2:] == [str(MOST_LINES * 2 - 1), "last"]
    numbers = [number for number, _ in tail.lines]
    assert numbers == sorted(set(numbers))


def test_a_line_without_an_end_is_cut_and_not_kept() -> None:
    tail = LogTail()
    for _ in range(100):
        tail.put(b"x" * 10_000)
    tail.put(b"\nnext\n")
    cut, after = texts(tail)
    assert cut == "x" * LONGEST_LINE + "…" and after == "next"


def test_colours_are_left_out_and_other_sequences_left_for_the_view() -> None:
    tail = LogTail()
    tail.put(b"\x1b[1;31mred\x1b[0m \x1b]52;c;eA==\x07\r\n")
    assert texts(tail) == ["red \x1b]52;c;eA==\x07"]


async def test_it_says_why_no_more_comes() -> None:
    tail = LogTail()
    await tail.follow(["sh", "-c", "printf 'a\nhalf'; exit 4"])
    assert texts(tail) == ["a", "half"] and tail.note == "the log ended: exit status 4"
    await tail.follow(["no-such-program"])
    assert tail.note.startswith("no-such-program: not found")


async def test_a_flood_leaves_the_loop_to_others() -> None:
    tail = LogTail()
    following = asyncio.ensure_future(tail.follow(["yes"]))
    await until(lambda: len(tail.lines) == MOST_LINES)
    following.cancel()
    await asyncio.wait({following})
    assert tail.lines[-1][0] < 20 * MOST_LINES * 100
