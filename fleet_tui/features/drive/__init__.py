"""Driving a robot by hand."""
