# The add-on in Blender without a window: blender -b --factory-startup --python headless.py -- ZIP ZSTRIP FOLDER
# A small scene of its own is rendered, saved and animated; pictures are compared with those that the command draws of
# files which this script exports itself.
import json
import math
import os
import subprocess
import sys
import traceback

import addon_utils
import bpy

sys.path.insert(0, os.path.dirname(__file__))
from checks import ZIP, ZSTRIP, check, failures, path


def equal(found, wanted, said):
    check(found == wanted, said if found == wanted else f'{said}: {str(found)[:300]}, not {str(wanted)[:300]}')


def run(*words):
    done = subprocess.run([ZSTRIP, *words], capture_output=True, text=True, check=False)
    check(done.returncode == 0, f'zstrip {words[0]} ends well {done.stderr}')
    return done.stdout


def exported(name, **options):
    bpy.ops.export_scene.gltf(filepath=path(name), export_format='GLB', export_cameras=True, export_lights=True,
                              use_renderable=True, use_active_scene=True, **options)
    return path(name)


def pixels(name):
    """Rows of 8-bit red, green, blue of a PNG, as Blender reads it."""
    image = bpy.data.images.load(path(name))
    image.colorspace_settings.name = 'Non-Color'
    values = [round(255 * value) for value in image.pixels]
    size = tuple(image.size)
    bpy.data.images.remove(image)
    del values[3::4]
    return size, values


def turned_back(size, values):
    """A picture that a panel shows turned clockwise by 90 degrees: its row y from the top is the panel's column
    width - 1 - y. Rows of pixels() begin at the bottom."""
    wide, high = size
    turned = []
    for column in range(wide):
        for row in reversed(range(high)):
            at = 3 * (row * wide + column)
            turned += values[at:at + 3]
    return (high, wide), turned


def rendered(name):
    bpy.ops.render.render()
    bpy.data.images['Render Result'].save_render(path(name))
    return pixels(name)


def error_of(call):
    try:
        call()
    except RuntimeError as error:
        return str(error)
    return ''


