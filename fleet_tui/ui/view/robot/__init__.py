"""The page of one robot, over the whole screen, as lines of text."""
