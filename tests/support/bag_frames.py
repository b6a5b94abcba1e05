"""Messages of bags for tests."""


class Connection:
    """What rosbags says of a connection, as far as it matters here."""

    def __init__(self, msgtype: str, text: str, form: str = "MSG") -> None:
        from rosbags.interfaces import MessageDefinition, MessageDefinitionFormat

        self.msgtype, self.msgdef = msgtype, MessageDefinition(MessageDefinitionFormat[form], text)


LINE = "=" * 80
