"""The layout of the panes."""

from textual.containers import Container


class Panes(Container):
    """Only its ground is to be seen, between the panes: Textual need not make it row by row."""

    BLANK = True
