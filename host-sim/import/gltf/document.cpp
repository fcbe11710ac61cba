// The two parts of a glTF file. A .glb has a header of 12 bytes (magic, version, length), then chunks (length, type,
// data).
#include "import/gltf/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::size_t kHeaderBytes = 12, kChunkBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t word_at(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{bytes[at + i]} << 8 * i;
  return word;
}

bool is_binary(std::span<const std::uint8_t> file) {
  constexpr std::string_view kMagic = "glTF";
  return file.size() >= kHeaderBytes && std::equal(kMagic.begin(), kMagic.end(), file.begin());
}

/// Chunks end at a multiple of four bytes. Some writers do not count the padding, others do not write it.
std::size_t bytes_to_next(std::span<const std::uint8_t> data_on, std::size_t length) {
  const bool follows = data_on.size() >= length + kChunkBytes && word_at(data_on, length + 4) == kBinaryChunk;
  return follows ? length : std::min(data_on.size(), (length + 3) / 4 * 4);
}

/// Removes the next chunk, of any type, from `rest` and returns it.
Result<std::pair<std::uint32_t, std::span<const std::uint8_t>>> take_chunk(std::span<const std::uint8_t>& rest) {
  if (rest.size() < kChunkBytes) return gltf_damaged("the file ends in the header of a chunk");
  const std::size_t length = word_at(rest, 0);
  const std::uint32_t type = word_at(rest, 4);
  rest = rest.subspan(kChunkBytes);
  if (length > rest.size()) return gltf_damaged("the file ends in the middle of a chunk");
  const std::span<const std::uint8_t> data = rest.first(length);
  rest = rest.subspan(bytes_to_next(rest, length));
  return std::pair{type, data};
}

Result<Done> parse_json(std::span<const std::uint8_t> text, GltfDocument& document) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.size() >= 3 && std::equal(text.begin(), text.begin() + 3, kByteOrderMark.begin(),
                                     [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); })) {
    text = text.subspan(3);
  }
  document.json = GltfJson::parse(text.begin(), text.end(), nullptr, false);
  if (!document.json.is_object()) return gltf_damaged("it holds no JSON object");
  const GltfJson& asset = member(document.json, "asset");
  // Files of glTF 1.0 may have a number.
  const GltfJson& number = member(asset, "version");
  const std::string version = number.is_number() ? number.dump() : text_in(asset, "version");
  if (version.empty()) return gltf_damaged("asset.version is missing");
  document.version = version[0] >= '0' && version[0] <= '9' ? version[0] - '0' : 0;
  const std::string least = text_in(asset, "minVersion");
  if (least > "2.0" && document.version == 2) {
    return gltf_damaged(fmt::format("asset.minVersion {} is more than 2.0", printable(least)));
  }
  return Done{};
}

}  // namespace

Failure gltf_damaged(std::string reason) { return {ExitStatus::input, std::move(reason)}; }

Result<GltfDocument> parse_gltf(std::span<const std::uint8_t> file) {
  GltfDocument document;
  if (!is_binary(file)) {
    if (const Result<Done> parsed = parse_json(file, document); !parsed) return parsed.failure();
    return document;
  }
  document.version = static_cast<int>(std::min<std::uint32_t>(word_at(file, 4), 9));
  if (document.version != 2) return document;
  std::span<const std::uint8_t> rest = file.subspan(kHeaderBytes);
  // Bytes behind the last chunk do no harm.
  const std::size_t length = word_at(file, 8);
  const auto note_end = [&] {
    if (!document.warnings.empty() || (length <= file.size() && file.size() - rest.size() <= length)) return;
    document.warnings.push_back(fmt::format("the header of the .glb says {}, and the file has {}; export it again",
                                            counted(length, "byte"), grouped(file.size())));
  };
  const auto first = take_chunk(rest);
  if (!first) return first.failure();
  if (first->first != kJsonChunk) return gltf_damaged("its first chunk is not JSON");
  if (const Result<Done> parsed = parse_json(first->second, document); !parsed) return parsed.failure();
  note_end();
  while (rest.size() >= kChunkBytes && !document.binary) {
    const auto chunk = take_chunk(rest);
    if (!chunk) return chunk.failure();
    if (chunk->first == kBinaryChunk) document.binary.emplace(chunk->second.begin(), chunk->second.end());
    note_end();
  }
  return document;
}

}  // namespace zstrip::sim
