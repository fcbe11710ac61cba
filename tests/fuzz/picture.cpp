// Draws whole pictures through the public interface; see picture.hpp.
#include "picture.hpp"

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

#include "require.hpp"

namespace fuzz {
namespace {

using namespace zstrip;

/// Heap memory of exactly this size, so that AddressSanitizer sees the first byte beyond it.
struct Buffer {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t size;

  Buffer(std::size_t size_in_bytes, std::uint8_t garbage)
      : bytes(std::make_unique<std::byte[]>(size_in_bytes)), size(size_in_bytes) {
    std::memset(bytes.get(), garbage, size);
  }
  std::span<std::byte> span() const { return {bytes.get(), size}; }
};

/// No more than this is allocated for a plan that nobody planned.
constexpr std::uint32_t kLargestArena = 1U << 20;

Plan with_surplus(Plan plan, const std::array<std::uint32_t, 5>& surplus) {
  plan.instance_bytes += surplus[0];
  plan.extent_bytes += surplus[0];
  plan.vertex_bytes += surplus[1];
  plan.depth_bytes += surplus[2];
  plan.colour_bytes += surplus[3];
  plan.bin_bytes += surplus[4];
  return plan;
}

bool all_equal(std::span<const std::byte> bytes, std::uint8_t value) {
  return std::all_of(bytes.begin(), bytes.end(), [value](std::byte b) { return b == std::byte{value}; });
}

std::uint16_t pixel_at(std::span<const std::byte> pixels, std::size_t index) {
  std::uint16_t pixel = 0;
  std::memcpy(&pixel, pixels.data() + 2 * index, 2);
  return pixel;
}

std::uint16_t rgb565_of(const Colour& colour) {
  return static_cast<std::uint16_t>(colour.r / 8 * 2048 + colour.g / 4 * 32 + colour.b / 8);
}

/// A renderer that refused the frame refuses its strips and leaves the pixels alone.
void require_nothing_drawn(AnyRenderer& renderer, const View& view, std::uint8_t garbage) {
  const Buffer pixels(bytes_per_row(view.width, view.format), garbage);
  require(renderer.draw_strip(0, pixels.span()).error == Error::not_begun, "a refused frame draws nothing");
  require(all_equal(pixels.span(), garbage), "a refused frame leaves the pixels alone");
}

void require_sound_bounds(const Frame& frame) {
  const Rect& bounds = frame.bounds();
  require(bounds.empty() || (bounds.left >= 0 && bounds.top >= 0 && bounds.right <= frame.view().width &&
                             bounds.bottom <= frame.view().height),
          "bounds lie inside the view: %d,%d..%d,%d", bounds.left, bounds.top, bounds.right, bounds.bottom);
}

/// `pixels` of the strip drawn last, RGB565.
void require_sound_depth(const Frame& frame, const Scene& scene, std::span<const std::byte> pixels, const Rect& strip) {
  const Rect& area = frame.depth_area();
  const std::uint16_t background = rgb565_of(scene.background);
  for (std::int32_t row = strip.top; row < strip.bottom; ++row) {
    for (std::int32_t x = strip.left; x < strip.right; ++x) {
      const bool inside = x >= area.left && x < area.right && row >= area.top && row < area.bottom;
      const std::uint16_t code =
          inside ? frame.depth()[(row - area.top) * area.width() + (x - area.left)] : std::uint16_t{0};
      require(code <= 65534, "depth codes end at 65534: pixel %d,%d", x, row);
      const auto index = static_cast<std::size_t>((row - strip.top) * strip.width() + x - strip.left);
      require(code != 0 || pixel_at(pixels, index) == background, "undrawn pixels are background: %d,%d", x, row);
    }
  }
}

void draw_strip(AnyRenderer& renderer, const Scene& scene, std::uint16_t strip, std::uint8_t garbage,
                std::span<std::byte> picture) {
  const View& view = renderer.frame().view();
  const Rect area = renderer.frame().plan().strip_area(strip, view);
  require(!area.empty() && area.left >= 0 && area.top >= 0 && area.right <= view.width && area.bottom <= view.height,
          "a strip is a part of the picture");
  const std::size_t row_bytes = bytes_per_row(static_cast<std::uint16_t>(area.width()), view.format);
  const std::size_t bytes = static_cast<std::size_t>(area.height()) * row_bytes;
  const Buffer pixels(bytes, garbage);
  require(renderer.draw_strip(strip, pixels.span().first(bytes - 1)).error == Error::pixels_too_small,
          "a strip needs all of its bytes");
  require(all_equal(pixels.span(), garbage), "a refused strip leaves the pixels alone");
  const Status status = renderer.draw_strip(strip, pixels.span());
  require(static_cast<bool>(status), "after begin_frame every strip can be drawn: %s", message(status.error));
  if (view.format == PixelFormat::rgb565 && renderer.frame().has_plain_depth())
    require_sound_depth(renderer.frame(), scene, pixels.span(), area);
  const std::size_t picture_row = bytes_per_row(view.width, view.format);
  const std::size_t left = bytes_per_row(static_cast<std::uint16_t>(area.left), view.format);
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    std::copy_n(pixels.bytes.get() + static_cast<std::size_t>(y - area.top) * row_bytes, row_bytes,
                picture.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(y) * picture_row + left));
  }
}

}  // namespace

Picture draw(const Scene& scene, const Camera& camera, const View& view, const Request& request) {
  Picture picture{};
  const PlanResult planned = plan(count(scene), view, request.effects, request.budget);
  picture.status = planned.status;
  if (!picture.status) return picture;
  const Plan tampered = with_surplus(planned.plan, request.surplus);
  if (tampered.bytes() > kLargestArena) {
    picture.status = {.error = Error::arena_too_small, .needed = tampered.bytes(), .available = kLargestArena};
    return picture;
  }

  AnyRenderer renderer(request.effects);
  const Buffer arena(tampered.bytes(), request.garbage);
  require(
      arena.size == 0 ||
          renderer.begin_frame(scene, camera, view, tampered, arena.span().first(arena.size - 1)).error != Error::none,
      "an arena needs all of its bytes");
  require_nothing_drawn(renderer, view, request.garbage);
  picture.status = renderer.begin_frame(scene, camera, view, tampered, arena.span());
  if (!picture.status) {
    require_nothing_drawn(renderer, view, request.garbage);
    return picture;
  }
  require_sound_bounds(renderer.frame());
  picture.bounds = renderer.frame().bounds();
  picture.pixels.resize(std::size_t{view.height} * bytes_per_row(view.width, view.format));
  const std::uint16_t strips = tampered.strips;
  for (std::uint16_t i = 0; i < strips; ++i) {
    const auto strip = static_cast<std::uint16_t>(request.last_strip_first ? strips - 1 - i : i);
    draw_strip(renderer, scene, strip, request.garbage, picture.pixels);
  }
  picture.statistics = renderer.frame().statistics();
  return picture;
}

}  // namespace fuzz
