// A Linux framebuffer, /dev/fbN, as a display.
#include "zstrip_hal_linux/framebuffer_display.hpp"

#include <algorithm>
#include <cerrno>

namespace zstrip::hal {
namespace {

/// Returns none if the field does not describe a true colour.
std::optional<BitField> field_of(const fb_bitfield& field) {
  if (field.msb_right != 0 || field.offset > 31 || field.length > 16) return std::nullopt;
  return BitField{static_cast<std::uint8_t>(field.offset), static_cast<std::uint8_t>(field.length)};
}

std::optional<PixelLayout> layout_of(const fb_var_screeninfo& mode) {
  const auto red = field_of(mode.red);
  const auto green = field_of(mode.green);
  const auto blue = field_of(mode.blue);
  if (!red || !green || !blue || mode.grayscale != 0) return std::nullopt;
  if (mode.bits_per_pixel != 16 && mode.bits_per_pixel != 24 && mode.bits_per_pixel != 32) return std::nullopt;
  return PixelLayout{static_cast<std::uint8_t>(mode.bits_per_pixel / 8), *red, *green, *blue};
}

/// Returns the visible part of the device's memory, or none if it lies outside the memory.
std::optional<VideoMemory> visible_memory(const fb_fix_screeninfo& device, const fb_var_screeninfo& mode,
                                          std::span<std::byte> memory) {
  const std::uint64_t pixel_bytes = mode.bits_per_pixel / 8;
  if (mode.xres == 0 || mode.yres == 0 || mode.xres > kMaxScreen || mode.yres > kMaxScreen) return std::nullopt;
  const std::uint64_t row_end = (std::uint64_t{mode.xoffset} + mode.xres) * pixel_bytes;
  const std::uint64_t rows = std::uint64_t{mode.yoffset} + mode.yres;
  if (row_end > device.line_length || rows > device.smem_len / device.line_length) return std::nullopt;
  const std::uint64_t first = std::uint64_t{mode.yoffset} * device.line_length + mode.xoffset * pixel_bytes;
  return VideoMemory{memory.subspan(static_cast<std::size_t>(first)), static_cast<std::uint16_t>(mode.xres),
                     static_cast<std::uint16_t>(mode.yres), device.line_length};
}

std::string in_words(const fb_var_screeninfo& mode) {
  return std::to_string(mode.xres) + "x" + std::to_string(mode.yres) + " with " + std::to_string(mode.bits_per_pixel) +
         " bits a pixel";
}

/// Lists the other depths, as the command's keys.
std::string other_depths(const fb_var_screeninfo& mode) {
  std::string keys;
  for (const std::uint32_t depth : {16U, 24U, 32U}) {
    if (depth == mode.bits_per_pixel) continue;
    keys += keys.empty() ? "depth=" : " or depth=";
    keys += std::to_string(depth);
  }
  return keys;
}

/// Sets `options` and reads back the mode that the driver really has then.
std::optional<Fault> change_mode(int file, const std::string& path, const FramebufferOptions& options,
                                 fb_var_screeninfo& mode) {
  fb_var_screeninfo wanted = mode;
  if (options.size) {
    wanted.xres = wanted.xres_virtual = options.size->width;
    wanted.yres = wanted.yres_virtual = options.size->height;
    wanted.xoffset = wanted.yoffset = 0;
  }
  if (options.depth) wanted.bits_per_pixel = *options.depth;
  const auto is_wanted = [&] {
    return mode.xres == wanted.xres && mode.yres == wanted.yres && mode.bits_per_pixel == wanted.bits_per_pixel;
  };
  if (is_wanted()) return std::nullopt;
  wanted.activate = FB_ACTIVATE_NOW;
  fb_var_screeninfo answer = wanted;
  const int error = device_control(file, FBIOPUT_VSCREENINFO, &answer);
  if (const int unread = device_control(file, FBIOGET_VSCREENINFO, &mode); unread != 0)
    return device_fault(DeviceKind::framebuffer, path, "tell its mode", unread);
  if (is_wanted()) return std::nullopt;
  return Fault{path + " does not take " + in_words(wanted) + (error == 0 ? ", although it reports success" : "") +
               "; it has " + in_words(mode)};
}

}  // namespace

Outcome<FramebufferDisplay> FramebufferDisplay::open(const std::string& path, const FramebufferOptions& options) {
  Outcome<FileDescriptor> opened = open_device(DeviceKind::framebuffer, path);
  if (!opened) return opened.fault();
  const int number = opened->get();
  fb_var_screeninfo mode{};
  if (device_control(number, FBIOGET_VSCREENINFO, &mode) != 0) return Fault{path + " is not a framebuffer"};

  FramebufferFile file(std::move(*opened), mode);
  if (const auto fault = change_mode(number, path, options, mode)) return *fault;

  // Read this after the mode was set: the row length may have changed.
  fb_fix_screeninfo device{};
  if (const int error = device_control(number, FBIOGET_FSCREENINFO, &device); error != 0)
    return device_fault(DeviceKind::framebuffer, path, "tell where its memory is", error);
  const std::optional<PixelLayout> layout = layout_of(mode);
  const std::optional<PixelWriter> writer = layout ? PixelWriter::create(*layout) : std::nullopt;
  if (!writer || device.type != FB_TYPE_PACKED_PIXELS || device.visual != FB_VISUAL_TRUECOLOR) {
    return Fault{path + " has " + std::to_string(mode.bits_per_pixel) +
                 " bits a pixel that are no true colour; another depth may be: " + other_depths(mode)};
  }

  // The memory begins somewhere in its first page.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t start = device.smem_start & (page - 1);
  if (device.smem_len == 0 || device.line_length == 0) return Fault{path + " reports that it has no memory"};
  Mapping mapping(number, (start + device.smem_len + page - 1) / page * page, 0);
  if (mapping.bytes().empty()) return device_fault(DeviceKind::framebuffer, path, "be mapped", errno);
  const std::span<std::byte> device_memory = mapping.bytes().subspan(start, device.smem_len);
  const std::optional<VideoMemory> memory = visible_memory(device, mode, device_memory);
  if (!memory) return Fault{path + " reports that its picture lies beyond its memory, or is larger than 4096x4096"};

  device_control(
      number, FBIOBLANK,
      reinterpret_cast<void*>(FB_BLANK_UNBLANK));  // NOLINT(performance-no-int-to-ptr): not every driver can blank
  return FramebufferDisplay(std::move(file), std::move(mapping), device_memory, *memory, *layout, *writer);
}

FramebufferFile::~FramebufferFile() {
  if (!file_) return;  // moved from
  former_mode_.activate = FB_ACTIVATE_NOW;
  device_control(file_.get(), FBIOPUT_VSCREENINFO, &former_mode_);
}

FramebufferDisplay::FramebufferDisplay(FramebufferFile file, Mapping mapping, std::span<std::byte> device_memory,
                                       const VideoMemory& memory, const PixelLayout& layout, const PixelWriter& writer)
    : file_(std::move(file)),
      mapping_(std::move(mapping)),
      device_memory_(device_memory),
      memory_(memory),
      layout_(layout),
      writer_(writer) {
  blacken();
}

FramebufferDisplay::~FramebufferDisplay() {
  if (file_) blacken();  // else moved from
}

void FramebufferDisplay::blacken() {
  std::ranges::fill(device_memory_, std::byte{0});
  static_cast<void>(end_frame());
}

Error FramebufferDisplay::end_frame() {
  // Deferred I/O: fsync passes the written pages on. Drivers that scan the memory out have no fsync (EINVAL).
  if (fsync(file_.get()) != 0 && errno == EIO) return Error::bus;
  return Error::none;
}

}  // namespace zstrip::hal
