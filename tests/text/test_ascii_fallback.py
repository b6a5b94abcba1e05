"""The console's own signs where an encoding lacks them."""

import codecs

import pytest

from fleet_tui.text.ascii_fallback import PLAIN, ascii_fallback


def test_every_sign_has_one_of_ascii_that_stands_for_it() -> None:
    assert all(chr(sign).isascii() is False for sign in PLAIN)
    assert all(isinstance(plain, str) and plain.isascii() and len(plain) == 1 for plain in PLAIN.values())


def test_an_encoding_gets_what_it_has_and_question_marks_for_letters() -> None:
    codecs.register_error("test-stand-in", ascii_fallback)
    assert "● up → Säge".encode("ascii", "test-stand-in") == b"* up > S?ge"
    assert "Säge ●".encode("latin-1", "test-stand-in") == "Säge *".encode("latin-1")


def test_what_is_no_problem_of_encoding_stays_one() -> None:
    codecs.register_error("test-stand-in", ascii_fallback)
    with pytest.raises(UnicodeDecodeError):
        b"\xff".decode("ascii", "test-stand-in")
