// Scene blobs: what the bake command writes of any scene opens exactly if the scene is valid, and draws the same; any
// other bytes and sections, even under a right checksum, are refused or are a scene that can be drawn.
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <memory>
#include <vector>

#include "bake/scene_blob.hpp"
#include "characters_input.hpp"
#include "edges_input.hpp"
#include "input.hpp"
#include "overlay_input.hpp"
#include "picture.hpp"
#include "require.hpp"
#include "scene_input.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/scene/validate.hpp"
#include "zstrip/visibility/bsp_order.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace {

using namespace zstrip;
using Bytes = std::vector<std::uint8_t>;

/// On the heap and of exactly this size: AddressSanitizer guards both ends.
struct Exact {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t size;

  explicit Exact(std::size_t s) : bytes(new std::byte[s]()), size(s) {}
  std::span<std::byte> span() { return {bytes.get(), size}; }
};

/// A blob in memory of its own, with as much memory lent as it asks for.
struct Opened {
  Exact blob, memory{0};
  SceneBlob content;
  Status status;

  explicit Opened(const Bytes& bytes) : blob(bytes.size()) {
    if (!bytes.empty()) std::memcpy(blob.bytes.get(), bytes.data(), bytes.size());
    status = open_scene_blob(blob.span(), memory.span(), content);
    if (status.error != Error::blob_memory) return;
    memory = Exact(status.needed - 1);
    fuzz::require(open_scene_blob(blob.span(), memory.span(), content).error == Error::blob_memory,
                  "a byte less than what is needed is too little");
    memory = Exact(status.needed);
    status = open_scene_blob(blob.span(), memory.span(), content);
    fuzz::require(status.error != Error::blob_memory, "what is asked for is enough");
  }
};

/// Makes size and checksum right.
void mend(Bytes& bytes) {
  if (bytes.size() < 12) return;
  const auto put = [&bytes](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
  };
  put(4, static_cast<std::uint32_t>(bytes.size()));
  put(8, static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), bytes.data() + 12, bytes.size() - 12)));
}

/// A section taken out of a blob.
struct Piece {
  std::uint32_t tag;  ///< as it stands
  Bytes content;
};

std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[at + i]} << 8 * i;
  return value;
}
void put_word(Bytes& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Of a blob that was written.
std::vector<Piece> pieces_of(const Bytes& bytes) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0, at = 16; i < word(bytes, 12); ++i, at += 12) {
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(word(bytes, at + 4));
    pieces.push_back({word(bytes, at), {first, first + static_cast<std::ptrdiff_t>(word(bytes, at + 8))}});
  }
  return pieces;
}

