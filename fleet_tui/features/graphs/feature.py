from functools import partial

from fleet_tui.features.graphs.checks import DraftChecks
from fleet_tui.features.graphs.drawing import GraphDrawing
from fleet_tui.features.graphs.edge_values import EdgeValues
from fleet_tui.features.graphs.editor import GraphEditor
from fleet_tui.features.graphs.files import DraftFiles
from fleet_tui.features.graphs.old_files import OldFiles
from fleet_tui.features.graphs.route_files import RouteFiles
from fleet_tui.features.graphs.sending import DraftSending
from fleet_tui.features.graphs.values import VertexValues
from fleet_tui.keys.edit import FAR
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.screens.feature import Feature
from fleet_tui.ui.view.map.map_picture import MapPicture


class GraphEditing:
    """The editor of a floor's graph."""

    def __init__(self, console: Console, controls: MapControls, picture: MapPicture) -> None:
        self.editor = GraphEditor(console, controls, picture)
        old_files = OldFiles()
        self.checks = DraftChecks(console, self.editor)
        files = DraftFiles(console, self.editor, self.checks, old_files)
        sending = DraftSending(console, self.editor, self.checks, RouteFiles(console, self.editor, old_files))
        vertex = VertexValues(console, self.editor)
        edge = EdgeValues(console, self.editor)
        self.drawing = GraphDrawing(console, self.editor, vertex, edge)
        self.feature = Feature(
            actions={
                "edit": self.editor.start,
                "edit_add": self.drawing.add_at_cursor,
                "edit_connect": self.drawing.connect,
                "edit_select": self.drawing.select,
                "edit_name": vertex.name,
                "edit_type": vertex.choose_type,
                "edit_turn": self.drawing.turn,
                "edit_move": self.drawing.hold,
                "edit_remove": self.drawing.remove,
                "edit_undo": self.editor.undo,
                "edit_redo": self.editor.redo,
                "edit_lint": self.checks.show_findings,
                "edit_compare": self.checks.compare,
                "edit_write": files.write,
                "edit_send": sending.start,
                "edit_add_at_robot": self.drawing.add_at_robot,
                "edit_leave": self.editor.leave,
                "edit_left_far": partial(controls.pan, -FAR, 0),
                "edit_right_far": partial(controls.pan, FAR, 0),
                "edit_up_far": partial(controls.pan, 0, -FAR),
                "edit_down_far": partial(controls.pan, 0, FAR),
            },
            typed=(vertex.typed, edge.typed, files.typed),
        )
