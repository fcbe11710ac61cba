# The buttons: figures of a board, files for firmware, a panel's size, colours as the panel shows them.
import json
import os
import shutil
import tempfile

import bpy

from . import command, export, glb, preferences, process, properties

# The figures of each scene that were asked for last, by its name: (what they are of, board, command.Figures).
figures = {}


def _with_animation(scene):
    return 'with its animation' if scene.zstrip.animation else f'at frame {scene.frame_current}'


class _Commands:
    """Exports the scene, then runs commands one after the other. In Blender's window it does so while Blender goes on,
    until Escape; in the background it waits for the end."""

    def begin(self, context, steps_of):
        """`steps_of(path, settings)` returns the steps for the exported file: pairs of a command line, and what to call
        with its standard output."""
        self._process = self._timer = self._finish = None
        self._folder = tempfile.mkdtemp(prefix='zstrip_')
        scene = context.scene
        try:
            path, model = export.export_scene(self._folder, scene, context.view_layer, scene.zstrip.animation,
                                              scene.zstrip.modifiers)
            settings = properties.settings_of(scene, properties.camera_name(scene, model.document))
            self._steps = list(steps_of(path, settings))
            if bpy.app.background or context.window is None:
                while self._next():
                    self._ended(self._process.wait())
                self._clean(context)
                return {'FINISHED'}
        except (command.CommandError, OSError, glb.GlbError) as error:
            return self._fail(context, str(error))
        self._next()
        self._timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        """Looks after the command that runs."""
        if event.type == 'ESC':
            self._process.cancel()
        if event.type != 'TIMER':
            return {'PASS_THROUGH'}
        if self._process.running:
            words = self._process.progress or f'zstrip {self._process.words[1]}'
            context.workspace.status_text_set(f'{words} (Escape cancels)')
            return {'PASS_THROUGH'}
        try:
            self._ended(self._process.outcome())
            if self._next():
                return {'PASS_THROUGH'}
        except (command.CommandError, OSError) as error:
            return self._fail(context, str(error))
        self._clean(context)
        return {'FINISHED'}

    def cancel(self, context):
        """Blender closes the window or loads another file."""
        if self._process is not None:
            self._process.cancel()
        self._clean(context)

    def _next(self):
        if not self._steps:
            return False
        words, self._finish = self._steps.pop(0)
        self._process = process.Process(words)
        return True

    def _ended(self, outcome):
        out = command.checked(outcome)
        for warning in command.warnings_of(outcome.err):
            self.report({'WARNING'}, f'zstrip: {warning}')
        try:
            self._finish(out)
        except (KeyError, IndexError, TypeError, ValueError) as error:
            raise command.CommandError(f'its report: {error!r}; is the command as new as the add-on?') from error

    def _fail(self, context, message):
        self._clean(context)
        self.report({'INFO' if message == command.CANCELLED else 'ERROR'}, f'zstrip: {message}')
        return {'CANCELLED'}

    def _clean(self, context):
        shutil.rmtree(self._folder, ignore_errors=True)
        if self._timer is not None:
            context.window_manager.event_timer_remove(self._timer)
            context.workspace.status_text_set(None)
            self._timer = None
            for area in context.window.screen.areas:
                area.tag_redraw()


def _plan_step(scene, path, settings):
    what = _with_animation(scene)

    def keep(out):
        figures[scene.name] = (what, settings.board, command.parse_plan(out, settings.board))

    return command.plan_words(preferences.find(), path, settings), keep


class ZSTRIP_OT_plan(_Commands, bpy.types.Operator):
    """Ask zstrip for RAM and flash of the scene, and frames a second of the board"""

    bl_idname = 'zstrip.plan'
    bl_label = 'Figures'

    def execute(self, context):
        """Fills the figures of the scene."""
        return self.begin(context, lambda path, settings: [_plan_step(context.scene, path, settings)])


class ZSTRIP_OT_save(_Commands, bpy.types.Operator):
    """Save the scene for firmware"""

    bl_idname = 'zstrip.save'
    bl_label = 'Save for zstrip'

    kind: bpy.props.EnumProperty(
        name='Kind', items=[
            ('HEADER', 'Header', 'C++ constants, .hpp'), ('BLOB', 'Blob', 'A file that is used in place, .zsc'),
            ('SKETCH', 'Sketch', 'A folder for the Arduino IDE'),
            ('UF2', '.uf2', 'A file that a Raspberry Pi Pico or Pico 2 takes')])
    filepath: bpy.props.StringProperty(subtype='FILE_PATH')
    filter_glob: bpy.props.StringProperty(options={'HIDDEN'})

    def invoke(self, context, event):
        """Asks for the file's name."""
        name = bpy.path.clean_name(bpy.path.display_name_from_filepath(bpy.data.filepath) or context.scene.name)
        folder = os.path.dirname(self.filepath or bpy.data.filepath)
        ending = command.KINDS[self.kind]
        self.filepath = os.path.join(folder, name + ending)
        self.filter_glob = f'*{ending}'
        context.window_manager.fileselect_add(self)
        return {'RUNNING_MODAL'}

    def execute(self, context):
        """Saves."""
        output = bpy.path.abspath(self.filepath)
        if not output:
            self.report({'ERROR'}, 'zstrip: the file needs a name')
            return {'CANCELLED'}
        if not os.path.splitext(output)[1]:
            output += command.KINDS[self.kind]
        scene = context.scene

        def tell(out):
            total = json.loads(out)['flash_bytes']['total']
            self.report({'INFO'}, f'zstrip: saved {output}, {total:,} bytes of flash')

        def steps(path, settings):
            board = scene.zstrip.uf2_board
            words = command.bake_words(
                preferences.find(), path, output, self.kind, settings,
                uf2_board='' if board in ('', properties.NONE) else board,
                uf2_program=bpy.path.abspath(scene.zstrip.uf2_program))
            return [(words, tell), _plan_step(scene, path, settings)]

        return self.begin(context, steps)


