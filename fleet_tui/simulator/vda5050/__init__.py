"""Simulated vehicles of VDA 5050 on an MQTT broker of their own."""
