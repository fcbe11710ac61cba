// A baked scene on a display in four calls: open, fit, play, draw. It uses the exact interface, zstrip/zstrip.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/blob.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip/frame/begin_frame.hpp"
#include "zstrip/frame/picked.hpp"
#include "zstrip/frame/pipeline.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/plan.hpp"
#include "zstrip_hal/present.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip {

/// A pipeline, and the effects that it draws.
struct DrawnWith {
  Effects effects;    ///< the required effects and those that the pipeline has in addition
  Pipeline pipeline;  ///< its functions
};

/// A function that returns the pipeline for the effects that a scene and its picture need.
using ChoosePipeline = DrawnWith (*)(Effects called_for);

/// Always returns this one pipeline, whatever the scene needs: on a board, pass kEffects of the baked header. With
/// effect::overlay the player can show text. any_player.hpp has the alternative.
template <Effects effects>
DrawnWith drawn_with(Effects) {
  return {effects, {&detail::begin_frame<effects>, &detail::draw_strip<effects>, nullptr}};
}

/// A function that returns the function `pick` for frames of a pipeline with the effects `drawn`, or null if it has
/// none: pick_with of pick_with.hpp, or pick_with_any.
using ChoosePick = PickFunction (*)(Effects drawn);

/// Properties of a display that its size and format do not show.
struct FitOptions {
  std::uint8_t strip_buffers = 1;  ///< 1 or 2; two for displays that send one while another is drawn
  bool split_columns = false;      ///< strips may be narrower than the picture
  /// Rows of a strip, if a plan with so many fits; 0: the planner decides. With two buffers, more strips than the
  /// fastest number may still save time: the bus has less to send before the first strip is drawn and after the last
  /// one.
  std::uint16_t strip_rows = 0;
  bool masked = false;          ///< strips have a mask: a byte more for each pixel of a strip
  bool tracks_changes = false;  ///< changed() knows single instances: 12 bytes more for each instance
};

/// A strip of a frame.
struct DrawnStrip {
  Rect area;                             ///< pixels of the picture
  std::span<const std::byte> pixels;     ///< rows without gaps, in the view's format
  std::span<const std::uint8_t> mask{};  ///< a byte a pixel, directly after `pixels`; empty unless FitOptions::masked
};

/// After a fault a call returns false, and error() says why; the next call may try again. `memory` holds all data that
/// is not constant: tables of a blob, moving parts, the arena, strips of pixels. It must outlive the player; it may
/// have any address.
class Player {
 public:
  /// Does not access the memory before the first call.
  constexpr Player(std::span<std::byte> memory, ChoosePipeline choose) : memory_(memory), choose_(choose) {}
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;

  /// 1. Opens a scene blob (`zstrip bake MODEL -o scene.zsc`), in place, at a multiple of 4. Any bytes are safe.
  bool open(const void* blob, std::size_t size);
  /// Or opens the constants of a baked header. The animation of other constants must have passed validate():
  ///     open({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, baked::kView)
  /// `events`: of the animation, each before its end: baked::kEvents, if the header has them. They must outlive the
  /// player.
  bool open(const scenes::AtRest& scene, const View& baked_for, std::span<const ClipEvent> events = {});
  /// Promises, for constants that were opened, that no data changes to which their meshes, textures, fonts and images
  /// refer; pose_skins() of a baked header would change them. Then draw() leaves out strips that the display shows
  /// already, if it remembers strips (ChangedTiles). Of a blob this is always true.
  void keep_tables() { keeps_tables_ = true; }

  /// 2. Fits the camera to the display and the plan to the memory. Call it again for another display.
  template <hal::Display Panel>
  bool fit(const Panel& panel, const FitOptions& options = {}) {
    std::uint16_t row_step = 1;
    if constexpr (requires { Panel::kRowStep; }) row_step = Panel::kRowStep;
    return fit(panel.width(), panel.height(), static_cast<PixelFormat>(panel.format()), options, row_step);
  }
  /// Does the same for a display of this size and format. The number of rows in a strip is a multiple of `row_step`.
  bool fit(std::uint16_t width, std::uint16_t height, PixelFormat format, const FitOptions& options = {},
           std::uint16_t row_step = 1);

