"""Text in the pixels of a PNG, as rosbridge compresses messages."""

import base64
import io

from fleet_tui.adapters.adapter import Limit
from fleet_tui.errors import WireError


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
                text = f"a message of {size / 1e6:.1f} MB exceeds the limit of {megabytes:g} MB: raise {key}"
                raise WireError(text)
            return image.convert("RGB").tobytes().rstrip(b"\n")
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as problem:
        raise WireError(f"unreadable: {problem}") from None
