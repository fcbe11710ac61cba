# The render engine ZSTRIP: F12, animations and the rendered viewport show the pixels of the device.
import json
import os
import tempfile

import bpy

from . import command, export, live_view, picture, preferences, process, properties


# The LiveView of each viewport's engine, by the engine's id: when an engine ends, its attributes are gone before it is.
live_views = {}


class ZstripEngine(bpy.types.RenderEngine):
    """Draws by the command zstrip."""

    bl_idname = 'ZSTRIP'
    bl_label = 'zstrip'
    bl_use_preview = False
    bl_use_eevee_viewport = True
    bl_use_shading_nodes_custom = False

    def render(self, depsgraph):
        """F12 and each frame of an animation."""
        try:
            self._render(depsgraph)
        except export.Stopped:
            pass
        except (command.CommandError, picture.PictureError, OSError) as error:
            self.report({'ERROR'}, f'zstrip: {error}')

    def _render(self, depsgraph):
        scene = bpy.data.scenes[depsgraph.scene.name]
        if scene.render.use_border and scene.render.use_crop_to_border:
            raise command.CommandError("a device draws the whole picture; turn 'Crop to Render Region' off")
        frame, subframe = depsgraph.scene.frame_current, depsgraph.scene.frame_subframe
        with tempfile.TemporaryDirectory(prefix='zstrip_') as folder:
            self.update_stats('', 'exporting the scene')

            def write():
                if self.is_animation:
                    scene.frame_set(frame, subframe=subframe)
                view_layer = scene.view_layers.get(depsgraph.view_layer.name)
                path, model = export.export_scene(folder, scene, view_layer)
                return path, properties.settings_of(scene, properties.camera_name(scene, model.document))

            path, settings = export.on_main_thread(write, self.test_break)
            output = os.path.join(folder, 'picture.ppm')
            words = command.render_words(preferences.find(), path, output, settings)
            outcome = process.Process(words).wait(self.test_break, self._tell)
            if outcome.cancelled:
                return
            report = command.checked(outcome)
            for warning in command.warnings_of(outcome.err):
                self.report({'WARNING'}, f'zstrip: {warning}')
            with open(output, 'rb') as file:
                shown = picture.turned_back(picture.parse_ppm(file.read()), settings.rotation)
        self._show(shown, depsgraph.view_layer.name)
        self.update_stats('', summary_of(report))

    def _tell(self, line):
        self.update_stats('', line or 'drawing')

    def _show(self, shown, layer):
        result = self.begin_result(0, 0, shown.width, shown.height, layer=layer)
        values = iter(picture.linear_pixels(shown))
        result.layers[0].passes['Combined'].rect = list(zip(values, values, values, values))
        self.end_result(result)

    def view_update(self, context, depsgraph):
        """The scene has changed, or the viewport is new."""
        self._live().scene_changed()

    def view_draw(self, context, depsgraph):
        """Shows the newest picture; never waits."""
        live = self._live()
        live.draw(context, depsgraph)
        self.update_stats('', live.message)

    def _live(self):
        if id(self) not in live_views:
            live_views[id(self)] = live_view.LiveView()
        return live_views[id(self)]

    def __del__(self):
        live = live_views.pop(id(self), None)
        if live is not None:
            live.close()


def summary_of(report):
    """What the command's report of a picture says in one line: strips, RAM."""
    try:
        frame = json.loads(report)['frames'][0]
        ram = frame['ram_bytes']
        return f"{frame['strips']} strips, {ram['arena'] + ram['strip_pixels']:,} bytes of RAM for the picture"
    except (KeyError, IndexError, TypeError, ValueError):
        return ''


def register():
    """Adds the engine to Blender."""
    bpy.utils.register_class(ZstripEngine)


def unregister():
    """Takes it out again."""
    for live in live_views.values():
        live.close()
    live_views.clear()
    bpy.utils.unregister_class(ZstripEngine)
