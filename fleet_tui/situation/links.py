"""Facts about what is between the robots and the screen: the bridges, and this console."""

from fleet_tui.model import link as reasons
from fleet_tui.model.alarm import Priority
from fleet_tui.model.fleet import FleetState, behind_text
from fleet_tui.model.link import ACTIONS_GLOB, NO_WAY, SERVICES_GLOB, UNPROVEN, CommandPath, LinkState, Phase
from fleet_tui.model.robot import Robot
from fleet_tui.situation.fact import Fact
from fleet_tui.situation.facts import (
    BEHIND,
    BRIDGE_HANGS,
    CALLS_HANG,
    COMMANDS_DEAD,
    COMMANDS_UNTRIED,
    HALF_DEAD,
    HEARTBEAT_NOT_ALLOWED,
    LATE_LINK,
    LOST_SUBSCRIPTIONS,
    NO_LINK,
    NOT_ALLOWED,
    UNSOURCED,
)
from fleet_tui.text.errors import STOPPED, UNANSWERED
from fleet_tui.text.language import EMPTY, Message, counted, joined
from fleet_tui.text.limits import some
from fleet_tui.text.units import age, duration

LATE_FROM = 1.0
"""Seconds from which this console, or a bridge, counts as late."""
_KINDS = {
    STOPPED: BRIDGE_HANGS,
    UNANSWERED: BRIDGE_HANGS,
    reasons.HALF_DEAD: HALF_DEAD,
    reasons.NO_REPLY: CALLS_HANG,
    reasons.NOT_ADMITTED: HEARTBEAT_NOT_ALLOWED,
}
"""The kinds of what is known more closely about a bridge without a link or a command path, by its reason."""


def no_link(state: FleetState, link: LinkState) -> Fact | None:
    """Find that a bridge is not connected."""
    if link.phase is Phase.UP:
        return None
    kind, why = (
        _KINDS.get(link.reason, NO_LINK),
        Message(": {reason}", reason=link.reason) if link.reason else "",
    )
    if not link.was_up:
        kind = kind._replace(over=Message("connected after {age}", age=age(state.now - link.since)))
    return Fact(
        kind,
        link.name,
        Message("{word}{why}", word=kind.word, why=why),
        Priority.HIGH,
        link.since,
        short=kind.word,
        evidence=Message("no connection to {url}{why}", url=link.url, why=why),
    )


def dead_commands(link: LinkState) -> Fact | None:
    """Find that commands would not get through, to any robot of a bridge or to those named, whether or not
    its messages arrive."""
    if link.command_path not in NO_WAY:
        return None
    kind, text = _KINDS.get(link.command_reason, COMMANDS_DEAD), link.command_reason
    if link.command_path is CommandPath.DEAD:  # else of some robots: the others take commands
        text = Message(
            "{word}: {command_reason}", word=COMMANDS_DEAD.word, command_reason=link.command_reason
        )
    evidence = Message("no orders or pauses get through")
    fact = Fact(kind, link.name, text, Priority.HIGH, link.since, evidence=evidence)
    if kind is HALF_DEAD:
        evidence = Message("no topic and no node: only the bridge itself answers")
        fact = fact._replace(short=kind.word, evidence=evidence)
    return fact


def untried_commands(link: LinkState) -> Fact | None:
    """Find that nothing shows that commands get through a bridge that is connected: no node answers. Where
    only rosapi may be asked, it need not be there."""
    if link.phase is not Phase.UP or link.command_path is not CommandPath.ALIVE or not link.command_reason:
        return None
    kind = COMMANDS_UNTRIED
    remedy = kind.action[0].lower() + kind.action[1:]
    priority = Priority.MEDIUM if link.command_reason == UNPROVEN else Priority.LOW
    return Fact(
        kind,
        link.name,
        Message(
            "commands {command_reason}: {remedy}", command_reason=link.command_reason, remedy=Message(remedy)
        ),
        priority,
        link.since,
    )


