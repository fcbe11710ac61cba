// Codes, linear forms, gradients and formats as the documents define them.
#include "accuracy/truth_stages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/turned_billboard.hpp"

namespace zstrip::sim::truth {
namespace {

/// A range of distances along the viewing direction.
struct Reach {
  double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
};

/// Returns the range of all bounds that reach into the camera's range.
Reach fitted(const Scene& scene, const Camera& camera) {
  const Vector back = vector_of(camera.back, kOne30), eye = vector_of(camera.eye, kOne16);
  const double near = camera.near_plane / kOne16, far = camera.far_plane / kOne16;
  Reach span;
  const auto extend = [&](double middle, double reach) {
    if (middle + reach < near || middle - reach > far) return;
    span = {std::min(span.nearest, middle - reach), std::max(span.farthest, middle + reach)};
  };
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Transform transform = standing(scene, instance, camera);
    const Vector centre = transformed(transform, vector_of(mesh.centre, kOne16), false);
    const Vector extent = vector_of(mesh.half_extent, kOne16);
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) reach += std::abs(dot(back, column(transform, i)) * extent[i]);
    extend(dot(back, eye) - dot(back, centre), reach);
  }
  for (const Quadric& quadric : scene.quadrics) {
    double squares = 0;
    for (std::size_t i = 0; i < 3; ++i) squares += std::pow(dot(back, column(quadric.transform, i)), 2);
    extend(dot(back, eye) - dot(back, column(quadric.transform, 3)), std::sqrt(squares));
  }
  span = {std::max(span.nearest, near), std::min(span.farthest, far)};
  if (!(span.nearest < span.farthest)) return {near, far};
  const double wider = std::ldexp(1.0, -20);
  return {span.nearest * (1 - wider), span.farthest * (1 + wider)};
}

/// Returns 2^62 / divisor with a relative error of 2^-28; 2^31 <= divisor < 2^32.
double reciprocal_of(double divisor) {
  const double quotient = std::floor(4294967295.0 / std::floor(divisor / 65536)) * 16384;
  // A Newton step that keeps only the upper words of products.
  const double product = std::floor(std::ldexp(std::floor(divisor) * quotient, -32));
  return 2 * std::floor(std::ldexp(quotient * 2 * (std::ldexp(1.0, 31) - product), -32));
}

/// Returns 0..63: B. E. Bayer's matrix of order 8.
unsigned bayer(std::uint32_t x, std::uint32_t y) {
  unsigned value = 0;
  for (unsigned bit = 0; bit < 3; ++bit) {
    const unsigned column = (x >> bit) & 1, row = (y >> bit) & 1;
    value |= ((column ^ row) << 1 | row) << (4 - 2 * bit);
  }
  return value;
}

unsigned with_bits(unsigned value, unsigned bits, bool dither, std::uint32_t x, std::uint32_t y) {
  if (!dither) return value >> (8 - bits);
  const unsigned threshold = (bayer(x, y) << (8 - bits)) / 64;
  return (value - (value >> bits) + threshold) >> (8 - bits);
}

}  // namespace

DepthCodes::DepthCodes(const Scene& scene, const Camera& camera, const Stages::Depth& depth)
    : format_(depth.format), orthographic_(camera.projection == Projection::orthographic), first_(1), span_(65533) {
  const Reach span =
      camera.fixed_depth_range ? Reach{camera.near_plane / kOne16, camera.far_plane / kOne16} : fitted(scene, camera);
  near_ = span.nearest;
  far_ = span.farthest;
  if (depth.ranges) span_ = 16381;
  if (format_ == DepthFormat::z24) span_ = 16777213;
}

double DepthCodes::linear(double w) const {
  if (format_ == DepthFormat::float16) return 4294574080.0 * near_ / w;
  if (orthographic_) return first_ + span_ * (far_ - w) / (far_ - near_);
  return first_ + span_ * (1 / w - 1 / far_) / (1 / near_ - 1 / far_);
}

double DepthCodes::distance(double linear) const {
  if (format_ == DepthFormat::float16) return 4294574080.0 * near_ / linear;
  const double part = (linear - first_) / span_;
  if (orthographic_) return far_ - part * (far_ - near_);
  return 1 / (1 / far_ + part * (1 / near_ - 1 / far_));
}

std::uint32_t DepthCodes::code(double w) const {
  const double value = linear(w);
  if (format_ != DepthFormat::float16)
    return static_cast<std::uint32_t>(std::clamp(std::floor(value + 0.5), first_, first_ + span_));
  const auto v = static_cast<std::uint64_t>(std::clamp(value, 0.0, 4294967295.0));
  if (v < (1U << 25)) return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(v >> 12));
  std::uint32_t exponent = 1;
  while (v >> (25 + exponent) != 0) ++exponent;
  return std::min<std::uint32_t>(65534, exponent << 13 | ((v >> (11 + exponent)) & 0x1FFF));
}

double FixedTransform::Form::at(const Position& p) const {
  const auto product = [](double c, int of) { return std::floor(c * of / 65536); };
  return offset + product(coefficient[0], p.x) + product(coefficient[1], p.y) + product(coefficient[2], p.z);
}

