// An overlay read from the fuzzer's bytes: images, fonts, sprites and labels, within their ranges or anything.
#pragma once

#include <algorithm>
#include <vector>

#include "input.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace fuzz {

/// Owns what the overlay refers to, each array in heap memory of its own size. A zero byte: none.
class OverlayInput {
 public:
  explicit OverlayInput(Input& input) {
    const std::uint32_t choice = input.below(4);
    if (choice == 0) return;
    is_there_ = true;
    is_hostile_ = choice == 3;
    images_.resize(input.below(3));
    fonts_.resize(input.below(3));
    // What spans view stays where it is.
    image_arrays_.resize(images_.size());
    font_arrays_.resize(fonts_.size());
    for (std::size_t i = 0; i < images_.size(); ++i) read_image(input, image_arrays_[i], images_[i]);
    for (std::size_t i = 0; i < fonts_.size(); ++i) read_font(input, font_arrays_[i], fonts_[i]);
    sprites_.resize(images_.empty() && !is_hostile_ ? 0 : input.below(6));
    for (zstrip::Sprite& sprite : sprites_) {
      sprite = {.x = place(input), .y = place(input), .image = index(input, images_.size()), .colour = colour(input)};
    }
    labels_.resize(fonts_.empty() && !is_hostile_ ? 0 : input.below(4));
    texts_.resize(labels_.size());
    for (std::size_t i = 0; i < labels_.size(); ++i) read_label(input, texts_[i], labels_[i]);
    overlay_ = {.images = images_, .fonts = fonts_, .sprites = sprites_, .labels = labels_};
  }
  OverlayInput(const OverlayInput&) = delete;
  OverlayInput& operator=(const OverlayInput&) = delete;

  /// For Scene::overlay.
  const zstrip::Overlay* overlay() const { return is_there_ ? &overlay_ : nullptr; }

 private:
  struct ImageArrays {
    std::vector<std::uint16_t> colours;
    std::vector<std::uint8_t> coverage;
  };
  struct FontArrays {
    std::vector<zstrip::Glyph> glyphs;
    std::vector<std::uint8_t> coverage;
  };

  static std::int16_t place(Input& input) { return static_cast<std::int16_t>(input.number(2)); }
  /// Zero bytes are opaque white.
  static zstrip::Colour colour(Input& input) {
    const auto channel = [&input] { return static_cast<std::uint8_t>(~input.any<std::uint8_t>()); };
    const std::uint8_t r = channel();
    const std::uint8_t g = channel();
    const std::uint8_t b = channel();
    return {r, g, b, channel()};
  }
  std::uint16_t index(Input& input, std::size_t count) const {
    return static_cast<std::uint16_t>(is_hostile_ ? input.any<std::uint8_t>() % 4
                                                  : input.below(static_cast<std::uint32_t>(count)));
  }
  std::uint8_t bits(Input& input) const {
    constexpr std::uint8_t kBits[] = {8, 4, 1};
    return is_hostile_ && input.flag() ? input.any<std::uint8_t>() : kBits[input.below(3)];
  }
  /// The right number of elements, or another. Zero bytes are all covered, or white.
  template <class T>
  void read_array(Input& input, std::size_t right, std::vector<T>& array) const {
    array.resize(is_hostile_ && input.flag() ? input.below(300) : std::min<std::size_t>(right, 4096));
    for (std::size_t i = 0; i < array.size(); ++i) {
      array[i] = static_cast<T>(i < 8 ? ~input.any<T>() : array[i % 8] - i);
    }
  }

