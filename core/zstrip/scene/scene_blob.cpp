// Opens a blob: every count, offset and value is checked before anything looks through it.
#include "zstrip/scene/scene_blob.hpp"

#include <bit>
#include <cstring>
#include <iterator>
#include <new>

#include "zstrip/base/crc32.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip {
namespace {

// Records of the blob that are the program's own structures, byte for byte.
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
static_assert(sizeof(void*) != 4 || (sizeof(Mesh) == 76 && sizeof(Texture) == 12 && sizeof(LineSet) == 64 &&
                                     sizeof(EdgeSet) == 12 && sizeof(Scene) == 112));
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
static_assert(sizeof(DirectionalLight) == 10 && offsetof(DirectionalLight, colour) == 6);

// Where the header has what; docs/formats.md.
constexpr std::uint32_t kVersion = 2, kKind = 3, kSize = 4, kChecksum = 8, kChecked = 12;
constexpr std::uint32_t kMeshes = 12, kMaterials = 20, kTextures = 28, kInstances = 36, kLights = 44;
constexpr std::uint32_t kAmbient = 52, kBackground = 56, kCamera = 60, kOutlines = 122, kLines = 123, kView = 124;
constexpr std::uint32_t kShadowCsgOrEdges = 131;
constexpr std::uint32_t kTracks = 132, kKeyframes = 140, kDuration = 148;
// In place of the duration where there are no tracks.
constexpr std::uint32_t kStillInstances = 148, kTurning = 150, kHasTurn = 151;
constexpr std::uint32_t kFinishes = 152, kPunctualLights = 160, kFog = 168, kQuadrics = 176;
constexpr std::uint32_t kTree = 184;
constexpr std::uint32_t kHeaderBytes = 192;

/// Records that become structures with pointers.
struct MeshRecord {
  static constexpr std::uint32_t kPositions = 0, kNormals = 8, kColours = 16, kTexcoords = 24, kTriangles = 32,
                                 kMeshlets = 40, kCentre = 48, kHalfExtent = 60, kTexcoordBits = 72, kBillboard = 73,
                                 kOutline = 74, kShadowRole = 75;
  std::uint32_t words[19];
};
struct TextureRecord {
  static constexpr std::uint32_t kTexels = 0, kLog2Width = 8, kLog2Height = 9, kFormat = 10, kSmallerLevels = 11;
  std::uint32_t words[3];
};
struct LineSetRecord {
  static constexpr std::uint32_t kSegments = 0, kMesh = 8, kMaterial = 10, kTransform = 12, kWidth = 60;
  std::uint32_t words[16];
};

struct EdgeSetRecord {
  static constexpr std::uint32_t kEdges = 0, kMesh = 8;
  std::uint32_t words[3];
};

/// Reads values and arrays; remembers the first that is wrong.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> blob) : blob_(blob) {}

  std::uint8_t byte(std::uint32_t at) const { return std::to_integer<std::uint8_t>(blob_[at]); }
  std::uint16_t half_word(std::uint32_t at) const { return static_cast<std::uint16_t>(byte(at) | byte(at + 1) << 8); }
  std::uint32_t word(std::uint32_t at) const {
    return half_word(at) | static_cast<std::uint32_t>(half_word(at + 2)) << 16;
  }
  Vec3 vector(std::uint32_t at) const {
    const auto component = [&](std::uint32_t offset) { return static_cast<std::int32_t>(word(at + offset)); };
    return {component(0), component(4), component(8)};
  }
  Colour colour(std::uint32_t at) const { return {byte(at), byte(at + 1), byte(at + 2), byte(at + 3)}; }

