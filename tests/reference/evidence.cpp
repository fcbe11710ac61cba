// See evidence.hpp.
#include "evidence.hpp"

#include <cstdlib>
#include <filesystem>
#include <span>
#include <vector>

#include "image/encode.hpp"
#include "image/write_file.hpp"

namespace zstrip::reference {
namespace {

constexpr std::uint16_t kWhite = 0xFFFF, kLightGrey = 0xB5B6, kGrey = 0x8410, kYellow = 0xFFE0, kGreen = 0x07E0,
                        kRed = 0xF800, kBlue = 0x001F;

std::vector<std::uint16_t> difference(const RendererPicture& picture, const ReferencePicture& reference,
                                      const Comparison& comparison) {
  std::vector<std::uint16_t> pixels(picture.pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    switch (comparison.verdicts[i]) {
      case Verdict::background: pixels[i] = kGrey; break;
      case Verdict::certain:
        pixels[i] = picture.pixels[i] == truncated(reference.centres()[i]) ? kWhite : kLightGrey;
        break;
      case Verdict::plausible: pixels[i] = kYellow; break;
      case Verdict::sliver: pixels[i] = kGreen; break;
      case Verdict::foreign:
      case Verdict::shading: pixels[i] = kRed; break;
      case Verdict::coverage: pixels[i] = kBlue; break;
    }
  }
  return pixels;
}

sim::Result<sim::Done> write(const std::string& path, const View& view, const std::vector<std::uint16_t>& pixels) {
  const auto file = sim::encode(sim::ImageType::png, view, std::as_bytes(std::span(pixels)));
  if (!file) return file.failure();
  return sim::write_file(path, *file, "the build folder");
}

}  // namespace

sim::Result<std::string> write_evidence(const std::string& name, const RendererPicture& picture,
                                        const ReferencePicture& reference, const Comparison& comparison) {
  std::error_code error;
  std::filesystem::create_directories(ZSTRIP_REFERENCE_PICTURES, error);  // if this fails, so does writing
  std::vector<std::uint16_t> expected;
  for (const Sample& sample : reference.centres()) expected.push_back(truncated(sample));
  const std::string path = std::string(ZSTRIP_REFERENCE_PICTURES) + "/" + name;
  if (const auto done = write(path + ".zstrip.png", reference.view, picture.pixels); !done) return done.failure();
  if (const auto done = write(path + ".reference.png", reference.view, expected); !done) return done.failure();
  const auto done = write(path + ".difference.png", reference.view, difference(picture, reference, comparison));
  if (!done) return done.failure();
  return path;
}

}  // namespace zstrip::reference
