// The functions of Player that do not depend on the pipeline: memory, the plan, motion, the camera, text.
#include "zstrip_player/player.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "zstrip/base/math.hpp"
#include "zstrip/frame.hpp"
#include "zstrip/scene/blob_sections.hpp"
#include "zstrip/state/digest.hpp"
#include "zstrip_player/words.hpp"

namespace zstrip {
namespace {

constexpr std::size_t kAlignment = kArenaAlignment;
static_assert(kSceneBlobMemoryAlignment <= kAlignment && alignof(Instance) <= kAlignment &&
              alignof(Font) <= kAlignment);

static_assert(static_cast<int>(hal::DisplayFormat::rgb565) == static_cast<int>(PixelFormat::rgb565) &&
              static_cast<int>(hal::DisplayFormat::rgb565_swapped) == static_cast<int>(PixelFormat::rgb565_swapped) &&
              static_cast<int>(hal::DisplayFormat::gray4) == static_cast<int>(PixelFormat::gray4) &&
              static_cast<int>(hal::DisplayFormat::mono) == static_cast<int>(PixelFormat::mono) &&
              static_cast<int>(hal::DisplayFormat::rgb666) == static_cast<int>(PixelFormat::rgb666) &&
              static_cast<int>(hal::DisplayFormat::rgb444) == static_cast<int>(PixelFormat::rgb444) &&
              static_cast<int>(hal::DisplayFormat::xrgb8888) == static_cast<int>(PixelFormat::xrgb8888));

constexpr std::uint64_t in_whole_words(std::uint64_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}
constexpr std::uint32_t saturated(std::uint64_t value) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(value, std::numeric_limits<std::uint32_t>::max()));
}

/// Returns one * by + other * by_other, rounded to nearest. Vectors are 2.30 or 16.16, the sine and cosine are 2.30.
Vec3 combined(const Vec3& one, std::int32_t by, const Vec3& other, std::int32_t by_other) {
  const auto sum = [by, by_other](std::int32_t a, std::int32_t b) {
    constexpr std::int64_t kHalf = 1 << 29;
    return static_cast<std::int32_t>((std::int64_t{a} * by + std::int64_t{b} * by_other + kHalf) >> 30);
  };
  return {sum(one.x, other.x), sum(one.y, other.y), sum(one.z, other.z)};
}

/// Returns the distance from the eye, along the camera's axis, to the point of the axis that is closest to the world's
/// y axis; to the point closest to the origin if the axis is nearly upright. 16.16, >= 0.
std::int64_t distance_to_y(const Camera& camera) {
  const auto along = [](std::int32_t a, std::int32_t b) { return (std::int64_t{a} * b) >> 30; };
  const std::int64_t level = along(camera.eye.x, camera.back.x) + along(camera.eye.z, camera.back.z);
  const std::int64_t square = along(camera.back.x, camera.back.x) + along(camera.back.z, camera.back.z);  // 2.30
  constexpr std::int64_t kUpright = (std::int64_t{1} << 30) / 64;
  const std::int64_t distance =
      square > kUpright ? level * (std::int64_t{1} << 30) / square : level + along(camera.eye.y, camera.back.y);
  return std::clamp<std::int64_t>(distance, 0, std::numeric_limits<Fixed>::max());
}

Status pose_blob(const SceneBlob& blob, const PlayedClips& played, std::span<Instance> instances,
                 std::uint32_t& weights) {
  if (!instances.empty()) pose_clips(blob.clips, played.all(), blob.scene.instances, instances);
  const Status posed = pose_clips(blob, played.all());
  detail::Digest digest(1);
  for (const MorphWeight weight : blob.morphs.weights) digest.add(std::int32_t{weight});
  weights = digest.value();
  return posed;
}

std::uint32_t digest_of(const PlayedClips& played) {
  detail::Digest digest(1);
  for (const PlayedClip& each : played.all()) {
    digest.add(each.time);
    digest.add(std::uint32_t{each.clip});
    digest.add(each.share());
  }
  return digest.value();
}

Vec3 about_y(const Vec3& v, std::int32_t sine, std::int32_t cosine) {
  const Vec3 turned = combined({v.x, 0, v.z}, cosine, {v.z, 0, -v.x}, sine);
  return {turned.x, v.y, turned.z};
}

}  // namespace

bool Player::fail(Fault fault, const Status& status) {
  fault_ = fault;
  status_ = status;
  return false;
}

