// Morph targets against an oracle: offsets as dense tables, sums of rational numbers in 128 bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <vector>

#include "creature.hpp"
#include "zstrip/zstrip.hpp"

namespace zstrip::test {
namespace {

__extension__ using Wide = __int128;
using Triple = std::array<int, 3>;

/// What a target adds to each vertex, and whether it lists the vertex at all.
struct DenseTarget {
  std::vector<Triple> positions, normals;  ///< in steps of MorphOffset and NormalOffset
  std::vector<bool> listed;
};

/// A target of the core, which owns its tables.
struct Tables {
  std::vector<MorphRun> runs;
  std::vector<MorphOffset> positions;
  std::vector<NormalOffset> normals;
};

Tables tables_of(const DenseTarget& dense, bool with_normals) {
  Tables tables;
  for (std::size_t v = 0; v < dense.listed.size(); ++v) {
    if (!dense.listed[v]) continue;
    if (v == 0 || !dense.listed[v - 1]) {
      tables.runs.push_back({.first_vertex = static_cast<std::uint16_t>(v),
                             .count = 0,
                             .first_offset = static_cast<std::uint16_t>(tables.positions.size())});
    }
    ++tables.runs.back().count;
    const auto& [x, y, z] = dense.positions[v];
    tables.positions.push_back(
        {static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), static_cast<std::int16_t>(z)});
    const auto& [nx, ny, nz] = dense.normals[v];
    if (with_normals) {
      tables.normals.push_back(
          {static_cast<std::int8_t>(nx), static_cast<std::int8_t>(ny), static_cast<std::int8_t>(nz)});
    }
  }
  return tables;
}

/// A mesh with targets, and memory for what they move. It must not be copied: it holds spans of itself.
struct Face {
  Creature creature;
  std::vector<DenseTarget> dense;
  std::vector<Tables> tables;
  std::vector<MorphTarget> targets;
  std::vector<MorphWeight> weights;
  Morph morph;

