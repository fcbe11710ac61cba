# Writes the open scene as glTF, by Blender's own exporter, on the main thread: nothing else may change the scene.
import contextlib
import os
import threading

import bpy

from . import command, glb

MODEL = 'scene.glb'


class Stopped(Exception):
    """The user does not want the file any more."""


def on_main_thread(function, asked_to_stop=lambda: False):
    """Calls the function on Blender's main thread, where operators may run, and returns what it returns or raises. A
    render job of Blender's window has a thread of its own: it waits until Blender is idle. Raises Stopped once
    asked_to_stop() is true and the function has not begun."""
    if threading.current_thread() is threading.main_thread():
        return function()
    lock, ended, box = threading.Lock(), threading.Event(), {'begun': False, 'stopped': False}

    def call():
        with lock:
            if box['stopped']:
                return
            box['begun'] = True
        try:
            box['value'] = function()
        except BaseException as error:  # it belongs to the waiting thread
            box['error'] = error
        ended.set()

    bpy.app.timers.register(call)
    while not ended.wait(0.02):
        if not asked_to_stop():
            continue
        with lock:
            if not box['begun']:
                box['stopped'] = True
                raise Stopped
    if 'error' in box:
        raise box['error']
    return box['value']


def _overridden(scene, view_layer):
    """A context of this scene without an active object: the exporter would leave its edit or pose mode."""
    windows = bpy.context.window_manager.windows
    words = {'scene': scene, 'view_layer': view_layer or scene.view_layers[0], 'active_object': None, 'object': None}
    if windows and bpy.context.window is None:
        words['window'] = windows[0]
    return bpy.context.temp_override(**words)


def _known(operator, words):
    known = operator.get_rna_type().properties.keys()
    return {key: value for key, value in words.items() if key in known}


def is_edited(scene):
    """True while an object of the scene is in Edit Mode: the exporter then finds half of a mesh."""
    return any(thing.mode == 'EDIT' for thing in scene.objects)


def _last_line(error):
    """What an operator's error says, without the lines of Python that it came through."""
    lines = [line.strip() for line in str(error).splitlines() if line.strip() and not line.startswith('Location:')]
    return lines[-1] if lines else type(error).__name__


def export_scene(folder, scene, view_layer=None, moving=False, modifiers=True):
    """Writes the scene as it stands into the folder, or, if `moving`, with its animation, skins and shape keys. Returns
    the path and the glb.Glb. Raises command.CommandError."""
    if not hasattr(bpy.types, 'EXPORT_SCENE_OT_gltf'):
        raise command.CommandError("Blender's add-on 'glTF 2.0 format' is off; tick it in Preferences, Add-ons; in Debian "
                                   "it needs the package python3-numpy")
    if is_edited(scene):
        raise command.CommandError('leave Edit Mode first: it has not stored the mesh yet')
    path = os.path.join(folder, MODEL)
    # Of releases that do not have an option, it is left out: _known.
    words = {
        'filepath': path, 'check_existing': False, 'export_format': 'GLB', 'export_yup': True, 'export_cameras': True,
        'export_lights': True, 'use_active_scene': True, 'use_renderable': True, 'export_apply': modifiers or not moving,
        'export_animations': moving, 'export_current_frame': not moving, 'export_skins': moving, 'export_morph': moving,
        'export_extras': moving, 'will_save_settings': False}
    try:
        with _overridden(scene, view_layer), contextlib.redirect_stdout(_Silence()):
            result = bpy.ops.export_scene.gltf(**_known(bpy.ops.export_scene.gltf, words))
        if 'FINISHED' not in result:
            raise command.CommandError('the glTF exporter was cancelled')
        with open(path, 'rb') as file:
            return path, glb.parse_glb(file.read())
    except (RuntimeError, OSError, glb.GlbError) as error:
        raise command.CommandError(f'the glTF exporter: {_last_line(error)}') from error


class _Silence:
    """A stream that drops the lines of the exporter."""

    def write(self, text):
        """Drops the text."""
        return len(text)

    def flush(self):
        """Nothing is kept."""
