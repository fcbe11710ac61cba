// Opens a blob: every count, offset and value is checked before it is used.
#include "zstrip/blob.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <iterator>
#include <new>

#include "zstrip/base/crc32.hpp"
#include "zstrip/scene/blob_reader.hpp"
#include "zstrip/scene/blob_sections.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {
namespace {

// Some records of the blob are the program's own structures, byte for byte.
static_assert(std::endian::native == std::endian::little, "blobs are little endian and used in place");
static_assert(sizeof(Position) == 6 && sizeof(Normal) == 4 && sizeof(Colour) == 4 && sizeof(TexCoord) == 4);
static_assert(sizeof(Triangle) == 6 && sizeof(Segment) == 4 && sizeof(Edge) == 8);
static_assert(sizeof(Meshlet) == 20 && offsetof(Meshlet, first_vertex) == 4 && offsetof(Meshlet, vertex_count) == 6 &&
              offsetof(Meshlet, triangle_count) == 8 && offsetof(Meshlet, radius) == 10 &&
              offsetof(Meshlet, centre) == 12);
static_assert(sizeof(Material) == 24 && offsetof(Material, texture) == 4 && offsetof(Material, lit) == 6 &&
              offsetof(Material, smooth) == 7 && offsetof(Material, double_sided) == 8 &&
              offsetof(Material, depth_test) == 9 && offsetof(Material, depth_write) == 10 &&
              offsetof(Material, depth_bias) == 12 && offsetof(Material, depth_slope_bias) == 16 &&
              offsetof(Material, depth_bias_clamp) == 20);
static_assert(sizeof(bool) == 1 && sizeof(Shading) == 1);
static_assert(sizeof(Camera) == 64 && offsetof(Camera, up) == 12 && offsetof(Camera, back) == 24 &&
              offsetof(Camera, eye) == 36 && offsetof(Camera, focal) == 48 && offsetof(Camera, near_plane) == 52 &&
              offsetof(Camera, far_plane) == 56 && offsetof(Camera, projection) == 60 &&
              offsetof(Camera, fixed_depth_range) == 61);
static_assert(sizeof(Instance) == 52 && offsetof(Instance, material) == 2 && offsetof(Instance, transform) == 4);
static_assert(sizeof(void*) != 4 ||
              (sizeof(Mesh) == 80 && sizeof(Texture) == 12 && sizeof(LineSet) == 64 && sizeof(EdgeSet) == 12));
static_assert(sizeof(Track) == 8 && offsetof(Track, count) == 2 && offsetof(Track, first) == 4);
static_assert(sizeof(Keyframe) == 36 && offsetof(Keyframe, rotation) == 4 && offsetof(Keyframe, translation) == 12 &&
              offsetof(Keyframe, scale) == 24);
static_assert(sizeof(BspNode) == 32 && offsetof(BspNode, distance) == 12 && offsetof(BspNode, first_triangle) == 16 &&
              offsetof(BspNode, front) == 20 && offsetof(BspNode, back) == 24 && offsetof(BspNode, parent) == 28);
static_assert(offsetof(Material, finish) == 11);
static_assert(sizeof(Finish) == 12 && offsetof(Finish, specular) == 4 && offsetof(Finish, shininess) == 8 &&
              offsetof(Finish, alpha_mode) == 9 && offsetof(Finish, alpha_cutoff) == 10);
static_assert(sizeof(PunctualLight) == 40 && offsetof(PunctualLight, colour) == 1 &&
              offsetof(PunctualLight, position) == 8 && offsetof(PunctualLight, intensity) == 20 &&
              offsetof(PunctualLight, range) == 24 && offsetof(PunctualLight, x) == 28 &&
              offsetof(PunctualLight, cosine_inner) == 34 && offsetof(PunctualLight, cosine_outer) == 36);
static_assert(sizeof(Fog) == 20 && offsetof(Fog, mode) == 4 && offsetof(Fog, start) == 8 &&
              offsetof(Fog, density) == 16);
static_assert(sizeof(Quadric) == 52 && offsetof(Quadric, transform) == 4);
static_assert(sizeof(Outline) == 8 && offsetof(Outline, width) == 4 && offsetof(Outline, hull) == 6);
static_assert(sizeof(CsgOperand) == 4 && offsetof(CsgOperand, product) == 2 && offsetof(CsgOperand, use) == 3);
static_assert(sizeof(Shadow) == 12 && offsetof(Shadow, bias) == 2 && offsetof(Shadow, slope_bias) == 4 &&
              offsetof(Shadow, pool) == 8);
static_assert(sizeof(Glyph) == 16 && offsetof(Glyph, offset) == 4 && offsetof(Glyph, width) == 8 &&
              offsetof(Glyph, left) == 10 && offsetof(Glyph, top) == 12 && offsetof(Glyph, advance) == 14);
static_assert(sizeof(Sprite) == 10 && offsetof(Sprite, image) == 4 && offsetof(Sprite, colour) == 6);
static_assert(sizeof(Joint) == 52 && offsetof(Joint, parent) == 48 && sizeof(VertexJoints) == 8 &&
              offsetof(VertexJoints, weights) == 4);
static_assert(sizeof(JointPose) == 32 && offsetof(JointPose, translation) == 8 && offsetof(JointPose, scale) == 20);
static_assert(sizeof(void*) != 4 || (sizeof(Skin) == 28 && sizeof(Skinning) == 112 && sizeof(Clip) == 64));
static_assert(sizeof(MorphRun) == 6 && sizeof(MorphOffset) == 6 && sizeof(NormalOffset) == 3 &&
              sizeof(WeightKey) == 8 && offsetof(WeightKey, weight) == 4);
static_assert(sizeof(ClipEvent) == 8 && offsetof(ClipEvent, number) == 2 && offsetof(ClipEvent, time) == 4);
static_assert(sizeof(void*) != 4 || (sizeof(MovedMorph) == 40 && sizeof(MorphTarget) == 28));
static_assert(sizeof(DetailLevel) == 8 && offsetof(DetailLevel, coarser) == 2 && offsetof(DetailLevel, distance) == 4);
static_assert(sizeof(DirectionalLight) == 10 && offsetof(DirectionalLight, colour) == 6);

using blob_layout::Header;
using blob_layout::MeshRecord;
using blob_layout::Records;
using detail::BlobReader;

/// Checks that these bytes are a complete blob of this version.
Status check_envelope(std::span<const std::byte> blob) {
  if (reinterpret_cast<std::uintptr_t>(blob.data()) % kSceneBlobAlignment != 0) return {.error = Error::blob_alignment};
  const auto damaged = [](std::size_t at) {
    return Status{.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(at)};
  };
  constexpr char kMagic[] = {'z', 's'};
  for (std::size_t i = 0; i < sizeof kMagic; ++i) {
    if (i >= blob.size() || std::to_integer<char>(blob[i]) != kMagic[i]) return damaged(i);
  }
  if (blob.size() <= offsetof(Header, kind)) return damaged(blob.size());
  const Header& header = *reinterpret_cast<const Header*>(blob.data());
  if (header.kind != 's') return damaged(offsetof(Header, kind));
  if (header.version < kFirstSceneBlobVersion || header.version > kSceneBlobVersion) {
    return {.error = Error::blob_version, .needed = header.version, .available = kSceneBlobVersion};
  }
  if (blob.size() < sizeof(Header) || header.bytes > blob.size()) return damaged(blob.size());
  if (header.bytes < blob.size() || header.bytes % kSceneBlobAlignment != 0) return damaged(offsetof(Header, bytes));
  if (header.checksum != crc32(blob.subspan(blob_layout::kChecked))) return damaged(offsetof(Header, checksum));
  if (header.sections > (header.bytes - sizeof(Header)) / sizeof(blob_layout::Section))
    return damaged(offsetof(Header, sections));
  return {};
}

void check_camera(BlobReader& reader, const Camera& camera) {
  reader.require(camera.projection <= Projection::orthographic, &camera.projection);
  reader.flag(camera.fixed_depth_range);
}

void check_materials(BlobReader& reader, std::span<const Material> materials) {
  for (const Material& material : materials) {
    reader.flag(material.lit);
    reader.flag(material.double_sided);
    reader.flag(material.depth_write);
    reader.require(material.smooth <= Shading::pixel, &material.smooth);
    reader.require(material.depth_test <= DepthTest::always, &material.depth_test);
  }
}

void read_picture(BlobReader& reader, const blob_layout::PictureRecord& picture, SceneBlob& found) {
  for (const std::uint16_t* const side : {&picture.width, &picture.height}) {
    reader.require(*side >= 1 && *side <= kMaxViewSize, side);
  }
  reader.require(picture.format <= static_cast<std::uint8_t>(kLastPixelFormat), &picture.format);
  reader.require(picture.dither <= 1, &picture.dither);
  found.view = {.width = picture.width,
                .height = picture.height,
                .format = static_cast<PixelFormat>(picture.format),
                .dither = picture.dither == 1,
                .samples = picture.samples};
  reader.require(valid_samples(found.view), &picture.samples);
  if (blob_layout::is_gone(picture.effects)) reader.fail({.error = Error::blob_depth, .needed = picture.effects});
  const bool known = picture.effects < std::size(kPictureEffects);
  reader.require(known, &picture.effects);
  if (known) found.effects = kPictureEffects[picture.effects];
}

void read_turn(BlobReader& reader, const blob_layout::TurnRecord& turn, SceneBlob& found) {
  reader.require(turn.what <= static_cast<std::uint8_t>(Turning::nothing), &turn.what);
  reader.require(turn.still_instances <= found.scene.instances.size(), &turn.still_instances);
  found.turn = {static_cast<Turning>(turn.what), turn.still_instances};
}

Mesh read_mesh(BlobReader& reader, const MeshRecord& record, const Records& all) {
  reader.require(record.billboard <= static_cast<std::uint8_t>(Billboard::upright), &record.billboard);
  reader.require(record.shadow <= static_cast<std::uint8_t>(ShadowRole::none), &record.shadow);
  return {.positions = reader.some(all.positions, record.positions),
          .normals = reader.some(all.normals, record.normals),
          .colours = reader.some(all.colours, record.colours),
          .texcoords = reader.some(all.texcoords, record.texcoords),
          .triangles = reader.some(all.triangles, record.triangles),
          .meshlets = reader.some(all.meshlets, record.meshlets),
          .centre = record.centre,
          .half_extent = record.half_extent,
          .texcoord_bits = record.texcoord_bits,
          .billboard = static_cast<Billboard>(record.billboard),
          .outline = record.outline,
          .shadow = static_cast<ShadowRole>(record.shadow)};
}

Texture read_texture(BlobReader& reader, const blob_layout::TextureRecord& record, const Records& all) {
  reader.require(record.format <= static_cast<std::uint8_t>(TextureFormat::palette4), &record.format);
  return {.texels = reader.some(all.texels, record.texels),
          .log2_width = record.log2_width,
          .log2_height = record.log2_height,
          .format = static_cast<TextureFormat>(record.format),
          .smaller_levels = record.smaller_levels};
}

LineSet read_lines(BlobReader& reader, const blob_layout::LineRecord& record, const Records& all) {
  return {.segments = reader.some(all.segments, record.segments),
          .mesh = record.mesh,
          .material = record.material,
          .transform = record.transform,
          .width = record.width};
}

EdgeSet read_edges(BlobReader& reader, const blob_layout::EdgeRecord& record, const Records& all) {
  return {.edges = reader.some(all.edges, record.edges), .mesh = record.mesh};
}

OverlayImage read_image(BlobReader& reader, const blob_layout::ImageRecord& record, const Records& all) {
  return {.width = record.width,
          .height = record.height,
          .colours = reader.some(all.image_colours, record.colours),
          .coverage = reader.some(all.coverage, record.coverage),
          .coverage_bits = record.coverage_bits};
}

Font read_font(BlobReader& reader, const blob_layout::FontRecord& record, const Records& all) {
  return {.glyphs = reader.some(all.glyphs, record.glyphs),
          .coverage = reader.some(all.coverage, record.coverage),
          .coverage_bits = record.coverage_bits,
          .line_height = record.line_height,
          .baseline = record.baseline,
          .replacement = record.replacement};
}

Label read_label(BlobReader& reader, const blob_layout::LabelRecord& record, const Records& all) {
  return {.text = reader.some(all.text, record.text),
          .x = record.x,
          .y = record.y,
          .font = record.font,
          .alignment = static_cast<Alignment>(record.alignment),
          .colour = record.colour,
          .background = record.background};
}

/// Converts the records to a table in `memory`, and moves `memory` to the end of the table.
template <class Object, class Record>
std::span<const Object> read_table(std::byte*& memory, std::span<const Record> records, BlobReader& reader,
                                   const Records& all, Object (*read)(BlobReader&, const Record&, const Records&)) {
  auto* const table = reinterpret_cast<Object*>(memory);
  for (std::size_t i = 0; i < records.size(); ++i) ::new (table + i) Object(read(reader, records[i], all));
  memory += records.size() * sizeof(Object);
  return {table, records.size()};
}

const Overlay* read_overlay(BlobReader& reader, const Records& all, std::byte* memory) {
  // Sprites need images and labels need fonts; otherwise the blob is damaged.
  reader.require(all.sprites.empty() || !all.images.empty(), all.sprites.data());
  reader.require(all.labels.empty() || !all.fonts.empty(), all.labels.data());
  if (all.images.empty() && all.fonts.empty()) return nullptr;
  auto* const place = reinterpret_cast<Overlay*>(memory);
  memory += sizeof(Overlay);
  Overlay overlay;
  overlay.images = read_table<OverlayImage>(memory, all.images, reader, all, read_image);
  overlay.fonts = read_table<Font>(memory, all.fonts, reader, all, read_font);
  overlay.labels = read_table<Label>(memory, all.labels, reader, all, read_label);
  overlay.sprites = all.sprites;
  return ::new (place) Overlay(overlay);
}

/// Counts what skins, clips and morph targets need in the lent memory; the meshlets need not be valid.
CharacterCounts count_characters(BlobReader& reader, const Records& all) {
  CharacterCounts counts{.skins = static_cast<std::uint32_t>(all.skins.size()),
                         .joints = static_cast<std::uint32_t>(all.joints.size()),
                         .clips = static_cast<std::uint32_t>(all.clips.size()),
                         .morphs = static_cast<std::uint32_t>(all.morphs.size()),
                         .targets = static_cast<std::uint32_t>(all.morph_targets.size())};
  reader.require(all.joints.size() <= kMaxJoints && (all.joints.empty() || !all.skins.empty()), all.joints.data());
  reader.require(all.clips.size() <= 0x10000, all.clips.data());
  // A mesh has at most one skin, and one set of morph targets.
  const auto is_next = [&]<class Record>(std::span<const Record> records, std::size_t i) {
    const std::uint16_t& mesh = records[i].mesh;
    const bool holds = mesh < all.meshes.size() && (i == 0 || mesh > records[i - 1].mesh);
    reader.require(holds, &mesh);
    return holds;
  };
  for (std::size_t i = 0; i < all.morphs.size() && is_next(all.morphs, i); ++i) {
    const MeshRecord& mesh = all.meshes[all.morphs[i].mesh];
    counts.morphed_positions += reader.some(all.positions, mesh.positions).size();
    counts.morphed_normals += reader.some(all.normals, mesh.normals).size();
    counts.morphed_meshlets += reader.some(all.meshlets, mesh.meshlets).size();
  }
  for (const blob_layout::MorphTargetRecord& target : all.morph_targets) {
    counts.weights = std::max<std::uint32_t>(counts.weights, target.weight + 1U);
  }
  for (std::size_t i = 0; i < all.skins.size() && is_next(all.skins, i); ++i) {
    const MeshRecord& mesh = all.meshes[all.skins[i].mesh];
    std::uint32_t largest = mesh.meshlets.count == 0 ? mesh.positions.count : 0;
    for (const Meshlet& meshlet : reader.some(all.meshlets, mesh.meshlets)) {
      largest = std::max<std::uint32_t>(largest, meshlet.vertex_count);
    }
    counts.positions = std::max(counts.positions, largest);
    if (mesh.normals.count != 0) counts.normals = std::max(counts.normals, largest);
  }
  return counts;
}

/// The tables and the memory of meshes with morph targets, in the lent memory.
struct MorphMemory {
  std::span<MovedMorph> morphs;
  std::span<Mesh> bases;
  std::span<MorphTarget> targets;
  MovedVertices vertices;  ///< of all these meshes
};

/// Returns a copy of `from` in the first records of `free`, which loses them.
template <class Record>
std::span<Record> copied(std::span<const Record> from, std::span<Record>& free) {
  const std::span<Record> copy = free.first(from.size());
  std::copy(from.begin(), from.end(), copy.begin());
  free = free.subspan(from.size());
  return copy;
}

/// Reads morph targets, and lets the scene's meshes, which lie in RAM, have the vertices that they move.
Status read_morphs(BlobReader& reader, const Records& all, MorphMemory memory, SceneBlob& found) {
  found.morphs.meshes = memory.morphs;
  std::uint32_t first_target = 0, first_run = 0;
  for (std::size_t i = 0; i < memory.morphs.size(); ++i) {
    const blob_layout::MorphRecord& record = all.morphs[i];
    // Each mesh has targets of its own, and each target has runs of its own, so that each is checked once.
    reader.require(record.targets.first == first_target, &record.targets);
    first_target += record.targets.count;
    const std::span targets = reader.some(all.morph_targets, record.targets);
    for (const blob_layout::MorphTargetRecord& target : targets) {
      reader.require(target.runs.first == first_run, &target.runs);
      first_run += target.runs.count;
      memory.targets[static_cast<std::size_t>(&target - all.morph_targets.data())] = {
          .weight = target.weight,
          .runs = reader.some(all.morph_runs, target.runs),
          .positions = reader.some(all.morph_offsets, target.positions),
          .normals = reader.some(all.normal_offsets, target.normals)};
    }
    if (!reader.status()) return {};
    Mesh& mesh = const_cast<Mesh&>(found.scene.meshes[record.mesh]);
    memory.bases[i] = mesh;
    MovedMorph& morph = memory.morphs[i];
    morph = {
        .morph = {&memory.bases[i], memory.targets.subspan(record.targets.first, record.targets.count)},
        .vertices = {copied(mesh.positions, memory.vertices.positions), copied(mesh.normals, memory.vertices.normals),
                     copied(mesh.meshlets, memory.vertices.meshlets)},
        .mesh = record.mesh};
    if (const Status status = validate(morph.morph); !status) return status;
    mesh = moved_mesh(mesh, morph.vertices);
  }
  return {};
}

/// Reads skins, clips and morph targets into `memory`. The scene must be valid, and its meshes lie in RAM.
Status read_characters(BlobReader& reader, const Records& all, const CharacterCounts& counts, std::byte* memory,
                       SceneBlob& found) {
  // The objects are of types whose life begins with their memory; each is assigned before it is read.
  const auto take = [&memory]<class Object>(std::span<Object>& table, std::size_t count) {
    table = {reinterpret_cast<Object*>(memory), count};
    memory += table.size_bytes();
  };
  std::span<Skin> skins;
  std::span<Clip> clips;
  std::span<Transform> matrices;
  std::span<Position> positions;
  std::span<Normal> normals;
  MorphMemory morphs;
  take(skins, counts.skins);
  take(found.moved.skinnings, counts.skins);
  take(clips, counts.clips);
  take(morphs.morphs, counts.morphs);
  take(morphs.bases, counts.morphs);
  take(morphs.targets, counts.targets);
  take(matrices, std::size_t{counts.skins} * counts.joints);
  take(found.moved.pose, counts.joints);
  take(morphs.vertices.meshlets, static_cast<std::size_t>(counts.morphed_meshlets));
  take(morphs.vertices.positions, static_cast<std::size_t>(counts.morphed_positions));
  take(positions, counts.positions);
  take(found.morphs.weights, counts.weights);
  take(normals, counts.normals);
  take(morphs.vertices.normals, static_cast<std::size_t>(counts.morphed_normals));
  std::fill(found.morphs.weights.begin(), found.morphs.weights.end(), MorphWeight{0});
  if (const Status status = read_morphs(reader, all, morphs, found); !status) return status;
  if (!reader.status()) return {};
  found.skins = skins;
  found.clips = clips;
  const auto is_skin = [&found](std::uint32_t mesh) {
    return mesh < found.scene.meshes.size() && found.scene.meshes[mesh].skinning != nullptr;
  };
  const auto wrong = [](std::uint32_t mesh) { return Status{.error = Error::skin, .needed = mesh}; };
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const Mesh& mesh = found.scene.meshes[all.skins[i].mesh];
    skins[i] = {.mesh = &mesh,
                .vertices = reader.some(all.vertex_joints, all.skins[i].vertices),
                .joints = all.joints,
                .rest = all.joint_rest};
    if (!reader.status()) return {};
    if (const Status status = validate(skins[i]); !status) return status;
    Skinning& skinning = found.moved.skinnings[i];
    skinning = {.skin = &skins[i],
                .matrices = matrices.subspan(i * counts.joints, counts.joints),
                .positions = positions,
                .normals = mesh.normals.empty() ? std::span<Normal>() : normals};
    // The table of meshes lies in the lent memory.
    const_cast<Mesh&>(mesh).skinning = &skinning;
  }
  for (const LineSet& lines : found.scene.lines) {
    if (is_skin(lines.mesh)) return wrong(lines.mesh);
  }
  for (const EdgeSet& edges : found.scene.edges) {
    if (is_skin(edges.mesh)) return wrong(edges.mesh);
  }
  for (const CsgOperand& operand : found.scene.csg) {
    if (const std::uint16_t mesh = found.scene.instances[operand.instance].mesh; is_skin(mesh)) return wrong(mesh);
  }
  const std::span<const Track> tracks = found.animation.tracks;
  const std::span<const Keyframe> keyframes = found.animation.keyframes;
  reader.require(all.weight_ranges.empty() || all.weight_ranges.size() == clips.size(), all.weight_ranges.data());
  if (!reader.status()) return {};
  std::uint32_t first_track = 0, first_joint_track = 0, first_weight_track = 0;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const blob_layout::ClipRecord& record = all.clips[i];
    reader.require(record.duration != 0, &record.duration);
    // Each clip has tracks of its own, so that each track is checked once; tracks may share keys.
    reader.require(record.tracks.first == first_track, &record.tracks);
    reader.require(record.joint_tracks.first == first_joint_track, &record.joint_tracks);
    first_track += record.tracks.count;
    first_joint_track += record.joint_tracks.count;
    const std::span<const char> name = reader.some(all.clip_names, record.name);
    const bool ends = !name.empty() && name.back() == 0;
    reader.require(ends, &record.name);
    clips[i] = {.name = ends ? name.data() : "",
                .instances = {reader.some(tracks, record.tracks), keyframes, record.duration},
                .joints = {reader.some(all.joint_tracks, record.joint_tracks), all.joint_keyframes, record.duration}};
    if (!all.weight_ranges.empty()) {
      const blob_layout::Range& weights = all.weight_ranges[i];
      reader.require(weights.first == first_weight_track, &weights);
      first_weight_track += weights.count;
      clips[i].weights = {reader.some(all.weight_tracks, weights), all.weight_keys, record.duration};
    }
    if (!reader.status()) return {};
    const auto instances = static_cast<std::uint32_t>(found.scene.instances.size());
    if (const Status status = validate(clips[i].instances, instances); !status) return status;
    if (const Status status = validate(clips[i].joints, counts.joints); !status) return status;
    if (const Status status = validate(clips[i].weights, counts.weights); !status) return status;
  }
  if (clips.empty()) return {};
  found.animation = clips[0].instances;
  found.turn = {.what = Turning::nothing};
  return {};
}

