// glTF 2.0 files made to measure.
#include "gltf_file.hpp"

#include <spng.h>

#include <cstdlib>
#include <cstring>
#include <memory>

namespace zstrip::sim::test {
namespace {

std::string joined(const std::vector<std::string>& objects) {
  std::string all;
  for (const std::string& object : objects) all += (all.empty() ? "" : ",") + object;
  return "[" + all + "]";
}

std::string view(std::size_t at, std::size_t size) {
  return R"({"buffer":0,"byteOffset":)" + std::to_string(at) + R"(,"byteLength":)" + std::to_string(size) + "}";
}

std::string data_uri(const std::string& type, const std::string& bytes) {
  return R"("uri":"data:)" + type + ";base64," + base64(bytes) + '"';
}

}  // namespace

std::string base64(const std::string& bytes) {
  const char* const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? letters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string floats(const std::vector<float>& values) {
  std::string bytes(values.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

std::string rgba_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> png(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
  spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_ihdr header{};
  header.width = width, header.height = height;
  header.bit_depth = 8;
  header.color_type = SPNG_COLOR_TYPE_TRUECOLOR_ALPHA;
  spng_set_ihdr(png.get(), &header);
  spng_encode_image(png.get(), rgba.data(), rgba.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t size = 0;
  int error = 0;
  const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(png.get(), &size, &error), &std::free);
  return {static_cast<const char*>(bytes.get()), size};
}

std::string GltfFile::text() const {
  const std::string corners = floats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
  const std::string normals = floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  const std::string texcoords = floats({0, 1, 1, 1, 1, 0, 0, 0});
  const std::string triangles("\0\0\1\0\2\0\0\0\2\0\3\0", 12);
  const std::string buffer = corners + normals + texcoords + triangles;
  std::vector<std::string> meshes, roots;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    meshes.push_back(
        R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2},"indices":3,"material":)" +
        std::to_string(i) + "}]}");
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) roots.push_back(std::to_string(i));
  std::string text = R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":)" + joined(roots) + R"(}],"nodes":)" +
                     joined(nodes) + R"(,"meshes":)" + joined(meshes) + R"(,"materials":)" + joined(materials);
  if (!pictures.empty()) {
    text += R"(,"images":[{)" + data_uri("image/png", pictures) + R"(}],"textures":[{"source":0}])";
  }
  if (!lights.empty()) {
    text +=
        R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[)" + lights + "]}}";
  }
  return text +
         R"(,"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[-1,-1,0],"max":[1,1,0]},)"
         R"({"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":2,"componentType":5126,"count":4,"type":"VEC2"},)"
         R"({"bufferView":3,"componentType":5123,"count":6,"type":"SCALAR"}],"bufferViews":[)" +
         view(0, 48) + "," + view(48, 48) + "," + view(96, 32) + "," + view(128, 12) +
         R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size()) + "," +
         data_uri("application/octet-stream", buffer) + "}]}";
}

std::size_t GltfData::add(const std::string& bytes, const std::string& what, const std::string& of_view) {
  const std::string comma = count_ == 0 ? "" : ",";
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  views_ += comma + R"({"buffer":0,"byteOffset":)" + std::to_string(bytes_.size()) + R"(,"byteLength":)" +
            std::to_string(bytes.size()) + of_view + "}";
  accessors_ += comma + R"({"bufferView":)" + std::to_string(count_) + "," + what + "}";
  bytes_ += bytes;
  return count_++;
}

std::size_t GltfData::add_floats(const std::vector<float>& values, const std::string& type) {
  const std::size_t components = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<std::size_t>(type[3] - '0');
  return add(floats(values), R"("componentType":5126,"count":)" + std::to_string(values.size() / components) +
                                 R"(,"type":")" + type + '"');
}

std::size_t GltfData::add_indices(const std::vector<std::uint16_t>& values) {
  std::string bytes;
  for (const std::uint16_t value : values) bytes += {static_cast<char>(value & 0xFF), static_cast<char>(value >> 8)};
  return add(bytes, R"("componentType":5123,"count":)" + std::to_string(values.size()) + R"(,"type":"SCALAR")");
}

std::string GltfData::json(const std::string& uri) const {
  return R"("accessors":[)" + accessors_ + R"(],"bufferViews":[)" + views_ + R"(],"buffers":[{"byteLength":)" +
         std::to_string(bytes_.size()) + uri + "}]";
}

std::string GltfData::json() const { return json("," + data_uri("application/octet-stream", bytes_)); }

std::string gltf_of(const std::string& members) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)" + members + "}";
}

std::string glb_of(const std::string& json, const std::string& binary) {
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
    return bytes;
  };
  std::string text = json, data = binary;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  data.resize((data.size() + 3) / 4 * 4);
  const std::string chunks = word(text.size()) + "JSON" + text + word(data.size()) + std::string("BIN\0", 4) + data;
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

}  // namespace zstrip::sim::test
