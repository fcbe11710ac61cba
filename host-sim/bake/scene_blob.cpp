// Writes a scene as a blob: collects the records of its tables, and writes section after section.
#include "bake/scene_blob.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "bake/blob_writer.hpp"
#include "zstrip/scene/blob_sections.hpp"

namespace zstrip::sim {
namespace {

/// Writes the sections that blob_layout::for_each_section passes, and records the position of each.
class SectionWriter {
 public:
  template <class Record>
  void operator()(blob_layout::Tag tag, std::span<const Record> records) {
    if (records.empty()) return;
    const std::size_t first = content_.bytes().size();
    for (const Record& record : records) content_.put(record);
    table_.push_back({tag, first, content_.bytes().size() - first});
    content_.align();
  }
  template <class Record>
  void operator()(blob_layout::Tag tag, const Record* record) {
    if (record != nullptr) (*this)(tag, std::span(record, 1));
  }
  template <class Record>
  void needed(blob_layout::Tag tag, const Record* record) {
    (*this)(tag, record);
  }

  /// Returns the complete blob.
  Result<std::vector<std::uint8_t>> blob(std::uint8_t version) const {
    const std::size_t head = sizeof(blob_layout::Header) + table_.size() * sizeof(blob_layout::Section);
    const std::vector<std::uint8_t>& content = content_.bytes();
    if (head + content.size() > 0xFFFFFFFF) {
      return Failure{ExitStatus::input, "takes more than 4 GB; simplify the model"};
    }
    BlobWriter checked;
    checked.word(static_cast<std::uint32_t>(table_.size()));
    for (const Entry& entry : table_) {
      for (int shift = 24; shift >= 0; shift -= 8) checked.byte(entry.tag >> shift & 0xFF);
      checked.word(static_cast<std::uint32_t>(head + entry.first));
      checked.word(static_cast<std::uint32_t>(entry.bytes));
    }
    std::vector<std::uint8_t>& rest = checked.bytes();
    rest.insert(rest.end(), content.begin(), content.end());
    BlobWriter blob;
    for (const char letter : {'z', 's'}) blob.byte(static_cast<std::uint8_t>(letter));
    blob.byte(version);
    blob.byte('s');
    blob.word(static_cast<std::uint32_t>(blob_layout::kChecked + rest.size()));
    blob.word(static_cast<std::uint32_t>(crc32_z(crc32_z(0, nullptr, 0), rest.data(), rest.size())));
    blob.bytes().insert(blob.bytes().end(), rest.begin(), rest.end());
    return std::move(blob.bytes());
  }

 private:
  struct Entry {
    blob_layout::Tag tag;
    std::size_t first, bytes;
  };
  BlobWriter content_;
  std::vector<Entry> table_;
};

/// The records of one kind, array after array.
template <class Record>
class Pool {
 public:
  blob_layout::Range add(std::span<const Record> records) {
    if (records.empty()) return {0, 0};
    const auto [known, is_new] = arrays_.try_emplace({records.data(), records.size()}, records_.size());
    if (is_new) records_.insert(records_.end(), records.begin(), records.end());  // scaled meshes share arrays
    return {static_cast<std::uint32_t>(known->second), static_cast<std::uint32_t>(records.size())};
  }
  std::span<const Record> all() const { return records_; }

 private:
  std::vector<Record> records_;
  std::map<std::pair<const void*, std::size_t>, std::size_t> arrays_;  ///< start of each array that was added
};

/// The arrays that `records` refers to.
struct Pools {
  Pool<Position> positions;
  Pool<Normal> normals;
  Pool<Colour> colours;
  Pool<TexCoord> texcoords;
  Pool<Triangle> triangles;
  Pool<Meshlet> meshlets;
  Pool<std::uint16_t> texels;
  Pool<Segment> segments;
  Pool<Edge> edges;
  Pool<std::uint16_t> image_colours;
  Pool<std::uint8_t> coverage;
  Pool<Glyph> glyphs;
  Pool<char> text;
  std::vector<blob_layout::MeshRecord> meshes;
  std::vector<blob_layout::TextureRecord> textures;
  std::vector<blob_layout::LineRecord> lines;
  std::vector<blob_layout::EdgeRecord> edge_sets;
  std::vector<blob_layout::ImageRecord> images;
  std::vector<blob_layout::FontRecord> fonts;
  std::vector<blob_layout::LabelRecord> labels;
  std::span<const Sprite> sprites;

