"""Set-up of a robot: poses and goals, mapping, cameras."""
