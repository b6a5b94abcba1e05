"""Keys of the map, most of which work from every pane."""

from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message

MAP: tuple[Key, ...] = (
    Key("zoom_in", ("+",), Message("Zoom in"), hint=Message("zoom"), of_map=True),
    Key("zoom_out", ("-",), Message("Zoom out"), of_map=True),
    Key("fit", ("0",), Message("Fit the floor to the pane"), hint=Message("fit"), of_map=True),
    Key("zoom_about", ("z",), Message("Toggle the zoom centre: robot or view"), of_map=True),
    Key(
        "follow", ("f",), Message("Toggle following the selected robot"), hint=Message("follow"), of_map=True
    ),
    Key(
        "centre",
        ("c",),
        Message("Centre on the selected robot, once"),
        hint=Message("centre"),
        of_map=True,
        helps="leaves",
    ),
    Key("edges", ("e",), Message("Toggle edges"), of_map=True),
    Key("labels", ("v",), Message("Toggle labels"), of_map=True),
    Key("trails", ("t",), Message("Toggle trails: robot positions of the last minute"), of_map=True),
    Key("drawing", ("m",), Message("Cycle the drawing: braille, half-block, ASCII"), of_map=True),
    Key("map_cursor", ("g",), Message("Toggle the map cursor; arrows move it"), of_map=True),
    Key("next_vertex", ("n",), Message("Go to the next labelled vertex"), of_map=True),
    Key("previous_vertex", ("N",), Message("Go to the previous labelled vertex"), of_map=True),
    Key("pan_left", ("left", "h"), Message("Pan left"), pane=Pane.MAP),
    Key("pan_right", ("right", "l"), Message("Pan right"), pane=Pane.MAP),
    Key("pan_up", ("up", "k"), Message("Pan up"), pane=Pane.MAP),
    Key("pan_down", ("down", "j"), Message("Pan down"), pane=Pane.MAP),
    Key(
        "pick",
        ("enter",),
        Message("Open the robot's menu; with the map cursor: order from its vertex, or select its robot"),
        pane=Pane.MAP,
    ),
)
