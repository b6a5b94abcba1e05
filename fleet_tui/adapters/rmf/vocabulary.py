"""Names of Open-RMF's topics, each shared by all robots behind a bridge."""

from fleet_tui.adapters.ros.names import Vocabulary

VOCABULARY = Vocabulary(
    topics={
        "fleets": ("/fleet_states", "rmf_fleet_msgs/FleetState"),
        "statuses": ("/fleet_state_update", "std_msgs/String"),
        "tasks": ("/task_state_update", "std_msgs/String"),
        "responses": ("/task_api_responses", "rmf_task_msgs/ApiResponse"),
        "dispatches": ("/dispatch_states", "rmf_task_msgs/DispatchStates"),
        "graphs": ("/nav_graphs", "rmf_building_map_msgs/Graph"),
        "building": ("/map", "rmf_building_map_msgs/BuildingMap"),
        "requests": ("/task_api_requests", "rmf_task_msgs/ApiRequest"),
    },
    floor_topics=frozenset(),
    services={},
    fields={},
)
