"""Findings about cameras: what the newest picture is, and none of them a failure."""

import io

import pytest
from PIL import Image

from fleet_tui.features.doctor.topics import judged_camera
from fleet_tui.links.discovery.facts import TopicFacts
from fleet_tui.links.discovery.finding import Verdict
from fleet_tui.model.set_up.streams import CameraImage
from fleet_tui.robots.adapter import Feed
from fleet_tui.text.language import Message

FEED = Feed("camera", ("robot_0",), "", "/c", "sensor_msgs/CompressedImage", 500, silent=True)


def jpeg() -> bytes:
    written = io.BytesIO()
    Image.new("RGB", (640, 480), "red").save(written, "JPEG")
    return written.getvalue()


def test_a_picture_is_told_with_its_size_and_rate() -> None:
    facts = TopicFacts(FEED, True, 2.0, count=4, rate=2.0, picture=CameraImage(jpeg()))
    kilobytes = round(len(jpeg()) / 1000)
    told = f"640 x 480 px, {kilobytes} kB a picture, 2.0 Hz"
    assert judged_camera(facts) == (Verdict.OK, told, "")


@pytest.mark.parametrize(
    ("facts", "verdict", "says"),
    [
        (TopicFacts(FEED, True, 0.5), Verdict.SKIPPED, "out of time"),
        (TopicFacts(FEED, True, 2.0), Verdict.WARN, "no picture on /c in 2.0 s"),
        (TopicFacts(FEED, True, 2.0, complaint="no type"), Verdict.WARN, "rosbridge: no type"),
        (TopicFacts(FEED, True, 2.0, 1, 1, problem="data: 7"), Verdict.WARN, "unreadable: data: 7"),
        (
            TopicFacts(FEED, True, 2.0, 1, picture=CameraImage(b"", None, Message("raw"))),
            Verdict.WARN,
            "picture: raw",
        ),
        (TopicFacts(FEED, True, 2.0, 1, picture=CameraImage(jpeg()[:200])), Verdict.WARN, "no picture: "),
    ],
)
def test_what_is_wrong_with_it(facts: TopicFacts, verdict: Verdict, says: str) -> None:
    found = judged_camera(facts)
    assert found[0] is verdict and says in found[1] and found[2]
