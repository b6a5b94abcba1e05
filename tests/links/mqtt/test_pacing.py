"""Of a large fleet on a broker, only the vehicles that are looked at send their frequent positions."""

import asyncio
from pathlib import Path

from fleet_tui.config.load import from_text
from fleet_tui.links.rates.plan import HOLD
from fleet_tui.model.attention import Attention
from tests.support.broker import broker_in
from tests.support.links import linked
from tests.support.polling import until
from tests.support.vda_broker import SpokenFor
from tests.support.vda_fleet import ONE, config_text
from tests.support.vda_messages import BASE, message, position

OTHER = ONE.replace('"agv"', '"agv_2"').replace("0001", "0002")


async def test_positions_are_subscribed_while_their_vehicle_is_looked_at(tmp_path: Path) -> None:
    with broker_in(tmp_path) as broker:
        vehicle = SpokenFor(broker)
        text = config_text(broker.url, "watch", robots=f"{ONE}\n{OTHER}\n[rates]\nfull_up_to = 1")
        async with linked(from_text(text)) as (link, store):
            store.attention = Attention("agv_2")
            topics = link.counters["broker"].topics
            states, positions = (topics[f"+/+/KIT/0001/{name}"] for name in ("state", "visualization"))

            def say() -> None:
                vehicle.peer.publish(f"{BASE}/visualization", message(agvPosition=position(1.0, 2.0)))
                vehicle.say()

            await store.until(lambda state: state.robots["agv"].connection)
            await asyncio.sleep(2 * HOLD)  # nobody is looked at before the link is there
            say()
            await store.until(lambda _: states.count)
            assert not positions.count
            store.attention = Attention("agv")

            def is_heard() -> bool:
                say()
                return positions.count > 0

            await until(is_heard)
            store.attention, lead = Attention("agv_2"), states.count - positions.count

            def is_left() -> bool:
                """Tell whether states have come without the positions before them."""
                say()
                return states.count - positions.count > lead + 3

            await until(is_left)
