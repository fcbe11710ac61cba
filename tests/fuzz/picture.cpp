// Draws whole pictures through the public interface; see picture.hpp.
#include "picture.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "require.hpp"

namespace fuzz {
namespace {

using namespace zstrip;

/// No more than this is allocated for a plan that nobody planned.
constexpr std::uint32_t kMaxArena = 1U << 20;

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

void require_sound_bounds(Frame frame) {
  const Rect& bounds = frame.bounds();
  require(bounds.empty() || (bounds.left >= 0 && bounds.top >= 0 && bounds.right <= frame.view().width &&
                             bounds.bottom <= frame.view().height),
          "bounds lie inside the view: %d,%d..%d,%d", bounds.left, bounds.top, bounds.right, bounds.bottom);
}

/// `pixels` of the strip drawn last, RGB565.
void require_sound_depth(Frame frame, const Scene& scene, std::span<const std::byte> pixels, const Rect& strip) {
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

/// A renderer that checks what is promised of each call.
class CheckedRenderer {
 public:
  CheckedRenderer(Effects effects, std::uint8_t garbage) : renderer_(effects), garbage_(garbage) {}

  auto frame() const { return renderer_.frame(); }

  Status begin_frame(const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                     std::span<std::byte> arena) {
    scene_ = &scene;
    require(arena.empty() || !renderer_.begin_frame(scene, camera, view, plan, arena.first(arena.size() - 1)),
            "an arena needs all of its bytes");
    require_nothing_drawn(view);
    const Status begun = renderer_.begin_frame(scene, camera, view, plan, arena);
    if (begun) {
      require_sound_bounds(renderer_.frame());
    } else {
      require_nothing_drawn(view);
    }
    return begun;
  }

  /// `pixels`: full of garbage, exactly what the strip needs.
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    const View& view = frame().view();
    const Rect area = frame().plan().strip_area(strip, view);
    require(!area.empty() && area.left >= 0 && area.top >= 0 && area.right <= view.width && area.bottom <= view.height,
            "a strip is a part of the picture");
    require(renderer_.draw_strip(strip, pixels.first(pixels.size() - 1)).error == Error::pixels_too_small,
            "a strip needs all of its bytes");
    require(all_equal(pixels, garbage_), "a refused strip leaves the pixels alone");
    const Status status = renderer_.draw_strip(strip, pixels);
    require(static_cast<bool>(status), "after begin_frame every strip can be drawn: %s", message(status.error));
    if (view.format == PixelFormat::rgb565 && frame().has_plain_depth() && scene_->overlay == nullptr)
      require_sound_depth(frame(), *scene_, pixels, area);
    return status;
  }

 private:
  /// A renderer that refused the frame refuses its strips and leaves the pixels alone.
  void require_nothing_drawn(const View& view) {
    std::vector<std::byte> pixels = picture::lent(bytes_per_row(view.width, view.format), garbage_);
    require(renderer_.draw_strip(0, pixels).error == Error::not_begun, "a refused frame draws nothing");
    require(all_equal(pixels, garbage_), "a refused frame leaves the pixels alone");
  }

  AnyRenderer renderer_;
  std::uint8_t garbage_;
  const Scene* scene_ = nullptr;
};

}  // namespace

Picture draw(const Scene& scene, const Camera& camera, const View& view, const Request& request) {
  const PlanResult planned = plan(count(scene), view, request.effects, request.budget);
  if (!planned.status) return {planned.status, {}, {}, {}};
  const Plan tampered = with_surplus(planned.plan, request.surplus);
  if (tampered.bytes() > kMaxArena) {
    return {{.error = Error::arena_too_small, .needed = tampered.bytes(), .available = kMaxArena}, {}, {}, {}};
  }
  CheckedRenderer renderer(request.effects, request.garbage);
  return picture::draw(renderer, scene, camera, view, tampered,
                       {.garbage = request.garbage, .last_strip_first = request.last_strip_first});
}

}  // namespace fuzz
