"""Examples of the commands, for their help and for the manual page."""

from collections.abc import Mapping

Example = tuple[str, str]
"""A line for a shell, and its effect."""

EXAMPLES: Mapping[str, tuple[Example, ...]] = {
    "demo": (
        ("fleet-tui demo", "three robots on two floors"),
        ("fleet-tui demo --kind nav2 --robots 12", "twelve robots with Nav2"),
        ("fleet-tui demo --fault dies:robot_1", "one of them dies: watch what the console says"),
    ),
    "sim": (
        ("fleet-tui sim --kind nav2 --port 9191", "robots with Nav2 behind ws://127.0.0.1:9191"),
        ("fleet-tui sim --robots 50 --speed 10", "fifty robots, ten times as fast"),
    ),
    "config": (
        ("fleet-tui config init --output config.toml", "an example to edit"),
        ("fleet-tui config show", "every value in effect"),
    ),
    "config init": (
        ("fleet-tui config init --output config.toml", "an example to edit"),
        (
            "fleet-tui config init --from-live ws://robot-server:9090 --output config.toml",
            "the robots that are there",
        ),
    ),
    "config show": (("fleet-tui config show --origin", "every value, with the file and line it comes from"),),
    "doctor": (
        ("fleet-tui doctor --url ws://robot-server:9090", "check a bridge without a configuration"),
        ("fleet-tui doctor --robot robot_0", "check one robot"),
        ("fleet-tui doctor --bundle", "pack the report, log and recordings for a ticket"),
    ),
    "status": (
        ("fleet-tui status || echo 'somebody should look'", "the fleet as a table"),
        ("fleet-tui status --json | jq '.robots[].name'", "for scripts"),
        ("fleet-tui status --oneline --watch", "for the status bar of tmux"),
    ),
    "order": (
        ("fleet-tui order robot_0 Base Store", "from Base to Store: ends when it is in the queue"),
        ("fleet-tui order robot_0 Store", "to Store, with the cargo on board"),
        (
            "fleet-tui order robot_0 Base Store --until-done && echo arrived",
            "ends when it is driven, after an hour at most",
        ),
    ),
    "cancel": (("fleet-tui cancel robot_0 12", "the order with the id 12"),),
    "clear": (("fleet-tui clear robot_0 --yes", "without a question, as in a script"),),
    "pause": (
        ("fleet-tui pause robot_0", "one robot"),
        ("fleet-tui pause --all", "all robots; not a safety device"),
    ),
    "resume": (
        ("fleet-tui resume robot_0", "one robot"),
        ("fleet-tui resume --all --yes", "all robots, in spite of warnings"),
    ),
    "goto": (
        ("fleet-tui goto robot_0 Store", "to the vertex with this label"),
        ("fleet-tui goto robot_0 3.5 -2 90", "to x 3.5 m, y -2 m, facing the map's y"),
    ),
    "set-pose": (
        ("fleet-tui set-pose robot_0 3.5 -2 90", "asks, then tells the robot where it stands"),
        ("fleet-tui set-pose robot_0 3.5 -2 90 --yes", "without the question"),
    ),
    "localise": (("fleet-tui localise robot_0", "asks, then the robot searches"),),
    "settle": (
        ("fleet-tui settle robot_0", "up to 5 calls, until the pose stays"),
        ("fleet-tui settle robot_0 1", "one call"),
    ),
    "mapping": (
        ("fleet-tui mapping robot_0 on", "asks, then the robot maps"),
        ("fleet-tui mapping robot_0 off --yes", "back to navigation, without the question"),
    ),
    "store-map": (("fleet-tui store-map robot_0 hall", "its navigation saves the map hall"),),
    "store-pose-graph": (
        ("fleet-tui store-pose-graph robot_0 hall", "for a later mapping of the same hall"),
    ),
    "run": (
        ("fleet-tui run morning.txt --dry-run", "tell for each line whether it would be sent"),
        ("echo 'robot_0 Base > Store' | fleet-tui run -", "one line from a pipe"),
    ),
    "map": (
        ("fleet-tui map show ws://robot-server:9090", "the live map, in the terminal"),
        ("fleet-tui map save ws://robot-server:9090 maps/hall", "maps/hall.yaml and maps/hall.pgm"),
        ("fleet-tui map info maps/hall.yaml", "size, resolution and origin"),
    ),
    "map info": (
        ("fleet-tui map info maps/hall.yaml", "of a file"),
        ("fleet-tui map info ws://robot-server:9090 --json", "of the live map, for scripts"),
    ),
    "map show": (
        ("fleet-tui map show maps/hall.yaml", "the whole map"),
        ("fleet-tui map show maps/hall.yaml --part 400 100 160 80", "160 x 80 pixels of it, from (400, 100)"),
    ),
    "map save": (
        ("fleet-tui map save ws://robot-server:9090 maps/hall", "maps/hall.yaml and maps/hall.pgm"),
        ("fleet-tui map save ws://robot-server:9090 maps/upper --floor floor_1", "one floor of several"),
    ),
    "map place": (
        (
            "fleet-tui map place plan.png hall --points 20 30 420 30 --distance 40",
            "the plan's points (20, 30) and (420, 30) are 40 m apart",
        ),
    ),
    "graph": (
        ("fleet-tui graph lint hall.geojson", "list errors and warnings"),
        ("fleet-tui graph show hall.geojson --map maps/hall.yaml", "draw it over a map"),
        ("fleet-tui graph convert hall.building.yaml hall.geojson", "from Open-RMF to Nav2"),
    ),
    "graph lint": (("fleet-tui graph lint hall.geojson", "list errors and warnings"),),
    "graph diff": (
        ("fleet-tui graph diff old.geojson new.geojson", "what has been added, removed, changed"),
    ),
    "graph convert": (
        ("fleet-tui graph convert hall.building.yaml hall.geojson", "from Open-RMF to Nav2"),
        ("fleet-tui graph convert hall.geojson hall.yaml --to rmf", "from Nav2 to Open-RMF"),
    ),
    "graph show": (
        ("fleet-tui graph show hall.geojson", "the graph alone"),
        ("fleet-tui graph show hall.geojson --map maps/hall.yaml", "over its map"),
    ),
    "programs": (
        ("fleet-tui programs", "list them with their states"),
        ("fleet-tui programs restart laser", "asks, then waits until it runs"),
        ("fleet-tui programs log laser --follow", "its log, line by line"),
    ),
    "programs start": (("fleet-tui programs start laser", "waits until it runs"),),
    "programs stop": (("fleet-tui programs stop laser", "asks, then waits until it has stopped"),),
    "programs restart": (("fleet-tui programs restart laser", "asks, then waits until it runs"),),
    "programs log": (
        ("fleet-tui programs log laser", "its last lines"),
        ("fleet-tui programs log laser --follow", "and each new one, until Ctrl-C"),
    ),
    "routine": (
        ("fleet-tui routine check morning", "the problems, or the timeline"),
        ("fleet-tui routine run morning", "carry it out, and print each step"),
    ),
    "routine check": (("fleet-tui routine check morning", "the problems, or the timeline"),),
    "routine run": (
        ("fleet-tui routine run morning", "carry it out, and print each step"),
        ("fleet-tui routine run morning --resume", "go on where it was held"),
    ),
    "routine list": (("fleet-tui routine list", "the routines in the folder of the configuration"),),
    "routine install": (("fleet-tui routine install morning --print", "show its timer without writing it"),),
    "history": (
        ("fleet-tui history --robot robot_0 --since 2h", "what happened to one robot"),
        ("fleet-tui history --since 7d lost", "every event of a week with this word"),
        ("fleet-tui history --collect", "write the history where no console stays open"),
    ),
    "report": (
        ("fleet-tui report --output shift.html", "the last eight hours"),
        ("fleet-tui report --since 30d --output month.html", "a month"),
    ),
    "audit": (
        ("fleet-tui audit --robot robot_0 --since 2h", "the commands of the last two hours"),
        ("fleet-tui audit --since 7d --csv > week.csv", "a week for a spreadsheet"),
    ),
    "record": (
        ("fleet-tui record shift.jsonl.gz --for 8h", "a shift"),
        ("fleet-tui record night.jsonl.gz --rotate-every 1h --keep 12", "the last twelve hours, always"),
    ),
    "replay": (
        ("fleet-tui replay shift.jsonl.gz --at 12:04:31", "from this time of day"),
        ("fleet-tui replay shift.jsonl.gz --speed 8", "eight times as fast"),
    ),
    "metrics": (
        ("fleet-tui metrics & curl -s localhost:9464/metrics | grep ^fleet_robot", "the figures of robots"),
    ),
    "serve": (
        ("fleet-tui serve", "watch at http://127.0.0.1:8000"),
        ("fleet-tui serve --demo --allow-commands", "a simulated fleet for each tab, to try it"),
    ),
    "check": (("fleet-tui check && fleet-tui", "open the console if the configuration is valid"),),
    "kinds": (
        ("fleet-tui kinds", "what each kind reports and accepts"),
        ("fleet-tui kinds --json", "for scripts"),
    ),
    "rights": (("fleet-tui rights", "what you may do here: view, dispatch or setup"),),
    "man": (
        ("fleet-tui man", "all commands on one page"),
        ("fleet-tui man > fleet-tui.1", "its source, for man fleet-tui"),
    ),
    "docs": (
        ("fleet-tui docs tutorial", "the first robot"),
        ("fleet-tui docs keys | grep -i pause", "search a page"),
    ),
}
"""By the words of the command after `fleet-tui`."""
