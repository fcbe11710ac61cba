// Keeps, marks and restores tiles; see layer.hpp.
#include "zstrip/layer.hpp"

#include <algorithm>

namespace zstrip {

Status StaticLayer::reset(const Memory& memory, const View& view) {
  width_ = height_ = 0;
  last_ = pending_ = {};
  depth_ = {};
  colour_ = {};
  dirty_ = {};
  if (const Status status = depth_.reset(memory.depth, view.width, view.height); !status) return status;
  if (const Status status = colour_.reset(memory.colour, view.width, view.height); !status) return status;
  if (const Status status = dirty_.reset(memory.dirty, view.width, view.height); !status) return status;
  width_ = view.width;
  height_ = view.height;
  invalidate();
  return {};
}

bool StaticLayer::between_tiles(const Rect& area) const {
  const auto at_tile = [](std::int32_t coordinate, std::int32_t end) {
    return coordinate % static_cast<std::int32_t>(kTileSide) == 0 || coordinate == end;
  };
  return !area.empty() && area.left >= 0 && area.top >= 0 && area.right <= width_ && area.bottom <= height_ &&
         at_tile(area.left, width_) && at_tile(area.top, height_) && at_tile(area.right, width_) &&
         at_tile(area.bottom, height_);
}

Status StaticLayer::keep(Frame frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if (strip >= frame.plan().strips)
    return {.error = Error::strip_rows, .needed = strip, .available = frame.plan().strips};
  if (!frame.drew_last(strip)) return {.error = Error::not_begun};
  if (!frame.has_plain_depth()) return {.error = Error::depth_effects};
  const Rect area = frame.plan().strip_area(strip, frame.view());
  if (frame.view().width != width_ || frame.view().height != height_ || !between_tiles(area) ||
      frame.view().format != PixelFormat::rgb565) {
    return {.error = Error::store_range};
  }
  const auto stride = static_cast<std::uint32_t>(area.width());
  const std::uint32_t needed = 2 * stride * static_cast<std::uint32_t>(area.height());
  if (pixels.size() < needed) {
    return {.error = Error::pixels_too_small, .needed = needed, .available = static_cast<std::uint32_t>(pixels.size())};
  }
  if (reinterpret_cast<std::uintptr_t>(pixels.data()) % 2 != 0) return {.error = Error::pixels_misaligned};
  dirty_.mark(area);
  const auto* const colour = reinterpret_cast<const std::uint16_t*>(pixels.data());
  const Rect& covered = frame.depth_area();
  constexpr auto kSide = static_cast<std::int32_t>(kTileSide);
  for (std::int32_t top = area.top; top < area.bottom; top += kSide) {
    for (std::int32_t left = area.left; left < area.right; left += kSide) {
      const auto tx = static_cast<std::uint32_t>(left) / kTileSide;
      const auto ty = static_cast<std::uint32_t>(top) / kTileSide;
      // The frame has depth only inside its bounds; elsewhere it is cleared.
      std::uint16_t depth[kTileCells] = {};
      const Rect part = Rect{left, top, left + kSide, top + kSide}.cut_to(covered);
      for (std::int32_t y = part.top; y < part.bottom; ++y) {
        for (std::int32_t x = part.left; x < part.right; ++x) {
          depth[(y - top) * kSide + (x - left)] =
              frame.depth()[(y - covered.top) * covered.width() + (x - covered.left)];
        }
      }
      if (const Status status = depth_.write_tile(tx, ty, depth, kTileSide); !status) return status;
      const std::uint16_t* const from =
          colour + static_cast<std::uint32_t>(top - area.top) * stride + static_cast<std::uint32_t>(left - area.left);
      if (const Status status = colour_.write_tile(tx, ty, from, stride); !status) return status;
    }
  }
  return {};
}

void StaticLayer::move_to(const Rect& bounds) {
  dirty_.mark(pending_);
  pending_ = {};
  dirty_.mark(last_);
  dirty_.mark(bounds);
  last_ = bounds;
}

void StaticLayer::invalidate() {
  pending_ = {};
  dirty_.mark({0, 0, width_, height_});
}

bool StaticLayer::next(Rect& area, std::uint32_t cells) {
  if (pending_.empty() && !dirty_.take(pending_)) return false;
  // The rectangle has as many columns as fit in one row of tiles, and then as many rows of tiles as fit.
  constexpr auto kSide = static_cast<std::int32_t>(kTileSide);
  cells = std::min(cells, std::uint32_t{kMaxViewSize} * kMaxViewSize);
  const auto fitting = static_cast<std::int32_t>(cells / kTileSide) / kSide * kSide;
  area = pending_;
  if (area.width() > fitting) {
    area.right = area.left + std::max(fitting, kSide);
    area.bottom = std::min(area.top + kSide, area.bottom);
    // The rest of this row of tiles is returned next; the rows below are marked again.
    dirty_.mark({pending_.left, area.bottom, pending_.right, pending_.bottom});
    pending_ = {area.right, area.top, pending_.right, area.bottom};
    return true;
  }
  const auto rows = static_cast<std::int32_t>(cells / static_cast<std::uint32_t>(area.width())) / kSide * kSide;
  area.bottom = std::min(area.top + std::max(rows, kSide), pending_.bottom);
  pending_.top = area.bottom;
  return true;
}

Status StaticLayer::restore(const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) const {
  if (!between_tiles(area)) return {.error = Error::store_range};
  const auto stride = static_cast<std::uint32_t>(area.width());
  const std::size_t cells = std::size_t{stride} * static_cast<std::size_t>(area.height());
  if (pixels.size() < cells || depth.size() < cells) {
    return {.error = Error::pixels_too_small,
            .needed = static_cast<std::uint32_t>(2 * cells),
            .available = static_cast<std::uint32_t>(2 * std::min(pixels.size(), depth.size()))};
  }
  constexpr auto kSide = static_cast<std::int32_t>(kTileSide);
  for (std::int32_t top = area.top; top < area.bottom; top += kSide) {
    for (std::int32_t left = area.left; left < area.right; left += kSide) {
      const auto tx = static_cast<std::uint32_t>(left) / kTileSide;
      const auto ty = static_cast<std::uint32_t>(top) / kTileSide;
      const std::uint32_t first =
          static_cast<std::uint32_t>(top - area.top) * stride + static_cast<std::uint32_t>(left - area.left);
      if (const Status status = depth_.read_tile(tx, ty, depth.data() + first, stride); !status) return status;
      if (const Status status = colour_.read_tile(tx, ty, pixels.data() + first, stride); !status) return status;
    }
  }
  return {};
}

}  // namespace zstrip
