# The panel "zstrip" in the render properties; and Blender's own panels that the engine's scenes need.
import bpy

from . import operators, properties

# Panels of materials, lights and the world that other engines name as theirs.
_SHARED = ('EEVEE_MATERIAL_PT_context_material', 'EEVEE_MATERIAL_PT_surface', 'EEVEE_MATERIAL_PT_settings',
           'EEVEE_MATERIAL_PT_viewport_settings', 'EEVEE_WORLD_PT_surface', 'DATA_PT_EEVEE_light')


class ZSTRIP_PT_device(bpy.types.Panel):
    """The device, its figures, and what is saved for it."""

    bl_label = 'zstrip'
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = 'render'
    COMPAT_ENGINES = {'ZSTRIP'}

    @classmethod
    def poll(cls, context):
        """Only in scenes of this engine."""
        return context.engine in cls.COMPAT_ENGINES

    def draw(self, context):
        """Settings, figures, buttons."""
        layout, scene = self.layout, context.scene
        layout.use_property_split = True
        layout.use_property_decorate = False
        own = scene.zstrip
        column = layout.column()
        column.prop(own, 'board')
        column.prop(own, 'panel')
        if own.panel not in ('', properties.NONE):
            column.operator_menu_enum('zstrip.use_size', 'size')
        self._draw_figures(scene)
        column = layout.column()
        for name in ('format', 'ram', 'samples', 'dither', 'edges', 'highlights', 'plain_materials'):
            column.prop(own, name)
        if not operators.shows_exact_colours(scene):
            box = layout.box()
            box.label(text='Colour management changes the colours', icon='ERROR')
            box.operator('zstrip.exact_colours')
        column = layout.column()
        column.prop(own, 'animation')
        column.prop(own, 'modifiers')
        row = layout.row(align=True)
        for kind, text in (('HEADER', 'Header'), ('BLOB', 'Blob'), ('SKETCH', 'Sketch')):
            row.operator('zstrip.save', text=text).kind = kind
        column = layout.column()
        column.operator('zstrip.fit')
        column.prop(own, 'uf2_board')
        column.prop(own, 'uf2_program')
        column.operator('zstrip.save', text='Save .uf2').kind = 'UF2'

    def _draw_figures(self, scene):
        box = self.layout.box()
        what, board, found = operators.figures.get(scene.name, ('', '', None))
        box.operator('zstrip.plan', text=f'Figures {what}'.strip())
        if found is not None:
            for line in found.lines(board):
                box.label(text=line)


def _shared_panels():
    for name in _SHARED:
        found = getattr(bpy.types, name, None)
        if found is not None and hasattr(found, 'COMPAT_ENGINES'):
            yield found
    for found in bpy.types.Panel.__subclasses__():
        if 'BLENDER_RENDER' in getattr(found, 'COMPAT_ENGINES', ()):
            yield found


def register():
    """Adds the panel, and the engine to Blender's own."""
    bpy.utils.register_class(ZSTRIP_PT_device)
    for found in _shared_panels():
        found.COMPAT_ENGINES.add('ZSTRIP')


def unregister():
    """Takes them out again."""
    for found in _shared_panels():
        found.COMPAT_ENGINES.discard('ZSTRIP')
    bpy.utils.unregister_class(ZSTRIP_PT_device)
