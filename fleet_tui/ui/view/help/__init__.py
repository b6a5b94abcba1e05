"""Help as sections of rows: tasks, keys, the legend of the map, typed commands."""