  explicit Pools(const Scene& scene) {
    for (const Mesh& mesh : scene.meshes) {
      meshes.push_back({.positions = positions.add(mesh.positions),
                        .normals = normals.add(mesh.normals),
                        .colours = colours.add(mesh.colours),
                        .texcoords = texcoords.add(mesh.texcoords),
                        .triangles = triangles.add(mesh.triangles),
                        .meshlets = meshlets.add(mesh.meshlets),
                        .centre = mesh.centre,
                        .half_extent = mesh.half_extent,
                        .texcoord_bits = mesh.texcoord_bits,
                        .billboard = static_cast<std::uint8_t>(mesh.billboard),
                        .outline = mesh.outline,
                        .shadow = static_cast<std::uint8_t>(mesh.shadow)});
    }
    for (const Texture& texture : scene.textures) {
      textures.push_back({.texels = texels.add(texture.texels),
                          .log2_width = texture.log2_width,
                          .log2_height = texture.log2_height,
                          .format = static_cast<std::uint8_t>(texture.format),
                          .smaller_levels = texture.smaller_levels});
    }
    for (const LineSet& set : scene.lines) {
      lines.push_back({.segments = segments.add(set.segments),
                       .mesh = set.mesh,
                       .material = set.material,
                       .transform = set.transform,
                       .width = set.width,
                       .unused = {}});
    }
    for (const EdgeSet& set : scene.edges) {
      edge_sets.push_back({.edges = edges.add(set.edges), .mesh = set.mesh, .unused = 0});
    }
    if (scene.overlay != nullptr) add(*scene.overlay);
  }

  void add(const Overlay& overlay) {
    for (const OverlayImage& image : overlay.images) {
      images.push_back({.colours = image_colours.add(image.colours),
                        .coverage = coverage.add(image.coverage),
                        .width = image.width,
                        .height = image.height,
                        .coverage_bits = image.coverage_bits,
                        .unused = {}});
    }
    for (const Font& font : overlay.fonts) {
      fonts.push_back({.glyphs = glyphs.add(font.glyphs),
                       .coverage = coverage.add(font.coverage),
                       .replacement = font.replacement,
                       .line_height = font.line_height,
                       .baseline = font.baseline,
                       .coverage_bits = font.coverage_bits,
                       .unused = {}});
    }
    for (const Label& label : overlay.labels) {
      labels.push_back({.text = text.add(label.text),
                        .x = label.x,
                        .y = label.y,
                        .font = label.font,
                        .alignment = static_cast<std::uint8_t>(label.alignment),
                        .unused = 0,
                        .colour = label.colour,
                        .background = label.background});
    }
    sprites = overlay.sprites;
  }

  blob_layout::Records records() const {
    blob_layout::Records all;
    all.meshes = meshes;
    all.textures = textures;
    all.lines = lines;
    all.edge_sets = edge_sets;
    all.positions = positions.all();
    all.normals = normals.all();
    all.colours = colours.all();
    all.texcoords = texcoords.all();
    all.triangles = triangles.all();
    all.meshlets = meshlets.all();
    all.texels = texels.all();
    all.segments = segments.all();
    all.edges = edges.all();
    all.images = images;
    all.fonts = fonts;
    all.labels = labels;
    all.sprites = sprites;
    all.image_colours = image_colours.all();
    all.coverage = coverage.all();
    all.glyphs = glyphs.all();
    all.text = text.all();
    return all;
  }
};

/// The records of skins, clips and morph targets.
struct CharacterPools {
  Pool<VertexJoints> vertex_joints;
  Pool<Keyframe> keyframes, joint_keyframes;
  Pool<char> names;
  std::vector<Track> tracks, joint_tracks, weight_tracks;
  std::vector<blob_layout::SkinRecord> skins;
  std::vector<blob_layout::ClipRecord> clips;
  std::vector<MorphRun> runs;
  Pool<MorphOffset> offsets;
  Pool<NormalOffset> normal_offsets;
  Pool<WeightKey> weight_keys;
  std::vector<blob_layout::MorphRecord> morphs;
  std::vector<blob_layout::MorphTargetRecord> targets;
  std::vector<blob_layout::Range> weight_ranges;