/// Returns the unused memory, from its first aligned byte on.
std::span<std::byte> Player::left() const {
  const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
  const std::size_t first = used_ + (kAlignment - address % kAlignment) % kAlignment;
  return first < memory_.size() ? memory_.subspan(first) : std::span<std::byte>();
}

/// Takes the bytes from the unused memory. Returns an empty span if there are too few.
std::span<std::byte> Player::take(std::uint64_t bytes) {
  const std::span<std::byte> all = left();
  if (bytes > all.size()) return {};
  used_ += std::min<std::size_t>(static_cast<std::size_t>(in_whole_words(bytes)), all.size());
  return all.first(static_cast<std::size_t>(bytes));
}

template <class T>
bool Player::take_table(std::size_t count, std::span<T>& table, Fault fault) {
  const std::uint64_t bytes = std::uint64_t{count} * sizeof(T);
  const std::size_t available = left().size();
  std::byte* const place = take(bytes).data();
  if (count > 0 && place == nullptr) {
    return fail(fault,
                {.error = Error::arena_too_small, .needed = saturated(bytes), .available = saturated(available)});
  }
  for (std::size_t i = 0; i < count; ++i) ::new (place + i * sizeof(T)) T;
  table = {reinterpret_cast<T*>(place), count};
  return true;
}

bool Player::open(const void* blob, std::size_t size) {
  is_open_ = is_fitted_ = has_clock_ = counts_frames_ = false;
  used_ = used_open_ = time_ = event_from_ = 0;
  played_ = {};
  pose_ = nullptr;
  fault_ = Fault::none;
  baked_.clips = {};
  baked_.events = {};
  if (blob == nullptr) return fail(Fault::null_scene);
  const std::span<std::byte> free = left();
  const Status opened = open_scene_blob({static_cast<const std::byte*>(blob), size}, free, baked_);
  if (opened.error == Error::blob_memory) return fail(Fault::scene_memory, opened);
  if (!opened) return fail(Fault::scene, opened);
  take(baked_.memory_bytes);
  checksum_ = static_cast<const blob_layout::Header*>(blob)->checksum;
  if (!baked_.clips.empty() || !baked_.skins.empty() || !baked_.morphs.meshes.empty()) pose_ = &pose_blob;
  used_open_ = used_;
  is_open_ = keeps_tables_ = true;
  return true;
}

bool Player::open(const scenes::AtRest& scene, const View& baked_for, std::span<const ClipEvent> events) {
  is_open_ = is_fitted_ = has_clock_ = counts_frames_ = false;
  used_ = used_open_ = time_ = event_from_ = 0;
  played_ = {};
  pose_ = nullptr;
  fault_ = Fault::none;
  baked_ = {.scene = scene.scene,
            .camera = scene.camera,
            .view = baked_for,
            .animation = scene.animation,
            .turn = scene.turn,
            .events = events,
            .levels = scene.levels};
  is_open_ = true;
  checksum_ = 0;
  keeps_tables_ = false;
  return true;
}

bool Player::plan_strips(const FitOptions& options, std::uint16_t row_step) {
  const std::span<std::byte> free = left();
  const std::uint8_t buffers = options.strip_buffers > 1 ? 2 : 1;
  // Arena and strips begin at whole words.
  const std::uint32_t gaps = static_cast<std::uint32_t>(kAlignment) * (buffers + 1U);
  Budget budget{.bytes = free.size() > gaps ? std::min(saturated(free.size() - gaps), kMaxArena) : 1,
                .strip_rows = std::min(options.strip_rows, view_.height),
                .split_columns = options.split_columns,
                .strip_buffers = buffers};
  const SceneCounts counts = count(baked_.scene);
  const std::uint32_t all_bytes = budget.bytes;
  const auto mask_bytes = [this](const Plan& plan) {
    return masked_ ? std::uint32_t{plan.strip_columns} * plan.strip_rows : 0;
  };
  // The planner does not know the mask: it gets fewer bytes until the mask fits, too.
  const auto plan_all = [&] {
    budget.bytes = all_bytes;
    while (true) {
      PlanResult result = zstrip::plan(counts, view_, drawn_with_.effects, budget);
      const std::uint64_t bytes = std::uint64_t{result.plan.bytes()} +
                                  std::uint64_t{buffers} * result.plan.strip_pixel_bytes(view_) +
                                  mask_bytes(result.plan);
      if (!result.status)
        result.status.needed = saturated(std::uint64_t{result.status.needed} + mask_bytes(result.plan));
      if (!result.status || bytes <= all_bytes) return result;
      budget.bytes -= std::min(saturated(bytes - all_bytes), budget.bytes - 1);
    }
  };
  PlanResult planned = plan_all();
  if (!planned.status && budget.strip_rows != 0) {
    budget.strip_rows = 0;
    planned = plan_all();
  }
  if (row_step > 1 && planned.plan.strip_rows % row_step != 0) {
    const int rows = std::max<int>(row_step, planned.plan.strip_rows / row_step * row_step);
    budget.strip_rows = static_cast<std::uint16_t>(std::min<int>(rows, view_.height));
    planned = plan_all();
  }
  if (!planned.status) {
    if (planned.status.error == Error::arena_too_small) {
      planned.status.needed = saturated(std::uint64_t{planned.status.needed} + gaps);
      planned.status.available = saturated(free.size());
    }
    return fail(Fault::plan, planned.status);
  }
  plan_ = planned.plan;
  arena_ = take(plan_.bytes());
  const std::uint32_t pixels = plan_.strip_pixel_bytes(view_);
  strips_[0] = take(pixels + mask_bytes(plan_)).first(pixels);  // the mask of a strip follows its pixels
  strips_[1] = buffers > 1 ? take(plan_.strip_pixel_bytes(view_)) : std::span<std::byte>();
  return true;
}