/// A blob whose table is right for these pieces, in this order.
Bytes blob_of(const std::vector<Piece>& pieces) {
  Bytes bytes{'z', 's', kSceneBlobVersion, 's'};
  bytes.resize(12);
  put_word(bytes, static_cast<std::uint32_t>(pieces.size()));
  std::size_t at = 16 + 12 * pieces.size();
  for (const Piece& piece : pieces) {
    put_word(bytes, piece.tag);
    put_word(bytes, static_cast<std::uint32_t>(at));
    put_word(bytes, static_cast<std::uint32_t>(piece.content.size()));
    at += (piece.content.size() + 3) / 4 * 4;
  }
  for (const Piece& piece : pieces) {
    bytes.insert(bytes.end(), piece.content.begin(), piece.content.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
  }
  mend(bytes);
  return bytes;
}

/// Takes sections away, adds some, makes them longer or shorter, gives them other tags.
Bytes edited(const Bytes& whole, fuzz::Input& input) {
  const std::uint32_t edits = input.below(4);
  if (edits == 0) return whole;
  std::vector<Piece> pieces = pieces_of(whole);
  for (std::uint32_t i = 0; i < edits; ++i) {
    const auto place = pieces.begin() + input.below(static_cast<std::uint32_t>(pieces.size()));
    switch (pieces.empty() ? 2 : input.below(6)) {
      case 0: pieces.erase(place); break;
      case 1: pieces.insert(place, Piece(*place)); break;
      case 2: pieces.insert(place, {input.any<std::uint32_t>(), Bytes(input.below(300))}); break;
      case 3: place->content.resize(input.below(static_cast<std::uint32_t>(2 * place->content.size() + 2))); break;
      case 4: place->tag = input.any<std::uint32_t>(); break;
      default: std::iter_swap(place, pieces.begin() + input.below(static_cast<std::uint32_t>(pieces.size()))); break;
    }
  }
  return blob_of(pieces);
}

bool valid_values(const fuzz::SceneInput& input, const Scene& scene) {
  const View& view = input.view();
  const auto known_test = [](const Material& material) { return material.depth_test <= DepthTest::always; };
  return std::ranges::all_of(scene.materials, known_test) && view.width >= 1 && view.width <= kMaxViewSize &&
         view.height >= 1 && view.height <= kMaxViewSize && view.format <= kLastPixelFormat &&
         input.camera().projection <= Projection::orthographic;
}

/// A tree over the triangles of the scene's only instance; none where there are more instances, or indices are wrong.
std::vector<BspNode> tree_over(const Scene& scene, fuzz::Input& input) {
  if (scene.instances.size() != 1 || scene.instances[0].mesh >= scene.meshes.size()) return {};
  const auto triangles = static_cast<std::uint32_t>(scene.meshes[scene.instances[0].mesh].triangles.size());
  std::vector<BspNode> nodes;
  for (std::uint32_t i = input.below(6); i > 0; --i) {
    BspNode node{};
    for (std::int32_t* value : {&node.x, &node.y, &node.z, &node.distance}) *value = input.any<std::int32_t>();
    const auto index = static_cast<std::uint32_t>(nodes.size());
    if (index != 0) {
      node.parent = input.below(index);
      while (nodes[node.parent].front != 0 && nodes[node.parent].back != 0) node.parent = (node.parent + 1) % index;
      BspNode& parent = nodes[node.parent];
      (parent.front == 0 ? parent.front : parent.back) = index;
      const std::uint32_t from = nodes.back().first_triangle;
      node.first_triangle = from + input.below(triangles - from + 1);
    }
    nodes.push_back(node);
  }
  return nodes;
}

/// Sets of lines between vertices of the scene's meshes, some of them between vertices that are not there.
struct LinesInput {
  std::vector<std::vector<Segment>> segments;
  std::vector<LineSet> sets;

  LinesInput(const Scene& scene, fuzz::Input& input) {
    for (std::uint32_t i = input.below(3); i > 0; --i) {
      LineSet set{.segments = {},
                  .mesh = static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(scene.meshes.size()) + 1)),
                  .material = static_cast<std::uint16_t>(input.below(2)),
                  .width = static_cast<std::uint8_t>(input.below(70))};
      for (auto& row : set.transform.m) row[3] = static_cast<std::int16_t>(input.any<std::uint16_t>());
      const std::size_t vertices = set.mesh < scene.meshes.size() ? scene.meshes[set.mesh].positions.size() : 0;
      const auto vertex = [&] {
        return static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(vertices) + 1));
      };
      segments.emplace_back();
      for (std::uint32_t n = input.below(5); n > 0; --n) segments.back().push_back({vertex(), vertex()});
      sets.push_back(set);
    }
    for (std::size_t i = 0; i < sets.size(); ++i) sets[i].segments = segments[i];
  }
};

/// Every triangle once, for any eye.
void judge_tree(const SceneBlob& content) {
  if (content.tree.nodes.empty()) return;
  const std::size_t triangles = content.scene.meshes[content.scene.instances[0].mesh].triangles.size();
  std::vector<int> visits(triangles, 0);
  const detail::BspEye eye{1000, -70000, 65536, content.camera.projection == Projection::orthographic};
  const bool whole = detail::for_each_bsp_run(content.tree, eye, triangles, [&](std::uint32_t first, std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) ++visits[first + i];
    return true;
  });
  fuzz::require(whole, "a tree that opens is walked to its end");
  fuzz::require(std::ranges::count(visits, 1) == static_cast<std::ptrdiff_t>(triangles), "each triangle once");
}

/// Each skin as skin_mesh moves it, in memory of exactly its size; a mesh that leaves its box keeps its shape.
struct MovedMeshes {
  struct Moved {
    std::vector<Position> positions;
    std::vector<Normal> normals;
    std::vector<Meshlet> meshlets;
  };
  std::vector<Mesh> meshes;
  std::vector<Moved> moved;
  bool all = true;  ///< no mesh leaves its box

