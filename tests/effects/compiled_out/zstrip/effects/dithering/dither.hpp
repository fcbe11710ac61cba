// Declared, not there: what code without dithering may know of it.
#pragma once

namespace zstrip {

template <class... Arguments>
void dither_pixels(const Arguments&...);

namespace detail {

template <class... Arguments>
void fill_dithered(const Arguments&...);

}  // namespace detail
}  // namespace zstrip