/// Checks that clips and times of events exist and ascend.
void check_events(BlobReader& reader, const SceneBlob& found) {
  const ClipEvent* last = nullptr;
  for (const ClipEvent& event : found.events) {
    std::uint32_t duration = event.clip == 0 ? found.animation.duration : 0;
    if (!found.clips.empty()) duration = event.clip < found.clips.size() ? found.clips[event.clip].duration() : 0;
    reader.require(event.time < duration, &event.time);
    const bool ascends =
        last == nullptr || event.clip > last->clip || (event.clip == last->clip && event.time > last->time);
    reader.require(ascends, &event);
    last = &event;
  }
}

/// Checks the links of a tree: each node except the first is the child of an earlier node, and names it as its parent.
/// Triangles are in the order of the nodes. `scene` must be valid.
void check_tree(BlobReader& reader, std::span<const BspNode> nodes, const Scene& scene) {
  if (nodes.empty()) return;
  reader.require(scene.instances.size() == 1, nodes.data());
  if (!reader.status()) return;
  const std::size_t triangles = scene.meshes[scene.instances[0].mesh].triangles.size();
  std::uint32_t first_triangle = 0;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const BspNode& node = nodes[i];
    const auto is_child = [&](std::uint32_t child) {
      return child == 0 || (child > i && child < nodes.size() && nodes[child].parent == i);
    };
    reader.require(
        i == 0 ? node.first_triangle == 0 : node.first_triangle >= first_triangle && node.first_triangle <= triangles,
        &node.first_triangle);
    first_triangle = node.first_triangle;
    reader.require(is_child(node.front), &node.front);
    reader.require(is_child(node.back) && (node.back == 0 || node.back != node.front), &node.back);
    const bool has_parent =
        i == 0 ? node.parent == 0 : node.parent < i && (nodes[node.parent].front == i || nodes[node.parent].back == i);
    reader.require(has_parent, &node.parent);
  }
}

}  // namespace

