# zstrip in Blender: a render engine that shows a microcontroller's pixels, and buttons that write scenes for firmware.
# The command zstrip draws, plans and writes. Everything that needs no Blender is in modules without bpy.
bl_info = {
    "name": "zstrip",
    "author": "zstrip",
    "version": (0, 0, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Render",
    "description": "Shows scenes as microcontrollers draw them, and writes them for firmware",
    "category": "Render",
}


def _modules():
    from . import engine, operators, panels, preferences, properties
    return preferences, properties, operators, engine, panels


def register():
    """Adds everything to Blender."""
    for module in _modules():
        module.register()


def unregister():
    """Takes everything out of Blender again."""
    for module in reversed(_modules()):
        module.unregister()
