// The overlay of a scene file: [[sprite]] and [[label]].
#include "compose/scene_tables.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::sim {
namespace {

constexpr std::pair<std::string_view, Alignment> kAlignments[] = {
    {"left", Alignment::left}, {"centre", Alignment::centre}, {"right", Alignment::right}};
constexpr std::pair<std::string_view, FileFont> kFonts[] = {{"small", FileFont::small}, {"large", FileFont::large}};

std::int16_t read_place(TomlTable& table, const char* key) {
  return static_cast<std::int16_t>(table.integer(key, INT16_MIN, INT16_MAX).value_or(0));
}

/// Reads `key`, and alpha from a separate key.
Colour read_colour(TomlTable& table, const char* key, const char* alpha, const Colour& without) {
  Colour colour = table.colour(key).value_or(without);
  colour.a = static_cast<std::uint8_t>(table.integer(alpha, 0, 255).value_or(table.has(key) ? 255 : without.a));
  return colour;
}

}  // namespace

FileSprite read_sprite(TomlTable& table) {
  FileSprite sprite;
  sprite.line = table.line();
  sprite.image = table.needed_text("image", "'image' is missing: a PNG, JPEG, WebP, BMP or TGA");
  sprite.x = read_place(table, "x");
  sprite.y = read_place(table, "y");
  sprite.colour = read_colour(table, "colour", "alpha", {255, 255, 255, 255});
  if (const auto bits = table.integer("coverage", 1, 8)) {
    if (*bits != 1 && *bits != 4 && *bits != 8) table.wrong("coverage", "'coverage' must be 1, 4 or 8 bits");
    sprite.coverage_bits = static_cast<std::uint8_t>(*bits);
  } else if (table.has("colour")) {
    table.wrong("colour", "'colour' goes with 'coverage': an image has its own");
  }
  table.finish();
  return sprite;
}

FileLabel read_label(TomlTable& table) {
  FileLabel label;
  label.line = table.line();
  label.text = table.needed_text("text", "'text' is missing");
  if (label.text.size() > kMaxLabelBytes) table.wrong("text", "'text' must have 65,535 bytes at most");
  label.x = read_place(table, "x");
  label.y = read_place(table, "y");
  label.font = table.choice("font", kFonts).value_or(FileFont::small);
  label.alignment = table.choice("align", kAlignments).value_or(Alignment::left);
  label.colour = read_colour(table, "colour", "alpha", {255, 255, 255, 255});
  if (table.has("background_alpha") && !table.has("background")) {
    table.wrong("background_alpha", "'background_alpha' goes with 'background'");
  }
  label.background = read_colour(table, "background", "background_alpha", {0, 0, 0, 0});
  table.finish();
  return label;
}

}  // namespace zstrip::sim
