// The options that say what a picture is and what memory it may take.
#include "cli/plan_arguments.hpp"

#include <CLI/CLI.hpp>

#include "cli/parse.hpp"

namespace zstrip::sim {

void add_plan_options(CLI::App& command, PlanArguments& arguments) {
  PlanArguments& a = arguments;
  command.add_option("--size", a.size, "Size of the picture, each side 1 to 4096 (default: 320x240)")->type_name("WxH");
  command
      .add_option("--format", a.format,
                  "Pixels: rgb565 (default), rgb565_swapped, gray4, mono, rgb666, rgb444, xrgb8888")
      ->type_name("FORMAT");
  command.add_option("--ram", a.ram, "Bytes at most, of arena and strip buffers, K and M allowed (default: no limit)")
      ->type_name("BYTES");
  command.add_option("--strip-buffers", a.strip_buffers, "Pixel buffers of a strip: 2 where DMA sends one meanwhile")
      ->type_name("N")
      ->check(CLI::Range(std::uint32_t{0}, std::uint32_t{2}))
      ->capture_default_str();
  command.add_option("--strip-rows", a.strip_rows, "Rows of a strip (default: auto, what is fastest)")
      ->type_name("N|auto");
  command.add_option("--strip-columns", a.strip_columns, "Pixels of a strip's row, a multiple of 8 (default: auto)")
      ->type_name("N|auto");
  command.add_flag("--split-columns", a.split_columns, "The display takes rectangles narrower than the picture");
  command.add_option("--mode", a.mode, "Transform geometry for each strip, once, or what is faster")
      ->check(CLI::IsMember({"any", "streamed", "binned"}))
      ->capture_default_str();
}

Result<PlanRequest> parse_plan(const PlanArguments& arguments) {
  PlanRequest request;
  const auto size = parse_size(arguments.size);
  if (!size) return size.failure();
  const Result<PixelFormat> format = parse_format(arguments.format);
  if (!format) return format.failure();
  request.view = {size->first, size->second, *format};
  if (arguments.ram) {
    const Result<std::uint32_t> bytes = parse_bytes(*arguments.ram);
    if (!bytes) return bytes.failure();
    request.budget.bytes = *bytes;
  }
  const Result<Done> strips = parse_strips(arguments.strip_rows, arguments.strip_columns, request.view, request.budget);
  if (!strips) return strips.failure();
  request.budget.split_columns = arguments.split_columns;
  request.budget.strip_buffers = static_cast<std::uint8_t>(arguments.strip_buffers);
  request.may_bin = arguments.mode != "streamed";
  request.budget.modes = arguments.mode == "binned" ? Modes::binned : Modes::any;
  return request;
}

}  // namespace zstrip::sim
