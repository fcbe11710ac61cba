// The patterns, and how names are compared with them.
#include "groups.hpp"

#include <cctype>
#include <string_view>

#include "elf_file.hpp"
#include "reader_name.hpp"

namespace zstrip::flash {
namespace {

/// How a part of a name begins, between two "::".
struct Pattern {
  std::string_view begin;
  Group group;
};

/// The first that fits counts: what is special comes before what is general.
constexpr Pattern kPatterns[] = {
    {"std", Group::library},
    {"message", Group::texts},

    {"unclipped", Group::set_up},
    {"Clip", Group::clipping},
    {"TriangleClipper", Group::clipping},
    {"clip", Group::clipping},
    {"crossing", Group::clipping},
    {"Fraction", Group::clipping},
    {"project_wide", Group::clipping},
    {"RasterPolygon", Group::clipping},
    {"TriangleParts", Group::clipping},
    {"winding_number", Group::clipping},

    {"validate", Group::checks},
    {"valid_", Group::checks},
    {"check_", Group::checks},
    {"refuse_", Group::checks},
    {"count", Group::checks},
    {"effects_of", Group::checks},
    {"effect", Group::checks},
    {"Effects", Group::checks},
    {"edge_groups", Group::checks},
    {"has_depth_state", Group::checks},
    {"finish_of", Group::checks},
    {"largest_purpose", Group::checks},

    {"convert_pixels", Group::resolve},
    {"resolve_", Group::resolve},
    {"luma", Group::resolve},
    {"bytes_per_row", Group::resolve},

    {"transform", Group::vertices},
    {"shade_vertices", Group::vertices},

    {"set_up_texture", Group::spans},
    {"set_medium_edge", Group::spans},

    {"draw_small", Group::small_triangles},
    {"zstrip_set_up_small", Group::small_triangles},
    {"zstrip_scan_small", Group::small_triangles},
    {"set_up", Group::small_triangles},

    {"draw_span", Group::spans},
    {"draw_cut", Group::spans},
    {"scan_cut_rows", Group::spans},
    {"draw_medium_textured", Group::spans},
    {"begin_textured", Group::spans},
    {"scan_textured", Group::spans},
    {"fill_smooth", Group::spans},
    {"TriangleRows", Group::spans},
    {"RowsLeft", Group::spans},
    {"MediumPlanes", Group::spans},
    {"CalledPlanes", Group::spans},
    {"ThumbPlanes", Group::spans},
    {"zstrip_set_plane", Group::spans},
    {"set_medium_planes", Group::spans},
    {"divide_texels", Group::spans},
    {"scan_rows_of_texels", Group::spans},
    {"walk_", Group::spans},
    {"SpanTriangle", Group::spans},
    {"PlaneSetup", Group::spans},
    {"WordOrLongPlanes", Group::spans},
    {"EdgeWalk", Group::spans},
    {"floor_of", Group::spans},
    {"signed_area", Group::spans},
    {"TextureCoordinates", Group::spans},
    {"fill_", Group::spans},
    {"Assembler", Group::spans},
    {"NarrowAssembler", Group::spans},

    {"compile_", Group::set_up},
    {"view_row", Group::set_up},
    {"normalise", Group::set_up},
    {"distance_", Group::set_up},
    {"fit_", Group::set_up},
    {"reach_of", Group::set_up},
    {"pixels", Group::set_up},
    {"bound", Group::set_up},
    {"usable", Group::set_up},
    {"LinearForm", Group::set_up},
    {"LinearHalves", Group::set_up},
    {"NarrowProjection", Group::set_up},
    {"begin_instances", Group::set_up},
    {"orbit", Group::set_up},
    {"sine", Group::set_up},
    {"cosine", Group::set_up},

    {"divide_", Group::library},
    {"quotient", Group::library},
    {"seldom_quotient", Group::library},
    {"multiply_high", Group::library},
    {"reciprocal", Group::library},
    {"kReciprocalTable", Group::library},
    {"kInverse", Group::library},
    {"mem", Group::library},
    {"copy_upwards", Group::library},
    {"puts", Group::library},
    {"printf", Group::library},
    {"__", Group::library},

    {"main", Group::frame},
    {"begin_", Group::frame},
    {"draw_", Group::frame},
    {"GeometryStage", Group::frame},
    {"RasterStage", Group::frame},
    {"StripGrid", Group::frame},
    {"Rect", Group::frame},
    {"divide", Group::frame},
    {"target_of", Group::frame},
    {"lay_out_arena", Group::frame},
    {"extend_bounds", Group::frame},
    {"clear", Group::frame},
    {"FixedRenderer", Group::frame},
    {"kPlan", Group::frame},
};

bool fits(const std::string& name, std::string_view begin) {
  constexpr std::string_view kBetween = "::";
  for (std::size_t at = 0;; at += kBetween.size()) {
    if (name.compare(at, begin.size(), begin) == 0) return true;
    at = name.find(kBetween, at);
    if (at == std::string::npos) return false;
  }
}

}  // namespace

Group group_of(const std::string& name) {
  const std::string without = budget::without_arguments(budget::reader_name(name));
  for (const Pattern& pattern : kPatterns) {
    if (fits(without, pattern.begin)) return pattern.group;
  }
  return Group::rest;
}

bool is_table(const std::string& name) {
  constexpr std::string_view kScenes = "zstrip::scenes::", kOfProgram = "(anonymous namespace)::";
  std::string whole = budget::demangled(name);
  if (whole.starts_with(kScenes)) return true;
  if (whole.starts_with(kOfProgram)) whole.erase(0, kOfProgram.size());
  const bool is_constant = whole.size() > 1 && whole[0] == 'k' && std::isupper(static_cast<unsigned char>(whole[1]));
  return is_constant && whole.find(':') == std::string::npos && whole != "kPlan";
}

}  // namespace zstrip::flash
