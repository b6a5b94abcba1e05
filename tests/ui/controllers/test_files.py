"""Files of a console: opened once, and what fails of them is noted."""

from fleet_tui.ui.controllers.files import ConsoleFiles


def test_they_are_opened_by_whoever_knows_how_and_only_then() -> None:
    opened = list[ConsoleFiles]()
    files = ConsoleFiles(opened.append)
    assert opened == []
    files.open()
    assert opened == [files]


def test_without_any_there_is_no_operator_and_nothing_to_note() -> None:
    files = ConsoleFiles()
    files.open()
    assert (files.operator, files.notes(), files.pack, files.saving) == ("", [], None, None)
