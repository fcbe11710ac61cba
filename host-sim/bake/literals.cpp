// Values as C++ literals; see literals.hpp.
#include "bake/literals.hpp"

#include <utility>

#include "zstrip/effects/list.hpp"

namespace zstrip::sim {

std::string literal(const Vec3& v) { return fmt::format("{{{}, {}, {}}}", v.x, v.y, v.z); }
std::string literal(const Colour& c) { return fmt::format("{{{}, {}, {}, {}}}", c.r, c.g, c.b, c.a); }
std::string literal(const Position& p) { return fmt::format("{{{}, {}, {}}}", p.x, p.y, p.z); }
std::string literal(const Normal& n) { return fmt::format("{{{}, {}, {}, {}}}", n.x, n.y, n.z, n.unused); }
std::string literal(const TexCoord& t) { return fmt::format("{{{}, {}}}", t.u, t.v); }
std::string literal(const Triangle& t) { return fmt::format("{{{}, {}, {}}}", t.a, t.b, t.c); }
std::string literal(std::uint16_t texel) { return fmt::format("0x{:04X}", texel); }
std::string literal(Billboard billboard) {
  if (billboard == Billboard::none) return "";
  return fmt::format(",\n     .billboard = zstrip::Billboard::{}",
                     billboard == Billboard::viewer ? "viewer" : "upright");
}
std::string outline_literal(std::uint8_t outline) {
  return outline == 0 ? "" : fmt::format(",\n     .outline = {}", outline);
}
std::string literal(ShadowRole role) {
  if (role == ShadowRole::casts_and_receives) return "";
  return fmt::format(",\n     .shadow = zstrip::ShadowRole{{{}}}", static_cast<int>(role));
}
std::string literal(const Meshlet& m) {
  return fmt::format("{{{}, {}, {}, {}, {}, {}}}", m.first_triangle, m.first_vertex, m.vertex_count, m.triangle_count,
                     m.radius, literal(m.centre));
}
std::string literal(const Material& m) {
  std::string text = fmt::format("{{.colour = {}", literal(m.colour));
  if (m.texture != kNoTexture) text += fmt::format(", .texture = {}", m.texture);
  const char* const smooth = m.smooth == Shading::pixel ? "zstrip::Shading::pixel" : m.smooth ? "true" : "false";
  text += fmt::format(", .lit = {}, .smooth = {}, .double_sided = {}", m.lit, smooth, m.double_sided);
  // In the order of the declaration, as C++ requires for designators.
  if (has_depth_state(m)) {
    text += fmt::format(", .depth_test = zstrip::DepthTest{{{}}}, .depth_write = {}", static_cast<int>(m.depth_test),
                        m.depth_write);
  }
  if (m.finish != kNoFinish) text += fmt::format(", .finish = {}", m.finish);
  if (has_depth_state(m)) {
    text += fmt::format(", .depth_bias = {}, .depth_slope_bias = {}, .depth_bias_clamp = {}", m.depth_bias,
                        m.depth_slope_bias, m.depth_bias_clamp);
  }
  return text + '}';
}
std::string literal(const Finish& f) {
  return fmt::format(
      "{{.emissive = {}, .specular = {}, .shininess = {}, .alpha_mode = zstrip::AlphaMode{{{}}}, .alpha_cutoff = {}, "
      ".filter = zstrip::TextureFilter{{{}}}}}",
      literal(f.emissive), literal(f.specular), f.shininess, static_cast<int>(f.alpha_mode), f.alpha_cutoff,
      static_cast<int>(f.filter));
}
std::string literal(const PunctualLight& light) {
  return fmt::format(
      "{{.type = zstrip::PunctualLightType{{{}}}, .colour = {}, .position = {}, .intensity = {}, .range = {}, .x = {}, "
      ".y = {}, .z = {}, .cosine_inner = {}, .cosine_outer = {}}}",
      static_cast<int>(light.type), literal(light.colour), literal(light.position), light.intensity, light.range,
      light.x, light.y, light.z, light.cosine_inner, light.cosine_outer);
}
std::string literal(const Transform& transform) {
  std::string rows;
  for (const auto& row : transform.m) {
    rows += fmt::format("{}{{{}, {}, {}, {}}}", rows.empty() ? "" : ", ", row[0], row[1], row[2], row[3]);
  }
  return fmt::format("{{{{{}}}}}", rows);
}
std::string literal(const Instance& instance) {
  return fmt::format("{{.mesh = {}, .material = {}, .transform = {}}}", instance.mesh, instance.material,
                     literal(instance.transform));
}
std::string literal(const Fog& fog) {
  return fmt::format("{{.colour = {}, .mode = zstrip::FogMode{{{}}}, .start = {}, .end = {}, .density = {}}}",
                     literal(fog.colour), static_cast<int>(fog.mode), fog.start, fog.end, fog.density);
}
std::string literal(const Outline& outline) {
  return fmt::format("{{.colour = {}, .width = {}, .hull = {}}}", literal(outline.colour), outline.width, outline.hull);
}
std::string literal(const CsgOperand& operand) {
  return fmt::format("{{{}, {}, zstrip::CsgUse{{{}}}}}", operand.instance, operand.product,
                     static_cast<int>(operand.use));
}
std::string literal(const Shadow& shadow) {
  return fmt::format("{{.light = {}, .log2_size = {}, .bias = {}, .slope_bias = {}, .pool = {}}}", shadow.light,
                     shadow.log2_size, shadow.bias, shadow.slope_bias, shadow.pool);
}
std::string literal(const Quadric& quadric) {
  return fmt::format("{{.material = {}, .transform = {}}}", quadric.material, literal(quadric.transform));
}
std::string literal(const Segment& segment) { return fmt::format("{{{}, {}}}", segment.a, segment.b); }
std::string literal(const Edge& edge) {
  return fmt::format("{{{}, {}, {}, {}}}", edge.a, edge.b, edge.left, edge.right);
}
std::string literal(const DirectionalLight& light) {
  return fmt::format("{{.x = {}, .y = {}, .z = {}, .colour = {}}}", light.x, light.y, light.z, literal(light.colour));
}

std::string literal(std::uint8_t byte) { return fmt::format("0x{:02X}", byte); }
std::string literal(const Glyph& g) {
  return fmt::format("{{0x{:04X}, {}, {}, {}, {}, {}, {}}}", g.code_point, g.offset, g.width, g.height, g.left, g.top,
                     g.advance);
}
std::string literal(const Sprite& s) { return fmt::format("{{{}, {}, {}, {}}}", s.x, s.y, s.image, literal(s.colour)); }
// Three octal digits, so that a following digit cannot belong to them.
std::string quoted(std::span<const char> text) {
  std::string result = "\"";
  for (const char c : text) {
    const bool plain = c >= ' ' && c <= '~' && c != '"' && c != '\\' && c != '?';
    result += plain ? std::string(1, c) : fmt::format("\\{:03o}", static_cast<unsigned char>(c));
  }
  return result + '"';
}

std::string literal(const Track& track) {
  return fmt::format("{{.instance = {}, .count = {}, .first = {}}}", track.instance, track.count, track.first);
}
std::string literal(const Keyframe& k) {
  return fmt::format("{{{}, {{{}, {}, {}, {}}}, {}, {}}}", k.time, k.rotation[0], k.rotation[1], k.rotation[2],
                     k.rotation[3], literal(k.translation), literal(k.scale));
}

namespace {

/// Shades, and the effects that the picture's settings choose.
constexpr std::pair<const char*, Effects> kChosen[] = {
    {"effect::shade_flat", effect::shade_flat},
    {"effect::shade_gouraud", effect::shade_gouraud},
    {"effect::shade_textured", effect::shade_textured},
    {"effect::shade_textured_flat", effect::shade_textured_flat},
    {"effect::shade_textured_gouraud", effect::shade_textured_gouraud},
    {"effect::shade_fragments", effect::shade_fragments},
    {"effect::two_sided", effect::two_sided},
    {"effect::perspective_affine", effect::perspective_affine},
    {"effect::perspective_8", effect::perspective_8},
    {"effect::perspective_1", effect::perspective_1},
    {"effect::depth_float", effect::depth_float},
    {"effect::depth_24", effect::depth_24},
    {"effect::depth_ranges", effect::depth_ranges},
    {"method::painter", method::painter},
    {"method::in_order", method::in_order},
    {"method::bsp", method::bsp},
    {"method::front_to_back", method::front_to_back},
    {"method::hierarchical_z", method::hierarchical_z},
    {"method::midpoint", method::midpoint},
    {"method::midpoint_safe", method::midpoint_safe}};

}  // namespace

const char* turning_name(Turning turning) {
  switch (turning) {
    case Turning::instances_and_lines: return "instances_and_lines";
    case Turning::instances: return "instances";
    case Turning::camera: return "camera";
    case Turning::nothing: break;
  }
  return "nothing";
}

std::string literal(Effects effects) {
  std::string text;
  for (const EffectName& known : kEffectNames) {
    if (effects.has(known.effect)) text += fmt::format("{}zstrip::effect::{}", text.empty() ? "" : " | ", known.name);
  }
  for (const auto& [name, effect] : kChosen) {
    if (effects.has(effect)) text += fmt::format("{}zstrip::{}", text.empty() ? "" : " | ", name);
  }
  return text.empty() ? "zstrip::Effects{}" : text;
}

std::string literal(const BspNode& n) {
  return fmt::format("{{{}, {}, {}, {}, {}, {}, {}, {}}}", n.x, n.y, n.z, n.distance, n.first_triangle, n.front, n.back,
                     n.parent);
}
std::string literal(const VertexJoints& vertex) {
  const auto four = [](const std::uint8_t(&bytes)[4]) {
    return fmt::format("{{{}, {}, {}, {}}}", bytes[0], bytes[1], bytes[2], bytes[3]);
  };
  return fmt::format("{{{}, {}}}", four(vertex.joints), four(vertex.weights));
}
std::string literal(const Joint& joint) {
  const std::string parent = joint.parent == kNoJoint ? "zstrip::kNoJoint" : fmt::format("{}", joint.parent);
  return fmt::format("{{{}, {}}}", literal(joint.inverse_bind), parent);
}
std::string literal(const JointPose& pose) {
  const auto& q = pose.rotation;
  return fmt::format("{{{{{}, {}, {}, {}}}, {}, {}}}", q[0], q[1], q[2], q[3], literal(pose.translation),
                     literal(pose.scale));
}

std::string literal(const MorphRun& run) {
  return fmt::format("{{{}, {}, {}}}", run.first_vertex, run.count, run.first_offset);
}
std::string literal(const MorphOffset& offset) { return fmt::format("{{{}, {}, {}}}", offset.x, offset.y, offset.z); }
std::string literal(const NormalOffset& offset) { return fmt::format("{{{}, {}, {}}}", offset.x, offset.y, offset.z); }
std::string literal(const WeightKey& key) { return fmt::format("{{{}, {}}}", key.time, key.weight); }
std::string literal(const DetailLevel& level) {
  return fmt::format("{{{}, {}, {}}}", level.mesh, level.coarser, level.distance);
}

std::string literal(const ClipEvent& event) {
  return fmt::format("{{{}, {}, {}}}", event.clip, event.number, event.time);
}

}  // namespace zstrip::sim
