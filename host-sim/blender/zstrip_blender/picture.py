# Reads the pictures of `zstrip render --image ppm`, and turns them into what Blender's buffers hold. Without bpy.
from array import array
from dataclasses import dataclass


class PictureError(Exception):
    """A file that is no such picture."""


@dataclass(frozen=True)
class Picture:
    """8 bits for each of red, green and blue, as the screen shows them (sRGB), rows from the top."""

    width: int
    height: int
    rgb: bytes


MAX_SIDE = 4096


def rendered_size(width, height, percentage):
    """Returns the size in pixels at which Blender renders this share of a resolution. Both are whole numbers, as in
    Blender: 29 % of 100 are 29, but 28.999 in floating point."""
    return width * percentage // 100, height * percentage // 100


def parse_ppm(data):
    """Returns the Picture of a binary PPM (P6) or PGM (P5, greys) with 255 as the brightest value. Raises PictureError."""
    fields, at = [], 0
    while len(fields) < 4:
        while at < len(data) and (data[at:at + 1].isspace() or data[at:at + 1] == b'#'):
            if data[at:at + 1] == b'#':
                end = data.find(b'\n', at)
                at = len(data) if end < 0 else end
            else:
                at += 1
        begin = at
        while at < len(data) and not data[at:at + 1].isspace():
            at += 1
        if begin == at:
            raise PictureError('the picture ends in its header')
        fields.append(data[begin:at])
    at += 1  # one space ends the header
    channels = {b'P6': 3, b'P5': 1}.get(fields[0])
    if channels is None:
        raise PictureError('the picture is neither PPM (P6) nor PGM (P5)')
    if not all(field.isdigit() and len(field) <= 5 for field in fields[1:]):
        raise PictureError("the picture's header has no size")
    width, height, brightest = (int(field) for field in fields[1:])
    if not (1 <= width <= MAX_SIDE and 1 <= height <= MAX_SIDE) or brightest != 255:
        raise PictureError(f'the picture has {width}x{height} pixels up to {brightest}')
    pixels = data[at:at + width * height * channels]
    if len(pixels) != width * height * channels:
        raise PictureError('the picture ends before its last pixel')
    if channels == 1:
        grey, pixels = pixels, bytearray(3 * len(pixels))
        for channel in range(3):
            pixels[channel::3] = grey
    return Picture(width, height, bytes(pixels))


def turned_back(picture, rotation):
    """Returns the Picture that a panel shows turned clockwise by 0 or 90 degrees."""
    if rotation == 0:
        return picture
    width, height = picture.height, picture.width
    row = 3 * picture.width
    rows = []
    for y in range(height):
        # Column width - 1 - y of the panel, from its first row on.
        column = 3 * (picture.width - 1 - y)
        line = bytearray(3 * width)
        for channel in range(3):
            line[channel::3] = picture.rgb[column + channel::row]
        rows.append(bytes(line))
    return Picture(width, height, b''.join(rows))


def to_linear(byte):
    """Returns the light, 0 to 1, of an 8-bit value of sRGB (IEC 61966-2-1)."""
    value = byte / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


def to_srgb_byte(light):
    """Returns the 8-bit value of sRGB of a light; below 0 is 0, above 1 is 255."""
    light = min(max(light, 0.0), 1.0)
    value = 12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055
    return int(value * 255 + 0.5)


def hex_colour(red, green, blue):
    """Returns "RRGGBB", as sRGB, of linear channels."""
    return ''.join(f'{to_srgb_byte(channel):02x}' for channel in (red, green, blue))


_LINEAR = [to_linear(byte) for byte in range(256)]


def linear_pixels(picture):
    """Returns red, green, blue and alpha of each pixel as floats of linear light, rows from the bottom."""
    row = 3 * picture.width
    upwards = b''.join(picture.rgb[at:at + row] for at in range(len(picture.rgb) - row, -1, -row))
    pixels = array('f', [1.0]) * (4 * picture.width * picture.height)
    for channel in range(3):
        pixels[channel::4] = array('f', map(_LINEAR.__getitem__, upwards[channel::3]))
    return pixels
