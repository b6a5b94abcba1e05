"""The graph editor's draft: opened from the live graph or from the disk, kept on disk with every step."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from fleet_tui.features.graphs.edit_mode import EditMode
from fleet_tui.maps.draft_file import Done, DraftFile, Line, Redone, Undone
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.graph import RouteGraph
from fleet_tui.model.graphs.document import DocumentFloor
from fleet_tui.model.graphs.draft import Change, GraphDraft
from fleet_tui.model.graphs.live import floor_of, roles_of
from fleet_tui.text.language import EMPTY, Message, counted
from fleet_tui.text.sanitize import sanitize
from fleet_tui.ui.controllers.console import Console
from fleet_tui.ui.controllers.map import MapControls
from fleet_tui.ui.view.map.floor_scene import map_owner
from fleet_tui.ui.view.map.map_picture import MapPicture
from fleet_tui.ui.view.map.scene import Scene
from fleet_tui.ui.view.selection import Selection


class GraphEditor:
    """Owns the draft of one floor while it is edited. `changed` is called after every step with the floor,
    and with None when the editor is left."""

    def __init__(self, console: Console, controls: MapControls, picture: MapPicture) -> None:
        self._store = console.store
        self._dispatch = console.dispatch
        self._navigation = console.navigation
        self._notices = console.notices
        self._open_menu = console.open_menu
        self._controls = controls
        self.picture = picture
        self._file_of = console.files.draft
        self._file: DraftFile | None = None
        self._edges: bool | None = None
        self.draft: GraphDraft | None = None
        self.mode: EditMode | None = None
        self.changed: Callable[[DocumentFloor | None], None] = lambda _floor: None

    @property
    def is_open(self) -> bool:
        """Tell whether a draft is edited."""
        return self.mode is not None and self.picture.mode is self.mode

    def start(self) -> None:
        """Edit the graph of the shown floor; a draft that was left is offered first."""
        if self.is_open:
            self.leave()
            return
        if refusal := self._dispatch.set_up_refusal():
            self._notices.say(refusal)
            return
        floor = self._navigation.floor
        file = self._file_of(floor)
        try:
            kept = file.load() if file is not None else None
        except OSError as problem:
            self._notices.say(Message("draft not readable: {strerror}", strerror=problem.strerror))
            return
        if kept is None or kept.floor.name != floor or not (kept.done or kept.undone):
            self._begin(floor, file)
            return
        steps = counted("{count} step", "{count} steps", len(kept.done))
        self._open_menu(
            Message("A draft of {floor} with {steps} was left", floor=sanitize(floor), steps=steps),
            [
                (Message("Continue this draft"), partial(self._enter, kept, file)),
                (
                    Message("Start again from the live graph (the draft is kept as .bak)"),
                    partial(self._begin, floor, file),
                ),
            ],
        )

    def _begin(self, floor: str, file: DraftFile | None) -> None:
        """Begin a draft with the live graph."""
        if floor != self._navigation.floor:
            self._notices.say(Message("not edited: {floor} is not the floor shown", floor=sanitize(floor)))
            return
        draft = GraphDraft(live_floor(self._store.state, self._navigation.selection))
        if self._enter(draft, file) and file is not None:
            self._keep(partial(file.begin, draft))

    def _enter(self, draft: GraphDraft, file: DraftFile | None) -> bool:
        scene, view = self.picture.scene, self.picture.viewport
        if scene is None or scene.floor != draft.floor.name:
            self._notices.say(
                Message("not edited: {name} is not the floor shown", name=sanitize(draft.floor.name))
            )
            return False
        self.draft = draft
        self._file = file
        self.mode = EditMode(draft.floor, view.middle(scene), roles_of(self.live_graph()))
        self._edges = self.picture.options.edges
        self.picture.options = replace(self.picture.options, edges=True)
        self._controls.enter(self.mode)
        self.changed(draft.floor)
        return True

    def live_graph(self) -> RouteGraph | None:
        """Return the graph that the robots have of the shown floor, None if none has one."""
        selection = self._navigation.selection
        owner = map_owner(self._store.state, selection)
        return owner.maps[selection.floor].graph if owner is not None else None

    def leave(self) -> None:
        """Put a held vertex back, else clear the selection, else leave; the draft stays on disk."""
        mode = self.mode
        if mode is None or not self.is_open:
            return
        if mode.held:
            mode.held = False
        elif mode.selected or mode.edge:
            mode.selected = mode.edge = ""
        else:
            self._close()
            return
        self._controls.enter(mode)

    def _close(self) -> None:
        assert self.draft is not None
        steps = counted("{count} step", "{count} steps", len(self.draft.done)) if self.draft.done else EMPTY
        self.picture.options = replace(self.picture.options, edges=self._edges)
        self._controls.leave_mode()
        if self._file is not None:
            self._keep(self._file.close)
        self.draft = self.mode = self._file = None
        self.changed(None)
        if steps:
            self._notices.say(Message("draft kept with {steps}: E continues it", steps=steps))

    def do(self, change: Change) -> None:
        """Take a step."""
        if self.draft is not None:
            self.draft.do(change)
            self._took(change.text, Done(change), change)

    @property
    def opened(self) -> tuple[GraphDraft, EditMode, Scene] | None:
        """Return the draft with its mode and the scene of its floor, None while none is edited; say so if
        another floor is shown."""
        draft, mode, scene = self.draft, self.mode, self.picture.scene
        if draft is None or mode is None or scene is None or not self.is_open:
            return None
        if scene.floor != draft.floor.name:
            self._notices.say(
                Message(
                    "the draft is of {name}: go to that floor to edit it", name=sanitize(draft.floor.name)
                )
            )
            return None
        return draft, mode, scene

    def undo(self) -> None:
        """Take the last step back."""
        change = opened[0].undo() if (opened := self.opened) is not None else None
        if change is None:
            self._notices.say(Message("nothing to undo"))
        else:
            self._took(Message("undone: {text}", text=change.text), Undone(), change)

    def redo(self) -> None:
        """Take the undone step again."""
        change = opened[0].redo() if (opened := self.opened) is not None else None
        if change is None:
            self._notices.say(Message("nothing to redo"))
        else:
            self._took(change.text, Redone(), change)

    def _took(self, text: Message, line: Line, change: Change) -> None:
        assert self.draft is not None and self.mode is not None
        self._notices.note(sanitize(text))
        if self._file is not None:
            self._keep(partial(self._file.write, line))
        self.mode.show(self.draft.floor, change)
        self.refresh()
        self.changed(self.draft.floor)

    def refresh(self) -> None:
        """Show the cursor and the selection."""
        if self.mode is not None and self.is_open:
            self._controls.enter(self.mode)

    def _keep(self, write: Callable[[], None]) -> None:
        try:
            write()
        except OSError as problem:
            self._notices.say(
                sanitize(
                    Message("draft not on disk (:write FILE keeps it): {strerror}", strerror=problem.strerror)
                )
            )


def live_floor(state: FleetState, selection: Selection) -> DocumentFloor:
    """Return the graph of the shown floor as the robots have it, empty if none has one."""
    floor, owner = state.floors[selection.floor], map_owner(state, selection)
    robot_map = owner.maps[floor.name] if owner is not None else None
    if robot_map is None or robot_map.graph is None:
        return DocumentFloor(floor.name, frame_id=floor.frame_id)
    return floor_of(floor.name, robot_map.graph, robot_map.labels, floor.frame_id)
