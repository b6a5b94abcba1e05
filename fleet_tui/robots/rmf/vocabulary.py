"""Names of Open-RMF's topics, each shared by all robots behind a bridge."""

from fleet_tui.robots.ros.names import Vocabulary

VOCABULARY = Vocabulary(
    topics={
        "fleets": ("/fleet_states", "rmf_fleet_msgs/FleetState"),
        "statuses": ("/fleet_state_update", "std_msgs/String"),
        "tasks": ("/task_state_update", "std_msgs/String"),
        "responses": ("/task_api_responses", "rmf_task_msgs/ApiResponse"),
        "dispatches": ("/dispatch_states", "rmf_task_msgs/DispatchStates"),
        "graphs": ("/nav_graphs", "rmf_building_map_msgs/Graph"),
        "building": ("/map", "rmf_building_map_msgs/BuildingMap"),
        "lifts": ("/lift_states", "rmf_lift_msgs/LiftState"),
        "doors": ("/door_states", "rmf_door_msgs/DoorState"),
        "dispensers": ("/dispenser_states", "rmf_dispenser_msgs/DispenserState"),
        "ingestors": ("/ingestor_states", "rmf_ingestor_msgs/IngestorState"),
        "lanes": ("/lane_states", "rmf_fleet_msgs/LaneStates"),
        "requests": ("/task_api_requests", "rmf_task_msgs/ApiRequest"),
    },
    floor_topics=frozenset(),
    services={},
    fields={},
)
