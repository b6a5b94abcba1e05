"""Rates at which messages are requested, by what the operator looks at."""