  Face() = default;
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;
  Status move() { return morph_mesh(morph, weights, creature.moved()); }
};

/// `reach`: the largest offset; each target lists about `share` of the vertices, in runs.
void make(Face& face, Random& random, int reach, double share, std::size_t count) {
  face.creature = creature(random, 3);
  connect(face.creature);
  face.dense.resize(count);
  for (DenseTarget& target : face.dense) {
    bool inside = random.within(0, 1) < share;
    for (std::size_t v = 0; v < kVertices; ++v) {
      if (random.within(0, 1) < 0.1) inside = random.within(0, 1) < share;
      target.listed.push_back(inside);
      const auto within = [&](int limit) { return static_cast<int>(random.within(-limit, limit + 0.99)); };
      const Triple place{within(reach), within(reach), within(reach)}, normal{within(127), within(127), within(127)};
      target.positions.push_back(inside ? place : Triple{});
      target.normals.push_back(inside ? normal : Triple{});
    }
  }
  for (std::size_t i = 0; i < count; ++i) face.tables.push_back(tables_of(face.dense[i], i % 3 != 2));
  for (std::size_t i = 0; i < count; ++i) {
    const Tables& tables = face.tables[i];
    if (i % 3 == 2) face.dense[i].normals.assign(kVertices, Triple{});
    face.targets.push_back({.weight = static_cast<std::uint16_t>(count - 1 - i),
                            .runs = tables.runs,
                            .positions = tables.positions,
                            .normals = tables.normals});
  }
  face.weights.resize(count);
  face.morph = {&face.creature.mesh, face.targets};
}

/// floor(a / b), b > 0.
Wide floor_of(Wide a, Wide b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// base + sum of weight * offset / 4096, to nearest, halves up.
Wide expected(int base, const Face& face, std::size_t vertex, std::size_t axis) {
  Wide sum = 0;
  for (std::size_t i = 0; i < face.dense.size(); ++i) {
    sum += Wide{face.weights[face.targets[i].weight]} * face.dense[i].positions[vertex][axis];
  }
  return base + floor_of(2 * sum + 4096, 8192);
}

Triple triple_of(const Position& p) { return {p.x, p.y, p.z}; }
Triple triple_of(const Normal& n) { return {n.x, n.y, n.z}; }

TEST(Morphs, PositionsAreTheExactSumRoundedOnce) {
  Random random(11);
  int inside = 0, outside = 0;
  for (int i = 0; i < 200; ++i) {
    Face face;
    make(face, random, i % 2 == 0 ? 4000 : 30000, random.within(0.05, 0.9), 1 + random.below(9));
    ASSERT_TRUE(validate(face.morph)) << i;
    for (MorphWeight& weight : face.weights) weight = static_cast<MorphWeight>(random.within(-4096, 4096) * 1.5);
    const Status status = face.move();
    std::size_t first = kVertices;
    for (std::size_t v = kVertices; v-- > 0;) {
      const Triple base = triple_of(face.creature.positions[v]), found = triple_of(face.creature.moved_positions[v]);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const Wide wanted = expected(base[axis], face, v, axis);
        if (wanted < -32767 || wanted > 32767) first = v;
        ASSERT_EQ(found[axis], static_cast<int>(std::clamp<Wide>(wanted, -32767, 32767))) << i << " vertex " << v;
      }
    }
    ++(first == kVertices ? inside : outside);
    if (first == kVertices) {
      EXPECT_TRUE(status) << i;
    } else {
      EXPECT_EQ(status.error, Error::skin);
      EXPECT_EQ(status.needed, first);
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 20);
}

TEST(Morphs, NormalsHaveTheDirectionOfTheSumAndKeepTheirLength) {
  Random random(12);
  double worst = 0;
  for (int i = 0; i < 100; ++i) {
    Face face;
    make(face, random, 100, 0.5, 1 + random.below(6));
    for (MorphWeight& weight : face.weights) weight = static_cast<MorphWeight>(random.within(-4096, 4096));
    ASSERT_TRUE(face.move());
    for (std::size_t v = 0; v < kVertices; ++v) {
      const Triple base = triple_of(face.creature.normals[v]), found = triple_of(face.creature.moved_normals[v]);
      Vector sum{};
      bool moves = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        sum[axis] = base[axis];
        for (std::size_t k = 0; k < face.dense.size(); ++k) {
          const int offset = face.dense[k].normals[v][axis];
          sum[axis] += face.weights[face.targets[k].weight] / 4096.0 * 2 * offset;
          moves = moves || offset != 0;
        }
      }
      if (!moves) {
        ASSERT_EQ(found, base) << "a normal without offsets keeps its bits";
        continue;
      }
      const double before = length({double(base[0]), double(base[1]), double(base[2])}), after = length(sum);
      if (after < 1) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        worst = std::max(worst, std::abs(found[axis] - std::clamp(sum[axis] / after * before, -128.0, 127.0)));
      }
    }
  }
  EXPECT_LE(worst, 1.1);
}

TEST(Morphs, WithoutWeightsTheMeshKeepsItsBits) {
  Random random(13);
  Face face;
  make(face, random, 30000, 0.5, 4);
  ASSERT_TRUE(face.move());
  for (std::size_t v = 0; v < kVertices; ++v) {
    EXPECT_EQ(triple_of(face.creature.moved_positions[v]), triple_of(face.creature.positions[v]));
    EXPECT_EQ(triple_of(face.creature.moved_normals[v]), triple_of(face.creature.normals[v]));
  }
}

TEST(Morphs, SpheresOfMeshletsHoldTheirVertices) {
  Random random(14);
  Face face;
  make(face, random, 5000, 0.5, 4);
  face.weights.assign(4, 3000);
  ASSERT_TRUE(face.move());
  for (const Meshlet& m : face.creature.moved_meshlets) {
    double farthest = 0;
    for (std::size_t v = m.first_vertex; v < std::size_t{m.first_vertex} + m.vertex_count; ++v) {
      const Position& p = face.creature.moved_positions[v];
      farthest =
          std::max(farthest, length({double(p.x - m.centre.x), double(p.y - m.centre.y), double(p.z - m.centre.z)}));
    }
    EXPECT_LE(farthest, m.radius);
    EXPECT_LT(m.radius, farthest + 1);
  }
}

