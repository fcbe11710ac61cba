// The layout of a scene blob: header, table of sections, and the only list of the sections' contents. Both the reader
// (scene_blob.cpp) and the writer (host-sim/bake) use that list; docs/formats.md defines the format. Add a new section
// as a line in for_each_section, in alphabetical order. Settings of a new effect then are in the blob automatically, as
// records of their own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "zstrip/animation.hpp"
#include "zstrip/base/fixed.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/parts.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::blob_layout {

/// Four letters, the first in the highest byte, so that the numeric order is the alphabetical order, capitals first. In
/// a blob the letters are stored in reading order.
using Tag = std::uint32_t;

constexpr Tag tag(const char (&letters)[5]) {
  Tag value = 0;
  for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<std::uint8_t>(letters[i]);
  return value;
}

/// True if a reader that does not know the section must refuse the blob: the tag begins with a capital letter. A reader
/// skips other unknown sections, because the picture is right without them.
constexpr bool must_be_known(Tag tag) { return (tag & 0x20000000U) == 0; }

/// Returns the letters with a zero after them, for messages; a question mark replaces each letter that is not
/// printable.
constexpr std::array<char, 5> name_of(Tag tag) {
  std::array<char, 5> name{};
  for (int i = 0; i < 4; ++i) {
    const auto letter = static_cast<char>(tag >> (24 - 8 * i) & 0xFF);
    name[static_cast<std::size_t>(i)] = letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return name;
}

struct Header {
  std::uint8_t magic[2];  ///< 'z', 's'
  std::uint8_t version;
  std::uint8_t kind;       ///< 's'
  std::uint32_t bytes;     ///< of the whole blob, a multiple of kSceneBlobAlignment
  std::uint32_t checksum;  ///< CRC-32 of all bytes from kChecked on
  std::uint32_t sections;  ///< entries of the table that follows
};
inline constexpr std::uint32_t kChecked = 12;

/// An entry of the table. Tags ascend. The first section begins after the table, each other section at the end of the
/// one before, both rounded up to kSceneBlobAlignment. The last section ends the blob.
struct Section {
  std::uint8_t letters[4];
  std::uint32_t offset;  ///< from the blob's first byte
  std::uint32_t bytes;   ///< of all its records, more than 0

  constexpr Tag tag() const {
    return Tag{letters[0]} << 24 | Tag{letters[1]} << 16 | Tag{letters[2]} << 8 | Tag{letters[3]};
  }
};

/// A run of the records of a section.
struct Range {
  std::uint32_t first, count;
};

// Records of data that is not used in place.
struct MeshRecord {
  Range positions, normals, colours, texcoords, triangles, meshlets;
  Vec3 centre, half_extent;
  std::uint8_t texcoord_bits, billboard, outline, shadow;
};
struct TextureRecord {
  Range texels;
  std::uint8_t log2_width, log2_height, format, smaller_levels;
};
struct LineRecord {
  Range segments;
  std::uint16_t mesh, material;
  Transform transform;
  std::uint8_t width, unused[3];
};
struct EdgeRecord {
  Range edges;
  std::uint16_t mesh, unused;
};
struct ImageRecord {
  Range colours, coverage;
  std::uint16_t width, height;
  std::uint8_t coverage_bits, unused[3];
};
struct FontRecord {
  Range glyphs, coverage;
  std::uint32_t replacement;
  std::uint16_t line_height, baseline;
  std::uint8_t coverage_bits, unused[3];
};
struct LabelRecord {
  Range text;
  std::int16_t x, y;
  std::uint16_t font;
  std::uint8_t alignment, unused;
  Colour colour, background;
};
struct BaseRecord {
  Colour ambient, background;
};
struct PictureRecord {
  std::uint16_t width, height;
  std::uint8_t format, dither, samples;
  std::uint8_t effects;  ///< index into kPictureEffects; is_gone must be false for it
};
/// True for the numbers of removed depth formats: w16, z32.
constexpr bool is_gone(std::uint8_t effects) { return effects == 5 || effects == 7; }
struct AnimationRecord {
  std::uint32_t duration;
};
struct ClipRecord {
  Range name, tracks, joint_tracks;
  std::uint32_t duration;
};
struct SkinRecord {
  Range vertices;
  std::uint16_t mesh, unused;
};
struct MorphRecord {
  Range targets;
  std::uint16_t mesh, unused;
};
struct MorphTargetRecord {
  Range runs, positions, normals;
  std::uint16_t weight, unused;
};
struct TurnRecord {
  std::uint16_t still_instances;
  std::uint8_t what, unused;
};
static_assert(sizeof(Header) == 16 && sizeof(Section) == 12 && sizeof(MeshRecord) == 76 &&
              sizeof(TextureRecord) == 12 && sizeof(LineRecord) == 64 && sizeof(EdgeRecord) == 12 &&
              sizeof(ImageRecord) == 24 && sizeof(FontRecord) == 28 && sizeof(LabelRecord) == 24 &&
              sizeof(BaseRecord) == 8 && sizeof(PictureRecord) == 8 && sizeof(TurnRecord) == 4 &&
              sizeof(ClipRecord) == 28 && sizeof(SkinRecord) == 12 && sizeof(MorphRecord) == 12 &&
              sizeof(MorphTargetRecord) == 28);

/// The data of a SceneBlob whose form in the blob is different.
struct Records {
  std::span<const MeshRecord> meshes;
  std::span<const TextureRecord> textures;
  std::span<const LineRecord> lines;
  std::span<const EdgeRecord> edge_sets;
  std::span<const ImageRecord> images;
  std::span<const FontRecord> fonts;
  std::span<const LabelRecord> labels;
  std::span<const Sprite> sprites;
  // These tables hold the data of all meshes, textures, sets of lines and of edges, images, fonts and labels.
  std::span<const Position> positions;
  std::span<const Normal> normals;
  std::span<const Colour> colours;
  std::span<const TexCoord> texcoords;
  std::span<const Triangle> triangles;
  std::span<const Meshlet> meshlets;
  std::span<const std::uint16_t> texels;
  std::span<const Segment> segments;
  std::span<const Edge> edges;
  std::span<const std::uint16_t> image_colours;
  std::span<const std::uint8_t> coverage;
  std::span<const Glyph> glyphs;
  std::span<const char> text;
  std::span<const ClipRecord> clips;
  std::span<const char> clip_names;
  std::span<const SkinRecord> skins;
  std::span<const VertexJoints> vertex_joints;
  std::span<const Joint> joints;
  std::span<const JointPose> joint_rest;
  std::span<const Track> joint_tracks;
  std::span<const Keyframe> joint_keyframes;
  std::span<const MorphRecord> morphs;
  std::span<const MorphTargetRecord> morph_targets;
  std::span<const MorphRun> morph_runs;
  std::span<const MorphOffset> morph_offsets;
  std::span<const NormalOffset> normal_offsets;
  std::span<const Range> weight_ranges;  ///< tracks of weights of each clip
  std::span<const Track> weight_tracks;
  std::span<const WeightKey> weight_keys;
  const BaseRecord* base = nullptr;
  const Camera* camera = nullptr;
  const PictureRecord* picture = nullptr;
  const AnimationRecord* animation = nullptr;
  const TurnRecord* turn = nullptr;
};

/// Calls section(tag, where) for each section in the order of a blob. `where` is a span of any number of records, or a
/// pointer to one record, which is null if there is none. Sections that every blob must have use section.needed(tag,
/// pointer).
template <class Blob, class RecordsOfBlob, class Visitor>
constexpr void for_each_section(Blob& blob, RecordsOfBlob& records, Visitor& section) {
  section(tag("ANIM"), records.animation);
  section.needed(tag("BASE"), records.base);
  section.needed(tag("CAMR"), records.camera);
  section(tag("CAMT"), blob.turning_camera);
  section(tag("CLIP"), records.clips);
  section(tag("CNAM"), records.clip_names);
  section(tag("COLR"), records.colours);
  section(tag("CSGO"), blob.scene.csg);
  section(tag("CWGT"), records.weight_ranges);
  section(tag("EDGE"), records.edges);
  section(tag("ESET"), records.edge_sets);
  section(tag("FINI"), blob.scene.finishes);
  section(tag("FOGS"), blob.scene.fog);
  section(tag("GLYP"), records.glyphs);
  section(tag("INST"), blob.scene.instances);
  section(tag("JKEY"), records.joint_keyframes);
  section(tag("JOIN"), records.joints);
  section(tag("JRES"), records.joint_rest);
  section(tag("JTRK"), records.joint_tracks);
  section(tag("KEYF"), blob.animation.keyframes);
  section(tag("LDIR"), blob.scene.lights);
  section(tag("LPNT"), blob.scene.punctual_lights);
  section(tag("LSET"), records.lines);
  section(tag("MATL"), blob.scene.materials);
  section(tag("MESH"), records.meshes);
  section(tag("MLET"), records.meshlets);
  section(tag("MOFF"), records.morph_offsets);
  section(tag("MOFN"), records.normal_offsets);
  section(tag("MORF"), records.morphs);
  section(tag("MRUN"), records.morph_runs);
  section(tag("MTGT"), records.morph_targets);
  section(tag("NORM"), records.normals);
  section(tag("OCOL"), records.image_colours);
  section(tag("OCOV"), records.coverage);
  section(tag("OFNT"), records.fonts);
  section(tag("OIMG"), records.images);
  section(tag("OLAB"), records.labels);
  section(tag("OSPR"), records.sprites);
  section(tag("OTXT"), records.text);
  section(tag("OUTL"), blob.scene.outlines);
  section.needed(tag("PICT"), records.picture);
  section(tag("POSI"), records.positions);
  section(tag("QUAD"), blob.scene.quadrics);
  section(tag("SEGM"), records.segments);
  section(tag("SHAD"), blob.scene.shadow);
  section(tag("SKIN"), records.skins);
  section(tag("TEXC"), records.texcoords);
  section(tag("TEXL"), records.texels);
  section(tag("TEXT"), records.textures);
  section(tag("TRAK"), blob.animation.tracks);
  section(tag("TRIA"), records.triangles);
  section(tag("TURN"), records.turn);
  section(tag("VJOI"), records.vertex_joints);
  section(tag("WKEY"), records.weight_keys);
  section(tag("WTRK"), records.weight_tracks);
  section(tag("evnt"), blob.events);
  section(tag("lods"), blob.levels);
  section(tag("tree"), blob.tree.nodes);
}

/// A visitor that checks that for_each_section passes ascending tags.
struct Order {
  Tag last = 0;
  bool holds = true;
  template <class Where>
  constexpr void operator()(Tag tag, const Where&) {
    holds = holds && tag > last;
    last = tag;
  }
  template <class Where>
  constexpr void needed(Tag tag, const Where& where) {
    (*this)(tag, where);
  }
};

constexpr bool is_in_order() {
  const SceneBlob blob;
  const Records records;
  Order order;
  for_each_section(blob, records, order);
  return order.holds;
}
static_assert(is_in_order());

/// A visitor that looks for a part of the scene among the sections.
struct Search {
  const void* part;
  bool found = false;
  template <class Where>
  constexpr void operator()(Tag, const Where& where) {
    found = found || static_cast<const void*>(&where) == part;
  }
  template <class Where>
  constexpr void needed(Tag tag, const Where& where) {
    (*this)(tag, where);
  }
};

/// True for the parts of a scene that a blob holds in another form: arrays of arrays as records and pools, both colours
/// in BASE, an overlay in several sections.
template <class Part>
constexpr bool kInOtherForm =
    std::is_same_v<Part, std::span<const Mesh>> || std::is_same_v<Part, std::span<const Texture>> ||
    std::is_same_v<Part, std::span<const LineSet>> || std::is_same_v<Part, std::span<const EdgeSet>> ||
    std::is_same_v<Part, Colour> || std::is_same_v<Part, const Overlay*>;

constexpr bool holds_every_part() {
  const SceneBlob blob;
  const Records records;
  bool holds = true;
  detail::for_each_part(blob.scene, [&]<class Part>(const char*, const Part& part) {
    Search search{&part, kInOtherForm<Part>};
    for_each_section(blob, records, search);
    holds = holds && search.found;
  });
  return holds;
}
static_assert(holds_every_part(), "a new part of a scene needs a section");

}  // namespace zstrip::blob_layout
