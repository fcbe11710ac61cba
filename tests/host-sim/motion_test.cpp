// Motions and the keyframes made of them, judged by rotations written out by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "import/quantise.hpp"
#include "motion/clip_sequence.hpp"
#include "motion/fitted_animation.hpp"
#include "motion/node_tree.hpp"

namespace zstrip::sim::test {
namespace {

/// About the y axis, with a translation and a scale.
Affine turned_about_y(double degrees, const Vector& moved, double size) {
  const double s = std::sin(degrees * std::numbers::pi / 180), c = std::cos(degrees * std::numbers::pi / 180);
  Affine a;
  a.m = {{{size * c, 0, size * s, moved[0]}, {0, size, 0, moved[1]}, {-size * s, 0, size * c, moved[2]}}};
  return a;
}

double largest_difference(const Affine& a, const Affine& b) {
  double largest = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      largest = std::max(largest, std::abs(a.m[row][column] - b.m[row][column]));
    }
  }
  return largest;
}

Affine posed(const Animation& animation, std::uint32_t time) {
  Instance instance;
  pose(animation, time, {&instance, 1});
  Affine a;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) a.m[row][column] = from_fixed(instance.transform.m[row][column]);
  }
  return a;
}

const std::vector<Vector> kBox{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};

TEST(Motion, PlacementsOfMatricesComeBack) {
  for (const double degrees : {0.0, 30.0, 90.0, 179.9, 180.0, 270.0}) {
    const Affine wanted = turned_about_y(degrees, {1, 2, 3}, 0.5);
    EXPECT_LT(largest_difference(to_affine(to_placement(wanted)), wanted), 1e-12) << degrees;
    Affine mirrored = wanted;
    for (auto& row : mirrored.m) row[2] = -row[2];
    EXPECT_LT(largest_difference(to_affine(to_placement(mirrored)), mirrored), 1e-12) << degrees;
    EXPECT_LT(largest_difference(wanted * inverse(wanted), Affine{}), 1e-12);
  }
  Affine nothing;
  for (std::size_t i = 0; i < 3; ++i) nothing.m[i][i] = 0;
  EXPECT_LT(largest_difference(to_affine(to_placement(nothing)), nothing), 1e-12);
}

TEST(Motion, FewKeyframesShowAWholeTurn) {
  const auto at = [](double seconds) { return turned_about_y(90 * seconds, {seconds, 0, 0}, 1 + seconds / 4); };
  const InstanceMotion motion{.instance = 0, .at = at, .corners = kBox};
  constexpr double kTolerance = 1.0 / 1600;
  const Result<FittedAnimation> fitted = fit_animation({&motion, 1}, 4, {}, kTolerance);
  ASSERT_TRUE(fitted);
  const Animation animation = fitted->view();
  EXPECT_TRUE(validate(animation, 1));
  EXPECT_EQ(animation.duration, 4000U);
  EXPECT_LT(animation.keyframes.size(), 40U);
  EXPECT_LE(fitted->error(), kTolerance);
  for (std::uint32_t time = 0; time < 4000; time += 7) {
    EXPECT_LT(largest_difference(posed(animation, time), at(time / 1000.0)), 2 * kTolerance) << time;
  }
  EXPECT_EQ(largest_difference(posed(animation, 4000), posed(animation, 0)), 0);  // it begins again
}

TEST(Motion, WhatStandsStillIsOneKeyframe) {
  const InstanceMotion motion{.instance = 0,
                              .at =
                                  [](double) {
                                    return turned_about_y(33, {1, 2, 3}, 2);
                                  },
                              .corners = kBox};
  const Result<FittedAnimation> fitted = fit_animation({&motion, 1}, 10, {}, 1e-3);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(fitted->view().keyframes.size(), 1U);
}

TEST(Motion, JumpsStayJumps) {
  const auto at = [](double seconds) { return translation({seconds < 1 ? 0.0 : 5.0, 0, 0}); };
  const InstanceMotion motion{.instance = 0, .at = at, .corners = kBox};
  const Result<FittedAnimation> fitted = fit_animation({&motion, 1}, 2, {0, 1, 2}, 1e-3);
  ASSERT_TRUE(fitted);
  EXPECT_EQ(posed(fitted->view(), 999).m[0][3], 0);
  EXPECT_EQ(posed(fitted->view(), 1000).m[0][3], 5);
  EXPECT_LE(fitted->view().keyframes.size(), 4U);
}