/// Does the work of fit() except for beginning a frame, so that its stack is free when the frame begins.
bool Player::prepare(std::uint16_t width, std::uint16_t height, PixelFormat format, const FitOptions& options,
                     std::uint16_t row_step) {
  used_ = used_open_;
  fault_ = Fault::none;
  ++version_;
  was_drawn_ = false;
  if (!is_open_) return fail(Fault::not_open);
  view_ = {width, height, format, baked_.view.dither, baked_.view.samples};
  if (!valid_size_and_format(view_)) return fail(Fault::plan, {.error = Error::view_size});
  if (view_.width * sample_columns(view_) > kMaxViewSize || view_.height * sample_rows(view_) > kMaxViewSize) {
    view_.samples = 1;  // the display has enough pixels without supersampling
  }
  camera_ = scenes::fit_width(baked_.camera_for(2), baked_.view, view_);
  const Effects called_for = effects_of(baked_.scene, camera_) | effects_of(view_) | baked_.effects;
  drawn_with_ = choose_(called_for);
  missing_ = missing_effects(called_for, drawn_with_.effects);
  if (missing_ != Effects{}) return fail(Fault::effects);

  reaches_far_ = called_for.any(effect::shadows | effect::csg | effect::outlines | effect::skins);
  masked_ = options.masked;
  if (masked_ && is_narrow(format)) return fail(Fault::mask_format);
  seen_ = {};
  if (!take_table(options.tracks_changes ? baked_.scene.instances.size() : 0, seen_instances_, Fault::motion_memory)) {
    return false;
  }
  const bool has_tracks = !baked_.animation.tracks.empty();
  const bool turns_instances =
      baked_.turn.what == Turning::instances || baked_.turn.what == Turning::instances_and_lines;
  const bool turns_lines = scenes::turns_lines(baked_.animation, baked_.turn);
  const auto moves_instances = [](const Clip& clip) { return !clip.instances.tracks.empty(); };
  const bool moves = has_tracks || turns_instances || !baked_.levels.empty() ||
                     std::any_of(baked_.clips.begin(), baked_.clips.end(), moves_instances);
  if (!take_table(moves ? baked_.scene.instances.size() : 0, instances_, Fault::motion_memory) ||
      !take_table(turns_lines ? baked_.scene.lines.size() : 0, lines_, Fault::motion_memory)) {
    return false;
  }
  fonts_ = {};
  labels_ = {};
  if (drawn_with_.effects.has(effect::overlay)) {
    const Overlay own = baked_.scene.overlay != nullptr ? *baked_.scene.overlay : Overlay{};
    if (!take_table(own.fonts.size() + 1, fonts_, Fault::text_memory) ||
        !take_table(own.labels.size() + 1, labels_, Fault::text_memory)) {
      return false;
    }
  }
  can_turn_ = scenes::can_turn({baked_.scene, camera_, baked_.animation, baked_.turn});
  state_ = {};
  return plan_strips(options, row_step);
}

bool Player::fit(std::uint16_t width, std::uint16_t height, PixelFormat format, const FitOptions& options,
                 std::uint16_t row_step) {
  is_fitted_ = prepare(width, height, format, options, row_step);
  if (!is_fitted_) return false;
  is_fitted_ = begin();  // reports errors of begin_frame now, not in draw()
  return is_fitted_;
}

