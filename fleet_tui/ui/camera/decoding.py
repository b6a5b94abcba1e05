"""Decodes pictures of cameras with Pillow: small, and hostile ones only by name."""

import io
import warnings
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from fleet_tui.text.language import EMPTY, Message, verbatim
from fleet_tui.text.limits import truncate
from fleet_tui.text.sanitize import sanitize

MOST_PIXELS = 16_000_000
FORMATS = ("JPEG", "PNG")
LONGEST_REASON = 80

Pixels = NDArray[np.uint8]
"""Shape (height, width, 3): red, green and blue."""

# Its limit is far above ours, and a warning on stderr would garble the screen.
warnings.filterwarnings("ignore", category=Image.DecompressionBombWarning)


class Decoded(NamedTuple):
    """A picture, scaled; `size` is that of the camera, width and height. Without `pixels` the reason."""

    pixels: Pixels | None
    size: tuple[int, int] = (0, 0)
    reason: Message = EMPTY


def decode(data: bytes, width: int, height: int) -> Decoded:
    """Return a picture that fits into `width` x `height` pixels. Takes long for large ones: not for the
    loop. Never raises."""
    try:
        with Image.open(io.BytesIO(data), formats=FORMATS) as image:
            size = image.size
            if size[0] * size[1] > MOST_PIXELS:
                return Decoded(
                    None,
                    size,
                    Message(
                        "{width} x {height} px exceeds {limit} px",
                        width=size[0],
                        height=size[1],
                        limit=f"{MOST_PIXELS:,}",
                    ),
                )
            return Decoded(_scaled(image, max(width, 1), max(height, 1)), size)
    except UnidentifiedImageError:
        return Decoded(None, reason=Message("unreadable: cut off, or neither JPEG nor PNG"))
    except Image.DecompressionBombError:
        return Decoded(None, reason=Message("exceeds {limit} px", limit=f"{MOST_PIXELS:,}"))
    except Exception as problem:  # noqa: BLE001  # hostile bytes: decoders raise what no list has in full
        text = sanitize(verbatim(truncate(str(problem), LONGEST_REASON)))
        return Decoded(None, reason=Message("unreadable: {text}", text=text or type(problem).__name__))


def _scaled(image: Image.Image, width: int, height: int) -> Pixels:
    # Of a large JPEG only as many pixels are decoded as are shown.
    image.draft("RGB", (width, height))
    scale = min(width / image.width, height / image.height)
    wanted = max(1, round(image.width * scale)), max(1, round(image.height * scale))
    small = _in_colour(image).resize(wanted, Image.Resampling.BOX, reducing_gap=2.0)
    return np.asarray(small, dtype=np.uint8)


def _in_colour(image: Image.Image) -> Image.Image:
    if image.mode.startswith("I"):  # 16 bits of grey, which Pillow would cut, not scale
        deep = np.clip(np.asarray(image), 0, 65535) >> 8
        return Image.fromarray(deep.astype(np.uint8)).convert("RGB")
    return (image.convert("RGBA") if "transparency" in image.info else image).convert("RGB")
