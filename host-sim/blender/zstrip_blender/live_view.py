# The viewport as the device draws it: exports when the scene rests, draws in a process, shows the newest picture.
import math
import os
import shutil
import tempfile
from dataclasses import dataclass, replace

import bpy
import gpu
from bpy_extras import view3d_utils
from gpu_extras import batch
from mathutils import Matrix, Vector

from . import command, export, glb, latest, picture, preferences, process, properties, viewports

CAMERA = 'zstrip view'
_WITHOUT_FACES = {'ARMATURE', 'CAMERA', 'EMPTY', 'LATTICE', 'LIGHT', 'LIGHT_PROBE', 'SPEAKER'}
TICK = 0.04
# Exporting takes Blender's own thread: a scene that changes all the time is exported this often.
EXPORT_SECONDS = 0.15

_VERTEX = 'void main() { gl_Position = ModelViewProjectionMatrix * vec4(pos, 0.0, 1.0); place = texel; }'
_FRAGMENT = 'void main() { colour = texelFetch(image, ivec2(min(place, vec2(textureSize(image, 0)) - 1.0)), 0); }'


@dataclass(frozen=True)
class _Shot:
    """One request: the scene's settings and the camera in the file, if it is not the scene's own."""

    settings: command.Settings
    matrix: tuple = ()
    lens: glb.Lens = glb.Lens()


class LiveView:
    """What one viewport shows. All of it runs on Blender's main thread; only the command does not."""

    def __init__(self):
        self.message = ''
        self.exports = 0
        self.pictures = 0
        self._folder = tempfile.mkdtemp(prefix='zstrip_')
        self._model = None
        self._latest = latest.Latest(self._start, self._finish)
        self._scene_changed, self._exporting = True, False
        self._asked = None
        self._wanted = None
        self._scene = self._view_layer = None
        self._next_export = 0.0
        self._shown = self._texture = self._shader = None
        self._closed = False
        bpy.app.timers.register(self._tick, first_interval=TICK)

    def scene_changed(self):
        """Exports the scene again, soon. Blender tells of changes while it exports, too: those are in the export."""
        if not self._exporting:
            self._scene_changed = True

    def close(self):
        """Cancels the process and removes the files."""
        if not self._closed:
            self._closed = True
            self._latest.close()
            shutil.rmtree(self._folder, ignore_errors=True)

    def _tick(self):
        if self._closed:
            return None
        try:
            self._step()
        except (command.CommandError, OSError, glb.GlbError, ReferenceError) as error:
            self._say(str(error))
        return TICK

    def _step(self):
        self._latest.step()
        if self._wanted is None or not viewports.any_rendered():
            return
        if self._scene_changed and self._latest.clock() >= self._next_export and self._latest.idle:
            self._export()
        if self._model is not None and self._wanted != self._asked:
            self._asked = self._wanted
            self._latest.ask(self._wanted)
            self._latest.step()

    def _export(self):
        scene = bpy.data.scenes[self._scene]
        if export.is_edited(scene):
            self._say('waits for the end of Edit Mode')
            return
        self._scene_changed, self._exporting = False, True
        try:
            _, model = export.export_scene(self._folder, scene, scene.view_layers.get(self._view_layer))
        finally:
            self._exporting = False
            self._next_export = self._latest.clock() + EXPORT_SECONDS
            self.exports += 1
        self._say('')
        if model != self._model:
            self._model, self._asked = model, None

    def _start(self, shot):
        settings, model = shot.settings, self._model
        if shot.matrix:
            model = glb.with_camera(model, CAMERA, shot.matrix, shot.lens, settings.width / settings.height)
            settings = replace(settings, camera=CAMERA)
        else:
            scene = bpy.data.scenes[self._scene]
            settings = replace(settings, camera=properties.camera_name(scene, model.document))
        path = os.path.join(self._folder, 'view.glb')
        with open(path, 'wb') as file:
            file.write(glb.to_bytes(model))
        return process.Process(command.render_words(preferences.find(), path, self._picture_path(), settings))

    def _picture_path(self):
        return os.path.join(self._folder, 'view.ppm')

    def _finish(self, shot, outcome):
        try:
            command.checked(outcome)
            with open(self._picture_path(), 'rb') as file:
                self._shown = picture.turned_back(picture.parse_ppm(file.read()), shot.settings.rotation)
        except (command.CommandError, OSError, picture.PictureError) as error:
            self._say(str(error))
            return
        self.pictures += 1
        self._texture = None
        self._say('')
        viewports.redraw()

    def _say(self, message):
        if message != self.message:
            self.message = message
            viewports.redraw()

    def draw(self, context, depsgraph):
        """Shows the newest picture, and asks for another one if the view has changed."""
        scene = depsgraph.scene
        self._scene, self._view_layer = scene.name, depsgraph.view_layer.name
        region, view = context.region, context.region_data
        settings = properties.settings_of(bpy.data.scenes[self._scene], '')
        left, bottom, width, height = place_of_picture(context, scene, settings.width, settings.height)
        if view.view_perspective == 'CAMERA' and scene.camera is not None:
            self._wanted = _Shot(settings)
        else:
            matrix, lens = view.view_matrix.inverted(), lens_of(context, height / region.height)
            if not view.is_perspective:
                matrix, lens = before_all(depsgraph, matrix, lens)
            self._wanted = _Shot(settings, tuple(glb.to_y_up(matrix)), lens)
        if self._shown is not None:
            self._draw_picture(left, bottom, width, height)

    def _draw_picture(self, left, bottom, width, height):
        shown = self._shown
        if self._texture is None:
            pixels = gpu.types.Buffer('FLOAT', 4 * shown.width * shown.height, picture.linear_pixels(shown))
            self._texture = gpu.types.GPUTexture((shown.width, shown.height), format='RGBA16F', data=pixels)
        if self._shader is None:
            self._shader = _shader()
        corners = [(left, bottom), (left + width, bottom), (left + width, bottom + height), (left, bottom + height)]
        texels = [(0, 0), (shown.width, 0), (shown.width, shown.height), (0, shown.height)]
        quad = batch.batch_for_shader(self._shader, 'TRIS', {'pos': corners, 'texel': texels},
                                       indices=((0, 1, 2), (0, 2, 3)))
        self._shader.bind()
        self._shader.uniform_sampler('image', self._texture)
        quad.draw(self._shader)


