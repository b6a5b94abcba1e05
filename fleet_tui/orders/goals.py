"""Goals as orders: the lists of a robot's action servers, combined into its queue."""

import math
from collections.abc import Collection, Iterable, Mapping, Sequence

from msgspec.structs import replace

from fleet_tui.model.navigation import Goal
from fleet_tui.model.order import BEGUN, OVER, Order, OrderQueue, OrderState, Stop
from fleet_tui.text.language import Message
from fleet_tui.text.limits import MOST_ORDERS

LISTED_FOR = 10.0
"""Seconds for which an ended goal stays in the queue, for the command that gave it."""

_FAILED = frozenset({OrderState.FAILED, OrderState.REPLACED})
Goals = Mapping[str, tuple[Goal, ...]]
"""The goals of each action."""


def with_reported(
    known: Goals, action: str, reported: Sequence[Goal], at: float, last: int, is_whole: bool = True
) -> Goals:
    """Return the goals after an action server has listed its own, oldest first; goals missing in an
    incomplete list stay. `last` is the highest serial so far."""
    before = {goal.uuid: goal for goal in known.get(action, ())}
    if not is_whole:
        reported = [
            *(goal for id_, goal in before.items() if id_ not in {one.uuid for one in reported}),
            *reported,
        ]
    seen_at = at if action in known else -math.inf
    merged = list[Goal]()
    for goal in list({goal.uuid: goal for goal in reported}.values())[-MOST_ORDERS:]:
        old = before.get(goal.uuid)
        if old is None:
            last += 1
            old = replace(goal, serial=last, listed_since=seen_at)
        merged.append(_listed(old, goal, at, seen_at))
    found = _with_legs({**known, action: tuple(_with_replaced(before, merged))})
    ended = (one for one in found[action] if one.is_leg and one.state in _FAILED)
    failed = any((old := before.get(one.uuid)) is None or old.state not in OVER for one in ended)
    return _with_missed(found) if failed else found


def _with_missed(goals: Goals) -> Goals:
    """Mark the active leading goals: their action server may count a stop that failed as reached."""
    return {
        action: tuple(
            replace(goal, has_missed=True) if goal.leads and goal.state in BEGUN else goal for goal in listed
        )
        for action, listed in goals.items()
    }


def _listed(old: Goal, goal: Goal, at: float, seen_at: float) -> Goal:
    begun = seen_at if old.begun_at is None and goal.state in BEGUN else old.begun_at
    # An order may go on after its end, when its master control adds to it; else its first end counts, if it
    # was reported.
    is_over = goal.state in OVER
    was_over = old.state in OVER and old.ended_at is not None
    was_over = was_over and (old.state is not OrderState.LOST or goal.state is OrderState.LOST)
    ended = None if not is_over else old.ended_at if was_over else seen_at
    told = old if is_over and was_over else goal
    return replace(
        old,
        stops=goal.stops if goal.stops and not old.is_ours else old.stops,
        state=told.state,
        word=told.word,
        said=goal.said,
        label=goal.label,
        tokens=goal.tokens,
        is_ending=goal.is_ending,
        begun_at=begun,
        ended_at=ended,
        listed_at=at,
    )


def _with_replaced(before: Mapping[str, Goal], goals: Sequence[Goal]) -> Iterable[Goal]:
    """Mark a goal that fails just when a newer one arrives as replaced by it."""
    for goal in goals:
        old = before.get(goal.uuid)
        was_over = old is not None and old.state in OVER
        newer = any(one.serial > goal.serial and one.state not in OVER for one in goals)
        if (old is not None and old.state is OrderState.REPLACED) or (
            goal.state is OrderState.FAILED and not was_over and newer
        ):
            yield replace(goal, state=OrderState.REPLACED)
        else:
            yield goal


def _with_legs(goals: Goals) -> Goals:
    """Mark the goals that a leading one gave while it was active."""
    leaders = [goal for listed in goals.values() for goal in listed if goal.leads and goal.state in BEGUN]
    if not leaders:
        return goals
    return {
        action: tuple(replace(goal, is_leg=True) if _is_leg_of(leaders, goal) else goal for goal in listed)
        for action, listed in goals.items()
    }


def _is_leg_of(leaders: Sequence[Goal], goal: Goal) -> bool:
    if goal.leads or goal.is_leg or goal.state in OVER:
        return goal.is_leg
    return any(one.stamp is None or goal.stamp is None or one.stamp <= goal.stamp for one in leaders)


def queue_of(goals: Goals, at: float, offset: float | None, last: int = 0) -> OrderQueue:
    """Return the goals as a queue: the active ones, and those just ended. `offset`: seconds by which our
    clock is ahead of the robot's; `last`: the highest serial before."""
    own = sorted(
        (goal for listed in goals.values() for goal in listed if not goal.is_leg),
        key=lambda goal: goal.serial,
    )
    # Two actions may report one id: a broken robot's order is still listed once.
    own = list({goal.id: goal for goal in own}.values())
    last = max([last, *(goal.serial for listed in goals.values() for goal in listed)])
    shown = [goal for goal in own if goal.ended_at is None or at - goal.ended_at < LISTED_FOR]
    begun = [goal.id for goal in shown if goal.state in BEGUN]
    orders = tuple(_order_of(goal, offset) for goal in shown[-MOST_ORDERS:])
    return OrderQueue(last, begun[-1] if begun else "", orders)


def _order_of(goal: Goal, offset: float | None) -> Order:
    has_failed = goal.state is OrderState.DONE and goal.has_missed
    return Order(
        goal.id,
        goal.stops,
        OrderState.FAILED if has_failed else goal.state,
        goal.word,
        goal.serial,
        None if goal.stamp is None or offset is None else goal.stamp + offset,
        "" if goal.stops else goal.label,
        goal.requester or goal.uuid,
        goal.said or (Message("a stop was missed") if has_failed else ""),
    )


def with_stops(goals: Goals, id_: str, stops: tuple[Stop, ...], is_ours: bool) -> Goals:
    """Return the goals, one of them with its stops and whether this console gave it."""
    return {
        action: tuple(
            replace(goal, stops=stops, is_ours=is_ours) if goal.id == id_ else goal for goal in listed
        )
        for action, listed in goals.items()
    }


def without(goals: Goals, uuids: Collection[str]) -> Goals:
    """Return the goals except those with these ids."""
    return {
        action: tuple(goal for goal in listed if goal.uuid not in uuids) for action, listed in goals.items()
    }


def is_given_as(goals: Goals, id_: str, stops: Sequence[Stop]) -> bool:
    """Tell whether a goal is of the action used for orders with these stops."""
    leads = any(goal.id == id_ and goal.leads for listed in goals.values() for goal in listed)
    return leads == (len(stops) > 1)


def own_ids(goals: Goals) -> frozenset[str]:
    """Return the ids of the goals that this console gave."""
    return frozenset(goal.id for listed in goals.values() for goal in listed if goal.is_ours)


def active(goals: Goals) -> list[Goal]:
    """Return the active goals, legs included."""
    return [goal for listed in goals.values() for goal in listed if goal.state not in OVER]
