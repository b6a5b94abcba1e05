"""The terminal console for robot fleets behind a rosbridge server."""

import os

__version__ = "0.8.0"

# Textual reads this when it is imported: a key is painted within 1 ms instead of 17. Unchanged cells
# are not sent, at any rate.
os.environ.setdefault("TEXTUAL_FPS", "1000")

# numpy reads this when it is imported: a thread per core is of no use to us, and starting them costs
# 0.1 s of CPU.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
