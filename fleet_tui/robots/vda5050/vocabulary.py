"""The names of this kind: its topics have a template in place of a name each."""

from fleet_tui.robots.ros.names import Vocabulary

VOCABULARY = Vocabulary(topics={}, floor_topics=frozenset(), services={}, fields={})