  /// 3. Sets the time, in milliseconds of any clock. After the first call the scene's animation runs, and frames are
  /// counted for show_text. A scene without an animation rotates by 360 degrees in kTurnTime. Of a blob with clips the
  /// first one plays, over and over.
  void play(std::uint32_t now);
  static constexpr std::uint32_t kTurnTime = 8192;  ///< milliseconds
  /// Pauses the motion, or continues it.
  void hold(bool held) { held_ = held; }
  /// Sets the motion to a time, in milliseconds from its beginning. A fade ends.
  void seek(std::uint32_t time);
  /// Returns the milliseconds since the beginning of the motion, less than period().
  std::uint32_t time() const { return baked_.clips.empty() ? time_ : played_.last().time; }
  /// Returns the duration of the open scene's motion in milliseconds, at least 1.
  std::uint32_t period() const;

  /// Returns the clips of the open blob: named animations, with skins. Headers have none.
  std::span<const Clip> clips() const { return baked_.clips; }
  /// Returns the number of the first clip of this name; clips().size() if there is none.
  std::size_t find_clip(const char* name) const;
  /// Plays a clip from its beginning. During `fade` milliseconds the clips that play go on and become this one, as by
  /// blend() of zstrip/skin.hpp; up to four clips at once. A clip that does not loop stops at its end.
  bool play_clip(std::size_t clip, std::uint16_t fade = 0, bool loops = true);
  /// Finds the next event of the clip that was chosen last, or of the motion of a blob without clips, that play() has
  /// reached since the call before. Returns false if there is none. Call it after play() until it returns false:
  ///     for (std::uint16_t number; player.poll_event(number);) play_sound(number);
  bool poll_event(std::uint16_t& number);
  /// Returns the number of the clip that was chosen last; 0 before play_clip.
  std::uint16_t clip() const { return played_.last().clip; }

  /// Moves the camera around the point of its axis that is closest to the world's y axis: to the right, and up. 65536
  /// is 360 degrees; 0, 0 is the baked position.
  void orbit(Angle right, Angle up) { right_ = right, up_ = up; }
  /// Enlarges the picture by its focal length. 100 is the baked size.
  void zoom(std::uint16_t percent) { zoom_ = percent; }

  /// Shows text in the upper left corner, from the next frame on: the first 24 bytes of `text`, none if it is null;
  /// with `with_rate` also the number of frames drawn in the last second. Needs effect::overlay.
  void show_text(const char* text, bool with_rate = false, const Font& font = kSmallFont);

  /// 4. Draws a frame on a display with the size and format that were fitted.
  template <hal::Display Panel>
  bool draw(Panel& panel) {
    if (!begin_on(panel.width(), panel.height(), static_cast<PixelFormat>(panel.format()))) return false;
    Strips strips{*this};
    // Methods may keep something for the next frame.
    if constexpr (hal::RemembersStrips<Panel>) {
      if (drawn_with_.effects.methods == 0 && knows_tables()) {
        KnownStrips<Panel::kStrips> known{{*this}, {Frame(state_), staged_.camera, tables_version()}};
        return present(known, panel);
      }
    }
    return present(strips, panel);
  }
  /// Or passes each strip to `take(area, pixels)`, which returns false to end the frame.
  template <class Take>
  bool draw_strips(Take&& take) {
    if (!begin()) return false;
    for (std::uint16_t i = 0; i < plan_.strips; ++i) {
      const Rect area = plan_.strip_area(i, view_);
      const auto width = static_cast<std::uint16_t>(area.width());
      const std::span<std::byte> pixels =
          strip(0).first(static_cast<std::size_t>(area.height()) * bytes_per_row(width, view_.format));
      if (const Status drawn = draw_into(i, strip(0)); !drawn) return end(drawn, {});
      if (!take(area, std::span<const std::byte>(pixels))) return fail(Fault::not_taken);
    }
    return end({}, {});
  }

