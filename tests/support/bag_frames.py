"""Messages of bags for tests."""


class Connection:
    """The relevant fields of a connection, as rosbags reports it."""

    def __init__(self, msgtype: str, text: str, form: str = "MSG") -> None:
        from rosbags.interfaces import MessageDefinition, MessageDefinitionFormat

        self.msgtype, self.msgdef = msgtype, MessageDefinition(MessageDefinitionFormat[form], text)


LINE = "=" * 80
