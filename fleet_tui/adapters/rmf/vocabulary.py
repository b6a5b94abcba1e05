"""Names of Open-RMF's topics, each shared by all robots behind a bridge."""

from fleet_tui.adapters.ros.names import Vocabulary

VOCABULARY = Vocabulary(
    topics={
        "fleets": ("/fleet_states", "rmf_fleet_msgs/FleetState"),
        "statuses": ("/fleet_state_update", "std_msgs/String"),
        "tasks": ("/task_state_update", "std_msgs/String"),
    },
    floor_topics=frozenset(),
    services={},
    fields={},
)