  /// Begins a frame at the time and from the place that were set last, for the next three functions and for pick. After
  /// a fault there is none for them.
  bool begin();
  /// Draws a strip of the frame that was begun last. `drawn` is valid until the next call that draws or begins. The
  /// strip that was drawn last is not drawn again. A byte of the mask is 255 where something was drawn, also partly,
  /// and 0 where only the background is seen. It is exact for opaque surfaces that write depth of 16 bits, in scenes
  /// without shadows. Any other surface, a sprite or a label of exactly the background's colour is not in it. In
  /// dithered scenes with fog only those opaque surfaces are in it; without such depth all pixels are.
  bool draw_strip(std::uint16_t number, DrawnStrip& drawn);
  /// Draws the pixels of `area` of the frame that was begun last: those of the whole picture, in the view's format. An
  /// empty `area`, as changed() returns if nothing changed, is an error.
  /// `pixels`: the upper left pixel of `area`; its rows are `stride` bytes apart, and each starts at a byte. `mask`:
  /// its bytes, `mask_stride` apart, if it is not empty. Nothing between the rows is written.
  bool draw_area(const Rect& area, std::span<std::byte> pixels, std::size_t stride, std::span<std::uint8_t> mask = {},
                 std::size_t mask_stride = 0);
  /// Returns a rectangle of the picture outside of which the frame that was begun last has the pixels of the frame that
  /// was begun when changed() was called before; empty if nothing changed; the whole picture after fit. It is found
  /// from places of instances, without drawing. With FitOptions::tracks_changes it is that of the instances that moved,
  /// unless the camera or the depth range changed, or the scene has shadows, outlines, CSG or skins. What the
  /// program itself changes in a scene in RAM, except places of instances and lines and the background, is not seen.
  Rect changed();

  /// Replaces the background of the scene, from the next frame on.
  void background(const Colour& colour) {
    background_ = colour;
    has_background_ = true;
  }
  /// Shows the background of the scene again.
  void baked_background() { has_background_ = false; }

  /// Finds the surface that pixel (x, y) shows in the frame that fit or a draw began last (zstrip/pick.hpp). `choose`:
  /// pick_with<effects> for drawn_with<effects>, pick_with_any for drawn_with_any. Labels after those of the scene are
  /// the player's text. Programs that do not call it do not link it.
  bool pick(ChoosePick choose, std::uint16_t x, std::uint16_t y, Picked& picked);

  /// Returns a message about the fault of the last call that returned a bool, valid until error() is called again; ""
  /// if there was none. A program that calls this function links all messages, 7 KB of flash.
  const char* error();

  /// Returns the view that was fitted last.
  const View& view() const { return view_; }
  /// Returns the plan that was fitted last.
  const Plan& plan() const { return plan_; }

 protected:
  /// Faults of the last call; the C functions add their own. error() has the messages.
  enum class Fault : std::uint8_t {
    none,
    null_scene,
    null_take,
    not_open,
    not_fitted,
    scene,
    scene_memory,
    motion_memory,
    text_memory,
    effects,
    plan,
    turn,
    frame,
    strip,
    other_display,
    display,
    not_taken,
    null_pick,
    pick_effects,
    pick,
    mask_format,
    no_mask,
    area,
    no_clip,
    pose,
  };
  /// Stores the fault for error(), and returns false.
  bool fail(Fault fault, const Status& status = {});

