"""The graph editor's draft: begun, left, continued, undone."""

from pathlib import Path

from fleet_tui.model.problem import Permissions
from fleet_tui.ui.view.map.modes.mode import ViewMode
from tests.support.drawn_graph import drawn_graph


async def test_it_opens_on_the_live_graph_and_leaves_it_as_it_is() -> None:
    async with drawn_graph() as it:
        live = it.picture.scene
        it.editor.start()
        assert it.floor.labels == {"1": "Base", "2": "Store"}
        assert "EDIT" in it.pane.rows()[0]
        assert it.picture.options.edges
        it.at((5.0, 5.0))
        it.drawing.add_at_cursor()
        assert it.picture.scene is live and len(it.floor.vertices) == 3
        it.editor.leave()  # clears the selection
        it.editor.leave()
        assert isinstance(it.picture.mode, ViewMode) and not it.picture.options.edges
        assert not it.editor.is_open


async def test_a_console_that_may_not_command_may_not_edit() -> None:
    for may, reason in ((Permissions(read_only=True), "read-only"), (Permissions(armed=False), "not armed")):
        async with drawn_graph(may=may) as it:
            it.editor.start()
            assert not it.editor.is_open
            assert reason in it.desk.notices.text


async def test_a_draft_is_offered_again_also_after_a_crash(tmp_path: Path) -> None:
    async with drawn_graph(tmp_path) as it:
        it.editor.start()
        it.at((5.0, 5.0))
        it.drawing.add_at_cursor()
    async with drawn_graph(tmp_path) as it:
        it.editor.start()
        (menu,) = it.desk.menus
        assert menu.title == "A draft of floor_0 with 1 step was left"
        menu.choose("Continue")
        assert list(it.floor.vertices) == ["1", "2", "3"]
        it.editor.undo()
        assert list(it.floor.vertices) == ["1", "2"]
    async with drawn_graph(tmp_path) as it:
        it.editor.start()
        it.desk.menus[0].choose("Continue")
        it.editor.redo()
        assert list(it.floor.vertices) == ["1", "2", "3"]
        it.editor.start()
    async with drawn_graph(tmp_path) as it:
        it.editor.start()
        it.desk.menus[0].choose("Start again")
        assert list(it.floor.vertices) == ["1", "2"]
    assert len(sorted(tmp_path.glob("*.bak"))) == 1  # noqa: ASYNC240  # the loop has nothing else to do


async def test_nothing_to_undo_and_nothing_to_redo_are_said() -> None:
    async with drawn_graph() as it:
        it.editor.undo()
        it.editor.start()
        for do in (it.editor.undo, it.editor.redo):
            do()
            assert it.desk.notices.text.startswith("nothing to ")


async def test_a_folder_that_cannot_be_written_is_said_and_drawing_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    async with drawn_graph(tmp_path / "file") as it:
        it.editor.start()
        assert "draft not" in it.desk.notices.text


async def test_escape_goes_one_level_back_at_a_time() -> None:
    async with drawn_graph() as it:
        it.editor.start()
        vertex = it.floor.vertices["1"]
        it.at((vertex.x, vertex.y))
        it.drawing.select()
        it.drawing.hold()
        assert it.mode.held
        it.editor.leave()
        assert (it.mode.held, it.mode.selected) == (False, "1")
        it.editor.leave()
        assert it.mode.selected == ""
        it.editor.leave()
        assert not it.editor.is_open
