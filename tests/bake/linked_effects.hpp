// Which effects' code a linked program holds, read from the names of its symbols.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <regex>
#include <set>
#include <string>
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

inline LinkedEffects linked_effects(const std::string& program) {
  const Outcome outcome = run(ZSTRIP_NM, {"--demangle", program}, "/");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const auto for_each = [&outcome](const char* pattern, const auto& take) {
    const std::regex regex(pattern);
    for (std::sregex_iterator found(outcome.out.begin(), outcome.out.end(), regex), end; found != end; ++found) {
      take(*found);
    }
  };
  LinkedEffects linked;
  for_each(R"(zstrip::Effects\{([0-9]+)u?l*(?:, ([0-9]+)u)?\})", [&linked](const std::smatch& match) {
    linked.pipelines.push_back(
        {std::stoull(match[1]), match[2].matched ? static_cast<std::uint32_t>(std::stoul(match[2])) : 0});
  });
  for_each(R"((?:spans|triangle|polygon|clipped|triangles|narrow)<\(zstrip::detail::Shade\)([0-9]))",
           [&linked](const std::smatch& match) { linked.shades.insert(std::stoi(match[1])); });
  linked.clips = outcome.out.find("zstrip::detail::TriangleClipper<") != std::string::npos;
  linked.bins = outcome.out.find("zstrip::detail::Bins::append") != std::string::npos;
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
