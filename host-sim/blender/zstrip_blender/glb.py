# Reads and writes the JSON part of binary glTF 2.0 files (.glb): finds the camera, adds one. Without bpy.
import json
import struct
from dataclasses import dataclass

_MAGIC, _VERSION = 0x46546C67, 2
_JSON, _BINARY = 0x4E4F534A, 0x004E4942


class GlbError(Exception):
    """A file that is no binary glTF 2.0, or lacks what was asked for."""


@dataclass(frozen=True)
class Glb:
    """The JSON as Python's values, and the bytes behind it."""

    document: dict
    binary: bytes


def parse_glb(data):
    """Returns the Glb of a file's bytes. Raises GlbError."""
    if len(data) < 20:
        raise GlbError('the file is too short for a .glb')
    magic, version, length, json_length, kind = struct.unpack_from('<5I', data)
    if magic != _MAGIC or version != _VERSION or kind != _JSON or length > len(data) or 20 + json_length > length:
        raise GlbError('the file is no .glb of version 2')
    try:
        document = json.loads(data[20:20 + json_length])
    except (UnicodeDecodeError, ValueError) as error:
        raise GlbError(f'the JSON of the .glb: {error}') from error
    if not isinstance(document, dict):
        raise GlbError('the JSON of the .glb is no object')
    binary, at = b'', 20 + json_length
    if at + 8 <= length:
        binary_length, kind = struct.unpack_from('<2I', data, at)
        if kind == _BINARY and at + 8 + binary_length <= length:
            binary = bytes(data[at + 8:at + 8 + binary_length])
    return Glb(document, binary)


def to_bytes(glb):
    """Returns the bytes of the file."""
    text = json.dumps(glb.document, separators=(',', ':')).encode('utf-8')
    text += b' ' * (-len(text) % 4)
    binary = glb.binary + b'\0' * (-len(glb.binary) % 4)
    chunks = struct.pack('<2I', len(text), _JSON) + text
    if binary:
        chunks += struct.pack('<2I', len(binary), _BINARY) + binary
    return struct.pack('<3I', _MAGIC, _VERSION, 12 + len(chunks)) + chunks


def _list(document, key):
    value = document.get(key)
    return value if isinstance(value, list) else []


def camera_of(document, name):
    """Returns the name by which `zstrip --camera` finds the camera of Blender's object `name`. Exporters put the camera
    into the object's node, or into a child of it. Raises GlbError if there is none."""
    nodes = _list(document, 'nodes')

    def has_camera(node):
        return isinstance(node, dict) and 'camera' in node

    for node in nodes:
        if not isinstance(node, dict) or node.get('name') != name:
            continue
        if has_camera(node):
            return name
        for child in _list(node, 'children'):
            if isinstance(child, int) and 0 <= child < len(nodes) and has_camera(nodes[child]):
                return nodes[child].get('name') or name
    raise GlbError(f"the exported file does not have the camera '{name}'; is it hidden for rendering?")


@dataclass(frozen=True)
class Lens:
    """What a camera of glTF sees: the vertical angle in radians, or half the height of a parallel view."""

    angle: float = 0.0
    half_height: float = 0.0  # above 0: parallel
    near: float = 0.01
    far: float = 1000.0


def with_camera(glb, name, matrix, lens, aspect):
    """Returns the Glb with one more camera. `matrix`: 16 numbers by columns, from the camera to the world, y up,
    without scale. `aspect`: width by height."""
    if lens.half_height > 0:
        camera = {'type': 'orthographic',
                  'orthographic': {'xmag': lens.half_height * aspect, 'ymag': lens.half_height, 'znear': lens.near,
                                   'zfar': lens.far}}
    else:
        camera = {'type': 'perspective',
                  'perspective': {'yfov': lens.angle, 'aspectRatio': aspect, 'znear': lens.near, 'zfar': lens.far}}
    document = dict(glb.document)
    cameras, nodes, scenes = (list(_list(document, key)) for key in ('cameras', 'nodes', 'scenes'))
    nodes.append({'name': name, 'matrix': list(matrix), 'camera': len(cameras)})
    cameras.append(camera)
    shown = document.get('scene', 0)
    if not scenes:
        scenes.append({})
    if not isinstance(shown, int) or not 0 <= shown < len(scenes) or not isinstance(scenes[shown], dict):
        raise GlbError('the .glb names a scene that it does not have')
    scene = dict(scenes[shown])
    scene['nodes'] = [*_list(scene, 'nodes'), len(nodes) - 1]
    scenes[shown] = scene
    document.update(cameras=cameras, nodes=nodes, scenes=scenes, scene=shown)
    return Glb(document, glb.binary)


def to_y_up(matrix):
    """Returns 16 numbers by columns of a matrix (4 rows of 4) from a camera to Blender's world, whose z points
    upwards, for glTF's world, whose y does. Both cameras look along -z."""
    x, y, z, w = (list(row) for row in matrix)
    rows = [x, z, [-value for value in y], w]
    return [rows[row][column] for column in range(4) for row in range(4)]
