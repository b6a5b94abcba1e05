"""The command palette: every action of the keys table, and "go to" for all that has a name."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import cast

from textual.command import DiscoveryHit, Hit, Hits, Provider

from fleet_tui.keys import KEYS
from fleet_tui.screens.main import MainScreen

NOT_LISTED = {"palette", "back", "next_pane", "previous_pane"}


class FleetProvider(Provider):
    """Offers what the main screen can do."""

    def _entries(self) -> Iterator[tuple[str, Callable[[], object]]]:
        main = cast(MainScreen, self.screen)
        for key in KEYS:
            if key.pane == "console" and key.id not in NOT_LISTED:
                yield key.text, partial(main.run_action, key.action)
        for robot in main.state.robots.values():
            yield f"Go to robot {robot.name}", partial(main.find_robot, robot.name)
        for floor in main.state.floors:
            yield f"Go to floor {floor}", partial(main.find_floor, floor)
        for floor, chart in main.state.robots[main.selection.robot].charts.items():
            for id_, label in chart.labels.items():
                vertex = chart.graph.vertices.get(id_) if chart.graph else None
                if vertex is not None:
                    yield f"Go to vertex {label}", partial(main.find_vertex, floor, vertex.x, vertex.y)
        for name, use in main.themes.items():
            yield f"Theme: {name}", use

    async def discover(self) -> Hits:
        """Everything, before anything is typed."""
        for text, action in self._entries():
            yield DiscoveryHit(text, action)

    async def search(self, query: str) -> Hits:
        """What matches."""
        matcher = self.matcher(query)
        for text, action in self._entries():
            score = matcher.match(text)
            if score > 0:
                yield Hit(score, matcher.highlight(text), action, text=text)
