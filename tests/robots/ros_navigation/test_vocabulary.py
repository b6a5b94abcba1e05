"""The names that both navigation stacks share."""

import pytest

from fleet_tui.robots.move_base.vocabulary import VOCABULARY as MOVE_BASE
from fleet_tui.robots.nav2.vocabulary import VOCABULARY as NAV2
from fleet_tui.robots.ros.names import Vocabulary


@pytest.mark.parametrize("vocabulary", [MOVE_BASE, NAV2])
def test_both_stacks_name_what_every_robot_has(vocabulary: Vocabulary) -> None:
    assert vocabulary.topics["pose"] == ("/{robot}/amcl_pose", "geometry_msgs/PoseWithCovarianceStamped")
    assert vocabulary.topics["drive"][0] == "/{robot}/cmd_vel"
    assert vocabulary.fields["pose"]["covariance"] == "pose.covariance"
    assert vocabulary.services["pause"] == ("", "std_srvs/Trigger")