class ZSTRIP_OT_fit(_Commands, bpy.types.Operator):
    """Make textures and meshes small enough for the board, and save what looks best"""

    bl_idname = 'zstrip.fit'
    bl_label = 'Fit to board'

    filepath: bpy.props.StringProperty(subtype='FILE_PATH')
    filter_glob: bpy.props.StringProperty(default='*.zsc;*.hpp;*.uf2', options={'HIDDEN'})

    def invoke(self, context, event):
        """Asks for the file's name."""
        self.filepath = bpy.path.clean_name(context.scene.name) + '.zsc'
        context.window_manager.fileselect_add(self)
        return {'RUNNING_MODAL'}

    def execute(self, context):
        """Saves."""
        output = bpy.path.abspath(self.filepath)

        def tell(out):
            report = json.loads(out)
            choice = report['choices'][report['chosen'] - 1]
            self.report({'INFO'}, f"zstrip: saved {output}, {choice['triangles']:,} triangles, "
                                  f"{choice['flash_bytes']:,} bytes of flash")

        def steps(path, settings):
            if not settings.board:
                raise command.CommandError('choose the board that the scene is to fit')
            return [(command.fit_words(preferences.find(), path, output, settings), tell)]

        return self.begin(context, steps)


def _sizes(self, context):
    panel = preferences.catalogue().panel(context.scene.zstrip.panel)
    sizes = []
    for width, height in panel.sizes if panel else ():
        sizes += [f'{width}x{height}'] + ([f'{height}x{width}'] if panel.rotates and width != height else [])
    properties._kept['sizes'] = [(size, size, '') for size in sizes] or [(properties.NONE, 'Choose a panel', '')]
    return properties._kept['sizes']


class ZSTRIP_OT_use_size(bpy.types.Operator):
    """Render as many pixels as the panel has, and show their colours unchanged"""

    bl_idname = 'zstrip.use_size'
    bl_label = "Use the panel's size"
    bl_options = {'REGISTER', 'UNDO'}

    size: bpy.props.EnumProperty(name='Size', items=_sizes)

    def execute(self, context):
        """Sets the resolution."""
        if self.size in ('', properties.NONE):
            self.report({'ERROR'}, 'zstrip: choose a panel first')
            return {'CANCELLED'}
        render = context.scene.render
        render.resolution_x, render.resolution_y = (int(side) for side in self.size.split('x'))
        render.resolution_percentage = 100
        render.pixel_aspect_x = render.pixel_aspect_y = 1
        return bpy.ops.zstrip.exact_colours()


def shows_exact_colours(scene):
    """True if Blender shows the pixels of a picture as they are."""
    view = scene.view_settings
    return (view.view_transform == 'Standard' and view.look in ('None', '') and view.exposure == 0 and view.gamma == 1
            and not view.use_curve_mapping and scene.render.dither_intensity == 0)


class ZSTRIP_OT_exact_colours(bpy.types.Operator):
    """Show the device's colours: the view transform Standard, without look, exposure, gamma, curves and dither"""

    bl_idname = 'zstrip.exact_colours'
    bl_label = "Show the device's colours"
    bl_options = {'REGISTER', 'UNDO'}

    def execute(self, context):
        """Sets the scene's colour management."""
        view = context.scene.view_settings
        try:
            view.view_transform = 'Standard'
            view.look = 'None'
        except TypeError as error:  # a configuration of the user's own
            self.report({'ERROR'}, f'zstrip: {str(error).strip()}')
            return {'CANCELLED'}
        view.exposure, view.gamma, view.use_curve_mapping = 0, 1, False
        context.scene.render.dither_intensity = 0
        return {'FINISHED'}


CLASSES = (ZSTRIP_OT_plan, ZSTRIP_OT_save, ZSTRIP_OT_fit, ZSTRIP_OT_exact_colours, ZSTRIP_OT_use_size)


def register():
    """Adds the operators to Blender."""
    for each in CLASSES:
        bpy.utils.register_class(each)


def unregister():
    """Takes them out again."""
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)
    figures.clear()