std::uint32_t Player::period() const {
  if (!baked_.clips.empty()) return baked_.clips[played_.last().clip].duration();
  return baked_.animation.tracks.empty() ? kTurnTime : std::max<std::uint32_t>(baked_.animation.duration, 1);
}

void Player::seek(std::uint32_t time) {
  if (baked_.clips.empty()) {
    time_ = time % period();
  } else {
    played_.seek(time, baked_.clips);
  }
  event_from_ = this->time();
}

bool Player::poll_event(std::uint16_t& number) {
  const ClipEvent* const event = next_event(baked_.events, clip(), time(), period(), event_from_);
  if (event != nullptr) number = event->number;
  return event != nullptr;
}

std::size_t Player::find_clip(const char* name) const {
  std::size_t found = 0;
  for (; found < baked_.clips.size(); ++found) {
    const char* own = baked_.clips[found].name;
    const char* other = name;
    while (*own != 0 && *own == *other) ++own, ++other;
    if (*own == *other) break;
  }
  return found;
}

bool Player::play_clip(std::size_t clip, std::uint16_t fade, bool loops) {
  fault_ = Fault::none;
  if (!is_open_) return fail(Fault::not_open);
  if (clip >= baked_.clips.size()) return fail(Fault::no_clip, {.needed = saturated(clip)});
  played_.play(static_cast<std::uint16_t>(clip), fade, loops);
  event_from_ = 0;
  return true;
}

void Player::play(std::uint32_t now) {
  if (!has_clock_) now_ = now;
  if (!counts_frames_) {
    second_began_ = now;
    frames_ = 0;
  }
  const std::uint32_t passed = now - now_;
  now_ = now;
  if (!held_ && !baked_.clips.empty()) {
    played_.advance(passed, baked_.clips);
  } else if (!held_) {
    time_ = static_cast<std::uint32_t>((std::uint64_t{time_} + passed) % period());
  }
  const std::uint32_t counted = now - second_began_;
  if (has_rate_ && (!counts_frames_ || counted >= 1000)) {
    detail::Words words(text_, text_size_);
    if (counts_frames_) {
      words << (frames_ * 1000U + counted / 2) / counted << " fps";
    } else {
      words << "- fps";
    }
  }
  if (counted >= 1000) {
    second_began_ = now;
    frames_ = 0;
  }
  has_clock_ = counts_frames_ = true;
}

void Player::show_text(const char* text, bool with_rate, const Font& font) {
  char rate[sizeof text_ - kMaxText];
  std::copy_n(text_ + text_size_, sizeof rate, rate);
  std::size_t size = 0;
  for (; text != nullptr && size < kMaxText && text[size] != 0; ++size) text_[size] = text[size];
  text_[size] = 0;
  text_size_ = static_cast<std::uint8_t>(size);
  if (with_rate && has_rate_) {
    std::copy_n(rate, sizeof rate, text_ + size);
  } else if (with_rate) {
    counts_frames_ = false;
  }
  has_rate_ = with_rate;
  font_ = font;
}

/// Returns the fitted camera, with orbit() and zoom() applied.
Camera Player::placed_camera() const {
  Camera camera = camera_;
  const std::int64_t focal = std::int64_t{camera.focal} * zoom_ / 100;
  camera.focal = static_cast<Fixed>(std::clamp<std::int64_t>(focal, 1, std::numeric_limits<Fixed>::max()));
  if (right_ == 0 && up_ == 0) return camera;
  const std::int64_t distance = distance_to_y(camera);
  const auto shifted = [distance](std::int32_t from, std::int32_t axis, int sign) {
    const std::int64_t at = from + sign * ((distance * axis) >> 30);
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(at, std::numeric_limits<Fixed>::min(), std::numeric_limits<Fixed>::max()));
  };
  const auto moved = [&shifted](const Vec3& from, const Vec3& axis, int sign) {
    return Vec3{shifted(from.x, axis.x, sign), shifted(from.y, axis.y, sign), shifted(from.z, axis.z, sign)};
  };
  const Vec3 target = moved(camera.eye, camera.back, -1);
  const Vec3 back = combined(camera.back, cosine(up_), camera.up, sine(up_));
  const Vec3 up = combined(camera.up, cosine(up_), camera.back, -sine(up_));
  camera.back = about_y(back, sine(right_), cosine(right_));
  camera.up = about_y(up, sine(right_), cosine(right_));
  camera.right = about_y(camera.right, sine(right_), cosine(right_));
  camera.eye = moved(target, camera.back, 1);
  return camera;
}

