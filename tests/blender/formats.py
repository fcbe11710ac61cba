# The same scene by glTF, OBJ, FBX and .blend: blender -b --factory-startup --python formats.py -- ZIP ZSTRIP FOLDER
# A scene of this script's own is written in each format, drawn by the command, and compared with that of glTF.
import subprocess
import sys

import bpy

sys.path.insert(0, __file__.rsplit('/', 1)[0])
from checks import ZSTRIP, check, failures, path

NEAR = 8  # of 255
STRAY = 0.02  # share of pixels that may differ by more: at borders
LOOK = ['--size', '120x120', '--look-at', '0,0,0', '--fov', '30', '--plain-materials']


def coloured(name, colour):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes['Principled BSDF']
    shader.inputs['Base Color'].default_value = (*colour, 1)
    return material, shader


def add(material, smooth=False):
    thing = bpy.context.active_object
    thing.data.materials.append(material)
    for face in thing.data.polygons:
        face.use_smooth = smooth
    return thing


def make_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_cube_add(size=2, location=(-1.2, 0, 0))
    add(coloured('dark', (0.1, 0.2, 0.05))[0])
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8, radius=1, location=(1.2, 0, 0))
    add(coloured('bright', (0.8, 0.3, 0.1))[0], smooth=True)
    picture = bpy.data.images.new('texels', 2, 2)
    picture.pixels = [0.5, 0.1, 0.1, 1, 0.1, 0.5, 0.1, 1, 0.1, 0.1, 0.5, 1, 0.5, 0.5, 0.5, 1]
    picture.filepath_raw, picture.file_format = path('texels.png'), 'PNG'
    picture.save()
    material, shader = coloured('painted', (1, 1, 1))
    node = material.node_tree.nodes.new('ShaderNodeTexImage')
    node.image = picture
    material.node_tree.links.new(shader.inputs['Base Color'], node.outputs['Color'])
    bpy.ops.mesh.primitive_plane_add(size=5, location=(0, 0, -1.2))
    ground = add(material)
    ground.modifiers.new('thick', 'SOLIDIFY').thickness = -0.3


def pixels(name):
    """Values of red, green, blue, 0 to 255, of a PNG, as Blender reads it."""
    image = bpy.data.images.load(path(name))
    image.colorspace_settings.name = 'Non-Color'
    values = [255 * value for value in image.pixels]
    bpy.data.images.remove(image)
    del values[3::4]
    return values


def drawn(name, *options):
    eye = '600,500,900' if name.endswith('.fbx') else '6,5,9'  # Blender's FBX has centimeters
    done = subprocess.run([ZSTRIP, 'render', path(name), '-o', path(name + '.png'), '--eye', eye, *LOOK, *options],
                          capture_output=True, text=True, check=False)
    check(done.returncode == 0, f'{name} is drawn {done.stderr}')
    return pixels(name + '.png')


make_scene()
bpy.ops.export_scene.gltf(filepath=path('scene.glb'), export_format='GLB', export_apply=True)
bpy.ops.wm.obj_export(filepath=path('scene.obj'), path_mode='COPY')
bpy.ops.export_scene.obj(filepath=path('older.obj'), path_mode='COPY')
bpy.ops.export_scene.fbx(filepath=path('scene.fbx'), path_mode='COPY', embed_textures=True)
bpy.ops.wm.save_as_mainfile(filepath=path('scene.blend'), compress=False, check_existing=False)
bpy.ops.wm.save_as_mainfile(filepath=path('packed.blend'), compress=True, check_existing=False)
wanted = drawn('scene.glb')
for file in ['scene.obj', 'older.obj', 'scene.fbx', 'scene.blend', 'packed.blend']:
    found = drawn(file)
    off = sum(any(abs(found[i + c] - wanted[i + c]) > NEAR for c in range(3)) for i in range(0, len(wanted), 3))
    share = 3 * off / len(wanted)
    check(share < STRAY, f'{file} is drawn as scene.glb: {100 * share:.1f} % of the pixels differ')
turned = drawn('scene.blend', '--up', 'y')
check(turned != wanted, '--up counts in the axes of Blender')
if failures:
    sys.exit(1)
