// A Linux framebuffer, /dev/fbN, as a display.
#include "zstrip_hal_linux/framebuffer_display.hpp"

#include <algorithm>
#include <cerrno>

namespace zstrip::hal {
namespace {

/// None for a field that is no field of a true colour.
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

/// The visible part of the mapped memory; none if it does not lie in it.
std::optional<VideoMemory> visible_memory(const fb_fix_screeninfo& device, const fb_var_screeninfo& mode,
                                          std::span<std::byte> mapped, std::size_t start) {
  const std::uint64_t pixel_bytes = mode.bits_per_pixel / 8;
  if (mode.xres == 0 || mode.yres == 0 || mode.xres > kLargestScreen || mode.yres > kLargestScreen) return std::nullopt;
  const std::uint64_t row_end = (std::uint64_t{mode.xoffset} + mode.xres) * pixel_bytes;
  const std::uint64_t rows = std::uint64_t{mode.yoffset} + mode.yres;
  if (row_end > device.line_length || rows > device.smem_len / device.line_length) return std::nullopt;
  const std::uint64_t first = start + std::uint64_t{mode.yoffset} * device.line_length + mode.xoffset * pixel_bytes;
  if (first > mapped.size()) return std::nullopt;
  return VideoMemory{mapped.subspan(static_cast<std::size_t>(first)), static_cast<std::uint16_t>(mode.xres),
                     static_cast<std::uint16_t>(mode.yres), device.line_length};
}

}  // namespace

Outcome<FramebufferDisplay> FramebufferDisplay::open(const std::string& path, std::optional<ScreenSize> size) {
  constexpr DeviceKind kKind = DeviceKind::framebuffer;
  Outcome<FileDescriptor> file = open_device(kKind, path);
  if (!file) return file.fault();
  const int number = file->get();
  fb_var_screeninfo mode{};
  if (device_control(number, FBIOGET_VSCREENINFO, &mode) != 0) return Fault{path + " is not a framebuffer"};

  std::optional<fb_var_screeninfo> former_mode;
  if (size && (mode.xres != size->width || mode.yres != size->height)) {
    former_mode = mode;
    mode.xres = mode.xres_virtual = size->width;
    mode.yres = mode.yres_virtual = size->height;
    mode.xoffset = mode.yoffset = 0;
    mode.activate = FB_ACTIVATE_NOW;
    const int error = device_control(number, FBIOPUT_VSCREENINFO, &mode);
    if (const int unread = device_control(number, FBIOGET_VSCREENINFO, &mode); unread != 0)
      return device_fault(kKind, path, "tell its mode", unread);
    if (mode.xres != size->width || mode.yres != size->height) {
      const std::string has = std::to_string(mode.xres) + "x" + std::to_string(mode.yres);
      return Fault{path + " does not take the size " + to_string(*size) + (error == 0 ? " although it says so" : "") +
                   ": it has " + has + "; leave the size out"};
    }
  }

  // Only after the mode was set: rows may have another length then.
  fb_fix_screeninfo device{};
  if (const int error = device_control(number, FBIOGET_FSCREENINFO, &device); error != 0)
    return device_fault(kKind, path, "tell where its memory is", error);
  const std::optional<PixelLayout> layout = layout_of(mode);
  const std::optional<PixelWriter> writer = layout ? PixelWriter::create(*layout) : std::nullopt;
  if (!writer || device.type != FB_TYPE_PACKED_PIXELS || device.visual != FB_VISUAL_TRUECOLOR) {
    return Fault{path + " has " + std::to_string(mode.bits_per_pixel) +
                 " bits a pixel that are no true colour; give it a mode of 16, 24 or 32 bits (fbset -depth 16)"};
  }

  // The memory begins somewhere in its first page.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t start = device.smem_start & (page - 1);
  if (device.smem_len == 0 || device.line_length == 0) return Fault{path + " says that it has no memory"};
  Mapping mapping(number, (start + device.smem_len + page - 1) / page * page, 0);
  if (mapping.bytes().empty()) return device_fault(kKind, path, "be mapped", errno);
  const std::optional<VideoMemory> memory = visible_memory(device, mode, mapping.bytes(), start);
  if (!memory) return Fault{path + " says that its picture lies beyond its memory, or is larger than 4096x4096"};

  device_control(number, FBIOBLANK, reinterpret_cast<void*>(FB_BLANK_UNBLANK));  // not every driver can blank
  return FramebufferDisplay(std::move(*file), std::move(mapping), *memory, *layout, *writer, former_mode);
}

FramebufferDisplay::FramebufferDisplay(FileDescriptor file, Mapping mapping, const VideoMemory& memory,
                                       const PixelLayout& layout, const PixelWriter& writer,
                                       const std::optional<fb_var_screeninfo>& former_mode)
    : file_(std::move(file)),
      mapping_(std::move(mapping)),
      memory_(memory),
      layout_(layout),
      writer_(writer),
      former_mode_(former_mode) {
  blacken();
}

FramebufferDisplay::~FramebufferDisplay() {
  if (!file_) return;  // moved from
  blacken();
  if (former_mode_) {
    former_mode_->activate = FB_ACTIVATE_NOW;
    device_control(file_.get(), FBIOPUT_VSCREENINFO, &*former_mode_);
  }
}

void FramebufferDisplay::blacken() {
  const std::size_t row_bytes = std::size_t{memory_.width} * layout_.bytes;
  for (std::size_t y = 0; y < memory_.height; ++y) {
    std::ranges::fill(memory_.bytes.subspan(y * memory_.stride, row_bytes), std::byte{0});
  }
  static_cast<void>(end_frame());
}

Error FramebufferDisplay::end_frame() {
  // Deferred I/O: fsync passes the written pages on. Drivers that scan the memory out know no fsync (EINVAL).
  if (fsync(file_.get()) != 0 && errno == EIO) return Error::bus;
  return Error::none;
}

}  // namespace zstrip::hal
