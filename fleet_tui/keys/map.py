"""Keys of the map, most of which work from every pane."""

from fleet_tui.actions import Actions
from fleet_tui.keys.key import Key, Pane

MAP: tuple[Key[Actions], ...] = (
    Key("zoom_in", ("+",), lambda do: do.map.zoom_in(), "Zoom in", hint="zoom", of_map=True),
    Key("zoom_out", ("-",), lambda do: do.map.zoom_out(), "Zoom out", of_map=True),
    Key("fit", ("0",), lambda do: do.map.fit(), "Fit the floor to the pane", hint="fit", of_map=True),
    Key(
        "zoom_about",
        ("z",),
        lambda do: do.map.zoom_about(),
        "Toggle the zoom centre: robot or view",
        of_map=True,
    ),
    Key(
        "follow",
        ("f",),
        lambda do: do.map.follow(),
        "Toggle following the selected robot",
        hint="follow",
        of_map=True,
    ),
    Key(
        "centre",
        ("c",),
        lambda do: do.map.centre(),
        "Centre on the selected robot, once",
        hint="centre",
        of_map=True,
        helps="leaves",
    ),
    Key("edges", ("e",), lambda do: do.map.edges(), "Toggle edges", of_map=True),
    Key("labels", ("v",), lambda do: do.map.labels(), "Toggle labels", of_map=True),
    Key(
        "trails",
        ("t",),
        lambda do: do.map.trails(),
        "Toggle trails: robot positions of the last minute",
        of_map=True,
    ),
    Key(
        "drawing",
        ("m",),
        lambda do: do.map.drawing(),
        "Cycle the drawing: braille, half-block, ASCII",
        of_map=True,
    ),
    Key(
        "map_cursor",
        ("g",),
        lambda do: do.map.cursor(),
        "Toggle the map cursor; arrows move it",
        of_map=True,
    ),
    Key(
        "next_vertex",
        ("n",),
        lambda do: do.map.next_vertex(1),
        "Go to the next labelled vertex",
        of_map=True,
    ),
    Key(
        "previous_vertex",
        ("N",),
        lambda do: do.map.next_vertex(-1),
        "Go to the previous labelled vertex",
        of_map=True,
    ),
    Key("pan_left", ("left", "h"), lambda do: do.map.pan(-1, 0), "Pan left", pane=Pane.MAP),
    Key("pan_right", ("right", "l"), lambda do: do.map.pan(1, 0), "Pan right", pane=Pane.MAP),
    Key("pan_up", ("up", "k"), lambda do: do.map.pan(0, -1), "Pan up", pane=Pane.MAP),
    Key("pan_down", ("down", "j"), lambda do: do.map.pan(0, 1), "Pan down", pane=Pane.MAP),
    Key(
        "pick",
        ("enter",),
        lambda do: do.map.pick(),
        "Open the robot's menu; with the map cursor: order from its vertex, or select its robot",
        pane=Pane.MAP,
    ),
)
