"""A value as a key of a cache, equal only to itself."""

from typing import Generic, TypeVar

T = TypeVar("T")


class Same(Generic[T]):
    """Comparing thousands of elements takes too long, and what holds the value may change beside it."""

    __slots__ = ("value",)

    def __init__(self, value: T) -> None:
        self.value = value

    def __hash__(self) -> int:
        return id(self.value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Same) and self.value is other.value