  void require(bool holds, std::uint32_t at) {
    if (!holds && !wrong_) wrong_ = true, wrong_at_ = at;
  }
  /// 0 or 1.
  bool flag(std::uint32_t at) {
    require(byte(at) <= 1, at);
    return byte(at) == 1;
  }
  /// The array whose offset and count stand at `at`; empty if they are wrong.
  template <class Record>
  std::span<const Record> array(std::uint32_t at) {
    const std::uint32_t offset = word(at), count = word(at + 4);
    const auto size = static_cast<std::uint32_t>(blob_.size());
    if (count == 0) {
      require(offset == 0, at);
      return {};
    }
    const bool inside = offset % kSceneBlobAlignment == 0 && offset >= kHeaderBytes && offset <= size &&
                        count <= (size - offset) / sizeof(Record);
    require(inside, at);
    if (!inside) return {};
    return {reinterpret_cast<const Record*>(blob_.data() + offset), count};
  }
  /// The next of the arrays that stand behind the header, of `count` records, which stands at `at`.
  template <class Record>
  std::span<const Record> next_behind_header(std::uint32_t count, std::uint32_t at) {
    static_assert(sizeof(Record) % kSceneBlobAlignment == 0);
    const bool inside = count <= (blob_.size() - behind_header_) / sizeof(Record);
    require(inside, at);
    if (count == 0 || !inside) return {};
    const auto* const first = reinterpret_cast<const Record*>(blob_.data() + behind_header_);
    behind_header_ += count * sizeof(Record);
    return {first, count};
  }
  template <class Record>
  std::uint32_t offset_of(const Record& record) const {
    return static_cast<std::uint32_t>(reinterpret_cast<const std::byte*>(&record) - blob_.data());
  }

  Status status() const { return wrong_ ? Status{.error = Error::blob_damaged, .needed = wrong_at_} : Status{}; }

 private:
  std::span<const std::byte> blob_;
  std::size_t behind_header_ = kHeaderBytes;
  bool wrong_ = false;
  std::uint32_t wrong_at_ = 0;
};

/// Everything that tells whether these bytes are a whole blob of this version.
Status check_envelope(std::span<const std::byte> blob) {
  if (reinterpret_cast<std::uintptr_t>(blob.data()) % kSceneBlobAlignment != 0) return {.error = Error::blob_alignment};
  const auto damaged = [](std::size_t at) {
    return Status{.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(at)};
  };
  constexpr char kMagic[] = {'z', 's'};
  for (std::size_t i = 0; i < sizeof kMagic; ++i) {
    if (i >= blob.size() || std::to_integer<char>(blob[i]) != kMagic[i]) return damaged(i);
  }
  if (blob.size() <= kKind) return damaged(blob.size());
  const Reader reader(blob);
  if (reader.byte(kKind) != 's') return damaged(kKind);
  if (reader.byte(kVersion) < kOldestSceneBlobVersion || reader.byte(kVersion) > kSceneBlobVersion) {
    return {.error = Error::blob_version, .needed = reader.byte(kVersion), .available = kSceneBlobVersion};
  }
  if (blob.size() < kHeaderBytes) return damaged(blob.size());
  if (reader.word(kSize) > blob.size()) return damaged(blob.size());
  if (reader.word(kSize) < blob.size()) return damaged(kSize);
  if (reader.word(kChecksum) != crc32(blob.subspan(kChecked))) return damaged(kChecksum);
  return {};
}

void read_camera(Reader& reader, Camera& camera) {
  camera.right = reader.vector(kCamera);
  camera.up = reader.vector(kCamera + 12);
  camera.back = reader.vector(kCamera + 24);
  camera.eye = reader.vector(kCamera + 36);
  camera.focal = static_cast<Fixed>(reader.word(kCamera + 48));
  camera.near_plane = static_cast<Fixed>(reader.word(kCamera + 52));
  camera.far_plane = static_cast<Fixed>(reader.word(kCamera + 56));
  camera.projection = reader.flag(kCamera + 60) ? Projection::orthographic : Projection::perspective;
  camera.fixed_depth_range = reader.flag(kCamera + 61);
}

void read_view(Reader& reader, View& view) {
  const auto side = [&reader](std::uint32_t at) {
    const std::uint16_t value = reader.half_word(at);
    reader.require(value >= 1 && value <= kMaxViewSize, at);
    return value;
  };
  view.width = side(kView);
  view.height = side(kView + 2);
  const unsigned format = reader.byte(kView + 4) & 0xFU;
  reader.require(format <= static_cast<std::uint8_t>(kLastPixelFormat), kView + 4);
  view.format = static_cast<PixelFormat>(format);
  view.dither = reader.flag(kView + 5);
  if (const std::uint8_t samples = reader.byte(kView + 6); samples != 0) view.samples = samples;
  reader.require(valid_samples(view), kView + 6);
}

