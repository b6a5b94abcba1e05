"""ASCII fallbacks of the program's own glyphs, for terminals and encodings without them."""

_SIGNS = {
    "●▪•·": "*",
    "○": "o",
    "■▅▆▇█": "#",
    "▸▶→": ">",
    "◂◀←": "<",
    "▲▴↑": "^",
    "△▽◇": "~",
    "▼▾↓": "v",
    "✗╳": "x",
    "✓◆": "+",
    "━": "=",
    "─┄▔▁▂▃▄▀": "-",
    "│┃▊▎▏▕▌▐": "|",
    "╭╮╰╯┌┐└┘├┤┬┴┼╶╴": "+",
    "…°": ".",
    "‖": "=",
    "⌂": "H",
    "↕": "I",
    "≈": "~",
}
PLAIN = str.maketrans({sign: plain for signs, plain in _SIGNS.items() for sign in signs})


def ascii_fallback(problem: UnicodeError) -> tuple[str, int]:
    """Return the replacement of glyphs that an encoding lacks: an error handler for `codecs`."""
    if not isinstance(problem, UnicodeEncodeError):
        raise problem
    missing = problem.object[problem.start : problem.end]
    return missing.translate(PLAIN).encode("ascii", "replace").decode(), problem.end