/// The morphed mesh is in the memory that the skin writes.
TEST(Morphs, ASkinMovesWhatTargetsHaveMoved) {
  Random random(15);
  Face face;
  make(face, random, 1500, 0.6, 3);
  face.weights = {2000, -1000, 4096};
  ASSERT_TRUE(face.move());
  Creature& c = face.creature;
  Creature apart = c;
  apart.positions = c.moved_positions;
  apart.normals = c.moved_normals;
  connect(apart);
  std::vector<JointPose> pose = c.rest;
  for (JointPose& joint : pose) random.turn(joint, 0.4);
  ASSERT_TRUE(apart.move(pose));
  const Mesh morphed = moved_mesh(c.mesh, c.moved());
  c.skin.mesh = &morphed;
  ASSERT_TRUE(c.move(pose));
  for (std::size_t v = 0; v < kVertices; ++v) {
    EXPECT_EQ(triple_of(c.moved_positions[v]), triple_of(apart.moved_positions[v]));
    EXPECT_EQ(triple_of(c.moved_normals[v]), triple_of(apart.moved_normals[v]));
  }
  for (std::size_t i = 0; i < c.meshlets.size(); ++i) {
    EXPECT_EQ(c.moved_meshlets[i].radius, apart.moved_meshlets[i].radius);
  }
}

TEST(Morphs, HostileTargetsAreRefused) {
  Random random(16);
  const auto refused = [&](auto change, std::size_t index) {
    Face face;
    make(face, random, 500, 0.5, 3);
    EXPECT_TRUE(validate(face.morph));
    change(face);
    const Status status = validate(face.morph);
    return status.error == Error::skin && status.needed == index;
  };
  const auto run = [](Face& f, std::size_t k) -> MorphRun& { return f.tables[1].runs[k]; };
  EXPECT_TRUE(refused([&](Face& f) { run(f, 0).count = 0; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { run(f, 1).first_vertex = run(f, 0).first_vertex; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.tables[1].runs.back().first_vertex = kVertices; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.tables[1].runs.back().first_vertex = 65535; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.tables[1].runs.back().count = 65535; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { run(f, 0).first_offset = 65535; }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.targets[1].positions = f.targets[1].positions.first(1); }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.targets[1].normals = f.targets[1].normals.first(1); }, 1));
  EXPECT_TRUE(refused([&](Face& f) { f.creature.mesh.normals = {}; }, 0));
  EXPECT_TRUE(refused([&](Face& f) { f.creature.mesh.half_extent.y += 1; }, 0));
  EXPECT_TRUE(refused([&](Face& f) { f.creature.mesh.positions = f.creature.mesh.positions.first(1); }, 0));
  EXPECT_TRUE(refused([&](Face& f) { f.morph.mesh = nullptr; }, 0));
  EXPECT_TRUE(refused([&](Face& f) { f.morph.targets = {}; }, 0));

  Face face;
  make(face, random, 500, 0.5, 3);
  face.weights = {32767, -32768, 0};
  EXPECT_TRUE(face.move()) << "a sum of 65535 / 4096";
  face.weights = {32767, -32768, 1};
  EXPECT_EQ(face.move().error, Error::skin) << "weights of 16 in all";
  face.weights = {0, 0};  // the first target has the last weight
  EXPECT_EQ(face.move().error, Error::skin);
  face.weights = {0, 0, 0};
  face.creature.moved_normals.pop_back();
  EXPECT_EQ(face.move().error, Error::skin);
}