Effects read_effects(Reader& reader) {
  const std::uint32_t number = reader.byte(kView + 4) >> 4;
  const bool known = number < std::size(kPictureEffects);
  reader.require(known, kView + 4);
  return known ? kPictureEffects[number] : Effects{};
}

/// The turn of a scene without tracks, and the camera for it, the last of what stands behind the header. Blobs without
/// either may have a duration there, which means nothing.
void read_turn(Reader& reader, SceneBlob& found) {
  constexpr std::uint8_t kAlone = 0x80, kWithCamera = 0x81;
  const std::uint8_t has_turn = reader.byte(kHasTurn);
  if (!found.animation.tracks.empty() || has_turn < kAlone) return;
  reader.require(has_turn <= kWithCamera, kHasTurn);
  reader.require(reader.byte(kTurning) <= static_cast<std::uint8_t>(Turning::nothing), kTurning);
  reader.require(reader.half_word(kStillInstances) <= found.scene.instances.size(), kStillInstances);
  found.turn = {static_cast<Turning>(reader.byte(kTurning)), reader.half_word(kStillInstances)};
  found.animation.duration = 0;
  if (has_turn != kWithCamera) return;
  found.turning_camera = reader.next_behind_header<Camera>(1, kHasTurn).data();
  if (found.turning_camera == nullptr) return;
  const std::uint32_t at = reader.offset_of(*found.turning_camera);
  for (const std::size_t member : {offsetof(Camera, projection), offsetof(Camera, fixed_depth_range)}) {
    (void)reader.flag(at + static_cast<std::uint32_t>(member));
  }
}

/// A bool, a shading or a test of any other value must not even be read as one.
void check_materials(Reader& reader, std::span<const Material> materials) {
  for (const Material& material : materials) {
    const std::uint32_t at = reader.offset_of(material);
    for (const std::size_t member :
         {offsetof(Material, lit), offsetof(Material, double_sided), offsetof(Material, depth_write)}) {
      (void)reader.flag(at + static_cast<std::uint32_t>(member));
    }
    const std::uint32_t shading = at + static_cast<std::uint32_t>(offsetof(Material, smooth));
    reader.require(reader.byte(shading) <= Shading::pixel, shading);
    const std::uint32_t test = at + static_cast<std::uint32_t>(offsetof(Material, depth_test));
    reader.require(reader.byte(test) <= static_cast<std::uint8_t>(DepthTest::always), test);
  }
}

Mesh read_mesh(Reader& reader, std::uint32_t at) {
  const std::uint32_t billboard = at + MeshRecord::kBillboard;
  reader.require(reader.byte(billboard) <= static_cast<std::uint8_t>(Billboard::upright), billboard);
  const std::uint32_t shadow = at + MeshRecord::kShadowRole;
  reader.require(reader.byte(shadow) <= static_cast<std::uint8_t>(ShadowRole::none), shadow);
  return {.positions = reader.array<Position>(at + MeshRecord::kPositions),
          .normals = reader.array<Normal>(at + MeshRecord::kNormals),
          .colours = reader.array<Colour>(at + MeshRecord::kColours),
          .texcoords = reader.array<TexCoord>(at + MeshRecord::kTexcoords),
          .triangles = reader.array<Triangle>(at + MeshRecord::kTriangles),
          .meshlets = reader.array<Meshlet>(at + MeshRecord::kMeshlets),
          .centre = reader.vector(at + MeshRecord::kCentre),
          .half_extent = reader.vector(at + MeshRecord::kHalfExtent),
          .texcoord_bits = reader.byte(at + MeshRecord::kTexcoordBits),
          .billboard = static_cast<Billboard>(reader.byte(billboard)),
          .outline = reader.byte(at + MeshRecord::kOutline),
          .shadow = static_cast<ShadowRole>(reader.byte(shadow))};
}