  MovedMeshes(const SceneBlob& content, std::span<const JointPose> joints)
      : meshes(content.scene.meshes.begin(), content.scene.meshes.end()), moved(content.skins.size()) {
    std::vector<Transform> work(joints.size());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Mesh& bind = *content.skins[i].mesh;
      moved[i].positions.resize(bind.positions.size());
      moved[i].normals.resize(bind.normals.size());
      moved[i].meshlets.resize(bind.meshlets.size());
      const MovedVertices vertices{moved[i].positions, moved[i].normals, moved[i].meshlets};
      all = skin_mesh(content.skins[i], joints, work, vertices) && all;
      Mesh& mesh = meshes[static_cast<std::size_t>(&bind - content.scene.meshes.data())];
      mesh = moved_mesh(bind, vertices);
      mesh.skinning = nullptr;
    }
  }
};

/// What the clips pose during a fade is drawn as skin_mesh moves it, or the pose is refused; nobody is harmed.
void judge_skins(const SceneBlob& content) {
  std::vector<Instance> instances(content.scene.instances.size());
  PlayedClips played;
  if (content.clips.size() > 1) played.play(1, 1000);
  for (const std::uint32_t passed : {0U, 130U, 700U}) {
    if (!content.clips.empty()) {
      played.advance(passed, content.clips);
      pose_clips(content.clips, played.all(), content.scene.instances, instances);
    }
    const Status morphed = pose_clips(content.clips, played.all(), content.morphs);
    fuzz::require(morphed || morphed.error == Error::skin, "morph targets are refused as a skin");
    const Status posed = pose_clips(content.clips, played.all(), content.moved);
    fuzz::require(posed || posed.error == Error::skin, "a pose is refused as a skin");
    if (content.skins.empty()) continue;
    const MovedMeshes moved(content, content.moved.pose);
    if (posed && moved.all) {
      constexpr View kView{40, 30, PixelFormat::rgb565};
      Scene before = content.scene;
      before.meshes = moved.meshes;
      const fuzz::Picture expected =
          fuzz::draw(before, content.camera, kView, {.effects = effects_of(before, content.camera), .budget = {}});
      const fuzz::Picture got = fuzz::draw(content.scene, content.camera, kView,
                                           {.effects = effects_of(content.scene, content.camera), .budget = {}});
      if (expected.status && got.status) fuzz::require(expected.pixels == got.pixels, "the pixels of moved meshes");
    }
  }
}

/// The pixels are those of the meshes as they were modelled, because nothing has posed them.
void judge_written(const fuzz::SceneInput& input, const Scene& scene, const fuzz::CharactersInput& characters,
                   const Opened& opened) {
  const bool valid = valid_values(input, scene) && validate(scene) && usable(input.camera()) && characters.valid(scene);
  fuzz::require(static_cast<bool>(opened.status) == valid, "a blob opens if its scene is valid: %s",
                message(opened.status.error));
  if (!valid) return;
  judge_tree(opened.content);
  const Effects effects = effects_of(scene, input.camera());
  // Without images and fonts an overlay has no section, and draws nothing.
  const bool is_empty = scene.overlay != nullptr && scene.overlay->images.empty() && scene.overlay->fonts.empty();
  const Effects read = effects_of(opened.content.scene, opened.content.camera);
  fuzz::require((is_empty ? without(effects, effect::overlay) : effects) == without(read, effect::skins),
                "the same effects");
  for (const Skin& skin : opened.content.skins) fuzz::require(skin.mesh->skinning != nullptr, "a mesh has its skin");
  fuzz::require(opened.content.skins.size() == characters.skins().size(), "as many skins");
  fuzz::require(opened.content.morphs.meshes.size() == characters.morphs().size(), "as many meshes that morph");
  const fuzz::Picture expected = fuzz::draw(scene, input.camera(), input.view(), {.effects = effects, .budget = {}});
  const fuzz::Picture got =
      fuzz::draw(opened.content.scene, opened.content.camera, opened.content.view, {.effects = read, .budget = {}});
  fuzz::require(expected.status == got.status, "the same status");
  fuzz::require(expected.pixels == got.pixels, "the same pixels");
}

/// A frame of what moves can be drawn, or is refused; where nothing is too far away for it, as in any program.
void judge_turn(const SceneBlob& content) {
  fuzz::require(content.turn.still_instances <= content.scene.instances.size(), "what stands still is there");
  const Camera& camera = content.camera_for(2);
  fuzz::require(static_cast<bool>(usable(camera)), "a camera for several frames is usable");
  const scenes::AtRest at_rest{content.scene, camera, content.animation, content.turn};
  if (!scenes::can_turn(at_rest)) return;
  std::vector<Instance> instances(content.scene.instances.size());
  std::vector<LineSet> lines(content.scene.lines.size());
  const scenes::BakedFrame frame = scenes::stage(at_rest, 1, 3, {.instances = instances, .lines = lines});
  constexpr View kView{40, 30, PixelFormat::rgb565};
  (void)fuzz::draw(frame.scene, frame.camera, kView, {.effects = effects_of(frame.scene, frame.camera), .budget = {}});
}

