# Makes the .glb files of this folder: blender -b --factory-startup --python make.py -- FOLDER
# Written by Blender 3.4.1 and its own exporter of glTF; everything in them comes from this file.
import math
import os
import sys

import bpy

folder = sys.argv[sys.argv.index('--') + 1]


def empty():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = 24


def export(name, **options):
    bpy.ops.export_scene.gltf(
        filepath=os.path.join(folder, name + '.glb'), export_format='GLB', export_yup=True, export_cameras=True,
        export_lights=True, **options)


def fields():
    """A picture of 8x8 fields of different colours, so that a flip or a shift shows."""
    image = bpy.data.images.new('fields', 32, 32)
    pixels = []
    for y in range(32):
        for x in range(32):
            column, row = x // 8, y // 8
            pixels += [0.2 + 0.2 * column, 0.2 + 0.2 * row, 0.9 if (column + row) % 2 else 0.1, 1.0]
    image.pixels = pixels
    image.pack()
    return image


def material(name, colour=(0.8, 0.8, 0.8, 1.0), image=None, mapping=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    shader = nodes['Principled BSDF']
    shader.inputs['Base Color'].default_value = colour
    shader.inputs['Roughness'].default_value = 1.0
    shader.inputs['Specular'].default_value = 0.0
    if image:
        texture = nodes.new('ShaderNodeTexImage')
        texture.image = image
        texture.interpolation = 'Closest'
        links.new(texture.outputs['Color'], shader.inputs['Base Color'])
        if mapping:
            place, node = nodes.new('ShaderNodeUVMap'), nodes.new('ShaderNodeMapping')
            node.inputs['Location'].default_value = (*mapping['offset'], 0)
            node.inputs['Rotation'].default_value = (0, 0, mapping['rotation'])
            node.inputs['Scale'].default_value = (*mapping['scale'], 1)
            links.new(place.outputs['UV'], node.inputs['Vector'])
            links.new(node.outputs['Vector'], texture.inputs['Vector'])
    return made


def added(made, *, at=(0, 0, 0), smooth=False):
    thing = bpy.context.object
    thing.location = at
    thing.data.materials.append(made)
    for polygon in thing.data.polygons:
        polygon.use_smooth = smooth
    return thing


def materials():
    """Textured, moved on the surface, mirrored, transparent, glowing, single- and double-sided."""
    empty()
    image = fields()
    bpy.ops.mesh.primitive_cube_add(size=1.6)
    added(material('textured', image=image), at=(-2, 0, 0))
    bpy.ops.mesh.primitive_plane_add(size=1.6, rotation=(math.pi / 2, 0, 0))
    turned = material('turned', image=image, mapping={'offset': (0.25, 0.5), 'rotation': math.pi / 6, 'scale': (2, 2)})
    added(turned, at=(0, 0, 0))
    bpy.ops.mesh.primitive_torus_add(major_radius=0.7, minor_radius=0.3, major_segments=24, minor_segments=12)
    ring = added(material('ring', (0.8, 0.3, 0.1, 1)), at=(2, 0, 0), smooth=True)
    ring.scale = (-1, 1, 1.5)
    ring.rotation_euler = (0.6, 0.2, 0.1)
    glass = material('glass', (0.1, 0.4, 0.9, 0.5))
    glass.blend_method = 'BLEND'
    glass.node_tree.nodes['Principled BSDF'].inputs['Alpha'].default_value = 0.5
    bpy.ops.mesh.primitive_plane_add(size=2.4, rotation=(math.pi / 2, 0, 0))
    added(glass, at=(1.2, -0.9, 0.6))
    lamp = material('lamp', (0, 0, 0, 1))
    lamp.use_backface_culling = True
    lamp.node_tree.nodes['Principled BSDF'].inputs['Emission'].default_value = (1, 0.8, 0.2, 1)
    lamp.node_tree.nodes['Principled BSDF'].inputs['Emission Strength'].default_value = 1
    bpy.ops.mesh.primitive_uv_sphere_add(segments=16, ring_count=8, radius=0.4)
    added(lamp, at=(-2, 0, 1.6))
    export('materials')


def lights():
    """A room's corner with a sun, a point light and a camera, objects below one parent."""
    empty()
    bpy.ops.object.empty_add(rotation=(0, 0, 0.4))
    parent = bpy.context.object
    parent.name = 'corner'
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=16, y_subdivisions=16, size=4)
    added(material('floor', (0.7, 0.7, 0.7, 1)), at=(0, 0, -1)).parent = parent
    bpy.ops.mesh.primitive_uv_sphere_add(segments=24, ring_count=12, radius=0.8)
    added(material('ball', (0.6, 0.2, 0.2, 1)), at=(0.3, -0.2, 0), smooth=True).parent = parent
    bpy.ops.object.light_add(type='SUN', rotation=(0.7, 0.3, 0.2))
    bpy.context.object.data.energy = 2
    bpy.ops.object.light_add(type='POINT', location=(-1.5, -1.5, 2))
    bpy.context.object.data.energy = 300
    bpy.context.object.data.color = (1, 0.8, 0.6)
    bpy.ops.object.camera_add(location=(4, -5, 3), rotation=(1.1, 0, 0.67))
    bpy.context.object.name = 'from the door'
    bpy.context.scene.camera = bpy.context.object
    export('lights')


