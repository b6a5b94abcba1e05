"""The calls of one `settle`: each after the answer to the one before, until the pose no longer changes."""

import asyncio
import math
import time
from collections.abc import Callable, Sequence

from fleet_tui.commands.set_up.settling import is_settled, pose_since, settling_text
from fleet_tui.links.rosbridge.answers import Answers
from fleet_tui.links.rosbridge.calls import PendingCall
from fleet_tui.model.commands import Command, Stage
from fleet_tui.model.geometry import Pose
from fleet_tui.model.set_up.commands import Settle
from fleet_tui.robots.adapter import ServiceCall
from fleet_tui.state.store import Store
from fleet_tui.text.errors import CommandError, LinkError
from fleet_tui.text.language import Message

POSE_WITHIN = 0.5
"""Seconds from an answer until the pose is reported: the filter waits for its next scan."""

Sent = Sequence[tuple[ServiceCall, PendingCall]]


class Settling:
    """Runs on the network loop. `send` sends a command once more, now or not at all; `advance` reports the
    stage of a command."""

    def __init__(
        self,
        store: Store,
        answers: Answers,
        send: Callable[[Command], Sent],
        advance: Callable[[int, Stage, Message], None],
    ) -> None:
        self._store = store
        self._answers = answers
        self._send = send
        self._advance = advance
        self._losses = 0

    def on_lost(self) -> None:
        """Give up all further calls: on a new connection they would be late."""
        self._losses += 1

    async def run(self, command_id: int, command: Settle, sent: Sent, sent_at: float) -> None:
        """Wait for the answer to the first call, which left at `sent_at`, and make the others. The first one
        that fails is the last."""
        losses = self._losses
        poses = [pose_since(self._store.state.robots[command.robot], -math.inf)]
        while True:
            end = await self._answers.end_of(command_id, command, sent, sent_at)
            if end is None:
                return
            if end[0] is not Stage.ACCEPTED:
                self._advance(command_id, end[0], _failed(poses, command, end[1]))
                return
            await asyncio.sleep(POSE_WITHIN)
            poses.append(pose_since(self._store.state.robots[command.robot], sent_at))
            if len(poses) > command.calls or is_settled(poses) or not self._is_under_way(command_id):
                self._advance(command_id, Stage.ACCEPTED, settling_text(poses))
                return
            sent_at = time.monotonic()
            try:
                if self._losses > losses:
                    raise LinkError(Message("the link was lost"))
                sent = self._send(command)
            except (LinkError, CommandError) as problem:
                # Never later: what was called before has had its effect, the rest is given up.
                self._advance(
                    command_id,
                    Stage.UNKNOWN,
                    _failed(poses, command, Message("not sent: {problem}", problem=problem)),
                )
                return

    def _is_under_way(self, command_id: int) -> bool:
        """Tell whether no answer was missing so far: after a late one the outcome is decided."""
        return any(one.id == command_id and one.stage is Stage.SENT for one in self._store.state.commands)


def _failed(poses: Sequence[Pose | None], command: Settle, detail: Message) -> Message:
    number = len(poses)
    return (
        detail
        if number == 1
        else Message(
            "call {number} of at most {calls}: {detail}", number=number, calls=command.calls, detail=detail
        )
    )
