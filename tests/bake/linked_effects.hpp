// Which effects' code a linked program holds, read from the names of its symbols.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "support.hpp"
#include "zstrip/raster/clip_triangle.hpp"
#include "zstrip/raster/raster_effects.hpp"

namespace zstrip::sim::test {

struct LinkedEffects {
  std::vector<Effects> pipelines;  ///< that templates were made for
  std::set<int> shades;            ///< values of detail::Shade that rasterisers were made for
  bool bins = false;
  bool clips = false;
};

/// The number at the beginning of `text`, which then begins behind it; none if there is no digit.
template <class Number>
std::optional<Number> take_number(std::string_view& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return {};
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

/// The names have megabytes, in which regular expressions would take seconds.
inline LinkedEffects linked_effects(const std::string& program) {
  const Outcome outcome = run(ZSTRIP_NM, {"--demangle", program}, "/");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string_view names = outcome.out;
  const auto for_each = [names](std::string_view before, const auto& take) {
    for (std::size_t at = names.find(before); at != names.npos; at = names.find(before, at + 1))
      take(at, names.substr(at + before.size()));
  };
  LinkedEffects linked;
  // zstrip::Effects{1ul} or zstrip::Effects{1ul, 2u}; the suffixes are those of the machine.
  for_each("zstrip::Effects{", [&linked](std::size_t, std::string_view text) {
    const std::optional bits = take_number<std::uint64_t>(text);
    if (!bits) return;
    text.remove_prefix(std::min(text.find_first_not_of("ul"), text.size()));
    std::uint32_t more = 0;
    if (text.starts_with(", ")) {
      text.remove_prefix(2);
      more = take_number<std::uint32_t>(text).value_or(0);
    }
    linked.pipelines.push_back({*bits, more});
  });
  for_each("<(zstrip::detail::Shade)", [&linked, names](std::size_t at, std::string_view text) {
    for (const char* drawn : {"spans", "triangle", "polygon", "clipped", "triangles", "narrow"}) {
      if (names.substr(0, at).ends_with(drawn)) linked.shades.insert(text.front() - '0');
    }
  });
  linked.clips = names.find("zstrip::detail::TriangleClipper<") != names.npos;
  linked.bins = names.find("zstrip::detail::Bins::append") != names.npos;
  return linked;
}

/// One pipeline, rasterisers, clipper and bins exactly as `effects` call for.
inline void expect_only(const std::string& program, Effects effects) {
  const LinkedEffects linked = linked_effects(program);
  ASSERT_FALSE(linked.pipelines.empty()) << program << " has no symbols";
  for (const Effects made_for : linked.pipelines) {
    if (constexpr Effects kOfProducts = effect::csg_layers | effect::csg_colours; made_for.any(kOfProducts)) {
      // The stage of products draws operands without what they do not have.
      const Effects rest = without(made_for, kOfProducts);
      EXPECT_TRUE(effects.has(effect::csg) && (effects.has(rest) || detail::raster_effects(effects).has(rest)))
          << program << ' ' << made_for.bits;
      continue;
    }
    if (effects.has(effect::shadows)) {
      // The map is a frame of its own, without colours: casters that are clipped on both sides.
      const Effects casting = effect::orthographic | effect::depth_state | (effects & effect::quadrics);
      if (made_for == casting || made_for == detail::raster_effects(casting) ||
          made_for == detail::clip_effects(casting)) {
        continue;
      }
    }
    // Rasterisers and vertices are made for what they ask for. A FixedRenderer is named by what no scene calls for.
    const Effects colours = effect::lighting | effect::vertex_colours;
    // Of operands of CSG both sides are drawn, so that they are clipped for both.
    const Effects sides = effects.has(effect::csg) ? effect::two_sided : Effects{};
    constexpr Effects kMore = effect::unclipped | effect::bins | effect::depth_formats | effect::perspective_runs;
    EXPECT_TRUE(made_for == effects || made_for == detail::raster_effects(effects) ||
                made_for == detail::clip_effects(effects) || made_for == (detail::clip_effects(effects) | sides) ||
                made_for == (effects & colours) || made_for == (effects & kMore))
        << program << ' ' << made_for.bits;
  }
  constexpr int kFlat = 0, kGouraud = 1, kTextured = 2, kTexturedFlat = 3, kTexturedGouraud = 4;
  EXPECT_EQ(linked.shades.contains(kFlat), effects.any(effect::shade_flat | effect::shadows)) << program;
  EXPECT_EQ(linked.shades.contains(kGouraud), effects.has(effect::shade_gouraud)) << program;
  EXPECT_EQ(linked.shades.contains(kTextured), effects.has(effect::shade_textured)) << program;
  EXPECT_EQ(linked.shades.contains(kTexturedFlat), effects.has(effect::shade_textured_flat)) << program;
  EXPECT_EQ(linked.shades.contains(kTexturedGouraud), effects.has(effect::shade_textured_gouraud)) << program;
  EXPECT_EQ(linked.bins, effects.has(effect::bins)) << program;
  EXPECT_EQ(linked.clips, !effects.has(effect::unclipped)) << program;
}

}  // namespace zstrip::sim::test