  void read_image(Input& input, ImageArrays& arrays, zstrip::OverlayImage& image) const {
    const auto side = [&] {
      return static_cast<std::uint16_t>(is_hostile_ && input.flag() ? input.any<std::uint16_t>() : 1 + input.below(12));
    };
    image.width = side();
    image.height = side();
    image.coverage_bits = bits(input);
    const std::uint32_t kinds = input.below(4);
    if (kinds % 2 == 0) read_array(input, std::size_t{image.width} * image.height, arrays.colours);
    if (kinds != 0) {
      const std::size_t row = zstrip::detail::coverage_row_bytes(image.width, image.coverage_bits);
      read_array(input, row * image.height, arrays.coverage);
    }
    image.colours = arrays.colours;
    image.coverage = arrays.coverage;
  }

  void read_font(Input& input, FontArrays& arrays, zstrip::Font& font) const {
    if (input.below(4) == 1) {
      font = zstrip::kSmallFont;
      return;
    }
    font.coverage_bits = bits(input);
    font.line_height = static_cast<std::uint16_t>(1 + input.below(20));
    font.baseline = static_cast<std::uint16_t>(input.below(24));
    if (input.flag()) font.replacement = 'a';
    if (is_hostile_ && input.flag()) {
      font.line_height = input.any<std::uint16_t>();
      font.baseline = input.any<std::uint16_t>();
    }
    arrays.glyphs.resize(input.below(6));
    std::uint32_t code_point = 'a', bytes = 0;
    for (zstrip::Glyph& glyph : arrays.glyphs) {
      glyph = {.code_point = code_point, .offset = bytes};
      read_glyph(input, font, glyph);
      code_point += 1 + input.below(3);
      bytes += zstrip::detail::coverage_row_bytes(glyph.width, font.coverage_bits) * glyph.height;
    }
    read_array(input, bytes, arrays.coverage);
    font.glyphs = arrays.glyphs;
    font.coverage = arrays.coverage;
  }

  void read_glyph(Input& input, const zstrip::Font& font, zstrip::Glyph& glyph) const {
    const std::int32_t line = std::min<std::int32_t>(font.line_height, 1000);
    glyph.width = static_cast<std::uint8_t>(input.below(10));
    glyph.height = static_cast<std::uint8_t>(input.below(static_cast<std::uint32_t>(std::min(3 * line, 12)) + 1));
    glyph.left = static_cast<std::int16_t>(input.between(-3, 3));
    glyph.top = static_cast<std::int16_t>(font.baseline - input.between(-line, 2 * line - glyph.height));
    glyph.advance = static_cast<std::uint16_t>(input.below(12));
    if (!is_hostile_ || !input.flag()) return;
    glyph.code_point = input.any<std::uint32_t>();
    glyph.offset += static_cast<std::uint32_t>(input.number(0));
    glyph.left = input.any<std::int16_t>();
    glyph.top = input.any<std::int16_t>();
    glyph.advance = input.any<std::uint16_t>();
  }

  void read_label(Input& input, std::vector<char>& text, zstrip::Label& label) const {
    constexpr char kUsual[] = {'a', 'b', 'c', 'd', ' ', '\n', 'f', '\0'};
    text.resize(input.below(24));
    for (char& letter : text) {
      // Upper halves: bytes of characters in UTF-8, and of none.
      const auto byte = input.any<std::uint8_t>();
      letter = byte < 0x80 ? kUsual[byte % 8] : static_cast<char>(byte);
    }
    label = {.text = text,
             .x = place(input),
             .y = place(input),
             .font = index(input, fonts_.size()),
             .alignment = static_cast<zstrip::Alignment>(is_hostile_ ? input.any<std::uint8_t>() : input.below(3)),
             .colour = colour(input),
             .background = colour(input)};
  }

  bool is_there_ = false, is_hostile_ = false;
  std::vector<ImageArrays> image_arrays_;
  std::vector<FontArrays> font_arrays_;
  std::vector<zstrip::OverlayImage> images_;
  std::vector<zstrip::Font> fonts_;
  std::vector<zstrip::Sprite> sprites_;
  std::vector<std::vector<char>> texts_;
  std::vector<zstrip::Label> labels_;
  zstrip::Overlay overlay_;
};

}  // namespace fuzz
