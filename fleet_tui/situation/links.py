"""Facts about what is between the robots and the screen: the bridges, and this console."""

from fleet_tui.errors import STOPPED, UNANSWERED
from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState, behind_text
from fleet_tui.model.link import (
    ACTIONS_GLOB,
    HALF_DEAD,
    NO_REPLY,
    NO_WAY,
    NOT_ADMITTED,
    SERVICES_GLOB,
    LinkState,
    Phase,
)
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import BEHIND, LATE_LINK, LOST_SUBSCRIPTIONS, NOT_ALLOWED
from fleet_tui.text.limits import some
from fleet_tui.text.units import counted, duration

LATE_FROM = 1.0
"""Seconds from which this console, or a bridge, counts as late."""


RESTART_BRIDGE = "Restart rosbridge: nothing of its robots arrives, and they may drive on"
"""What to do with a bridge that is half dead."""


def is_late(link: LinkState) -> bool:
    """Tell whether a bridge is late with its messages, by its answers to questions that wait beside them."""
    return link.phase is Phase.UP and link.late >= LATE_FROM


def late_link(state: FleetState, link: LinkState) -> Fact | None:
    """Find a bridge that is late, with what is missing because of that."""
    if not is_late(link):
        return None
    silent = sum(robot.link == link.name and not state.is_online(robot) for robot in state.robots.values())
    effects = [f"{counted(silent, 'robot')} silent"] * (silent > 0)
    effects += ["no reply to commands"] * (link.command_path in NO_WAY)
    why, told = LATE_LINK.word, ", ".join(effects)
    text = f"messages {duration(link.late)} late: {why}"
    if told:
        text = f"messages {duration(link.late)} late, {told}: {why}"
    priority = Priority.HIGH if told else Priority.MEDIUM
    since = state.began.get((link.name, LATE_LINK.name), state.now)
    return Fact(LATE_LINK, link.name, text, priority, since)


def lost_subscriptions(link: LinkState) -> Fact | None:
    """Find that a bridge is not subscribed any more to what nodes publish, as ROS has it."""
    if link.phase is not Phase.UP or not link.dropped or link.unsourced:
        return None
    return Fact(
        LOST_SUBSCRIPTIONS,
        link.name,
        f"rosbridge lost its subscriptions of {some(link.dropped)}: restart it",
        Priority.HIGH,
        link.since,
        remedy=RESTART_BRIDGE,
        evidence="nodes publish its topics, and the bridge is not among their subscribers",
    )


def not_allowed(link: LinkState) -> Fact | None:
    """Find that an allow-list of a bridge lacks topics or services of its robots."""
    # Questions to rosapi and to the bridge itself have substitutes; without any there is no command path.
    called = [one for one in link.barred if not one.startswith(("/rosapi/", "/rosbridge_websocket/"))]
    lists = {
        "topics_glob": [*link.not_allowed],
        SERVICES_GLOB: [one for one in called if link.barred[one] == SERVICES_GLOB],
        ACTIONS_GLOB: [one for one in called if link.barred[one] == ACTIONS_GLOB],
    }
    names = ", ".join(f"{some(barred)} ({name})" for name, barred in lists.items() if barred)
    if link.phase is not Phase.UP or not names:
        return None
    return Fact(
        NOT_ALLOWED,
        link.name,
        f"the bridge does not allow {names}",
        Priority.HIGH,
        link.since,
        remedy=NOT_ALLOWED.alarm.action,
        evidence="its log says so, or it alone leaves these calls unanswered",
    )


# With that parameter it stops answering at the second subscription.
_HANGS = "Restart rosbridge, or repair the network; on ROS 2 start it without use_events_executor"
_CALLS_HANG = (
    "Restart rosbridge, on ROS 2 without use_events_executor; until then pause a robot by its own controls"
)
_REMEDIES = {
    HALF_DEAD: RESTART_BRIDGE,
    NOT_ADMITTED: NOT_ALLOWED.alarm.action,
    NO_REPLY: _CALLS_HANG,
    STOPPED: _HANGS,
    UNANSWERED: _HANGS,
}


def remedy_for(reason: str) -> str:
    """Return what to do about a bridge without a link or a command path, empty for that of the alarm."""
    return _REMEDIES.get(reason, "")


def hidden(link: LinkState, robot: str) -> Fact | None:
    """Find why nothing of a robot arrives though its bridge is connected, none if it may be the robot."""
    if robot in link.dropped:
        return lost_subscriptions(link)
    return not_allowed(link) if link.hides(robot) else None


def behind(state: FleetState) -> Fact | None:
    """Find that this console does not keep up with incoming messages: the cause is no robot and no link."""
    if state.behind < LATE_FROM:
        return None
    since = state.began.get(("console", BEHIND.name), state.now)
    return Fact(BEHIND, "console", behind_text(state), Priority.MEDIUM, since)
