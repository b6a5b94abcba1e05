"""The layout of the panes."""

from textual.containers import Container


class Panes(Container):
    """Only its background is visible, between the panes: Textual need not build it row by row."""

    BLANK = True
