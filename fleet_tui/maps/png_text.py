"""Text in the pixels of a PNG, as rosbridge compresses messages."""

import base64
import io

from fleet_tui.robots.adapter import Limit
from fleet_tui.text.errors import WireError
from fleet_tui.text.language import Message


def text_of_png(data: str, limit: Limit) -> bytes:
    """Return the text in a base64 picture. The 39 kB of a large map are 8 MB of text: not for the loop.

    Raises WireError for an unreadable picture, or for one of more text than `limit` allows.
    """
    from PIL import Image  # takes longer to import than a status without a map

    megabytes, key = limit
    try:
        with Image.open(io.BytesIO(base64.b64decode(data)), formats=["PNG"]) as image:
            size = 3 * image.width * image.height
            if size > megabytes * 1e6:
                text = Message(
                    "a message of {size} MB exceeds the limit of {megabytes} MB: raise {key}",
                    size=f"{size / 1000000.0:.1f}",
                    megabytes=f"{megabytes:g}",
                    key=key,
                )
                raise WireError(text)
            return image.convert("RGB").tobytes().rstrip(b"\n")
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as problem:
        raise WireError(f"unreadable: {problem}") from None
