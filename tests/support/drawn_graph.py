"""A graph editor over a small map pane, without a fleet."""

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

from fleet_tui.features.graphs.checks import DraftChecks
from fleet_tui.features.graphs.drawing import GraphDrawing
from fleet_tui.features.graphs.edge_values import EdgeValues
from fleet_tui.features.graphs.edit_mode import EditMode
from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.files import DraftFiles
from fleet_tui.features.graphs.old_files import OldFiles
from fleet_tui.features.graphs.route_files import RouteFiles
from fleet_tui.features.graphs.sending import DraftSending
from fleet_tui.features.graphs.values import VertexValues
from fleet_tui.maps.draft_file import DraftFile
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graphs.document import DocumentFloor
from fleet_tui.model.problem import Permissions
from fleet_tui.ui.controllers.files import ConsoleFiles
from fleet_tui.ui.view.map.floor_scene import floor_scene
from fleet_tui.ui.view.map.viewport import Point
from tests.support.desk import Desk, ready
from tests.support.map_pane import Pane


class DrawnGraph:
    """The editor, its drawing and the desk it stands on."""

    def __init__(self, pane: Pane, state: FleetState, folder: Path | None, may: Permissions | None) -> None:
        self.pane, self.desk = pane, Desk(state, may)
        self.draft_files = list[DraftFile]()
        self.picture = pane.map.picture
        desk = self.desk
        self.graph_file: Path | None = None
        files = ConsoleFiles(
            graph_file=lambda _floor: self.graph_file,
            folder=folder,
            draft=lambda floor: None if folder is None else self._draft_file(folder, floor),
        )
        console = self.console = desk.console(files)
        self.editor = GraphEditor(console, pane.controls, self.picture)
        self.checks = DraftChecks(console, self.editor)
        old_files = OldFiles()
        self.files = DraftFiles(console, self.editor, self.checks, old_files)
        self.route_files = RouteFiles(console, self.editor, old_files)
        self.sending = DraftSending(console, self.editor, self.checks, self.route_files)
        self.values = VertexValues(console, self.editor)
        self.edge_values = EdgeValues(console, self.editor)
        self.drawing = GraphDrawing(console, self.editor, self.values, self.edge_values)
        pane.map.show(floor_scene(state, desk.navigation.selection))

    def _draft_file(self, folder: Path, floor: str) -> DraftFile:
        self.draft_files.append(DraftFile(folder, "site", floor))
        return self.draft_files[-1]

    @property
    def mode(self) -> EditMode:
        assert self.editor.mode is not None
        return self.editor.mode

    @property
    def floor(self) -> DocumentFloor:
        assert self.editor.draft is not None
        return self.editor.draft.floor

    def at(self, place: Point) -> None:
        """Put the cursor at a place, in metres."""
        self.mode.cursor = place
        self.editor.refresh()

    def typed(self, line: str) -> None:
        """Type a line into the palette, and press Enter."""
        typed = self.values.typed(line) or self.edge_values.typed(line) or self.files.typed(line)
        assert typed is not None
        typed.entries[0][1]()


@asynccontextmanager
async def drawn_graph(
    folder: Path | None = None, may: Permissions | None = None, state: FleetState | None = None
) -> AsyncIterator[DrawnGraph]:
    """Robot_0 with a graph of the vertices 1 and 2, which are Base and Store."""
    async with Pane().run_test(size=(100, 30)) as pilot:
        app = pilot.app
        assert isinstance(app, Pane)
        graph = DrawnGraph(app, state or ready(), folder, may)
        await pilot.pause()
        yield graph
        for file in graph.draft_files:
            file.close()  # as the system does after a crash
