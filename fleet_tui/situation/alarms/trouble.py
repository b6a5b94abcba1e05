"""The robots in trouble, and those without an alarm that are worth a look."""

from collections.abc import Iterable

from fleet_tui.model.alarm import Alarm, AlarmStage, Key, Priority
from fleet_tui.model.commands import ORDER_ENDS, Stage
from fleet_tui.model.fleet import MANY, FleetState, is_missing
from fleet_tui.model.order import natural
from fleet_tui.model.robot import Robot
from fleet_tui.orders.ends import seen_end
from fleet_tui.orders.newest import is_paused_elsewhere
from fleet_tui.situation.alarms.members import FAILED_MODES
from fleet_tui.situation.battery.charging import CHARGES, ON_ITS_WAY
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import BAD_DATA
from fleet_tui.situation.navigation import inactive
from fleet_tui.situation.pose_checks.jumps import is_jumping
from fleet_tui.situation.pose_checks.misplaced import misplaced_text
from fleet_tui.situation.reported_motion import (
    moves_despite_pause,
    running_action,
    says_driving,
    stands_with_order,
)
from fleet_tui.situation.robots import absence, adrift, bad_data, obstacle, silent
from fleet_tui.situation.vehicles import FINDERS
from fleet_tui.text.language import EMPTY, N_, Message

LONG_STILL = 30.0
"""Seconds of standing with an order that are worth a look: longer than loading takes."""
LOOK_EVERY = 0.5
"""Seconds from one look at all of many robots to the next."""
LOST_FOR = 60.0
"""Seconds for which an order that a robot lost is news."""
AGING = (N_("pose"), N_("battery"), N_("queue"), N_("cargo"), N_("obstacle"), N_("paused"))
"""Values that must not be old while a robot is online."""


