// The tables of a scene file, each with its own keys; docs/scenes.md describes them. A reader reads all keys of its
// table and finishes it; errors are added to the table's errors.
#pragma once

#include "compose/scene_file.hpp"
#include "compose/toml_table.hpp"

namespace zstrip::sim {

PictureSettings read_picture(TomlTable& table);
FileCamera read_camera(TomlTable& table);
FileModel read_model_table(TomlTable& table);
FileMaterial read_material(TomlTable& table);
FileInstance read_instance(TomlTable& table);
FileEllipsoid read_ellipsoid(TomlTable& table);
/// `are_points`: the table is [[points]].
FileLines read_lines(TomlTable& table, bool are_points);
FileCsg read_csg(TomlTable& table);
FileLight read_light(TomlTable& table);
FileFog read_fog(TomlTable& table);
FileSprite read_sprite(TomlTable& table);
FileLabel read_label(TomlTable& table);
AnimationEvent read_event(TomlTable& table);

}  // namespace zstrip::sim
