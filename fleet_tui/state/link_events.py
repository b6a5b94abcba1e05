"""Events of links: the effect of each on its bridge's state."""

from typing import assert_never

from msgspec.structs import replace

from fleet_tui.model import events
from fleet_tui.model.fleet import FleetState
from fleet_tui.model.link import LinkState, Phase
from fleet_tui.text.language import EMPTY
from fleet_tui.text.limits import truncate

LinkEvent = (
    events.LinkChanged
    | events.MessageArrived
    | events.CommandPathChanged
    | events.MessagesUnsourced
    | events.TopicsDropped
    | events.TopicNotAllowed
    | events.CallNotAllowed
    | events.SubscriptionsAdvanced
    | events.BridgeAnswered
    | events.FrameRejected
)


def _with_link(state: FleetState, link: LinkState) -> FleetState:
    return replace(state, links={**state.links, link.name: link})


def _change_link(state: FleetState, event: events.LinkChanged) -> FleetState:
    """Change the phase; during repeated attempts `since` stays the time of the loss."""
    link = state.links[event.link]
    same_side = (link.phase is Phase.UP) == (event.phase is Phase.UP)
    returns = link.was_up and event.phase is Phase.UP and not same_side
    return _with_link(
        state,
        replace(
            link,
            phase=event.phase,
            reason=truncate(event.reason) or (link.reason if event.phase is not Phase.UP else EMPTY),
            next_try=event.next_try,
            since=link.since if same_side and link.since else event.at,
            outage=event.at - link.since if returns else link.outage if same_side else 0.0,
            was_up=link.was_up or event.phase is Phase.UP,
            unsourced=link.unsourced if event.phase is Phase.UP else "",
            dropped=link.dropped if event.phase is Phase.UP else (),
            not_allowed=link.not_allowed if event.phase is Phase.UP else {},
            barred=link.barred if event.phase is Phase.UP else {},
            waiting_topics=link.waiting_topics if event.phase is Phase.UP else 0,
            lag=link.lag if event.phase is Phase.UP else 0.0,
        ),
    )


def _clocked(link: LinkState, at: float, stamp: float) -> LinkState:
    """Set the clock of a site by an answer: its stamp was true between question and answer. A clock that fits
    in between has not moved, however long an answer took; simulated time, with a pace of its own, does."""
    if link.clock is None:
        return replace(link, clock=at - stamp, clock_at=at, drift=0.0)
    clock = min(max(link.clock, link.asked_at - stamp), at - stamp)
    passed, moved = at - link.clock_at, clock - link.clock
    # Time that stands still is the slowest pace: a clock that lost more was set back.
    if passed <= 0.0 or moved > passed:
        return replace(link, clock=clock, clock_at=at, drift=0.0)
    return replace(link, clock=clock, clock_at=at, drift=moved / passed, drifted=link.drifted + moved)


def _with_barred(link: LinkState, event: events.TopicNotAllowed | events.CallNotAllowed) -> LinkState:
    if isinstance(event, events.TopicNotAllowed):
        return replace(link, not_allowed={**link.not_allowed, truncate(event.topic): event.robots})
    return replace(link, barred={**link.barred, truncate(event.name): event.glob})


def apply_to_link(state: FleetState, event: LinkEvent) -> FleetState:
    if isinstance(event, events.LinkChanged):
        return _change_link(state, event)
    link = state.links[event.link]
    match event:
        case events.MessageArrived():
            return _with_link(state, replace(link, last_received=event.at))
        case events.CommandPathChanged():
            changed = replace(link, command_path=event.path, command_reason=truncate(event.reason))
            return _with_link(state, replace(changed, commands_connected=event.connected))
        case events.MessagesUnsourced():
            return _with_link(state, replace(link, unsourced=truncate(event.package)))
        case events.TopicsDropped():
            return _with_link(state, replace(link, dropped=event.robots))
        case events.TopicNotAllowed() | events.CallNotAllowed():
            return _with_link(state, _with_barred(link, event))
        case events.SubscriptionsAdvanced(_, at, done, total):
            return _with_link(
                state, replace(link, topics=total, waiting_topics=total - done, subscribed_at=at)
            )
        case events.BridgeAnswered():
            link = replace(link, lag=event.after, asked_at=event.at - event.after)
            return _with_link(state, link if event.stamp is None else _clocked(link, event.at, event.stamp))
        case events.FrameRejected():
            return _with_link(
                state,
                replace(link, faults=link.faults + 1, last_fault=truncate(event.text), fault_at=state.now),
            )
        case _:
            assert_never(event)