Status open_scene_blob(std::span<const std::byte> blob, std::span<std::byte> memory, SceneBlob& opened) {
  if (const Status status = check_envelope(blob); !status) return status;
  BlobReader reader(blob);
  SceneBlob found;
  Records records;
  blob_layout::for_each_section(found, records, reader);
  reader.finish();
  // The sections that every blob must have are missing: nothing more can be checked.
  if (!reader.status()) return reader.status();
  check_camera(reader, *records.camera);
  if (found.turning_camera != nullptr) check_camera(reader, *found.turning_camera);
  check_materials(reader, found.scene.materials);
  read_picture(reader, *records.picture, found);
  if (records.turn != nullptr) read_turn(reader, *records.turn, found);
  if (!reader.status()) return reader.status();
  found.camera = *records.camera;
  found.scene.ambient = records.base->ambient;
  found.scene.background = records.base->background;
  if (records.animation != nullptr) found.animation.duration = records.animation->duration;

  const auto count = [](const auto& of) { return static_cast<std::uint32_t>(of.size()); };
  const CharacterCounts characters = count_characters(reader, records);
  reader.require(records.animation == nullptr || records.clips.empty(), records.animation);
  if (!reader.status()) return reader.status();
  const std::size_t tables =
      scene_blob_memory(count(records.meshes), count(records.textures), count(records.lines), count(records.edge_sets),
                        count(records.images), count(records.fonts), count(records.labels));
  const std::uint64_t needed = tables + character_memory(characters);
  const auto saturated = [](std::uint64_t bytes) {
    return bytes < 0xFFFFFFFF ? static_cast<std::uint32_t>(bytes) : 0xFFFFFFFFU;
  };
  if (memory.size() < needed) {
    return {.error = Error::blob_memory, .needed = saturated(needed), .available = saturated(memory.size())};
  }
  if (reinterpret_cast<std::uintptr_t>(memory.data()) % kSceneBlobMemoryAlignment != 0) {
    return {.error = Error::blob_alignment};
  }
  std::byte* place = memory.data();
  found.scene.meshes = read_table<Mesh>(place, records.meshes, reader, records, read_mesh);
  found.scene.textures = read_table<Texture>(place, records.textures, reader, records, read_texture);
  found.scene.lines = read_table<LineSet>(place, records.lines, reader, records, read_lines);
  found.scene.edges = read_table<EdgeSet>(place, records.edge_sets, reader, records, read_edges);
  found.scene.overlay = read_overlay(reader, records, place);
  if (!reader.status()) return reader.status();
  if (const Status status = validate(found.scene); !status) return status;
  const Status characters_read = read_characters(reader, records, characters, memory.data() + tables, found);
  if (!characters_read) return characters_read;
  if (!reader.status()) return reader.status();
  found.memory_bytes = saturated(needed);
  const auto instances = static_cast<std::uint32_t>(found.scene.instances.size());
  if (const Status status = validate(found.animation, instances); !status) return status;
  if (!usable(found.camera) || !usable(found.camera_for(2))) return {.error = Error::camera};
  check_tree(reader, found.tree.nodes, found.scene);
  check_events(reader, found);
  if (const Status levels = validate(found.levels, found.scene); !levels) {
    reader.require(false, &found.levels[levels.needed]);
  }
  if (!reader.status()) return reader.status();
  opened = found;
  return {};
}

}  // namespace zstrip