def key(thing, path, keys):
    for frame, value in keys:
        setattr(thing, path, value)
        thing.keyframe_insert(path, frame=frame)


def motion():
    """A crank: what turns, what hangs on it and is scaled, what moves along a curve of keys."""
    empty()
    bpy.context.scene.frame_end = 48
    bpy.ops.mesh.primitive_cylinder_add(vertices=24, radius=1, depth=0.3, rotation=(math.pi / 2, 0, 0))
    wheel = added(material('wheel', (0.3, 0.5, 0.2, 1)), smooth=False)
    bpy.ops.mesh.primitive_cube_add(size=0.4)
    handle = added(material('handle', (0.8, 0.6, 0.2, 1)), at=(0.7, 0, 0.4))
    handle.parent = wheel
    key(wheel, 'rotation_euler', [(1, (math.pi / 2, 0, 0)), (17, (math.pi / 2, 2, 0)), (49, (math.pi / 2, 6, 0))])
    key(handle, 'scale', [(1, (1, 1, 1)), (25, (1, 1, 3)), (49, (1, 1, 1))])
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=2, radius=0.3)
    ball = added(material('ball', (0.7, 0.2, 0.2, 1)))
    key(ball, 'location', [(1, (-2, 0, 0)), (13, (-2, 0, 1.2)), (37, (-1.5, -1, -1)), (49, (-2, 0, 0))])
    export('motion')


def bones():
    """A tube on three bones that bends."""
    empty()
    bpy.context.scene.frame_end = 48
    bpy.ops.mesh.primitive_cylinder_add(vertices=16, radius=0.3, depth=3)
    tube = added(material('tube', (0.3, 0.6, 0.8, 1)), at=(0, 0, 1.5), smooth=True)
    bpy.ops.object.transform_apply(location=True)
    bpy.ops.object.mode_set(mode='EDIT')
    bpy.ops.mesh.select_all(action='SELECT')
    bpy.ops.mesh.bisect(plane_co=(0, 0, 1.5), plane_no=(0, 0, 1))
    for height in (0.5, 1.0, 2.0, 2.5):
        bpy.ops.mesh.select_all(action='SELECT')
        bpy.ops.mesh.bisect(plane_co=(0, 0, height), plane_no=(0, 0, 1))
    bpy.ops.object.mode_set(mode='OBJECT')
    armature = bpy.data.armatures.new('spine')
    rig = bpy.data.objects.new('spine', armature)
    bpy.context.collection.objects.link(rig)
    bpy.context.view_layer.objects.active = rig
    bpy.ops.object.mode_set(mode='EDIT')
    before = None
    for i in range(3):
        bone = armature.edit_bones.new(f'bone {i}')
        bone.head, bone.tail = (0, 0, i), (0, 0, i + 1)
        bone.parent, bone.use_connect = before, before is not None
        before = bone
    bpy.ops.object.mode_set(mode='OBJECT')
    for i in range(3):
        group = tube.vertex_groups.new(name=f'bone {i}')
        for vertex in tube.data.vertices:
            weight = max(0, 1 - abs(vertex.co.z - (i + 0.5)))
            weight = 1 if (i == 0 and vertex.co.z < 0.5) or (i == 2 and vertex.co.z > 2.5) else weight
            if weight > 0:
                group.add([vertex.index], weight, 'REPLACE')
    tube.modifiers.new('spine', 'ARMATURE').object = rig
    tube.parent = rig
    for i, bend in ((1, 0.7), (2, 0.9)):
        bone = rig.pose.bones[f'bone {i}']
        bone.rotation_mode = 'XYZ'
        key(bone, 'rotation_euler', [(1, (0, 0, 0)), (17, (bend, 0, 0.3)), (33, (-bend, 0, 0)), (49, (0, 0, 0))])
    export('bones')


for make in (materials, lights, motion, bones):
    make()