def waits(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot has stood with an order for so long, by poses that still hold, and says of no
    reason: that it drives or works."""
    if stands_with_order(robot) < LONG_STILL or robot.orders.current is None:
        return False
    is_busy = says_driving(state, robot) or running_action(state, robot) is not None
    return not is_busy and state.is_fresh(robot, "pose")


def may_need_person(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot waits with an order or for its master control, is in a mode, such as MANUAL, in
    which it takes no order, or has a pose that jumps or at which it cannot be."""
    facts = (find(robot) for find in FINDERS) if state.is_fresh(robot, "vehicle") else ()
    is_held = any(fact is not None and fact.kind.alarm is None and fact.is_certain for fact in facts)
    return waits(state, robot) or is_held or is_lost(state, robot)


def is_lost(state: FleetState, robot: Robot) -> bool:
    """Tell whether fresh poses of a robot are no positions, or only estimated."""
    is_wrong = is_jumping(robot, state.now) or misplaced_text(state, robot) != ""
    is_wrong = is_wrong or adrift(state, robot) is not None
    return is_wrong and state.is_fresh(robot, "pose")


def in_trouble(state: FleetState) -> frozenset[str]:
    """Return the names of the robots with an alarm that is neither over nor shelved. Its off-delay keeps
    their rows where they are."""
    over = (AlarmStage.SHELVED, AlarmStage.RETURNED)
    return _robots(state, (one for one in state.alarms if one.stage not in over))


def shelved(state: FleetState) -> frozenset[str]:
    """Return the names of the robots whose trouble goes on while its alarm is shelved."""
    return _robots(state, (one for one in state.alarms if one.stage is AlarmStage.SHELVED and one.holds))


def acknowledged(state: FleetState) -> frozenset[str]:
    """Return the names of the robots with alarms that all are acknowledged, those of their links included."""
    return _concerned(state, AlarmStage.ACKNOWLEDGED) - _concerned(state, AlarmStage.UNACKNOWLEDGED)


def _concerned(state: FleetState, stage: AlarmStage) -> frozenset[str]:
    alarms = [one for one in state.alarms if one.stage is stage]
    links = {one.condition.source for one in alarms} & state.links.keys()
    if not links:  # asked several times a tick
        return _robots(state, alarms)
    return _robots(state, alarms) | {robot.name for robot in state.robots.values() if robot.link in links}


def _robots(state: FleetState, alarms: Iterable[Alarm]) -> frozenset[str]:
    named = {name for one in alarms for name in _whose(one)}
    return frozenset(named & state.robots.keys())


def urgency(alarm: Alarm) -> tuple[bool, bool, bool, bool, int]:
    """Return the sort key of an alarm. Equal ones stay in the order in which they were raised. Alarms that
    are over are below all that hold, whatever their priority; those that need nobody are just above."""
    is_over = alarm.stage is AlarmStage.RETURNED
    is_shelved, priority = alarm.stage is AlarmStage.SHELVED, alarm.condition.priority.value
    return is_shelved, is_over, _needs_nobody(alarm), not alarm.needs_acknowledgement, priority


def _needs_nobody(alarm: Alarm) -> bool:
    """Tell whether an alarm is about a robot on its way to its charger, or there."""
    return alarm.condition.remedy in (ON_ITS_WAY, CHARGES)


def by_urgency(state: FleetState) -> list[str]:
    """Return the robots in trouble in the order of the alarms pane."""
    alarms, troubled = sorted(state.alarms, key=urgency), in_trouble(state)
    return list(dict.fromkeys(name for one in alarms for name in _whose(one) if name in troubled))


def next_in_trouble(state: FleetState, after: str, marked: object = None) -> str:
    """Return the robot of the marked alarm. If `after` has it, or it is no robot's, return the next one in
    the order of the alarms pane, of those that need a person while there are some; after them those without
    an alarm that may need one; then around. Empty if there is none."""
    troubled, odd = by_urgency(state), _odd(state)
    of_marked = {name for one in state.alarms if one.key == marked for name in _whose(one)}
    # After one without an alarm, the marked alarm is the one that it came from.
    goes_on = after in of_marked or after in odd
    if not goes_on and (found := [name for name in troubled if name in of_marked]):
        return found[0]
    names = in_turn(state)
    start = names.index(after) + 1 if after in names else 0
    return names[start % len(names)] if names else ""


def in_turn(state: FleetState) -> list[str]:
    """Return the robots to go to, one after the other: those in trouble, of whom nobody knows while there are
    some, then those without an alarm that may need a person, then those that need nobody."""
    troubled, known = by_urgency(state), acknowledged(state)
    wanted = {name for one in state.alarms if one.holds and not _needs_nobody(one) for name in _whose(one)}
    unknown = [name for name in troubled if name not in known] or troubled
    return sorted([*unknown, *_odd(state)], key=lambda name: name in unknown and name not in wanted)


def _odd(state: FleetState) -> list[str]:
    unalarmed = {*shelved(state), *to_look_at(state)} - in_trouble(state)
    return [name for name in state.robots if name in unalarmed]


def alarms_of_none(state: FleetState) -> list[Key]:
    """Return the alarms that hold and are no robot's, of lifts, doors or links, in the order of the alarms
    pane."""
    lone = (one for one in sorted(state.alarms, key=urgency) if one.holds and not _robots(state, [one]))
    return [one.key for one in lone if one.stage is not AlarmStage.SHELVED]


def is_odd(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot is not as usual in a way that a person should look at, alarm or not: its row has
    an amber sign, and `!` goes there. A pause of this console and what a late bridge explains are known."""
    if not state.is_online(robot):
        fact = absence(state, robot)
        is_known = robot.last_received is not None or robot.is_gone
        is_gone = silent(state, robot) is not None and is_known
        is_bad = fact is not None and fact.kind is BAD_DATA
        return is_gone or is_bad or unexplained_end(state, robot) is not None
    is_held = is_paused_elsewhere(state, robot)
    is_held = is_held or _moves_again(state, robot)
    is_held = is_held or obstacle(state, robot) is not None
    is_held = is_held or inactive(state, robot) is not None
    unknown = is_missing(state, robot, "pose") or bad_data(state, robot) is not None
    unknown = unknown or _has_old(state, robot)
    return is_held or unknown or unexplained_end(state, robot) is not None or may_need_person(state, robot)


def _moves_again(state: FleetState, robot: Robot) -> bool:
    fact = moves_despite_pause(state, robot)
    return fact is not None and fact.priority is not Priority.LOW


def _has_old(state: FleetState, robot: Robot) -> bool:
    if not state.has_old(robot, AGING):
        return False
    others = tuple(value for value in AGING if value != "pose")
    fact = absence(state, robot)
    return state.has_old(robot, others) or fact is None or fact.priority is not Priority.LOW


class _Looks:
    """The last answer: the top line, the alarms pane and the footer ask in the same tick."""

    def __init__(self) -> None:
        self._state: FleetState | None = None
        self._odd: tuple[str, ...] = ()

    def odd(self, state: FleetState) -> tuple[str, ...]:
        if state is not self._state and not self._holds(state):
            known = in_trouble(state) | shelved(state)
            robots = (robot for name, robot in state.robots.items() if name not in known)
            self._odd = tuple(robot.name for robot in robots if is_odd(state, robot))
            self._state = state
        return self._odd

    def _holds(self, state: FleetState) -> bool:
        last = self._state
        if last is None or len(state.robots) < MANY or not 0.0 <= state.now - last.now < LOOK_EVERY:
            return False
        is_same = state.limits is last.limits and state.robots.keys() == last.robots.keys()  # the console
        return is_same and state.alarms == last.alarms


_LOOKS = _Looks()


def to_look_at(state: FleetState) -> tuple[str, ...]:
    """Return the odd robots without an alarm, shelved or not; those of many as they were less than half a
    second ago, unless an alarm has changed."""
    return _LOOKS.odd(state)


def halting_fact(state: FleetState, robot: Robot) -> Fact | None:
    """Find what keeps a robot from driving by its own fresh reports: an emergency stop, a grave error, an
    obstacle."""
    if robot.vehicle is not None and state.is_fresh(robot, "vehicle"):
        for find in FINDERS:
            if (fact := find(robot)) is not None and fact.priority is Priority.HIGH:
                return fact
    return obstacle(state, robot)


def is_halted(state: FleetState, robot: Robot) -> bool:
    """Tell whether a robot cannot drive by its own fresh reports, a mode of its driver among them."""
    if halting_fact(state, robot) is not None:
        return True
    return robot.member is not None and robot.member.value.mode in FAILED_MODES and state.is_online(robot)


def unexplained_end(state: FleetState, robot: Robot) -> Stage | None:
    """Return the last end that is only inferred of an order that a robot without another one had a short
    while ago: somebody has to see where its load is. None if there is none."""
    if robot.orders.current is not None:
        return None
    late = (one for one in reversed(robot.gone) if state.now - one.at < LOST_FOR)
    ends = (seen_end(state, robot, one) for one in late if ORDER_ENDS[one.stage].is_inferred)
    return next((end.stage for end in ends if ORDER_ENDS[end.stage].is_inferred and not end.is_open), None)


def _whose(alarm: Alarm) -> list[str]:
    return [alarm.condition.source, *sorted(alarm.condition.parts, key=natural)]


def needs_a_look(state: FleetState, name: str) -> bool:
    """Tell whether a robot has an alarm or may need a person: its row is coloured."""
    return name in in_trouble(state) or name in to_look_at(state)


def trouble_elsewhere(state: FleetState, floor: str) -> Message:
    """Return who is in trouble on other floors than this one and nobody knows of, after a `!`, else who is to
    be looked at there; empty if nobody."""
    away = _away(state, in_trouble(state) - acknowledged(state), floor)
    if len(away) == 1:
        return Message("! {name} on {floor}", name=away[0].name, floor=away[0].floor)
    if away:
        return Message("! {away} on other floors", away=len(away))
    odd = _away(state, to_look_at(state), floor)
    if len(odd) == 1:
        return Message("look at {name} on {floor}", name=odd[0].name, floor=odd[0].floor)
    return Message("look at {odd} on other floors", odd=len(odd)) if odd else EMPTY


def _away(state: FleetState, names: Iterable[str], floor: str) -> list[Robot]:
    robots = (state.robots[name] for name in sorted(names))
    return [robot for robot in robots if robot.floor not in (None, floor)]
