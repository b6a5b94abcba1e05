"""Hostile text for views."""

import unicodedata

from hypothesis import strategies as st

HOSTILE = [
    "\x1b[2J\x1b[31mred",
    "[red]markup[/red] [@click=app.quit]x[/]",
    "\u202eevil\u2066\u200f",
    "a\nb\r\tc\x00\x7f\x9b",
    "仓库" * 40,
    "👩\u200d👩\u200d👧 ✈\ufe0f",
    "e" + "\u0301" * 300,
    "\u0301\u0301starts with marks",
    "\ud800",
    "Consumidores " * 30,
    "\u3164\u2800\u115f",
    "-> ->",
    "",
]


TEXTS = st.text(max_size=30) | st.sampled_from(HOSTILE)


WIDTHS = [20, 21, 40, 79, 120]


def harmless(text: str) -> bool:
    return not {unicodedata.category(letter) for letter in text} & {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
