// convert_pixels for a format that is known only at run time.
#include "zstrip/resolve/convert.hpp"

#include "zstrip/resolve/resolve.hpp"

namespace zstrip {

void convert_pixels(PixelFormat format, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
                    std::byte* out) {
  detail::convert_rows(format, width, rows, pixels, out);
}

}  // namespace zstrip
