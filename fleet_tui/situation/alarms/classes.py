"""Classes of alarms, rationalised as in ISA-18.2: cause, consequence, the operator's action, time to act."""

from fleet_tui.model.alarm import Condition, class_of
from fleet_tui.situation.fact import AlarmClass
from fleet_tui.situation.facts import FACTS
from fleet_tui.text.language import N_, Message

CLASSES = {
    "command": AlarmClass(
        "medium",
        "a command was refused, not confirmed or carried out late; an order ended neither done nor cancelled"
        " here; high for a failed pause",
        "the robots are not doing as requested",
        Message("Read the reason, check the robot, then give the command again"),
        2,
    ),
    N_("issue"): AlarmClass(
        "medium",
        "the fleet adapter of a robot reports an issue, or its driver an emergency or an adapter error",
        "it may stand until somebody looks; its fleet may give its tasks to others",
        Message("Read the issue on the robot's page; check its fleet adapter and the robot"),
        5,
    ),
    N_("facility"): AlarmClass(
        "medium",
        "a lift in fire or emergency mode, or a lift, a door, a dispenser or an ingestor offline",
        "robots that need it wait there",
        Message("Go there and put it back in service, or close the lanes to it"),
        10,
    ),
    "held": AlarmClass(
        "low",
        "orders wait in this console; medium if another client took over the robot",
        "they are not carried out",
        Message("Resume the robot, or clear its orders"),
        30,
    ),
    "battery": AlarmClass(
        "low",
        "below `battery_low`, at a charger for half an hour; medium below `battery_critical`",
        "the robot may stop on its way",
        Message("Send it to a charger"),
        20,
    ),
    **{kind.name: kind.alarm for kind in FACTS if kind.alarm is not None},
}
"""All classes, by the names that the configuration uses."""


def action_of(condition: Condition) -> Message:
    """Return what the operator is to do about a condition."""
    return condition.remedy or CLASSES[class_of(condition.kind)].action
