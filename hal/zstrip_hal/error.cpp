// The words for each error.
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

const char* message(Error error) {
  switch (error) {
    case Error::none: return "no error";
    case Error::timeout: return "the bus did not get ready in time";
    case Error::area: return "the area is empty or reaches beyond the display";
    case Error::alignment: return "the area does not begin and end at whole bytes";
    case Error::pixels_too_small: return "the pixel buffer is smaller than the area";
    case Error::strip_layout: return "the strips do not cover the display exactly";
    case Error::bus: return "the bus reports a fault";
    case Error::pin: return "an output line cannot be set";
    case Error::configuration: return "the display's controller cannot do what its configuration needs";
    case Error::framebuffer: return "the picture does not fit its memory";
    case Error::flip: return "the last page flip did not happen";
    case Error::wrong_id: return "another controller answers, or none";
    case Error::second_core: return "the second core did not answer in time";
    case Error::underrun: return "the panel has read a strip before it was drawn";
  }
  return "unknown error";
}

}  // namespace zstrip::hal
