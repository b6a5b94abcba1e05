"""Stock roslibpy against a server: does what standard input asks for, prints what came back as JSON."""

import json
import sys
import threading
from typing import Any

import roslibpy

PATIENCE = 20.0  # seconds for anything


def main() -> None:
    asked = json.load(sys.stdin)
    ros = roslibpy.Ros(asked["url"].removesuffix("/"))
    ros.run(timeout=PATIENCE)
    found: dict[str, Any] = {"answers": {}, "messages": {}}
    for call in asked["calls"]:
        found["answers"][call["id"]] = answer(ros, call["service"], call["args"])
    for topic, type_ in asked["topics"].items():
        found["messages"][topic] = first_message(ros, topic, type_)
    found["echo"] = echo(ros, asked["string"])
    found["served"] = served(ros, asked["set_bool"])
    found["topic_type"] = ros.get_topic_type(next(iter(asked["topics"])))
    found["nodes"] = ros.get_nodes()
    found["fields"] = ros.get_message_details(asked["pose"])["typedefs"][0]["fieldnames"]
    print(json.dumps(found))
    ros.terminate()


def answer(ros: roslibpy.Ros, service: str, args: dict[str, Any]) -> list[Any]:
    done, got = threading.Event(), list[Any]()

    def take(result: bool, values: Any) -> None:
        got.extend((result, dict(values) if result else values))
        done.set()

    request = roslibpy.ServiceRequest(args)
    roslibpy.Service(ros, service, "").call(request, lambda v: take(True, v), lambda v: take(False, v))
    done.wait(PATIENCE)
    return got


def first_message(ros: roslibpy.Ros, name: str, type_: str) -> Any:
    done, got = threading.Event(), list[Any]()
    topic = roslibpy.Topic(ros, name, type_, queue_length=1)

    def take(message: Any) -> None:
        got.append(dict(message))
        done.set()

    topic.subscribe(take)
    done.wait(PATIENCE)
    topic.unsubscribe()
    return got[0] if got else None


def echo(ros: roslibpy.Ros, type_: str) -> Any:
    """Publish on a topic of our own, latched, and hear it."""
    talker = roslibpy.Topic(ros, "/chatter", type_, latch=True)
    talker.advertise()
    talker.publish(roslibpy.Message({"data": "hello"}))
    subscriptions = first_message(ros, "/chatter", type_)
    talker.unadvertise()
    return subscriptions


def served(ros: roslibpy.Ros, type_: str) -> Any:
    """Offer a service of our own and call it."""

    def serve(request: Any, response: Any) -> bool:
        response["success"], response["message"] = request["data"], "done"
        return True

    service = roslibpy.Service(ros, "/own_service", type_)
    service.advertise(serve)
    return answer(ros, "/own_service", {"data": True})


if __name__ == "__main__":
    main()
