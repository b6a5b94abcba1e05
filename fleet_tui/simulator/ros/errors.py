"""Operations that fail."""


class BridgeError(Exception):
    """An operation that the bridge or a service refuses: the text is its reason."""


class ServiceError(BridgeError):
    """A call that fails: its text is the answer's `values`, with `result` false."""


class NodeDiedError(ServiceError):
    """The node dies during the call."""


class HandlerError(ServiceError):
    """The service's handler throws this text."""
