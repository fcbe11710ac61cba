# The 3D viewports of all windows.
import bpy


def _areas():
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == 'VIEW_3D':
                yield area


def any_rendered():
    """True if one of them shows its scene rendered."""
    return any(area.spaces.active.shading.type == 'RENDERED' for area in _areas())


def redraw():
    """Draws them again."""
    for area in _areas():
        area.tag_redraw()
