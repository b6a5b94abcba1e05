"""Facts about what is between the robots and the screen: the bridges, and this console."""

from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState, behind_text
from fleet_tui.model.link import NO_WAY, LinkState, Phase
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
    """Find that an allow-list of a bridge lacks topics of its robots: it drops these subscriptions."""
    if link.phase is not Phase.UP or not link.not_allowed:
        return None
    topics = some([*link.not_allowed])
    return Fact(
        NOT_ALLOWED,
        link.name,
        f"the bridge does not allow {topics} (topics_glob)",
        Priority.HIGH,
        link.since,
        remedy=NOT_ALLOWED.alarm.action,
        evidence=f"its log says so of {topics}",
    )


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