  explicit CharacterPools(const SceneBlob& content) {
    for (const Skin& skin : content.skins) {
      skins.push_back({.vertices = vertex_joints.add(skin.vertices),
                       .mesh = static_cast<std::uint16_t>(skin.mesh - content.scene.meshes.data()),
                       .unused = 0});
    }
    for (const Clip& clip : content.clips) {
      clips.push_back({.name = names.add(std::span(clip.name, std::strlen(clip.name) + 1)),
                       .tracks = add(clip.instances.tracks, clip.instances.keyframes, keyframes, tracks),
                       .joint_tracks = add(clip.joints.tracks, clip.joints.keyframes, joint_keyframes, joint_tracks),
                       .duration = clip.duration()});
      if (content.morphs.meshes.empty()) continue;
      weight_ranges.push_back(add(clip.weights.tracks, clip.weights.keys, weight_keys, weight_tracks));
    }
    for (const MovedMorph& mesh : content.morphs.meshes) add(mesh);
  }

  void add(const MovedMorph& mesh) {
    morphs.push_back(
        {.targets = {static_cast<std::uint32_t>(targets.size()), static_cast<std::uint32_t>(mesh.morph.targets.size())},
         .mesh = mesh.mesh,
         .unused = 0});
    for (const MorphTarget& target : mesh.morph.targets) {
      const auto first_run = static_cast<std::uint32_t>(runs.size());
      runs.insert(runs.end(), target.runs.begin(), target.runs.end());
      targets.push_back({.runs = {first_run, static_cast<std::uint32_t>(target.runs.size())},
                         .positions = offsets.add(target.positions),
                         .normals = normal_offsets.add(target.normals),
                         .weight = target.weight,
                         .unused = 0});
    }
  }

  /// Appends the tracks, with indices into all keyframes.
  template <class Key>
  static blob_layout::Range add(std::span<const Track> tracks, std::span<const Key> keys, Pool<Key>& all_keys,
                                std::vector<Track>& all) {
    const std::uint32_t first = all_keys.add(keys).first;
    const auto first_track = static_cast<std::uint32_t>(all.size());
    for (Track track : tracks) {
      track.first += first;
      all.push_back(track);
    }
    return {first_track, static_cast<std::uint32_t>(tracks.size())};
  }

  void add_to(blob_layout::Records& records) const {
    records.clips = clips;
    records.clip_names = names.all();
    records.skins = skins;
    records.vertex_joints = vertex_joints.all();
    records.joint_tracks = joint_tracks;
    records.joint_keyframes = joint_keyframes.all();
    records.morphs = morphs;
    records.morph_targets = targets;
    records.morph_runs = runs;
    records.morph_offsets = offsets.all();
    records.normal_offsets = normal_offsets.all();
    records.weight_ranges = weight_ranges;
    records.weight_tracks = weight_tracks;
    records.weight_keys = weight_keys.all();
  }
};

/// Returns the number of one of kPictureEffects.
std::uint8_t number_of(Effects effects) {
  return static_cast<std::uint8_t>(std::ranges::find(kPictureEffects, effects) - std::begin(kPictureEffects));
}

}  // namespace

Result<std::vector<std::uint8_t>> to_scene_blob(const SceneBlob& content) {
  SceneBlob written = content;
  const CharacterPools characters(content);
  const bool has_clips = !content.clips.empty();
  if (has_clips) written.animation = {characters.tracks, characters.keyframes.all()};
  // Animated instances do not rotate.
  const bool is_animated = has_clips || !content.animation.tracks.empty();
  if (is_animated) written.turning_camera = nullptr;
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  for (const MovedMorph& morph : content.morphs.meshes) meshes[morph.mesh] = *morph.morph.mesh;
  written.scene.meshes = meshes;
  const Pools pools(written.scene);
  blob_layout::Records records = pools.records();
  const blob_layout::BaseRecord base{content.scene.ambient, content.scene.background};
  const View& view = content.view;
  const blob_layout::PictureRecord picture{.width = view.width,
                                           .height = view.height,
                                           .format = static_cast<std::uint8_t>(view.format),
                                           .dither = view.dither,
                                           .samples = view.samples,
                                           .effects = number_of(content.effects)};
  const blob_layout::AnimationRecord animation{content.animation.duration};
  const blob_layout::TurnRecord turn{content.turn.still_instances, static_cast<std::uint8_t>(content.turn.what), 0};
  records.base = &base;
  records.camera = &content.camera;
  records.picture = &picture;
  characters.add_to(records);
  if (!content.skins.empty()) {
    records.joints = content.skins[0].joints;
    records.joint_rest = content.skins[0].rest;
  }
  if (is_animated) {
    if (!has_clips) records.animation = &animation;
  } else if (content.turn != Turn{}) {
    records.turn = &turn;
  }
  SectionWriter sections;
  blob_layout::for_each_section(written, records, sections);
  return sections.blob(content.morphs.meshes.empty() ? kFirstSceneBlobVersion : kSceneBlobVersion);
}

}  // namespace zstrip::sim