def _shader():
    """Shows texels as squares, whatever the texture's filter is."""
    passed = gpu.types.GPUStageInterfaceInfo('zstrip_passed')
    passed.smooth('VEC2', 'place')
    info = gpu.types.GPUShaderCreateInfo()
    info.push_constant('MAT4', 'ModelViewProjectionMatrix')
    info.sampler(0, 'FLOAT_2D', 'image')
    info.vertex_in(0, 'VEC2', 'pos')
    info.vertex_in(1, 'VEC2', 'texel')
    info.vertex_out(passed)
    info.fragment_out(0, 'VEC4', 'colour')
    info.vertex_source(_VERTEX)
    info.fragment_source(_FRAGMENT)
    return gpu.shader.create_from_info(info)


def place_of_picture(context, scene, width, height):
    """Returns left, bottom, width and height, in the region's pixels, of a picture of this size: in a camera's view its
    frame, else as large as the region has room for."""
    region, view = context.region, context.region_data
    if view.view_perspective == 'CAMERA' and scene.camera is not None:
        corners = scene.camera.data.view_frame(scene=scene)
        matrix = scene.camera.matrix_world.normalized()
        points = [view3d_utils.location_3d_to_region_2d(region, view, matrix @ corner) for corner in corners]
        if all(points):
            xs, ys = [point.x for point in points], [point.y for point in points]
            return min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys)
    scale = min(region.width / width, region.height / height)
    wide, high = width * scale, height * scale
    return (region.width - wide) / 2, (region.height - high) / 2, wide, high


def before_all(depsgraph, matrix, lens):
    """Returns matrix and glb.Lens of a camera that sees what a parallel view shows. The matrix of Blender's view lies at
    the point about which it turns, and the view shows half of its clip end before that point, too."""
    axis, half = matrix.col[2].xyz, lens.far / 2
    reach = 0.0
    for shown in depsgraph.object_instances:
        if shown.object.type in _WITHOUT_FACES:
            continue
        for corner in shown.object.bound_box:
            reach = max(reach, (shown.matrix_world @ Vector(corner) - matrix.translation).dot(axis))
    # Rounding must not bring a corner before the near plane.
    back = 1.01 * min(reach, half) + 0.01 * lens.half_height + 2 * lens.near
    return Matrix.Translation(axis * back) @ matrix, replace(lens, far=back + half)


def lens_of(context, share):
    """Returns the glb.Lens of the viewport for a picture in its middle that takes this share of its height."""
    window = context.region_data.window_matrix
    near, far = context.space_data.clip_start, context.space_data.clip_end
    if context.region_data.is_perspective:
        return glb.Lens(angle=2 * math.atan(share / window[1][1]), near=near, far=far)
    return glb.Lens(half_height=share / window[1][1], near=near, far=far)
