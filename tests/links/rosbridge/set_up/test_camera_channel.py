"""Pictures over a connection of their own: only while one is watched, as CBOR, and what keeps them away."""

from collections.abc import AsyncIterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from fleet_tui.model.set_up.streams import CameraImage
from fleet_tui.simulator.senses.camera import NAME, TYPE
from tests.support.links import linked
from tests.support.nav2_site import Site, nav2_ready, nav2_site
from tests.support.watched_store import WatchedStore

R0 = "robot_0"
TOPIC = f"/{R0}/{NAME}"


@pytest.fixture
async def site(tmp_path: Path) -> AsyncIterator[Site]:
    async with nav2_site(tmp_path, robots=1, rate=10.0) as running:
        yield running


def newest(store: WatchedStore) -> CameraImage | None:
    found = store.streams.get(R0, "camera")
    return found.value if found is not None and isinstance(found.value, CameraImage) else None


def requests(site: Site, op: str) -> list[dict[str, object]]:
    return [dict(one) for one in site.server.bridge.received if one["op"] == op and one.get("topic") == TOPIC]


async def test_a_camera_is_subscribed_over_its_own_connection_while_it_is_watched(site: Site) -> None:
    async with linked(site.config) as (_, store):
        await store.until(nav2_ready)
        before = len(site.server.bridge.channels.clients("/robot_0/odom"))
        assert before == 1 and not requests(site, "subscribe")
        store.streams.watch(R0, "camera")
        await store.until(lambda _: newest(store))
        (asked,) = requests(site, "subscribe")
        wanted = {"throttle_rate": 500, "queue_length": 1, "compression": "cbor"}
        assert wanted.items() <= asked.items() and str(asked["type"]).endswith("CompressedImage")
        sessions = site.server.bridge.channels.clients(TOPIC)
        assert sessions.isdisjoint(site.server.bridge.channels.clients("/robot_0/odom"))
        store.streams.unwatch(R0, "camera")
        await store.until(lambda _: not site.server.bridge.subscribers(TOPIC))
        await store.until(lambda _: requests(site, "unsubscribe"))


async def test_a_camera_comes_again_after_the_link(site: Site) -> None:
    async with linked(site.config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "camera")
        await store.until(lambda _: (it := newest(store)) is not None and it.data)
        await site.server.restart_bridge()
        await store.until(lambda _: (it := newest(store)) is not None and "no link" in it.unshown)
        await store.until(lambda _: (it := newest(store)) is not None and it.data)


async def test_an_old_bridge_is_asked_for_json(site: Site, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(type(site.server.bridge.dialect), "never_cbor", (TYPE,))
    async with linked(site.config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "camera")
        await store.until(lambda _: (it := newest(store)) is not None and it.data)
    assert [one.get("compression") for one in requests(site, "subscribe")] == ["cbor", "none"]


async def test_large_pictures_are_read_too_and_hostile_ones_named(site: Site) -> None:
    async with linked(site.config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "camera")
        await store.until(lambda _: newest(store))
        site.server.bridge.muted.add(TOPIC)
        for size, reason in (
            (1_500_000, ""),
            (5_000_000, "5.0 MB a picture"),
            (9_000_000, "9.0 MB a picture"),
        ):
            data = b"\xff\xd8\xff" + bytes(size)
            site.server.bridge.publish_raw(
                TOPIC, {"header": {"frame_id": ""}, "format": "jpeg", "data": data}
            )
            await store.until(lambda _: (it := newest(store)) is not None and _is(it, size, reason))  # noqa: B023  # awaited at once
        site.server.bridge.publish_raw(TOPIC, {"format": "jpeg", "data": 7})
        await store.until(lambda _: (it := newest(store)) is not None and "unreadable" in it.unshown)


def _is(image: CameraImage, size: int, reason: str) -> bool:
    return reason in image.unshown and len(image.data) == (0 if reason else size + 3)


async def test_raw_pictures_are_never_subscribed(site: Site) -> None:
    profile = replace(site.config.profile, topics={**site.config.profile.topics, "camera": f"/{R0}/scan"})
    async with linked(replace(site.config, profile=profile)) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "camera")
        await store.until(lambda _: (it := newest(store)) is not None and TYPE[-15:] in it.unshown)
        assert not site.server.bridge.subscribers(f"/{R0}/scan")


async def test_a_camera_that_nothing_publishes_is_said_and_shown_once_it_comes(site: Site) -> None:
    topics = {**site.config.profile.topics, "camera": "/{robot}/front"}
    config = replace(site.config, profile=replace(site.config.profile, topics=topics))
    async with linked(config) as (_, store):
        await store.until(nav2_ready)
        store.streams.watch(R0, "camera")
        says = "no camera: nothing publishes /robot_0/front"
        await store.until(lambda _: (it := newest(store)) is not None and it.unshown == says)
        site.server.bridge.publish_raw("/robot_0/front", {"format": "jpeg", "data": b"\xff\xd8\xff"})
        await store.until(lambda _: (it := newest(store)) is not None and it.data)