Texture read_texture(Reader& reader, std::uint32_t at, TextureFormat last_format) {
  const std::uint32_t format = at + TextureRecord::kFormat;
  reader.require(reader.byte(format) <= static_cast<std::uint8_t>(last_format), format);
  return {.texels = reader.array<std::uint16_t>(at + TextureRecord::kTexels),
          .log2_width = reader.byte(at + TextureRecord::kLog2Width),
          .log2_height = reader.byte(at + TextureRecord::kLog2Height),
          .format = static_cast<TextureFormat>(reader.byte(format)),
          .smaller_levels = reader.byte(at + TextureRecord::kSmallerLevels)};
}

LineSet read_lines(Reader& reader, std::uint32_t at) {
  LineSet lines{.segments = reader.array<Segment>(at + LineSetRecord::kSegments),
                .mesh = reader.half_word(at + LineSetRecord::kMesh),
                .material = reader.half_word(at + LineSetRecord::kMaterial),
                .width = reader.byte(at + LineSetRecord::kWidth)};
  std::uint32_t value = at + LineSetRecord::kTransform;
  for (auto& row : lines.transform.m) {
    for (Fixed& number : row) number = static_cast<Fixed>(reader.word(value)), value += 4;
  }
  return lines;
}

EdgeSet read_edges(Reader& reader, std::uint32_t at) {
  return {.edges = reader.array<Edge>(at + EdgeSetRecord::kEdges), .mesh = reader.half_word(at + EdgeSetRecord::kMesh)};
}

/// Each node but the first is the child of one before it, which it names; triangles follow the nodes. `scene` is valid.
void check_tree(Reader& reader, std::span<const BspNode> nodes, const Scene& scene) {
  if (nodes.empty()) return;
  reader.require(scene.instances.size() == 1, kTree);
  if (!reader.status()) return;
  const std::size_t triangles = scene.meshes[scene.instances[0].mesh].triangles.size();
  std::uint32_t first_triangle = 0;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const BspNode& node = nodes[i];
    const auto require = [&](bool holds, std::size_t member) {
      reader.require(holds, reader.offset_of(node) + static_cast<std::uint32_t>(member));
    };
    const auto is_child = [&](std::uint32_t child) {
      return child == 0 || (child > i && child < nodes.size() && nodes[child].parent == i);
    };
    require(
        i == 0 ? node.first_triangle == 0 : node.first_triangle >= first_triangle && node.first_triangle <= triangles,
        offsetof(BspNode, first_triangle));
    first_triangle = node.first_triangle;
    require(is_child(node.front), offsetof(BspNode, front));
    require(is_child(node.back) && (node.back == 0 || node.back != node.front), offsetof(BspNode, back));
    const bool has_parent =
        i == 0 ? node.parent == 0 : node.parent < i && (nodes[node.parent].front == i || nodes[node.parent].back == i);
    require(has_parent, offsetof(BspNode, parent));
  }
}

}  // namespace

