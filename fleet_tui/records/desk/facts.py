"""Facts that consoles tell each other: one per line of a shared file."""

from typing import Annotated

from msgspec import Meta, Struct

from fleet_tui.model.commands import Stage

Name = Annotated[str, Meta(max_length=200)]
Text = Annotated[str, Meta(max_length=2000)]
Wall = Annotated[float, Meta(ge=0, le=1e10)]
"""Unix seconds that every calendar has."""
ShelvedFor = Annotated[float, Meta(ge=0, le=1e6)]
"""Seconds: no configuration allows more."""


class SharedFact(Struct, frozen=True, tag_field="fact"):
    """`id` is unique: the console's, and a number. `by` is the operator, `wall` Unix seconds."""

    id: Name
    by: Name
    wall: Wall

    @property
    def console(self) -> str:
        """Return the id of the console that told it."""
        return self.id.rpartition(":")[0]


class SharedAcknowledgement(SharedFact, frozen=True, tag="acknowledged"):
    """An alarm was acknowledged."""

    source: Name
    kind: Name


class SharedShelving(SharedFact, frozen=True, tag="shelved"):
    """An alarm was shelved for `seconds`; 0: unshelved."""

    source: Name
    kind: Name
    seconds: ShelvedFor


class SharedNote(SharedFact, frozen=True, tag="note"):
    """A remark for whoever takes over."""

    text: Text


class SharedClosure(SharedFact, frozen=True, tag="edge"):
    """An edge was closed, or opened again."""

    ends: tuple[Name, Name, Name]
    closed: bool


class SharedCommand(SharedFact, frozen=True, tag="command"):
    """A command reached a stage: `what` is its name in the audit log, `order` the one that it removes, else
    empty, `request` its number."""

    robot: Name
    what: Name
    order: Name
    request: Annotated[int, Meta(ge=0, le=2**53)]
    stage: Stage


Fact = SharedAcknowledgement | SharedShelving | SharedNote | SharedClosure | SharedCommand
