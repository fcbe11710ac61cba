// Writes pixels as a JPEG file, by libjpeg-turbo.
#include "image/jpeg_writer.hpp"

#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>

namespace zstrip::sim {

Result<std::vector<std::uint8_t>> write_jpeg(std::span<const std::uint8_t> pixels, int width, int height) {
  constexpr int kQuality = 90;
  const bool grey = pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const std::unique_ptr<void, decltype(&tjDestroy)> jpeg(tjInitCompress(), &tjDestroy);
  if (!jpeg) return Failure{ExitStatus::environment, "no memory to write a JPEG"};
  unsigned char* data = nullptr;
  unsigned long bytes = 0;
  const int error = tjCompress2(jpeg.get(), pixels.data(), width, 0, height, grey ? TJPF_GRAY : TJPF_RGB, &data, &bytes,
                                grey ? TJSAMP_GRAY : TJSAMP_444, kQuality, 0);
  const std::unique_ptr<unsigned char, decltype(&tjFree)> file(data, &tjFree);
  if (error != 0) return Failure{ExitStatus::internal, fmt::format("JPEG writer: {}", tjGetErrorStr2(jpeg.get()))};
  return std::vector<std::uint8_t>(data, data + bytes);
}

}  // namespace zstrip::sim