def is_late(link: LinkState) -> bool:
    """Tell whether a bridge is late with its messages, by its answers to questions that wait beside them."""
    return link.phase is Phase.UP and link.late >= LATE_FROM


def late_link(state: FleetState, link: LinkState) -> Fact | None:
    """Find a bridge that is late, with what is missing because of that."""
    if not is_late(link):
        return None
    silent = sum(robot.link == link.name and not state.is_online(robot) for robot in state.robots.values())
    effects = [counted("{count} robot silent", "{count} robots silent", silent)] * (silent > 0)
    effects += [Message("no reply to commands")] * (link.command_path in NO_WAY)
    why, told = LATE_LINK.word, joined(", ", effects)
    text = Message("messages {duration} late: {why}", duration=duration(link.late), why=why)
    if told:
        text = Message(
            "messages {duration} late, {told}: {why}", duration=duration(link.late), told=told, why=why
        )
    priority = Priority.HIGH if told else Priority.MEDIUM
    since = state.began.get((link.name, LATE_LINK.name), state.now)
    return Fact(LATE_LINK, link.name, text, priority, since)


def unsourced(link: LinkState) -> Fact | None:
    """Find that a bridge cannot read messages of its robots: the commonest mistake in setting it up."""
    if link.phase is not Phase.UP or not link.unsourced:
        return None
    text = Message(
        "rosbridge lacks package {unsourced}: source its workspace and restart rosbridge",
        unsourced=link.unsourced,
    )
    return Fact(
        UNSOURCED,
        link.name,
        text,
        Priority.HIGH,
        link.since,
        short=UNSOURCED.word,
        evidence=Message(
            "no message of {unsourced} arrives, and others of the same robots do", unsourced=link.unsourced
        ),
    )


def lost_subscriptions(link: LinkState) -> Fact | None:
    """Find that a bridge is not subscribed any more to what nodes publish, as ROS has it."""
    if link.phase is not Phase.UP or not link.dropped or link.unsourced:
        return None
    return Fact(
        LOST_SUBSCRIPTIONS,
        link.name,
        Message("rosbridge lost its subscriptions of {some}: restart it", some=some(link.dropped)),
        Priority.HIGH,
        link.since,
        short=LOST_SUBSCRIPTIONS.word,
        evidence=Message("nodes publish its topics, and the bridge is not among their subscribers"),
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
        Message("the bridge does not allow {names}", names=names),
        Priority.HIGH,
        link.since,
        short=NOT_ALLOWED.word,
        evidence=Message("its log says so, or it alone leaves these calls unanswered"),
    )


def withheld(link: LinkState) -> Fact | None:
    """Find why a connected bridge does not pass on messages of its robots."""
    return lost_subscriptions(link) or not_allowed(link) or unsourced(link)


def hidden(link: LinkState, robot: str, topic: str = "") -> Fact | None:
    """Find why nothing of a robot arrives, or not this topic, though its bridge is connected; none if it may
    be the robot."""
    if link.is_half_dead:
        return dead_commands(link)
    if robot in link.dropped:
        return lost_subscriptions(link)
    is_barred = topic in link.not_allowed if topic else link.hides(robot)
    return not_allowed(link) if is_barred else None


def bridge_remedy(state: FleetState, robot: Robot, topic: str = "") -> Message:
    """Return what to do at the bridge of a robot of which nothing arrives, or not this topic, empty if it may
    be the robot."""
    fact = hidden(state.links[robot.link], robot.name, topic.replace("{robot}", robot.name))
    return fact.action if fact is not None else EMPTY


def behind(state: FleetState) -> Fact | None:
    """Find that this console does not keep up with incoming messages: the cause is no robot and no link."""
    if state.behind < LATE_FROM:
        return None
    since = state.began.get(("console", BEHIND.name), state.now)
    return Fact(BEHIND, "console", behind_text(state), Priority.MEDIUM, since)