/// What is read is what was written.
void judge_motion(const SceneBlob& written, const SceneBlob& read) {
  fuzz::require(read.turn == written.turn, "the same turn");
  fuzz::require(read.effects == written.effects, "the same effects of the picture");
  fuzz::require((read.turning_camera == nullptr) == (written.turning_camera == nullptr), "another camera or none");
  fuzz::require(read.camera_for(2).eye == written.camera_for(2).eye, "the same camera for several frames");
  judge_turn(read);
}

void judge_any(const Bytes& bytes) {
  const Opened opened(bytes);
  if (!opened.status) {
    fuzz::require(opened.content.scene.meshes.empty(), "a failure changes nothing");
    return;
  }
  fuzz::require(static_cast<bool>(validate(opened.content.scene)), "what opens is valid");
  judge_tree(opened.content);
  constexpr View kView{40, 30, PixelFormat::rgb565};
  (void)fuzz::draw(opened.content.scene, opened.content.camera, kView,
                   {.effects = effects_of(opened.content.scene, opened.content.camera), .budget = {}});
  judge_turn(opened.content);
  judge_skins(opened.content);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const std::uint32_t kind = input.below(4);
  if (kind == 3) {
    Bytes bytes(data + 1, data + size);
    bytes.resize(bytes.size() / kSceneBlobAlignment * kSceneBlobAlignment);  // all others are refused at once
    if (bytes.size() > 4) bytes[0] = 'z', bytes[1] = 's', bytes[2] = kSceneBlobVersion, bytes[3] = 's';
    mend(bytes);
    judge_any(bytes);
    return 0;
  }
  struct Patch {
    std::uint32_t at, value;
  };
  std::vector<Patch> patches;
  if (kind != 0) {
    for (std::uint32_t count = 1 + input.below(4); count > 0; --count) {
      patches.push_back({input.any<std::uint16_t>(), static_cast<std::uint32_t>(input.number(0))});
    }
  }
  const fuzz::SceneInput scene(input);
  const std::vector<BspNode> nodes = tree_over(scene.scene(), input);
  const LinesInput lines(scene.scene(), input);
  Scene content = scene.scene();
  content.lines = lines.sets;
  const Turn turn{static_cast<Turning>(input.below(4)),
                  static_cast<std::uint16_t>(input.below(static_cast<std::uint32_t>(content.instances.size()) + 1))};
  Camera turning_camera = scene.camera();
  turning_camera.eye.x = input.any<std::int32_t>();
  const std::uint32_t turns_another_camera = input.below(2);
  const Effects picture_effects = kPictureEffects[input.below(std::size(kPictureEffects))];
  // Last, so that older inputs keep their meaning.
  const fuzz::EdgesInput edges(scene.scene(), input);
  content.edges = edges.sets;
  const fuzz::OverlayInput overlay(input);
  content.overlay = overlay.overlay();
  const fuzz::CharactersInput characters(scene.scene(), input);
  content.meshes = characters.meshes();
  const SceneBlob whole{.scene = content,
                        .camera = scene.camera(),
                        .view = scene.view(),
                        .tree = {nodes},
                        .turn = turn,
                        .turning_camera = turns_another_camera == 1 ? &turning_camera : nullptr,
                        .effects = picture_effects,
                        .clips = characters.clips(),
                        .skins = characters.skins(),
                        .morphs = {characters.morphs(), {}}};
  const auto written = sim::to_scene_blob(whole);
  fuzz::require(static_cast<bool>(written), "any scene can be written");
  if (kind == 0) {
    const Opened opened(*written);
    judge_written(scene, content, characters, opened);
    if (!opened.status) return 0;
    if (characters.clips().empty()) judge_motion(whole, opened.content);
    judge_skins(opened.content);
    return 0;
  }
  Bytes bytes = edited(*written, input);
  for (const Patch& patch : patches) {
    const std::size_t bytes_of_value = kind;  // 1 or 2
    for (std::size_t i = 0; i < bytes_of_value; ++i) {
      bytes[(patch.at + i) % bytes.size()] = static_cast<std::uint8_t>(patch.value >> 8 * i);
    }
  }
  mend(bytes);
  judge_any(bytes);
  return 0;
}
