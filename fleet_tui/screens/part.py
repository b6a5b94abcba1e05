"""What the main screen is made of. Only the whole is a class of Textual's: making each costs the start."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from textual.screen import Screen

    class Part(Screen[None]):
        """Mixed into the main screen, all of which it may use."""

else:

    class Part:
        """Mixed into the main screen, all of which it may use."""