/// Appends the text to the scene's own overlay, after all elements of the scene.
void Player::add_text() {
  const Overlay own = baked_.scene.overlay != nullptr ? *baked_.scene.overlay : Overlay{};
  const std::size_t fonts = std::min(own.fonts.size(), fonts_.size() - 1);
  const std::size_t labels = std::min(own.labels.size(), labels_.size() - 1);
  std::copy_n(own.fonts.begin(), fonts, fonts_.begin());
  std::copy_n(own.labels.begin(), labels, labels_.begin());
  fonts_[fonts] = font_;
  labels_[labels] = {
      .text = staged_text_, .x = 2, .y = 2, .font = static_cast<std::uint16_t>(fonts), .background = {0, 0, 0, 255}};
  overlay_ = {own.images, fonts_.first(fonts + 1), own.sprites, labels_.first(labels + 1)};
  staged_.scene.overlay = &overlay_;
}

bool Player::stage() {
  const Camera camera = placed_camera();
  staged_ = {baked_.scene, camera};
  std::ranges::copy(text_, staged_text_);
  if (pose_ != nullptr) {
    if (const Status posed = pose_(baked_, played_, instances_, weights_); !posed) return fail(Fault::pose, posed);
    staged_pose_ = digest_of(played_);
  }
  const bool has_tracks = !baked_.animation.tracks.empty();
  if (!baked_.clips.empty()) {
    if (!instances_.empty()) staged_.scene.instances = instances_;
  } else if (time_ != 0 || has_tracks) {
    const bool camera_turns = !has_tracks && baked_.turn.what == Turning::camera;
    if (!can_turn_ || (camera_turns && !scenes::can_turn(camera))) return fail(Fault::turn);
    staged_ = scenes::stage({baked_.scene, camera, baked_.animation, baked_.turn}, time_, period(),
                            {.instances = instances_, .lines = lines_});
  }
  scenes::choose_levels(baked_.levels, baked_.scene, instances_, staged_);
  if (has_background_) staged_.scene.background = background_;
  if (staged_text_[0] == 0) return true;
  missing_ = effect::overlay;
  if (labels_.empty()) return fail(Fault::effects);
  add_text();
  return true;
}

bool Player::begin() {
  fault_ = Fault::none;
  if (!is_open_) return fail(Fault::not_open);
  if (!is_fitted_) return fail(Fault::not_fitted);
  // The frame before refers to what stage() changes, so that after a fault there is none.
  state_.scene = nullptr;
  kept_strip_ = kNoStrip;
  if (!stage()) return false;
  if (!keeps_tables_) ++version_;
  const Status begun = drawn_with_.pipeline.begin_frame(state_, staged_.scene, staged_.camera, view_, plan_, arena_);
  return begun || fail(Fault::frame, begun);
}

/// Returns false for the first frame since fit() of a scene whose tables may change: the frame before may be that of
/// another player, with the same version.
bool Player::knows_tables() {
  const bool was_drawn = was_drawn_;
  was_drawn_ = true;
  return was_drawn || keeps_tables_;
}

/// Returns a version for fingerprints, which do not read tables. It differs for other bytes at the address of a blob,
/// for tables that another player may have drawn before they changed, and for other effects.
std::uint32_t Player::tables_version() const {
  detail::Digest digest(checksum_);
  digest.add(version_);
  digest.add(weights_);
  if (!keeps_tables_) digest.add(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(this)));
  digest.add(static_cast<std::int64_t>(drawn_with_.effects.bits));
  return digest.value();
}

bool Player::pick(ChoosePick choose, std::uint16_t x, std::uint16_t y, Picked& picked) {
  picked = {};
  fault_ = Fault::none;
  if (choose == nullptr) return fail(Fault::null_pick);
  if (!is_open_) return fail(Fault::not_open);
  if (!is_fitted_) return fail(Fault::not_fitted);
  const PickFunction function = choose(drawn_with_.effects);
  if (function == nullptr) return fail(Fault::pick_effects);
  const Status found = function(Frame(state_), x, y, picked);
  return found || fail(Fault::pick, found);
}

bool Player::begin_on(std::uint16_t width, std::uint16_t height, PixelFormat format) {
  if (is_fitted_ && (width != view_.width || height != view_.height || format != view_.format)) {
    return fail(Fault::other_display);
  }
  return begin();
}

bool Player::end(const Status& drawn, hal::Error shown) {
  display_error_ = shown;
  if (!drawn) return fail(Fault::strip, drawn);
  if (shown != hal::Error::none) return fail(Fault::display);
  ++frames_;
  return true;
}

}  // namespace zstrip
