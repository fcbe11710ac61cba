// Values as C++ literals, for headers of constants.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "zstrip/animation.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {

std::string literal(const Vec3& v);
std::string literal(const Colour& c);
std::string literal(const Position& p);
std::string literal(const Normal& n);
std::string literal(const TexCoord& t);
std::string literal(const Triangle& t);
std::string literal(std::uint16_t texel);
/// Returns an initialiser of the member, empty for the default value; the next two functions, too.
std::string literal(Billboard billboard);
std::string outline_literal(std::uint8_t outline);
std::string literal(ShadowRole role);
std::string literal(const Meshlet& m);
std::string literal(const Material& m);
std::string literal(const Finish& f);
std::string literal(const PunctualLight& light);
std::string literal(const Transform& transform);
std::string literal(const Instance& instance);
std::string literal(const Fog& fog);
std::string literal(const Outline& outline);
std::string literal(const CsgOperand& operand);
std::string literal(const Shadow& shadow);
std::string literal(const Quadric& quadric);
std::string literal(const Segment& segment);
std::string literal(const Edge& edge);
std::string literal(const DirectionalLight& light);
std::string literal(std::uint8_t byte);
std::string literal(const Glyph& g);
std::string literal(const Sprite& s);
/// Returns the text in quotes; bytes outside of ASCII become octal digits.
std::string quoted(std::span<const char> text);
std::string literal(const Track& track);
std::string literal(const Keyframe& k);
std::string literal(Effects effects);
std::string literal(const BspNode& n);
std::string literal(const VertexJoints& vertex);
std::string literal(const Joint& joint);
std::string literal(const JointPose& pose);
std::string literal(const MorphRun& run);
std::string literal(const MorphOffset& offset);
std::string literal(const NormalOffset& offset);
std::string literal(const WeightKey& key);
std::string literal(const DetailLevel& level);
std::string literal(const ClipEvent& event);
const char* turning_name(Turning turning);

// The name of the type of a scene's records; only the argument's type counts.
constexpr const char* type_name(const Material*) { return "zstrip::Material"; }
constexpr const char* type_name(const Instance*) { return "zstrip::Instance"; }
constexpr const char* type_name(const DirectionalLight*) { return "zstrip::DirectionalLight"; }
constexpr const char* type_name(const Fog*) { return "zstrip::Fog"; }
constexpr const char* type_name(const Finish*) { return "zstrip::Finish"; }
constexpr const char* type_name(const PunctualLight*) { return "zstrip::PunctualLight"; }
constexpr const char* type_name(const Quadric*) { return "zstrip::Quadric"; }
constexpr const char* type_name(const Outline*) { return "zstrip::Outline"; }
constexpr const char* type_name(const Shadow*) { return "zstrip::Shadow"; }
constexpr const char* type_name(const CsgOperand*) { return "zstrip::CsgOperand"; }

/// Returns the definition of an array that is not empty, in lines of a header's width.
template <class Record>
std::string array_definition(const std::string& type, const std::string& name, std::span<const Record> records) {
  constexpr std::size_t kWidth = 118;
  std::string text = fmt::format("inline constexpr {} {}[{}] = {{\n   ", type, name, records.size());
  std::size_t column = 3;
  for (const Record& record : records) {
    const std::string one = literal(record);
    if (column + one.size() + 2 > kWidth && column > 3) {
      text += "\n   ";
      column = 3;
    }
    text += ' ' + one + ',';
    column += one.size() + 2;
  }
  text.back() = '}';
  return text + ";\n";
}

}  // namespace zstrip::sim