 private:
  struct Strips {
    Player& player;
    Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) { return player.draw_into(strip, pixels); }
  };
  /// An instance as changed() saw it last: a digest of its place, and its rectangle of the picture.
  struct SeenInstance {
    std::uint32_t place;
    std::uint16_t left, top, right, bottom;
  };
  /// The rest of the frame that changed() saw last.
  struct SeenFrame {
    bool is_known = false;
    std::uint32_t picture = 0;  ///< a digest of background and text, on which every pixel depends
    std::uint32_t scene = 0;    ///< a digest of camera, depth range and lines, on which the pixels of `bounds` depend
    Rect bounds{};
  };
  template <std::size_t strips>
  struct KnownStrips : Strips {
    StripFingerprints<strips> fingerprints;
    std::uint32_t fingerprint(std::uint16_t strip) const { return fingerprints[strip]; }
  };
  template <class Drawn, hal::Display Panel>
  bool present(Drawn& strips, Panel& panel) {
    const auto shown =
        hal::present(strips, panel, {plan_.strips, plan_.strip_rows, plan_.strip_columns}, {strip(0), strip(1)});
    return end(shown.draw, shown.display);
  }

  bool knows_tables();
  std::uint32_t tables_version() const;
  Status draw_into(std::uint16_t strip, std::span<std::byte> pixels) {
    kept_strip_ = kNoStrip;
    return drawn_with_.pipeline.draw_strip(state_, strip, pixels);
  }
  std::span<std::byte> strip(std::size_t i) const { return strips_[i]; }
  std::span<std::byte> left() const;
  std::span<std::byte> take(std::uint64_t bytes);
  template <class T>
  bool take_table(std::size_t count, std::span<T>& table, Fault fault);
  bool prepare(std::uint16_t width, std::uint16_t height, PixelFormat format, const FitOptions& options,
               std::uint16_t row_step);
  bool plan_strips(const FitOptions& options, std::uint16_t row_step);
  Camera placed_camera() const;
  bool stage();
  void add_text();
  void mask_strip(const Rect& area, const std::byte* pixels, std::uint8_t* mask) const;
  Rect rectangle_of(std::size_t instance) const;
  bool begin_on(std::uint16_t width, std::uint16_t height, PixelFormat format);
  bool end(const Status& drawn, hal::Error shown);

  std::span<std::byte> memory_;
  ChoosePipeline choose_;
  std::size_t used_ = 0;       ///< bytes of memory_, from its start
  std::size_t used_open_ = 0;  ///< bytes of memory_ that the open scene uses
  SceneBlob baked_{};          ///< the open scene
  PlayedClips played_{};       ///< of baked_.clips
  /// Moves skins, morph targets and instances by the clips that play, and sets a digest of the weights. Null for scenes
  /// that have none of these, so that programs with headers do not link it.
  Status (*pose_)(const SceneBlob& blob, const PlayedClips& played, std::span<Instance> instances,
                  std::uint32_t& weights) = nullptr;
  bool is_open_ = false, is_fitted_ = false, can_turn_ = false, keeps_tables_ = false;
  bool was_drawn_ = false;  ///< since fit(), on a display that remembers strips

  std::uint32_t checksum_ = 0;  ///< of the open blob; 0: constants are open
  std::uint32_t weights_ = 0;   ///< a digest of the weights of morph targets, of the frame that was begun last
  std::uint32_t version_ = 0;   ///< grows with each fit(), and where tables change with each frame
  DrawnWith drawn_with_{};
  detail::MethodFrameState state_{};
  View view_{};
  Plan plan_{};
  Camera camera_{};  ///< the baked camera, fitted
  std::span<std::byte> arena_{}, strips_[2]{};
  std::span<Instance> instances_{};
  std::span<LineSet> lines_{};
  scenes::BakedFrame staged_{};
  std::uint32_t staged_pose_ = 0;  ///< a digest of the times of clips, of the frame that was begun last

  std::uint32_t time_ = 0, now_ = 0, second_began_ = 0;
  std::uint32_t event_from_ = 0;  ///< the earliest time of an event that is due, for next_event
  bool has_clock_ = false, held_ = false;
  bool counts_frames_ = false;  ///< since second_began_
  std::uint16_t frames_ = 0;    ///< frames since second_began_
  Angle right_ = 0, up_ = 0;
  std::uint16_t zoom_ = 100;

  static constexpr std::uint32_t kNoStrip = 0xFFFFFFFF;
  std::uint32_t kept_strip_ = kNoStrip;  ///< the strip of this frame that lies in strips_[0], with its mask
  bool masked_ = false, has_background_ = false;
  Colour background_{};
  bool reaches_far_ = false;                  ///< an instance may change pixels outside of its rectangle
  std::span<SeenInstance> seen_instances_{};  ///< as many as the scene has, with FitOptions::tracks_changes
  SeenFrame seen_{};

  std::span<Font> fonts_{};  ///< the scene's fonts and one more; the same for labels_
  std::span<Label> labels_{};
  Overlay overlay_{};
  Font font_{};
  static constexpr std::size_t kMaxText = 24;
  char text_[kMaxText + 16]{};
  char staged_text_[kMaxText + 16]{};  ///< of the frame that was begun last
  std::uint8_t text_size_ = 0;         ///< without the rate
  bool has_rate_ = false;

  Fault fault_ = Fault::none;
  hal::Error display_error_ = hal::Error::none;
  Status status_{};
  Effects missing_{};
  char words_[160]{};
};

}  // namespace zstrip