TEST(Motion, OutOfRangeIsRefused) {
  const InstanceMotion motion{.instance = 0,
                              .at =
                                  [](double s) {
                                    return translation({40000 * s, 0, 0});
                                  },
                              .corners = kBox};
  EXPECT_FALSE(fit_animation({&motion, 1}, 1, {}, 1e-3));
}

TEST(Motion, Curves) {
  Curve<Vector> curve{
      .times = {1, 2, 4}, .values = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, .slopes_in = {}, .slopes_out = {}};
  EXPECT_EQ(sample(curve, 0)[0], 0);
  EXPECT_EQ(sample(curve, 1.5)[0], 0.5);
  EXPECT_EQ(sample(curve, 3)[0], 2);
  EXPECT_EQ(sample(curve, 9)[0], 3);
  curve.interpolation = Interpolation::step;
  EXPECT_EQ(sample(curve, 1.999)[0], 0);
  EXPECT_EQ(sample(curve, 2)[0], 1);
  // Of a parabola, x = t^2, the cubic through its values and slopes is the parabola.
  const Curve<Vector> parabola{.interpolation = Interpolation::cubic_spline,
                               .times = {0, 2},
                               .values = {{0, 0, 0}, {4, 0, 0}},
                               .slopes_in = {{0, 0, 0}, {4, 0, 0}},
                               .slopes_out = {{0, 0, 0}, {4, 0, 0}}};
  EXPECT_NEAR(sample(parabola, 0.5)[0], 0.25, 1e-12);
  EXPECT_NEAR(sample(parabola, 1.5)[0], 2.25, 1e-12);
}

/// A child turns about its own place on a parent that moves.
TEST(Motion, NodesMoveWithTheirParents) {
  NodeTree tree;
  tree.nodes = {{.parent = kNoNode, .before = {}, .at_rest = {}},
                {.parent = 0, .before = translation({0, 1, 0}), .at_rest = translation({2, 0, 0})}};
  NodeAnimation animation{.name = "a", .duration = 1, .moved = {}};
  NodeCurves parent, child;
  parent.translation = {.times = {0, 1}, .values = {{0, 0, 0}, {10, 0, 0}}, .slopes_in = {}, .slopes_out = {}};
  child.node = 1;
  child.rotation = {
      .times = {0, 1}, .values = {{0, 0, 0, 1}, about_axis({0, 1, 0}, 90)}, .slopes_in = {}, .slopes_out = {}};
  animation.moved = {parent, child};
  EXPECT_LT(largest_difference(tree.at_rest(1), translation({2, 1, 0})), 1e-12);
  EXPECT_LT(largest_difference(tree.at(animation, 1, 0.5), turned_about_y(45, {7, 1, 0}, 1)), 1e-12);
}

/// One clip turns by 90 degrees a second, the other stands at -30; angles are worked out by hand.
TEST(Motion, ClipsFadeIntoTheNext) {
  NodeTree tree;
  tree.nodes = {{.parent = kNoNode, .before = translation({0, 1, 0}), .at_rest = translation({2, 0, 0})}};
  NodeAnimation turns{.name = "turns", .duration = 1, .moved = {}};
  NodeAnimation stands{.name = "stands", .duration = 2, .moved = {}};
  NodeCurves turning, standing;
  turning.rotation = {
      .times = {0, 1}, .values = {{0, 0, 0, 1}, about_axis({0, 1, 0}, 90)}, .slopes_in = {}, .slopes_out = {}};
  standing.rotation = {.times = {0}, .values = {about_axis({0, 1, 0}, -30)}, .slopes_in = {}, .slopes_out = {}};
  standing.translation = {.times = {0}, .values = {{4, 0, 0}}, .slopes_in = {}, .slopes_out = {}};
  turns.moved = {turning};
  turns.weights = {{.weight = 3, .curve = {.times = {0, 1}, .values = {{0}, {1}}, .slopes_in = {}, .slopes_out = {}}}};
  stands.moved = {standing};
  const std::array<ClipStep, 2> steps{
      {{.clip = &turns, .seconds = 1.5, .fade = 0.5}, {.clip = &stands, .seconds = 1, .fade = 0.5}}};
  const NodeAnimation joined = joined_clips(tree, steps);
  EXPECT_DOUBLE_EQ(joined.duration, 2.5);
  ASSERT_EQ(joined.weights.size(), 1U);
  EXPECT_EQ(joined.weights[0].weight, 3U);
  struct Pose {
    double seconds, degrees, x, weight;
  };
  for (const Pose& pose : {Pose{0, -30, 4, 0},           // fades from the last step, which goes on
                           Pose{0.25, -3.75, 3, 0.125},  // half of -30 and of 22.5
                           Pose{0.75, 67.5, 2, 0.75},    // the first clip alone, whose file moves it by nothing
                           Pose{1.25, 22.5, 2, 0.25},    // it has begun again
                           Pose{1.75, 18.75, 3, 0.375},  // half of 67.5, where the first would be, and of -30
                           Pose{2.25, -30, 4, 0}}) {
    EXPECT_LT(largest_difference(tree.at(joined, 0, pose.seconds), turned_about_y(pose.degrees, {pose.x, 1, 0}, 1)),
              1e-9)
        << pose.seconds;
    EXPECT_NEAR(sample(joined.weights[0].curve, pose.seconds), pose.weight, 1e-9) << pose.seconds;
  }
}

