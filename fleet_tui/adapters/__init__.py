"""Adapters: the messages that robots send and accept, one folder per kind. Pure."""
