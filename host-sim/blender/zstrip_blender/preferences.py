# The add-on's preferences: where the command zstrip is, and what it lists.
import os

import bpy

from . import command, process

# Listing takes a hundredth of a second; a command that does not answer must not stop Blender.
LIST_SECONDS = 5.0
_listed = {}
_said = []


class ZstripPreferences(bpy.types.AddonPreferences):
    """Where the command is."""

    bl_idname = __package__

    command: bpy.props.StringProperty(
        name='Command', subtype='FILE_PATH',
        description="The command zstrip, or host-sim/run of its repository; empty: zstrip in PATH")

    def draw(self, context):
        """The path, and whether it answers."""
        row = self.layout.row()
        row.prop(self, 'command')
        row.operator('zstrip.find_command', icon='VIEWZOOM', text='Search')
        try:
            self.layout.label(text=f'Found: {find()}', icon='CHECKMARK')
        except command.CommandError as error:
            self.layout.label(text=str(error), icon='ERROR')


class ZSTRIP_OT_find_command(bpy.types.Operator):
    """Search zstrip in PATH and set the path of the command"""

    bl_idname = 'zstrip.find_command'
    bl_label = 'Search zstrip in PATH'

    def execute(self, context):
        """Sets the preference."""
        try:
            own().command = command.find_command()
        except command.CommandError as error:
            self.report({'ERROR'}, str(error))
            return {'CANCELLED'}
        self.report({'INFO'}, own().command)
        return {'FINISHED'}


def own():
    """The add-on's preferences."""
    return bpy.context.preferences.addons[__package__].preferences


def find():
    """Returns the command's path. Raises command.CommandError."""
    return command.find_command(bpy.path.abspath(own().command))


def catalogue():
    """Returns the command.Catalogue, which is asked for once for each file; an empty one where the command is missing
    or does not answer."""
    try:
        path = find()
        state = os.stat(path)
        key = (path, state.st_mtime_ns, state.st_size)
        if key not in _listed:
            _listed.clear()
            _listed[key] = command.Catalogue()  # of a command that fails: it is not asked again
            _listed[key] = command.parse_catalogue(
                command.checked(process.run([path, 'boards', '--json'], LIST_SECONDS)))
        return _listed[key]
    except (command.CommandError, OSError) as error:
        if _said[-1:] != [str(error)]:  # once: lists are drawn again and again
            _said.append(str(error))
            print(f'zstrip: {error}')
        return command.Catalogue()


CLASSES = (ZSTRIP_OT_find_command, ZstripPreferences)
register, unregister = bpy.utils.register_classes_factory(CLASSES)
