"""The documented scrape configuration, rules and dashboard, with a real Prometheus."""

import json
import re
import shutil
import socket
import subprocess
import urllib.error
import urllib.parse
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace
from prometheus_client import CollectorRegistry, generate_latest
from prometheus_client.parser import text_string_to_metric_families

from fleet_tui.features.history.metrics.collector import FleetCollector
from fleet_tui.features.history.metrics.counting import Counting
from fleet_tui.features.history.metrics.serving import served
from fleet_tui.model.counters import LinkCounter
from fleet_tui.model.link import CommandPath
from tests.support.fleets import battery, fleet, link_up, pose, queue, reduced, tick
from tests.support.polling import eventually
from tests.support.records import record

DOCS = Path(__file__).parents[4] / "docs" / "prometheus"
PANELS = json.loads((DOCS / "dashboard.json").read_text())["panels"]
QUERIES = [target["expr"] for panel in PANELS for target in panel["targets"]]

needs_prometheus = pytest.mark.skipif(not shutil.which("prometheus"), reason="prometheus is not installed")


def registry() -> CollectorRegistry:
    """A fleet in which every figure has a value."""
    made = CollectorRegistry()
    counting, counter = Counting(made), LinkCounter("rosbridge", ())
    counter.round_trips.take(0.01, 0.0)
    facts = (link_up(1.0), pose(2.0), battery(2.0, 4.0), queue(2.0, (7, 1, 2, "Q")), tick(3.0))
    state = reduced(fleet(2), *facts)
    link = replace(state.links["rosbridge"], last_received=2.0, command_path=CommandPath.ALIVE)
    state = replace(state, links={"rosbridge": link})
    made.register(FleetCollector(lambda: state, lambda: {"rosbridge": counter}))
    for seen in (state, reduced(state, queue(3.5), tick(4.0))):
        counting.observe(seen)
    counting.read(state, [record(), record(change="refused")])
    return made


@pytest.fixture
def prometheus(tmp_path: Path) -> Iterator[str]:
    """The address of a Prometheus that has scraped a fleet by the documented configuration."""
    with served(registry(), "127.0.0.1", 0) as address, socket.create_server(("127.0.0.1", 0)) as taken:
        target = urllib.parse.urlsplit(address).netloc
        port = taken.getsockname()[1]
        taken.close()
        text = (DOCS / "prometheus.yml").read_text()
        assert "127.0.0.1:9464" in text and "15s" in text
        config = tmp_path / "prometheus.yml"
        config.write_text(text.replace("127.0.0.1:9464", target).replace("15s", "1s"))
        shutil.copy(DOCS / "alerts.yml", tmp_path)
        command = ["prometheus", f"--config.file={config}", f"--web.listen-address=127.0.0.1:{port}"]
        with subprocess.Popen([*command, f"--storage.tsdb.path={tmp_path}"], stderr=subprocess.PIPE) as peer:
            try:
                yield f"http://127.0.0.1:{port}"
            finally:
                peer.terminate()
                peer.communicate()


def asked(peer: str, path: str, **values: str) -> Any:
    url = f"{peer}/api/v1/{path}?{urllib.parse.urlencode(values)}"
    try:
        with urllib.request.urlopen(url, timeout=10) as answer:
            return json.load(answer)["data"]
    except urllib.error.HTTPError as problem:
        if problem.code == 503:
            return {}  # starting
        pytest.fail(f"{values}: {problem.read().decode()}")
    except OSError:
        return {}  # not up yet


@pytest.mark.nightly
@needs_prometheus
def test_every_query_of_the_dashboard_finds_its_figures(prometheus: str) -> None:
    assert len(QUERIES) >= 12
    for query in QUERIES:

        def finds(query: str = query) -> bool:
            return bool(asked(prometheus, "query", query=query).get("result"))

        eventually(finds, 40.0)


@pytest.mark.nightly
@needs_prometheus
def test_every_alert_rule_is_evaluated(prometheus: str) -> None:
    def are_healthy() -> bool:
        groups = asked(prometheus, "rules").get("groups", [])
        rules = [rule for group in groups for rule in group["rules"]]
        return len(rules) >= 7 and all(rule["health"] == "ok" for rule in rules)

    def fires() -> bool:
        pending = asked(prometheus, "alerts").get("alerts", [])
        return any(alert["labels"]["alertname"] == "FleetNotWatched" for alert in pending)

    eventually(are_healthy, 40.0)
    eventually(fires, 40.0)  # the fleet of this test is an old one


def test_every_name_in_rules_dashboard_and_docs_is_one_of_ours() -> None:
    families = text_string_to_metric_families(generate_latest(registry()).decode())
    ours = {sample.name for family in families for sample in family.samples}
    page = (DOCS.parent / "metrics.md").read_text()
    for text in (page, *QUERIES, (DOCS / "alerts.yml").read_text()):
        named = set(re.findall(r"\bfleet_[a-z_]+[a-z]", text)) - {"fleet_tui"}
        assert named <= ours | {"fleet_robot"}, named - ours
    assert ours <= set(re.findall(r"fleet_[a-z_]+[a-z]", page))
