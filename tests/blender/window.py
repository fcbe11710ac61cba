# The live view in Blender's window: blender --factory-startup --python window.py -- ZIP ZSTRIP FOLDER
# Each step waits until something holds; the test's time limit ends one that never does. A screenshot shows the pixels
# of the command, texel by texel.
import math
import os
import subprocess
import sys
import traceback

import bpy
from bpy_extras.view3d_utils import location_3d_to_region_2d
from mathutils import Vector

sys.path.insert(0, os.path.dirname(__file__))
from checks import ZIP, ZSTRIP, check, failures, path

TICK = 0.05
# So often the view is looked at before it is said that nothing more is drawn.
REST_TICKS = 20


def module(name):
    return sys.modules['zstrip_blender.' + name]


def live():
    views = list(module('engine').live_views.values())
    return views[0] if len(views) == 1 else None


def viewport():
    return next(area for area in bpy.context.window_manager.windows[0].screen.areas if area.type == 'VIEW_3D')


def in_viewport():
    area = viewport()
    region = next(region for region in area.regions if region.type == 'WINDOW')
    return bpy.context.temp_override(window=bpy.context.window_manager.windows[0], area=area, region=region)


def make_scene():
    bpy.ops.preferences.addon_install(filepath=ZIP)
    bpy.ops.preferences.addon_enable(module='zstrip_blender')
    bpy.context.preferences.addons['zstrip_blender'].preferences.command = ZSTRIP
    scene = bpy.context.scene
    scene.render.engine = 'ZSTRIP'
    scene.render.resolution_x, scene.render.resolution_y = 60, 45
    scene.render.resolution_percentage = 100
    bpy.ops.zstrip.exact_colours()
    space = viewport().spaces.active
    space.overlay.show_overlays = space.show_gizmo = False
    space.show_region_toolbar = space.show_region_ui = space.show_region_header = space.show_region_tool_header = False
    space.region_3d.view_perspective = 'CAMERA'
    space.shading.type = 'RENDERED'


def command_draws(name):
    """The picture of the scene as the command draws it of a file that this script exports: rows from the top."""
    with in_viewport():
        bpy.ops.export_scene.gltf(filepath=path(name + '.glb'), export_format='GLB', export_cameras=True,
                                  export_lights=True, export_animations=False, export_current_frame=True)
    background = module('properties').background_of(bpy.context.scene)
    subprocess.run([ZSTRIP, 'render', path(name + '.glb'), '-o', path(name + '.ppm'), '--size', '60x45', '--quiet',
                    '--camera', 'Camera', '--background', background], check=True)
    with open(path(name + '.ppm'), 'rb') as file:
        return file.read()[-60 * 45 * 3:]


def viewport_shows(wanted, name):
    """Compares the middle of each texel of the camera's frame in a screenshot."""
    with in_viewport():
        bpy.ops.screen.screenshot(filepath=path(name))
    image = bpy.data.images.load(path(name))
    image.colorspace_settings.name = 'Non-Color'
    width, values = image.size[0], list(image.pixels)
    bpy.data.images.remove(image)
    area = viewport()
    region = next(region for region in area.regions if region.type == 'WINDOW')
    scene, space = bpy.context.scene, area.spaces.active
    matrix = scene.camera.matrix_world
    corners = [location_3d_to_region_2d(region, space.region_3d, matrix @ corner)
               for corner in scene.camera.data.view_frame(scene=scene)]
    low = Vector((min(c.x for c in corners), min(c.y for c in corners)))
    high = Vector((max(c.x for c in corners), max(c.y for c in corners)))
    wrong = 0
    for row in range(45):
        for column in range(60):
            x = region.x + low.x + (column + 0.5) * (high.x - low.x) / 60
            y = region.y + high.y - (row + 0.5) * (high.y - low.y) / 45
            at = 4 * (math.floor(y) * width + math.floor(x))
            shown = [round(255 * value) for value in values[at:at + 3]]
            texel = list(wanted[3 * (row * 60 + column):][:3])
            if max(abs(a - b) for a, b in zip(shown, texel)) > 1:  # a framebuffer of half floats
                wrong += 1
    return wrong


