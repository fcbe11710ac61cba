# What a scene says of its device: board, panel, pixels; and the settings of the command that follow from it.
import zlib

import bpy

from . import command, glb, picture, preferences, viewports

NONE = 'NONE'
# Blender does not keep the texts of lists that a function returns.
_kept = {}


def _items(key, entries, none):
    """Returns the entries (name, description) of a list, behind one for "none of them". A file keeps a number for each:
    it comes from the name, so that it stays the same when the command lists others."""
    found = tuple(entries)
    if _kept.get(key, (None,))[0] != found:
        items = [(NONE, none, '', 0)]
        items += [(name, name, description, zlib.crc32(name.encode()) & 0x7FFFFFFF or 1) for name, description in found]
        _kept[key] = (found, items)
    return _kept[key][1]


def _boards(self, context):
    boards = preferences.catalogue().boards
    return _items('boards', ((board.name, board.description) for board in boards), 'No board')


def _panels(self, context):
    def words(panel):
        return 'Sizes ' + ', '.join(f'{width}x{height}' for width, height in panel.sizes)

    return _items('panels', ((panel.name, words(panel)) for panel in preferences.catalogue().panels), 'No panel')


def _formats(self, context):
    return _items('formats', ((name, '') for name in preferences.catalogue().formats), 'Usual format')


def _uf2_boards(self, context):
    return _items('uf2', ((name, '') for name in preferences.catalogue().uf2_boards), 'Usual board')


def _changed(self, context):
    viewports.redraw()  # which asks for another picture


class ZstripSettings(bpy.types.PropertyGroup):
    """The device of a scene."""

    board: bpy.props.EnumProperty(
        update=_changed, name='Board', items=_boards, description='Whose RAM and frames a second are shown')
    panel: bpy.props.EnumProperty(
        update=_changed, name='Panel', items=_panels,
        description='The picture goes through the driver and a model of this controller')
    format: bpy.props.EnumProperty(
        update=_changed, name='Pixels', items=_formats, description='Format of the pixels')
    ram: bpy.props.StringProperty(
        update=_changed, name='RAM',
        description='For arena and strip, for example 24K; empty: what is usual; max: one strip')
    samples: bpy.props.EnumProperty(
        update=_changed, name='Samples', items=[('1', '1', ''), ('2', '2', 'Side by side'), ('4', '4', 'Two by two')],
        description='Samples a pixel, whose mean smooths edges')
    dither: bpy.props.BoolProperty(
        update=_changed, name='Dither', description='Hide the steps between colours in a pattern')
    edges: bpy.props.BoolProperty(
        update=_changed, name='Smooth edges',
        description='Smooth the edges of models alone, for less time than samples')
    highlights: bpy.props.BoolProperty(
        update=_changed, name='Highlights', description='Highlights of materials, by their roughness and metal')
    plain_materials: bpy.props.BoolProperty(
        update=_changed, name='Matt metals', description='Draw smooth metals matt, which takes less flash and time')
    modifiers: bpy.props.BoolProperty(
        name='Apply modifiers', default=True,
        description='Save meshes as their modifiers make them; shape keys are then saved as they stand')
    animation: bpy.props.BoolProperty(
        name='With animation', default=True, description='Save the animation, and armatures as skins with joints')
    uf2_board: bpy.props.EnumProperty(name='.uf2 for', items=_uf2_boards, description='The board of a saved .uf2 file')
    uf2_program: bpy.props.StringProperty(
        name='With program', subtype='FILE_PATH',
        description='A player for the Pico, zstrip_pico_player.uf2, that a saved .uf2 file also has')


def _chosen(name):
    return '' if name in ('', NONE) else name


def size_of(scene):
    """Returns width and height of the scene's picture in pixels, as Blender renders it."""
    render = scene.render
    return picture.rendered_size(render.resolution_x, render.resolution_y, render.resolution_percentage)


def background_of(scene):
    """Returns the world's colour as "RRGGBB": of its Background node where nothing is plugged in, else the plain one."""
    world = scene.world
    if world is None:
        return '000000'
    if world.use_nodes and world.node_tree:
        for node in world.node_tree.nodes:
            if node.type == 'BACKGROUND' and not node.inputs['Color'].is_linked:
                strength = node.inputs['Strength'].default_value
                return picture.hex_colour(*(channel * strength for channel in node.inputs['Color'].default_value[:3]))
    return picture.hex_colour(*world.color)


def settings_of(scene, camera):
    """Returns the command.Settings of the scene. `camera`: its name in the exported file."""
    own = scene.zstrip
    width, height = size_of(scene)
    board = preferences.catalogue().board(_chosen(own.board))
    panel = preferences.catalogue().panel(_chosen(own.panel))
    pixels = _chosen(own.format)
    if panel and not pixels:
        pixels = panel.formats[0]
    return command.Settings(
        width=width, height=height, camera=camera, background=background_of(scene), board=board.name if board else '',
        dma=board.dma if board else True, panel=panel.name if panel else '',
        rotation=command.rotation_on(panel, width, height) if panel else 0, format=pixels, ram=own.ram,
        samples=int(own.samples), dither=own.dither, edges=own.edges, highlights=own.highlights,
        plain_materials=own.plain_materials)


def camera_name(scene, document):
    """Returns the name of the scene's camera in an exported document; empty if the scene has none, so that the command
    places one. Raises command.CommandError."""
    if scene.camera is None:
        return ''
    try:
        return glb.camera_of(document, scene.camera.name)
    except glb.GlbError as error:
        raise command.CommandError(str(error)) from error


def register():
    """Adds the settings to Blender's scenes."""
    bpy.utils.register_class(ZstripSettings)
    bpy.types.Scene.zstrip = bpy.props.PointerProperty(type=ZstripSettings)


def unregister():
    """Takes them out again; a file that has them keeps them."""
    del bpy.types.Scene.zstrip
    bpy.utils.unregister_class(ZstripSettings)
