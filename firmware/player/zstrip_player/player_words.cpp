// The messages of Player::error().
#include "zstrip/effects/list.hpp"
#include "zstrip/scene/blob_sections.hpp"
#include "zstrip_player/player.hpp"
#include "zstrip_player/words.hpp"

namespace zstrip {
namespace {

/// "4096 bytes of memory are missing: what moves takes 6144, 2048 are left".
void put_missing(detail::Words& words, const char* what, const Status& status) {
  words << status.needed - status.available << " bytes of memory are missing: " << what << status.needed << ", "
        << status.available << " are left";
  if (status.purpose != Purpose::none) words << "; most are for " << name(status.purpose);
}

void put_scene(detail::Words& words, const Status& status) {
  switch (status.error) {
    case Error::blob_alignment: words << "the scene does not lie at a multiple of 4: alignas(4)"; break;
    case Error::blob_damaged:
      words << "these bytes are no whole scene: byte " << status.needed << " is wrong; bake it again";
      break;
    case Error::blob_version:
      words << "the scene is of version " << status.needed << ", and version " << status.available
            << " is read: bake it again";
      break;
    case Error::blob_section:
      words << "the scene has a section '" << blob_layout::name_of(status.needed).data()
            << "' that is not known here: it needs a newer zstrip";
      break;
    default: words << "the scene cannot be drawn: " << message(status.error); break;
  }
}

void put_effects(detail::Words& words, Effects missing) {
  words << "effects are missing that the scene or its text calls for:";
  const char* before = " ";
  for (const EffectName& each : kEffectNames) {
    if (!missing.any(each.effect)) continue;
    words << before << each.name;
    before = ", ";
    missing = without(missing, each.effect);
  }
  if (missing.any(effect::shades)) {
    words << before << "ways to shade, or sides";
    before = ", ";
    missing = without_shades(missing);
  }
  if (missing != Effects{}) words << before << "those of the options that it was baked with";
}

void put_frame(detail::Words& words, const Status& status) {
  if (status.error == Error::effect_missing && missing_effects(status) == Effects{}) {
    words << "the scene has perspective, and the player is for orthographic cameras";
  } else {
    words << "the frame cannot begin: " << message(status.error);
  }
}

}  // namespace

const char* Player::error() {
  detail::Words words(words_);
  switch (fault_) {
    case Fault::none: break;
    case Fault::null_scene: words << "no scene was given: its address is null"; break;
    case Fault::null_take: words << "nothing takes the strips: the function given to draw is null"; break;
    case Fault::not_open: words << "no scene is open: open() comes first"; break;
    case Fault::not_fitted: words << "no display is fitted: fit() comes before draw()"; break;
    case Fault::scene: put_scene(words, status_); break;
    case Fault::scene_memory: put_missing(words, "the scene's tables take ", status_); break;
    case Fault::motion_memory: put_missing(words, "what moves takes ", status_); break;
    case Fault::text_memory: put_missing(words, "fonts and labels take ", status_); break;
    case Fault::effects: put_effects(words, missing_); break;
    case Fault::plan:
      if (status_.error == Error::arena_too_small) {
        put_missing(words, "the picture takes at least ", status_);
      } else {
        words << "the picture cannot be planned: " << message(status_.error);
      }
      break;
    case Fault::turn: words << "what turns is too far from the origin for it: hold(true)"; break;
    case Fault::frame: put_frame(words, status_); break;
    case Fault::strip: words << "a strip cannot be drawn: " << message(status_.error); break;
    case Fault::other_display: words << "the display has not the size and format that were fitted"; break;
    case Fault::display: words << "the display failed: " << hal::message(display_error_); break;
    case Fault::not_taken: words << "a strip was not taken"; break;
    case Fault::null_pick: words << "nothing finds the pixel: the function given to pick is null"; break;
    case Fault::pick_effects: words << "the pipeline has other effects than the function given to pick"; break;
    case Fault::mask_format: words << "a mask needs a format with a byte or more for each pixel"; break;
    case Fault::no_mask: words << "there is no mask: it was not asked for when the picture was fitted"; break;
    case Fault::area:
      if (status_.error == Error::pixels_too_small) {
        words << "the area's memory or stride has " << status_.available << " bytes, and needs " << status_.needed;
      } else {
        words << "the area is empty, or not within the picture";
      }
      break;
    case Fault::no_clip:
      words << "there is no clip " << status_.needed << ": the scene has "
            << static_cast<std::uint32_t>(baked_.clips.size()) << " clips";
      break;
    case Fault::pose: words << "what joints or morph targets move cannot be posed: " << message(status_.error); break;
    case Fault::pick:
      if (status_.error == Error::view_size) {
        words << "the pixel is outside of the picture";
      } else {
        words << "the pixel cannot be picked: " << message(status_.error);
      }
      break;
  }
  return words_;
}

}  // namespace zstrip