FixedTransform::Form FixedTransform::form_of(const Vector& axis, const Mesh& mesh, const Transform& transform,
                                             const Camera& camera) {
  const Vector extent = vector_of(mesh.half_extent, kOne16), eye = vector_of(camera.eye, kOne16);
  const Vector centre = transformed(transform, vector_of(mesh.centre, kOne16), false);
  std::array<double, 3> part{};
  const double offset = dot(axis, centre) - dot(axis, eye);
  double bound = std::abs(offset);
  for (std::size_t i = 0; i < 3; ++i) {
    part[i] = dot(axis, column(transform, i)) * extent[i];
    bound += std::abs(part[i]);
  }
  Form form;
  std::frexp(bound, &form.exponent);
  form.exponent -= 30;
  for (std::size_t i = 0; i < 3; ++i) form.coefficient[i] = std::floor(std::ldexp(2 * part[i], -form.exponent));
  form.offset = std::floor(std::ldexp(offset, -form.exponent));
  return form;
}

FixedTransform::FixedTransform(const Mesh& mesh, const Transform& transform, const Camera& camera, const View& view)
    : x_(form_of(vector_of(camera.right, kOne30), mesh, transform, camera)),
      y_(form_of(vector_of(camera.up, kOne30), mesh, transform, camera)),
      w_(form_of(vector_of(camera.back, -kOne30), mesh, transform, camera)),
      orthographic_(camera.projection == Projection::orthographic) {
  int exponent = 0;  // power of two, added to the shift
  mantissa_ = std::frexp(camera.focal / kOne16 * view.height / 2, &exponent);
  for (Form* const form : {&x_, &y_}) {
    for (double& c : form->coefficient) c = std::floor(c * mantissa_);
    form->offset = std::floor(form->offset * mantissa_);
  }
}

FixedVertex FixedTransform::at(const Position& p) const {
  const double x = x_.at(p), y = y_.at(p), w = w_.at(p);
  const auto length = [this](double value, const Form& form) { return std::ldexp(value / mantissa_, form.exponent); };
  // Points behind the camera are not divided.
  if (orthographic_ || w <= 0) return {length(x, x_), length(y, y_), std::ldexp(w, w_.exponent)};
  int bits = 0;
  std::frexp(w, &bits);
  const double inverse = reciprocal_of(std::ldexp(w, 32 - bits));  // 2^(62 - 32 + bits) / w
  const auto divided = [&](double value) { return std::ldexp(std::floor(std::ldexp(value * inverse, -32)), 2 - bits); };
  const double distance = std::ldexp(1 / inverse, 30 + bits + w_.exponent);
  // Converts the product back to a length on the screen, at the distance whose reciprocal was used.
  const auto back = [&](double value, const Form& form) {
    return std::ldexp(divided(value) / mantissa_, form.exponent - w_.exponent) * distance;
  };
  return {back(x, x_), back(y, y_), distance};
}

double stepped(const std::array<std::array<double, 2>, 3>& at, const std::array<double, 3>& value, double x, double y) {
  const double ax = at[1][0] - at[0][0], ay = at[1][1] - at[0][1], bx = at[2][0] - at[0][0], by = at[2][1] - at[0][1];
  const double area = ax * by - bx * ay, a = value[1] - value[0], b = value[2] - value[0];
  const auto rounded = [](double gradient) { return std::floor(gradient * 65536 + 0.5) / 65536; };
  return value[0] + rounded((a * by - b * ay) / area) * (x - at[0][0]) +
         rounded((b * ax - a * bx) / area) * (y - at[0][1]);
}

std::array<float, 3> shown(const View& picture, const Vector& rgb, ColourKind kind, std::uint32_t x, std::uint32_t y) {
  constexpr std::array<unsigned, 3> kBits{5, 6, 5};
  const bool narrow = picture.format == PixelFormat::gray4 || picture.format == PixelFormat::mono;
  const bool dithered = picture.dither && !narrow && (kind == ColourKind::gradient || kind == ColourKind::lit_texel);
  std::array<unsigned, 3> eight{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double clamped = std::clamp(rgb[c], 0.0, 255.0);
    const unsigned most = (1U << kBits[c]) - 1;
    const bool nearest = kind == ColourKind::lit_texel && !dithered;
    const unsigned level = nearest
                               ? static_cast<unsigned>(std::floor(clamped * most / 255 + 0.5))
                               : with_bits(static_cast<unsigned>(std::floor(clamped + 0.5)), kBits[c], dithered, x, y);
    eight[c] = level << (8 - kBits[c]) | level >> (2 * kBits[c] - 8);
  }
  if (narrow) {
    const unsigned grey = (77 * eight[0] + 150 * eight[1] + 29 * eight[2] + 128) >> 8;
    const bool mono = picture.format == PixelFormat::mono;
    const unsigned level = with_bits(grey, mono ? 1 : 4, picture.dither, x, y);
    eight.fill(mono ? 255 * level : 17 * level);
  }
  return {static_cast<float>(eight[0]), static_cast<float>(eight[1]), static_cast<float>(eight[2])};
}

}  // namespace zstrip::sim::truth