def steps():
    """Each `yield` gives a condition that is waited for."""
    make_scene()
    yield lambda: live() and live().pictures == 1
    view = live()
    for _ in range(REST_TICKS):
        yield lambda: True
    check((view.exports, view.pictures) == (1, 1), f'a scene at rest is drawn once: {view.exports}, {view.pictures}')
    wrong = viewport_shows(command_draws('first'), 'first.png')
    check(wrong == 0, f'the viewport shows the pixels of the command, {wrong} are others')
    for _ in range(REST_TICKS):  # the script's own export has changed nothing
        yield lambda: view.pictures >= 1

    pictures = view.pictures
    bpy.data.objects['Cube'].rotation_euler[2] += 0.5
    yield lambda: view.pictures > pictures
    wrong = viewport_shows(command_draws('turned'), 'turned.png')
    check(wrong == 0, f'what was turned is shown turned, {wrong} pixels are others')

    for _ in range(REST_TICKS):
        yield lambda: True

    exports, pictures = view.exports, view.pictures
    viewport().spaces.active.region_3d.view_perspective = 'PERSP'
    yield lambda: view.pictures > pictures
    check(view.exports == exports, 'another view of the same scene exports nothing')
    pictures = view.pictures
    viewport().spaces.active.region_3d.view_perspective = 'ORTHO'
    yield lambda: view.pictures > pictures
    check(view.message == '', f'a parallel view is drawn: {view.message}')
    # A cube before the point about which the view turns was cut away.
    region = viewport().spaces.active.region_3d
    region.view_location, region.view_rotation, region.view_distance = (0, 0, 0), (1, 0, 0, 0), 8
    with in_viewport():
        bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 3))
    nearer = bpy.context.object
    material = bpy.data.materials.new('red')
    material.use_nodes = True
    material.node_tree.nodes['Principled BSDF'].inputs['Base Color'].default_value = (1, 0, 0, 1)
    nearer.data.materials.append(material)
    at = 3 * (60 * 22 + 30)
    yield lambda: view._shown.rgb[at] > 2 * view._shown.rgb[at + 1]
    check(True, 'a parallel view shows what lies before its middle')
    pictures = view.pictures
    bpy.data.objects.remove(nearer)
    yield lambda: view.pictures > pictures and view._shown.rgb[at] <= 2 * view._shown.rgb[at + 1]

    with in_viewport():
        bpy.context.view_layer.objects.active = bpy.data.objects['Cube']
        bpy.ops.object.mode_set(mode='EDIT')
    yield lambda: 'Edit Mode' in view.message
    check(bpy.data.objects['Cube'].mode == 'EDIT', 'the live view leaves Edit Mode alone')
    with in_viewport():
        bpy.ops.object.mode_set(mode='OBJECT')
    yield lambda: view.message == ''

    bpy.context.scene.zstrip.ram = '1'
    bpy.data.objects['Cube'].location[0] += 0.1
    yield lambda: 'smallest that works' in view.message
    check(True, 'an error of the command is the message of the viewport')
    bpy.context.scene.zstrip.ram = ''
    yield lambda: view.message == ''

    with in_viewport():
        bpy.ops.render.render('INVOKE_DEFAULT')
    yield lambda: not bpy.app.is_job_running('RENDER')
    bpy.data.images['Render Result'].save_render(path('f12.png'))
    check(os.path.getsize(path('f12.png')) > 100, 'F12 in the window renders, by a thread of its own')
    with in_viewport():
        bpy.ops.zstrip.plan('INVOKE_DEFAULT')
    yield lambda: 'Scene' in module('operators').figures
    check(True, 'figures are asked for while Blender goes on')

    viewport().spaces.active.shading.type = 'SOLID'
    yield lambda: live() is None
    check(not os.path.exists(view._folder), 'a viewport that ends leaves no files')


running = steps()
condition = [lambda: True]


def go_on():
    try:
        while condition[0]():
            condition[0] = next(running)
            break
    except StopIteration:
        end()
    except Exception:  # Blender would go on
        traceback.print_exc()
        failures.append('an exception')
        end()
    return TICK


def end():
    print(f'{len(failures)} failures', flush=True)
    sys.stdout.flush()
    os._exit(1 if failures else 0)


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(go_on, first_interval=1)