/// No table that passes makes a sum wrap, or reads beyond another table: run under sanitizers.
TEST(Morphs, AnyTargetsThatPassAreMovedOrRefused) {
  Random random(17);
  int passed = 0, moved = 0;
  for (int i = 0; i < 3000; ++i) {
    Face face;
    face.creature = creature(random, 1);
    connect(face.creature);
    const auto word = [&] {
      const double any = random.within(0, 1);
      return static_cast<std::uint16_t>(any < 0.02 ? random.below(65536) : random.below(any < 0.6 ? 4 : 120));
    };
    face.tables.resize(1 + random.below(2));
    for (Tables& tables : face.tables) {
      tables.runs.resize(random.below(4));
      std::size_t at = 0;
      for (MorphRun& run : tables.runs) {
        run = {static_cast<std::uint16_t>(at + word()), word(), word()};
        at = run.first_vertex + std::size_t{run.count};
      }
      tables.positions.resize(random.below(400));
      for (MorphOffset& offset : tables.positions) {
        const auto any = [&] { return static_cast<std::int16_t>(random.within(-32768, 32767)); };
        offset = {any(), any(), any()};
      }
      tables.normals.assign(random.below(3) == 0 ? 0 : tables.positions.size() + (random.below(9) == 0 ? 1 : 0),
                            {-128, 127, 1});
      face.targets.push_back({.weight = static_cast<std::uint16_t>(random.below(3)),
                              .runs = tables.runs,
                              .positions = tables.positions,
                              .normals = tables.normals});
    }
    face.weights.resize(2);
    for (MorphWeight& weight : face.weights) weight = static_cast<MorphWeight>(random.within(-32768, 32767));
    face.morph = {&face.creature.mesh, face.targets};
    if (!validate(face.morph)) continue;
    ++passed;
    if (face.move()) ++moved;
  }
  EXPECT_GT(passed, 300);
  EXPECT_GT(moved, 30);
}

TEST(Morphs, WeightsAreLinearBetweenTheirKeys) {
  const WeightKey keys[] = {{100, 0}, {300, 4096}, {301, -4096}, {900, -32768}, {1000, 32767}, {5, 1000}};
  const Track tracks[] = {{.instance = 1, .count = 5, .first = 0}, {.instance = 0, .count = 1, .first = 5}};
  const WeightAnimation animation{.tracks = tracks, .keys = keys, .duration = 1200};
  ASSERT_TRUE(validate(animation, 2));
  std::array<MorphWeight, 2> weights{};
  for (std::uint32_t time = 0; time < 3000; ++time) {
    pose(animation, time, weights);
    EXPECT_EQ(weights[0], 1000);
    const auto at = static_cast<std::int64_t>(time % 1200);
    double wanted = at < 100 ? 0 : 32767;
    for (std::size_t k = 0; k + 1 < 5; ++k) {
      const std::int64_t from = keys[k].time, to = keys[k + 1].time;
      if (at < from || at >= to) continue;
      const auto share = static_cast<double>(at - from) / static_cast<double>(to - from);
      wanted = keys[k].weight + (keys[k + 1].weight - keys[k].weight) * share;
    }
    ASSERT_NEAR(weights[1], wanted, 2) << time;
  }
  EXPECT_EQ(validate(animation, 1).error, Error::animation);
  const auto refused = [&](Track track, std::uint32_t duration) {
    return validate(WeightAnimation{.tracks = {&track, 1}, .keys = keys, .duration = duration}, 1).error ==
           Error::animation;
  };
  EXPECT_TRUE(refused({.instance = 0, .count = 1, .first = 0}, 0));
  EXPECT_TRUE(refused({.instance = 0, .count = 0, .first = 0}, 1));
  EXPECT_TRUE(refused({.instance = 0, .count = 7, .first = 0}, 1));
  EXPECT_TRUE(refused({.instance = 0, .count = 1, .first = 6}, 1));
  EXPECT_TRUE(refused({.instance = 0, .count = 1, .first = 0xFFFFFFFF}, 1));
  EXPECT_TRUE(refused({.instance = 0, .count = 2, .first = 4}, 1)) << "times that do not grow";
}

}  // namespace
}  // namespace zstrip::test