Status open_scene_blob(std::span<const std::byte> blob, std::span<std::byte> memory, SceneBlob& opened) {
  if (const Status status = check_envelope(blob); !status) return status;
  Reader reader(blob);
  SceneBlob found;
  const std::span meshes = reader.array<MeshRecord>(kMeshes);
  const std::span textures = reader.array<TextureRecord>(kTextures);
  found.scene.materials = reader.array<Material>(kMaterials);
  found.scene.instances = reader.array<Instance>(kInstances);
  found.scene.lights = reader.array<DirectionalLight>(kLights);
  found.scene.finishes = reader.array<Finish>(kFinishes);
  found.scene.punctual_lights = reader.array<PunctualLight>(kPunctualLights);
  const std::span fog = reader.array<Fog>(kFog);
  reader.require(fog.size() <= 1, kFog);
  if (!fog.empty()) found.scene.fog = fog.data();
  found.scene.ambient = reader.colour(kAmbient);
  found.scene.background = reader.colour(kBackground);
  read_camera(reader, found.camera);
  read_view(reader, found.view);
  found.effects = read_effects(reader);
  found.scene.quadrics = reader.array<Quadric>(kQuadrics);
  found.scene.outlines = reader.next_behind_header<Outline>(reader.byte(kOutlines), kOutlines);
  // No scene has two of them.
  const std::uint32_t shadow_csg_or_edges = reader.byte(kShadowCsgOrEdges);
  const bool has_edges = shadow_csg_or_edges > 1 + kMaxCsgOperands;
  found.scene.shadow = reader.next_behind_header<Shadow>(shadow_csg_or_edges == 1 ? 1 : 0, kShadowCsgOrEdges).data();
  const std::uint32_t operands = shadow_csg_or_edges > 1 && !has_edges ? shadow_csg_or_edges - 1 : 0;
  found.scene.csg = reader.next_behind_header<CsgOperand>(operands, kShadowCsgOrEdges);
  const std::span edges =
      reader.next_behind_header<EdgeSetRecord>(has_edges ? 256 - shadow_csg_or_edges : 0, kShadowCsgOrEdges);
  const std::span lines = reader.next_behind_header<LineSetRecord>(reader.byte(kLines), kLines);
  found.tree.nodes = reader.array<BspNode>(kTree);
  found.animation = {.tracks = reader.array<Track>(kTracks),
                     .keyframes = reader.array<Keyframe>(kKeyframes),
                     .duration = reader.word(kDuration)};
  read_turn(reader, found);
  check_materials(reader, found.scene.materials);
  if (const Status status = reader.status(); !status) return status;

  const std::size_t needed =
      scene_blob_memory(static_cast<std::uint32_t>(meshes.size()), static_cast<std::uint32_t>(textures.size()),
                        static_cast<std::uint32_t>(lines.size()), static_cast<std::uint32_t>(edges.size()));
  if (memory.size() < needed) {
    const auto saturated = [](std::size_t bytes) {
      return bytes < 0xFFFFFFFF ? static_cast<std::uint32_t>(bytes) : 0xFFFFFFFFU;
    };
    return {.error = Error::blob_memory, .needed = saturated(needed), .available = saturated(memory.size())};
  }
  if (reinterpret_cast<std::uintptr_t>(memory.data()) % kSceneBlobMemoryAlignment != 0) {
    return {.error = Error::blob_alignment};
  }
  auto* const mesh_table = reinterpret_cast<Mesh*>(memory.data());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    ::new (mesh_table + i) Mesh(read_mesh(reader, reader.offset_of(meshes[i])));
  }
  auto* const texture_table = reinterpret_cast<Texture*>(memory.data() + meshes.size() * sizeof(Mesh));
  const bool knows_palettes = reader.byte(kVersion) > kOldestSceneBlobVersion;
  const TextureFormat last_format = knows_palettes ? TextureFormat::palette4 : TextureFormat::rgb565_alpha;
  for (std::size_t i = 0; i < textures.size(); ++i) {
    ::new (texture_table + i) Texture(read_texture(reader, reader.offset_of(textures[i]), last_format));
  }
  auto* const lines_table = reinterpret_cast<LineSet*>(texture_table + textures.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ::new (lines_table + i) LineSet(read_lines(reader, reader.offset_of(lines[i])));
  }
  auto* const edges_table = reinterpret_cast<EdgeSet*>(lines_table + lines.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    ::new (edges_table + i) EdgeSet(read_edges(reader, reader.offset_of(edges[i])));
  }
  found.scene.edges = {edges_table, edges.size()};
  found.scene.lines = {lines_table, lines.size()};
  found.scene.meshes = {mesh_table, meshes.size()};
  found.scene.textures = {texture_table, textures.size()};
  if (const Status status = reader.status(); !status) return status;
  if (const Status status = validate(found.scene); !status) return status;
  const auto instances = static_cast<std::uint32_t>(found.scene.instances.size());
  if (const Status status = validate(found.animation, instances); !status) return status;
  if (!usable(found.camera) || !usable(found.camera_for(2))) return {.error = Error::camera};
  check_tree(reader, found.tree.nodes, found.scene);
  if (const Status status = reader.status(); !status) return status;
  opened = found;
  return {};
}

}  // namespace zstrip
