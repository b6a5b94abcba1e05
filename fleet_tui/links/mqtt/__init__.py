"""Links to MQTT brokers: the vehicles of VDA 5050 on them."""