def make_scene():
    """A cube with a material, a light and a camera, before a dark blue world."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module='zstrip_blender')
    bpy.context.preferences.addons['zstrip_blender'].preferences.command = ZSTRIP
    scene = bpy.context.scene
    bpy.ops.mesh.primitive_cube_add(size=2, rotation=(0.3, 0.2, 0.5))
    cube = bpy.context.object
    paint = bpy.data.materials.new('paint')
    paint.use_nodes = True
    paint.node_tree.nodes['Principled BSDF'].inputs['Base Color'].default_value = (0.8, 0.2, 0.05, 1)
    cube.data.materials.append(paint)
    sun = bpy.data.objects.new('Sun', bpy.data.lights.new('Sun', 'SUN'))
    sun.rotation_euler = (0.6, 0.3, 0)
    camera = bpy.data.objects.new('Eye', bpy.data.cameras.new('Lens'))
    camera.location, camera.rotation_euler = (0, -7, 2), (math.radians(75), 0, 0)
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.world = bpy.data.worlds.new('World')
    scene.world.color = (0.01, 0.02, 0.1)
    scene.render.engine = 'ZSTRIP'
    scene.render.resolution_x, scene.render.resolution_y = 120, 90
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = 'PNG'
    scene.frame_start, scene.frame_end = 1, 5
    bpy.ops.zstrip.exact_colours()
    return scene, cube


# As picture.hex_colour(0.01, 0.02, 0.1), by a calculator: 12.92 and the power of 1 / 2.4 of IEC 61966-2-1.
BACKGROUND = '192759'
LOOK = ('--camera', 'Eye', '--background', BACKGROUND)


def renders_the_pixels_of_the_command(scene, cube):
    model = exported('own.glb', export_animations=False, export_apply=True)
    for options, size, changes in (
            ((), '120x90', {}),
            (('--format', 'gray4', '--dither', '--samples', '4'), '120x90',
             {'format': 'gray4', 'dither': True, 'samples': '4'}),
            (('--format', 'rgb565_swapped', '--edges'), '120x90', {'format': 'rgb565_swapped', 'edges': True}),
            (('--panel', 'st7789', '--rotation', '90', '--ram', '20K'), '320x240', {'panel': 'st7789', 'ram': '20K'})):
        for name, value in changes.items():
            setattr(scene.zstrip, name, value)
        scene.render.resolution_x, scene.render.resolution_y = (int(side) for side in size.split('x'))
        if size != '120x90':
            model = exported('wide.glb', export_animations=False, export_apply=True)  # its camera is of this shape
        run('render', model, '-o', path('own.png'), '--size', size, *LOOK, *options, '--quiet')
        own = pixels('own.png')
        if 'panel' in changes:
            own = turned_back(*own)
        equal(rendered('f12.png'), own, f'F12 has the pixels of zstrip render {" ".join(options)}')
        for name in changes:
            scene.zstrip.property_unset(name)
    scene.render.resolution_x, scene.render.resolution_y = 120, 90
    size, values = rendered('f12.png')
    check(len({tuple(values[at:at + 3]) for at in range(0, len(values), 3)}) >= 4, 'three sides and a background show')
    equal('%02x%02x%02x' % tuple(values[:3]), '18245a', "the world's colour is behind it, as RGB565")


def saves_what_the_command_bakes(scene, cube):
    scene.zstrip.board = 'pico'
    model = exported('scene.glb', export_animations=True, export_apply=True)
    for kind, ending in (('HEADER', '.hpp'), ('BLOB', '.zsc')):
        bpy.ops.zstrip.save(kind=kind, filepath=path('saved/scene' + ending))
        run('bake', model, '-o', path('baked/scene' + ending), '--size', '120x90', *LOOK, '--strip-buffers', '2',
            '--quiet')
        with open(path('saved/scene' + ending), 'rb') as saved, open(path('baked/scene' + ending), 'rb') as baked:
            equal(saved.read(), baked.read(), f'a saved {kind.lower()} is what zstrip bake writes')
    bpy.ops.zstrip.save(kind='SKETCH', filepath=path('saved/sketch'))
    equal(sorted(os.listdir(path('saved/sketch'))), ['scene.hpp', 'sketch.ino'], 'a sketch is a folder')
    scene.render.resolution_x = scene.render.resolution_y = 240
    bpy.ops.zstrip.save(kind='UF2', filepath=path('saved/scene'))
    with open(path('saved/scene.uf2'), 'rb') as file:
        equal(file.read(4), b'UF2\n', 'a .uf2 file begins as one')
    bpy.ops.zstrip.fit(filepath=path('saved/fit.zsc'))
    check(os.path.exists(path('saved/fit.zsc')), 'fit writes a blob')
    scene.render.resolution_x, scene.render.resolution_y = 120, 90


def figures_are_those_of_the_command(scene, cube):
    scene.zstrip.board = 'pico2'
    model = exported('scene.glb', export_animations=True, export_apply=True)
    bpy.ops.zstrip.plan()
    report = json.loads(run('plan', model, '--size', '120x90', *LOOK, '--strip-buffers', '2', '--json'))
    board = next(entry for entry in report['boards'] if entry['board'] == 'pico2')
    what, name, found = sys.modules['zstrip_blender.operators'].figures[scene.name]
    equal((what, name), ('with its animation', 'pico2'), 'figures say what they are of')
    equal((found.ram_bytes, found.needed_ram, found.flash_bytes, found.most_fps),
          (report['plan']['bytes']['total'], board['needed_ram'], report['flash_bytes'],
           board['frames_a_second']['most']), 'figures are those of zstrip plan')


def errors_of_the_command_are_reports(scene, cube):
    scene.zstrip.ram = '1'
    check('smallest that works' in error_of(bpy.ops.render.render), 'too little RAM is an error of the render')
    check('no plan for 120x90 fits' in error_of(bpy.ops.zstrip.plan), 'and of the figures')
    scene.zstrip.property_unset('ram')
    wrong = error_of(lambda: bpy.ops.zstrip.save(kind='UF2', filepath=path('saved/small.uf2')))
    check('240x240' in wrong, f'a .uf2 file of another size is an error: {wrong}')
    check(not os.path.exists(path('saved/small.uf2')), 'nothing is written then')
    own = bpy.context.preferences.addons['zstrip_blender'].preferences
    own.command = path('none')
    check('preferences' in error_of(bpy.ops.render.render), 'a command that is missing says where to set it')
    own.command = ZSTRIP
    bpy.context.view_layer.objects.active = cube
    bpy.ops.object.mode_set(mode='EDIT')
    check('Edit Mode' in error_of(bpy.ops.render.render), 'Edit Mode has to be left first')
    equal(cube.mode, 'EDIT', 'and is not left by itself')
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.data.objects['Eye'].hide_render = True
    check("does not have the camera 'Eye'" in error_of(bpy.ops.render.render), 'a hidden camera is an error')
    bpy.data.objects['Eye'].hide_render = False


def frames_of_an_animation_are_rendered(scene, cube):
    for frame, turn in ((1, 0.0), (5, 1.5)):
        cube.rotation_euler[2] = turn
        cube.keyframe_insert('rotation_euler', frame=frame)
    scene.frame_set(2)
    scene.render.filepath = path('film/')
    bpy.ops.render.render(animation=True)
    equal(sorted(os.listdir(path('film'))), [f'{frame:04}.png' for frame in range(1, 6)], 'each frame is a file')
    first, last = pixels('film/0001.png'), pixels('film/0005.png')
    check(first != last, 'the cube turns')
    scene.frame_set(5)
    equal(rendered('f12.png'), last, 'the last frame of the animation is that of F12')
    bpy.ops.zstrip.save(kind='HEADER', filepath=path('saved/turning.hpp'))
    with open(path('saved/turning.hpp'), encoding='utf-8') as file:
        check('kAnimation{' in file.read().replace(' = ', '').replace(' {', '{'), 'a header has the animation')
    cube.animation_data_clear()


def figures_bend(scene, cube):
    """A bar with a bone in its upper half that leans over, and a shape key that widens it."""
    bpy.ops.object.armature_add(location=(0, 0, 0))
    rig = bpy.context.object
    bpy.ops.object.mode_set(mode='EDIT')
    lower = rig.data.edit_bones[0]
    lower.tail = (0, 0, 1)
    upper = rig.data.edit_bones.new('upper')
    upper.head, upper.tail, upper.parent = (0, 0, 1), (0, 0, 2), lower
    bpy.ops.object.mode_set(mode='OBJECT')
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 1))
    bar = bpy.context.object
    bar.scale = (0.4, 0.4, 2)
    bpy.ops.object.transform_apply(location=True, scale=True)
    for name, above in (('Bone', False), ('upper', True)):
        group = bar.vertex_groups.new(name=name)
        group.add([vertex.index for vertex in bar.data.vertices if (vertex.co.z > 1) == above], 1.0, 'ADD')
    bar.parent = rig
    bar.modifiers.new('rig', 'ARMATURE').object = rig
    cube.hide_render = True
    straight = rendered('straight.png')
    bone = rig.pose.bones['upper']
    bone.rotation_mode = 'XYZ'
    bone.keyframe_insert('rotation_euler', frame=1)
    bone.rotation_euler[2] = 1.2
    bone.keyframe_insert('rotation_euler', frame=5)
    scene.frame_set(5)
    bent = rendered('bent.png')
    check(bent != straight, 'F12 shows the pose of the frame')
    equal(rig.data.pose_position, 'POSE', 'the pose stays')
    bpy.ops.zstrip.save(kind='HEADER', filepath=path('saved/bent.hpp'))
    with open(path('saved/bent.hpp'), encoding='utf-8') as file:
        check('kSkins' in file.read(), 'a header has the skin')
    rig.animation_data.action['events'] = [0.0, 7.0]
    bpy.ops.zstrip.save(kind='BLOB', filepath=path('saved/bent.zsc'))
    with open(path('saved/bent.zsc'), 'rb') as file:
        check(b'evnt' in file.read(), "a blob has the events of the action's custom property")
    check(bar.modifiers['rig'].show_viewport, "the armature's modifier stays on")
    scene.frame_set(1)
    bar.shape_key_add(name='Basis')
    wide = bar.shape_key_add(name='wide')
    for point in wide.data:
        point.co.x *= 3
    wide.value = 1
    check(rendered('wide.png') != straight, 'F12 shows the value of a shape key')


def goes_away_again(scene, cube):
    bpy.ops.preferences.addon_disable(module='zstrip_blender')
    check(not hasattr(bpy.types.Scene, 'zstrip') and not hasattr(bpy.types, 'ZSTRIP_PT_device'), 'nothing is left')
    bpy.ops.preferences.addon_enable(module='zstrip_blender')
    check(hasattr(bpy.types.Scene, 'zstrip'), 'it can be enabled again')


def main():
    for folder in ('saved', 'baked', 'film'):
        os.makedirs(path(folder))
    bpy.ops.preferences.addon_install(filepath=ZIP)
    found = next(each for each in addon_utils.modules(refresh=True) if each.__name__ == 'zstrip_blender')
    version = run('--version').split()[-1]
    equal('.'.join(str(part) for part in found.bl_info['version']), version, 'it has the version of the command')
    for step in (renders_the_pixels_of_the_command, saves_what_the_command_bakes, figures_are_those_of_the_command,
                 errors_of_the_command_are_reports, frames_of_an_animation_are_rendered, figures_bend, goes_away_again):
        print(f'-- {step.__name__}', flush=True)
        step(*make_scene())


try:
    main()
except Exception:  # Blender would go on
    traceback.print_exc()
    failures.append('an exception')
print(f'{len(failures)} failures', flush=True)
os._exit(1 if failures else 0)
