// Finds the function that picks in the frames of a pipeline, for programs that know the effects only at run time.
#include "zstrip/frame/make_rows.hpp"
#include "zstrip/frame/row_for.hpp"
#include "zstrip/pick.hpp"

namespace zstrip {
namespace {

using detail::kEverything;

/// These change no frame that lacks them, so that rows which differ in them share a function.
constexpr Effects kShared = effect::textures | effect::skins | effect::bins;
constexpr Effects shared(Effects effects) { return detail::picking_effects(effects) | kShared; }

struct PickerRow {
  Effects effects;
  PickFunction pick;
};
template <Effects effects>
constexpr PickerRow picker_row() {
  return {shared(effects), &pick<effects>};
}

constexpr PickerRow kPickerRows[] = {
    picker_row<kShared>(),
    picker_row<kShared | effect::orthographic>(),
    picker_row<kEverything>(),
    picker_row<kEverything | effect::orthographic>(),
};

template <Error error>
Status refuse(const Frame&, std::uint16_t, std::uint16_t, Picked& picked) {
  picked = {};
  return {.error = error};
}

}  // namespace

PickFunction picker_for(Effects effects) {
  const detail::RowFor found = detail::row_for(effects);
  if (found.error == Error::visibility || effects.methods != 0) return &refuse<Error::visibility>;
  if (found.row != nullptr) {
    for (const PickerRow& row : kPickerRows) {
      if (row.effects == shared(found.row->effects)) return row.pick;
    }
  }
  return &refuse<Error::depth_effects>;
}

}  // namespace zstrip
