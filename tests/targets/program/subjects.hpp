// Scenes as subjects of cases, and the views in which all of them are drawn.
#pragma once

#include <span>

#include "cases.hpp"
#include "draw_case.hpp"

namespace zstrip::targets {

template <const scenes::BuiltIn& built_in>
inline constexpr Subject kSubject{&built_in, draw_case<built_in>};

/// Odd sizes: rows end inside a byte, and neither 7 nor 1 strip rows fill the picture evenly.
inline constexpr View kViews[] = {
    {64, 48, PixelFormat::rgb565}, {37, 29, PixelFormat::gray4}, {51, 33, PixelFormat::mono}};
inline constexpr std::uint16_t kStripRows[] = {1, 7, 0};
inline constexpr std::uint32_t kFrame = 13;  // everything stands askew

/// Each subject in each of the first `views` views; false as soon as `run` returns it.
inline bool in_views(std::span<const Subject* const> subjects, std::size_t views, bool (*run)(const Case&)) {
  for (const Subject* subject : subjects) {
    for (const View& view : std::span(kViews).first(views)) {
      for (const std::uint16_t rows : kStripRows) {
        if (!run({subject, Motion::turntable, view, rows, kFrame, 1})) return false;
      }
    }
  }
  return true;
}

}  // namespace zstrip::targets
