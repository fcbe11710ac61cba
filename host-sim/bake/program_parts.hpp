// Parts that several texts of programs use: names, the player's memory, the panel, and checks of scenes and pictures.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "bake/baked_scene.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Replaces each @ by the header's namespace.
std::string with_namespace(std::string text, const std::string& name_space);

/// Returns the scene and its motion, for zstrip::Player::open and zstrip::scenes::stage.
std::string at_rest_words(const BakedScene& baked);

/// True if the scene has skins or morph targets, whose vertices the program writes before each frame.
bool bends(const BakedScene& baked);
/// Returns a call that moves them to their place at a time, with a placeholder for the namespace.
std::string pose_call(const BakedScene& baked, std::string_view time);
/// The message of a program that could not move them.
std::string pose_words(const BakedScene& baked);

std::string first_line(const BakedScene& baked);

/// The memory of the scene's player, and the player.
std::string player_text(const BakedScene& baked);

/// True if the panel is rotated: the picture is wider than the panel, or has the size of a module on its side.
bool lies_sideways(const View& view);

/// The module of the picture's size, upright.
struct UprightModule {
  std::uint16_t width, height, column_offset = 0, row_offset = 0;
  int columns_after = 0, rows_after = 0;  ///< the offsets of the module upside down
};
UprightModule upright_module(const View& view);

/// Returns the driver's configuration of the panel in this orientation.
std::string panel_config(const View& view);

/// Refuses pictures that no ST7789 can show.
Result<Done> check_panel(const View& view);
/// Refuses formats that zstrip's driver of an ST7789 does not send.
Result<Done> check_format(const View& view);
/// Refuses formats but RGB565; `advice` says what to choose.
Result<Done> check_rgb565(const View& view, std::string_view advice);

/// Refuses visibility methods, and a namespace that is one of `names`, those that the text defines itself.
Result<Done> check_names(const BakedScene& baked, const std::string& name_space,
                         std::initializer_list<const char*> names);

}  // namespace zstrip::sim
