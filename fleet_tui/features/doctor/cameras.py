"""Findings about the pictures of a camera. Pure.

A robot can drive without it, so none of them is a failure.
"""

from typing import TYPE_CHECKING

from fleet_tui.links.discovery.facts import LONG_ENOUGH, TopicFacts
from fleet_tui.links.discovery.finding import Verdict

if TYPE_CHECKING:
    from fleet_tui.model.set_up.streams import CameraImage

SMALL = 64
"""Pixels of the picture that is decoded to see that it can be."""
DRIVER = "check its camera driver"


def judged_camera(facts: TopicFacts) -> tuple[Verdict, str, str]:
    """Return verdict, measurement and remedy of a camera's topic, by its newest picture."""
    if not facts.count:
        if facts.waited < LONG_ENOUGH:
            return Verdict.SKIPPED, "not checked: out of time", "use a longer --timeout"
        complaint = f", rosbridge: {facts.complaint}" if facts.complaint else ""
        return Verdict.WARN, f"no picture on {facts.topic} in {facts.waited:.1f} s{complaint}", DRIVER
    # With numpy and Pillow, whose imports take longer than all other findings.
    from fleet_tui.model.set_up.streams import CameraImage

    image = facts.picture
    if not isinstance(image, CameraImage):
        return Verdict.WARN, f"no picture: unreadable: {facts.problem}", DRIVER
    if image.unshown:
        return Verdict.WARN, f"no picture: {image.unshown}", "publish JPEG or PNG of at most 4 MB"
    return _decoded(facts, image)


def _decoded(facts: TopicFacts, image: "CameraImage") -> tuple[Verdict, str, str]:
    from fleet_tui.ui.camera.decoding import decode

    found, kilobytes = decode(image.data, SMALL, SMALL), len(image.data) / 1000
    if found.pixels is None:
        return Verdict.WARN, f"no picture: {found.reason}", f"{DRIVER}, and the network between"
    width, height = found.size
    rate = "" if facts.rate is None else f", {facts.rate:.1f} Hz"
    return Verdict.OK, f"{width} x {height} px, {kilobytes:.0f} kB a picture{rate}", ""