/// Without a fade the pose before is shown until the last moment.
TEST(Motion, ClipsWithoutAFadeJump) {
  NodeTree tree;
  tree.nodes = {{.parent = kNoNode, .before = {}, .at_rest = {}}};
  std::array<NodeAnimation, 2> clips;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const double x = i == 0 ? 1 : 5;
    NodeCurves curves;
    curves.translation = {.times = {0}, .values = {{x, 0, 0}}, .slopes_in = {}, .slopes_out = {}};
    clips[i] = {.name = "a", .duration = 1, .moved = {curves}};
  }
  const std::array<ClipStep, 2> steps{{{.clip = &clips[0], .seconds = 0.4}, {.clip = &clips[1], .seconds = 0.6}}};
  const NodeAnimation joined = joined_clips(tree, steps);
  const auto x_at = [&](double seconds) { return tree.at(joined, 0, seconds).m[0][3]; };
  EXPECT_EQ(x_at(0), 1);
  EXPECT_EQ(x_at(0.3998), 1);
  EXPECT_EQ(x_at(0.4), 5);
  EXPECT_EQ(x_at(0.9998), 5);
}

/// Damaged animations are refused, not posed.
TEST(Motion, ValidateAnimations) {
  const Keyframe still{.time = 0, .rotation = {0, 0, 0, 32767}, .translation = {}, .scale = {65536, 65536, 65536}};
  const auto validated = [](std::vector<Keyframe> keyframes, Track track, std::uint32_t duration) {
    return validate(Animation{.tracks = {&track, 1}, .keyframes = keyframes, .duration = duration}, 1).error;
  };
  const auto with = [&](auto change) {
    Keyframe changed = still;
    change(changed);
    return std::vector<Keyframe>{still, changed};
  };
  Keyframe later = still;
  later.time = 5;
  EXPECT_EQ(validated({still, later}, {0, 2, 0}, 9), Error::none);
  EXPECT_EQ(validated({still, still}, {0, 2, 0}, 9), Error::animation);  // at the same time
  EXPECT_EQ(validated({still}, {1, 1, 0}, 9), Error::animation);         // no such instance
  EXPECT_EQ(validated({still}, {0, 2, 0}, 9), Error::animation);
  EXPECT_EQ(validated({still}, {0, 1, 1}, 9), Error::animation);
  EXPECT_EQ(validated({still}, {0, 1, 0xFFFFFFFF}, 9), Error::animation);
  EXPECT_EQ(validated({still}, {0, 0, 0}, 9), Error::animation);
  EXPECT_EQ(validated({still}, {0, 1, 0}, 0), Error::animation);
  EXPECT_EQ(validated(with([](Keyframe& k) { k.time = 5, k.rotation[3] = -32767; }), {0, 2, 0}, 9), Error::animation);
  EXPECT_EQ(validated(with([](Keyframe& k) { k.time = 5, k.rotation[3] = 16000; }), {0, 2, 0}, 9), Error::animation);
  EXPECT_EQ(validated(with([](Keyframe& k) { k.time = 5, k.scale.y = 256 * 65536; }), {0, 2, 0}, 9), Error::animation);
  EXPECT_EQ(validated(with([](Keyframe& k) {
                        for (auto& c : k.rotation) c = -32768;
                      }),
                      {0, 2, 0}, 9),
            Error::animation);
}

}  // namespace
}  // namespace zstrip::sim::test
