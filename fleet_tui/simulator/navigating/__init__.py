"""Robots that drive to poses on a map, whichever navigation stack they run: body, world, words, topics."""
