"""Keys of the map, most of which work from every pane."""

from fleet_tui.actions import Actions
from fleet_tui.keys.key import Key, Pane
from fleet_tui.text.language import Message

MAP: tuple[Key[Actions], ...] = (
    Key(
        "zoom_in", ("+",), lambda do: do.map.zoom_in(), Message("Zoom in"), hint=Message("zoom"), of_map=True
    ),
    Key("zoom_out", ("-",), lambda do: do.map.zoom_out(), Message("Zoom out"), of_map=True),
    Key(
        "fit",
        ("0",),
        lambda do: do.map.fit(),
        Message("Fit the floor to the pane"),
        hint=Message("fit"),
        of_map=True,
    ),
    Key(
        "zoom_about",
        ("z",),
        lambda do: do.map.zoom_about(),
        Message("Toggle the zoom centre: robot or view"),
        of_map=True,
    ),
    Key(
        "follow",
        ("f",),
        lambda do: do.map.follow(),
        Message("Toggle following the selected robot"),
        hint=Message("follow"),
        of_map=True,
    ),
    Key(
        "centre",
        ("c",),
        lambda do: do.map.centre(),
        Message("Centre on the selected robot, once"),
        hint=Message("centre"),
        of_map=True,
        helps="leaves",
    ),
    Key("edges", ("e",), lambda do: do.map.edges(), Message("Toggle edges"), of_map=True),
    Key("labels", ("v",), lambda do: do.map.labels(), Message("Toggle labels"), of_map=True),
    Key(
        "trails",
        ("t",),
        lambda do: do.map.trails(),
        Message("Toggle trails: robot positions of the last minute"),
        of_map=True,
    ),
    Key(
        "drawing",
        ("m",),
        lambda do: do.map.drawing(),
        Message("Cycle the drawing: braille, half-block, ASCII"),
        of_map=True,
    ),
    Key(
        "map_cursor",
        ("g",),
        lambda do: do.map.cursor(),
        Message("Toggle the map cursor; arrows move it"),
        of_map=True,
    ),
    Key(
        "next_vertex",
        ("n",),
        lambda do: do.map.next_vertex(1),
        Message("Go to the next labelled vertex"),
        of_map=True,
    ),
    Key(
        "previous_vertex",
        ("N",),
        lambda do: do.map.next_vertex(-1),
        Message("Go to the previous labelled vertex"),
        of_map=True,
    ),
    Key("pan_left", ("left", "h"), lambda do: do.map.pan(-1, 0), Message("Pan left"), pane=Pane.MAP),
    Key("pan_right", ("right", "l"), lambda do: do.map.pan(1, 0), Message("Pan right"), pane=Pane.MAP),
    Key("pan_up", ("up", "k"), lambda do: do.map.pan(0, -1), Message("Pan up"), pane=Pane.MAP),
    Key("pan_down", ("down", "j"), lambda do: do.map.pan(0, 1), Message("Pan down"), pane=Pane.MAP),
    Key(
        "pick",
        ("enter",),
        lambda do: do.map.pick(),
        Message("Open the robot's menu; with the map cursor: order from its vertex, or select its robot"),
        pane=Pane.MAP,
    ),
)
