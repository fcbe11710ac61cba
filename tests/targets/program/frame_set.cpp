// Draws a fixed set of frames and prints, as CSV, what came out: the same text on every target. An error is a line
// that is no CSV, and exit status 1.
#include <cstdint>

#include "cases.hpp"
#include "cortex_m/console.hpp"

namespace {

using zstrip::PixelFormat;
using zstrip::board::print;
using zstrip::board::print_decimal;
using zstrip::board::print_hex;
using zstrip::targets::Case;
using zstrip::targets::Motion;

const char* name_of(PixelFormat format) {
  switch (format) {
    case PixelFormat::rgb565: return "rgb565";
    case PixelFormat::rgb565_swapped: return "rgb565_swapped";
    case PixelFormat::gray4: return "gray4";
    case PixelFormat::mono: return "mono";
    case PixelFormat::rgb666: return "rgb666";
    case PixelFormat::rgb444: return "rgb444";
    case PixelFormat::xrgb8888: return "xrgb8888";
  }
  return "unknown";
}

/// As in "knot_workload_64x48_rgb565_rows16_frames7-8".
void print_name(const Case& frames) {
  print(frames.subject->built_in->name);
  print(frames.subject->depth);
  print(frames.motion == Motion::workload ? "_workload_" : "_");
  print_decimal(frames.view.width);
  print("x");
  print_decimal(frames.view.height);
  print("_");
  print(name_of(frames.view.format));
  print("_rows");
  print_decimal(frames.strip_rows != 0 ? frames.strip_rows : frames.view.height);
  print(frames.frames == 1 ? "_frame" : "_frames");
  print_decimal(frames.first_frame);
  if (frames.frames == 1) return;
  print("-");
  print_decimal(frames.first_frame + frames.frames - 1);
}

void print_column(std::uint64_t value) {
  print(",");
  print_decimal(value);
}

bool run(const Case& frames) {
  zstrip::targets::PictureSummary summary(frames.view);
  const zstrip::Status status = frames.subject->draw(frames, summary);
  print_name(frames);
  if (!status) {
    print(": ");
    print(message(status.error));
    print(", needed ");
    print_decimal(status.needed);
    print(", available ");
    print_decimal(status.available);
    print("\n");
    return false;
  }
  print(",");
  print_hex(summary.crc32());
  print(",");
  print_hex(summary.depth_crc32());
  const zstrip::Rect& box = summary.box();
  for (const std::int32_t side : {box.left, box.top, box.right, box.bottom}) {
    print_column(static_cast<std::uint64_t>(side));
  }
  print_column(summary.red());
  print_column(summary.green());
  print_column(summary.blue());
  print("\n");
  return true;
}

}  // namespace

int main() {
  print("case,crc32,depth_crc32,left,top,right,bottom,red,green,blue\n");
  return zstrip::targets::for_each_case(run) ? 0 : 1;
}
