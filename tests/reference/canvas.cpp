// Two passes over the geometry: the nearest surface, then what lies close behind it. See canvas.hpp.
#include "canvas.hpp"

#define GL_GLEXT_PROTOTYPES  // gl.h declares what came after OpenGL 1.3 only so
#include <GL/osmesa.h>

#include <array>
#include <cstddef>
#include <string>
#include <utility>

namespace zstrip::reference {
namespace {

/// Texture coordinates are perspective-correct, colours linear on the screen: the perspective-correct w * colour
/// divided by the perspective-correct w. (Mesa's `noperspective` is undefined for clipped edges that point at the eye.)
constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec4 position;
layout(location = 1) in vec3 colour;
layout(location = 2) in vec2 texcoord;
layout(location = 3) in uint triangle;
uniform vec2 shift;
smooth out vec4 shade;
smooth out vec2 at;
flat out uint id;
void main() {
  gl_Position = vec4(position.xy + shift * position.w, position.zw);
  shade = vec4(colour, 1) * position.w;
  at = texcoord;
  id = triangle;
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
smooth in vec4 shade;
smooth in vec2 at;
flat in uint id;
uniform bool textured, behind;
uniform float tolerance;
uniform usampler2D texels;
uniform usampler2D nearest_surface;
uniform sampler2D nearest_depth;
layout(location = 0) out vec4 colour;
layout(location = 1) out uvec2 surface;
void main() {
  if (behind) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    if (texelFetch(nearest_surface, pixel, 0).x == id) discard;
    if (gl_FragCoord.z < texelFetch(nearest_depth, pixel, 0).x - tolerance) discard;
  }
  colour = vec4(shade.rgb / shade.w, 1);
  surface = uvec2(id, 0u);
  if (textured) {
    ivec2 size = textureSize(texels, 0);
    ivec2 texel = ivec2(floor(at * vec2(size))) & (size - 1);
    uint rgb565 = texelFetch(texels, texel, 0).x;
    colour.rgb *= vec3(rgb565 >> 11, (rgb565 >> 5) & 63u, rgb565 & 31u) / vec3(31, 63, 31);
    surface.y = uint(texel.y * size.x + texel.x);
  }
}
)";

/// Texture units.
enum Unit : GLint { texels_unit, surface_unit, depth_unit };

/// The buffer holds code / kDepthCodes; codes run from 1 to kDepthCodes - 1.
constexpr double kDepthCodes = 65535;

struct Surface {
  std::uint32_t triangle, texel;
};
using Rgba = std::array<float, 4>;

/// A colour, a surface and a depth buffer that can be read as textures.
struct Layer {
  GLuint framebuffer = 0, colour = 0, surface = 0, depth = 0;
};

GLuint texture(GLint format, GLsizei width, GLsizei height, GLenum layout, GLenum type, const void* content) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, content);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

Layer layer(GLsizei width, GLsizei height) {
  Layer made;
  made.colour = texture(GL_RGBA32F, width, height, GL_RGBA, GL_FLOAT, nullptr);
  made.surface = texture(GL_RG32UI, width, height, GL_RG_INTEGER, GL_UNSIGNED_INT, nullptr);
  made.depth = texture(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glGenFramebuffers(1, &made.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, made.framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, made.colour, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, made.surface, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, made.depth, 0);
  constexpr GLenum kBuffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, kBuffers);
  return made;
}

/// Empty if the compiler has nothing to say.
std::string attach(GLuint program, GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::array<char, 1024> log{};
  if (compiled == 0) glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  glAttachShader(program, shader);
  glDeleteShader(shader);
  return compiled == 0 ? "shader: " + std::string(log.data()) : "";
}

void bind(Unit unit, GLuint name) {
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, name);
}

const void* offset_of(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

double depth_code(const Corner& corner) {
  return 1 + (kDepthCodes - 2) * (1 + static_cast<double>(corner.z) / corner.w) / 2;
}

struct Canvas::State {
  GLsizei width = 0, height = 0;
  OSMesaContext context = nullptr;
  std::vector<std::uint8_t> window;  ///< of the context; all drawing goes to the layers
  GLuint program = 0, corners = 0, vertex_array = 0;
  Layer nearest, contender;
  std::vector<GLuint> textures;
  std::vector<Batch> batches;

  GLint uniform(const char* name) const { return glGetUniformLocation(program, name); }
  void set_up(const Offset& offset, double tolerance) const;
  void draw_batches(const Layer& target, bool behind) const;
  Samples read(const Layer& source) const;
};

sim::Result<std::unique_ptr<Canvas>> Canvas::open(const View& view) {
  constexpr int kAttributes[] = {OSMESA_FORMAT,
                                 OSMESA_RGBA,
                                 OSMESA_PROFILE,
                                 OSMESA_CORE_PROFILE,
                                 OSMESA_CONTEXT_MAJOR_VERSION,
                                 3,
                                 OSMESA_CONTEXT_MINOR_VERSION,
                                 3,
                                 0};
  const auto failure = [](const std::string& why) { return sim::Failure{sim::ExitStatus::environment, why}; };
  std::unique_ptr<Canvas> canvas(new Canvas);
  canvas->state_ = std::make_unique<State>();
  State& state = *canvas->state_;
  state.width = view.width;
  state.height = view.height;
  state.context = OSMesaCreateContextAttribs(kAttributes, nullptr);
  if (state.context == nullptr) return failure("OSMesa has no OpenGL 3.3");
  state.window.resize(std::size_t{4} * view.width * view.height);
  if (OSMesaMakeCurrent(state.context, state.window.data(), GL_UNSIGNED_BYTE, view.width, view.height) == GL_FALSE) {
    return failure("OSMesa cannot draw into memory");
  }
  state.program = glCreateProgram();
  if (std::string log = attach(state.program, GL_VERTEX_SHADER, kVertexShader); !log.empty()) return failure(log);
  if (std::string log = attach(state.program, GL_FRAGMENT_SHADER, kFragmentShader); !log.empty()) return failure(log);
  glLinkProgram(state.program);
  GLint linked = 0;
  glGetProgramiv(state.program, GL_LINK_STATUS, &linked);
  if (linked == 0) return failure("the shaders do not link");

  state.nearest = layer(state.width, state.height);
  state.contender = layer(state.width, state.height);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return failure("no float framebuffer");
  glGenVertexArrays(1, &state.vertex_array);
  glGenBuffers(1, &state.corners);
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    return failure("OpenGL error " + std::to_string(error));
  }
  return canvas;
}

Canvas::~Canvas() {
  if (state_ != nullptr && state_->context != nullptr) OSMesaDestroyContext(state_->context);
}

void Canvas::load(const Geometry& geometry, const Scene& scene) {
  State& state = *state_;
  state.batches = geometry.batches;
  glBindVertexArray(state.vertex_array);
  glBindBuffer(GL_ARRAY_BUFFER, state.corners);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(geometry.corners.size() * sizeof(Corner)),
               geometry.corners.data(), GL_STATIC_DRAW);
  constexpr GLsizei kStride = sizeof(Corner);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, offset_of(offsetof(Corner, x)));
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride, offset_of(offsetof(Corner, r)));
  glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, kStride, offset_of(offsetof(Corner, u)));
  glVertexAttribIPointer(3, 1, GL_UNSIGNED_INT, kStride, offset_of(offsetof(Corner, triangle)));
  for (GLuint attribute = 0; attribute < 4; ++attribute) glEnableVertexAttribArray(attribute);

  glDeleteTextures(static_cast<GLsizei>(state.textures.size()), state.textures.data());
  state.textures.clear();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  for (const Texture& source : scene.textures) {
    state.textures.push_back(texture(GL_R16UI, 1 << source.log2_width, 1 << source.log2_height, GL_RED_INTEGER,
                                     GL_UNSIGNED_SHORT, source.texels.data()));
  }
}

void Canvas::State::draw_batches(const Layer& target, bool behind) const {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  constexpr GLfloat kBlack[4] = {0, 0, 0, 0};
  constexpr GLuint kNoSurface[4] = {0, 0, 0, 0};
  constexpr GLfloat kFarthest = 0;
  glClearBufferfv(GL_COLOR, 0, kBlack);
  glClearBufferuiv(GL_COLOR, 1, kNoSurface);
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  glUniform1i(uniform("behind"), behind ? 1 : 0);
  for (const Batch& batch : batches) {
    const bool textured = batch.texture != kNoTexture;
    glUniform1i(uniform("textured"), textured ? 1 : 0);
    bind(texels_unit, textured ? textures[batch.texture] : 0);
    if (batch.double_sided) {
      glDisable(GL_CULL_FACE);
    } else {
      glEnable(GL_CULL_FACE);
    }
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(batch.first_corner), static_cast<GLsizei>(batch.corners));
  }
}

Samples Canvas::State::read(const Layer& source) const {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<Rgba> colours(pixels);
  std::vector<Surface> surfaces(pixels);
  std::vector<float> depths(pixels);
  glBindFramebuffer(GL_FRAMEBUFFER, source.framebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, colours.data());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, width, height, GL_RG_INTEGER, GL_UNSIGNED_INT, surfaces.data());
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  Samples samples(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    samples[i] = {colours[i][0],        colours[i][1],     colours[i][2],
                  surfaces[i].triangle, surfaces[i].texel, depths[i] * static_cast<float>(kDepthCodes)};
  }
  return samples;
}

void Canvas::State::set_up(const Offset& offset, double tolerance) const {
  glUseProgram(program);
  glBindVertexArray(vertex_array);
  glViewport(0, 0, width, height);
  glDepthRange(1 / kDepthCodes, (kDepthCodes - 1) / kDepthCodes);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  // y grows downwards here, which turns the winding round.
  glFrontFace(GL_CW);
  glUniform2f(uniform("shift"), -2 * offset.x / static_cast<float>(width), -2 * offset.y / static_cast<float>(height));
  glUniform1f(uniform("tolerance"), static_cast<float>(tolerance / kDepthCodes));
  glUniform1i(uniform("texels"), texels_unit);
  glUniform1i(uniform("nearest_surface"), surface_unit);
  glUniform1i(uniform("nearest_depth"), depth_unit);
}

Samples Canvas::draw(const Offset& offset) {
  state_->set_up(offset, 0);
  // A texture must not be drawn to and bound at once.
  bind(surface_unit, 0);
  bind(depth_unit, 0);
  state_->draw_batches(state_->nearest, false);
  return state_->read(state_->nearest);
}

Layers Canvas::draw_layers(const Offset& offset, double tolerance) {
  Samples nearest = draw(offset);
  state_->set_up(offset, tolerance);
  bind(surface_unit, state_->nearest.surface);
  bind(depth_unit, state_->nearest.depth);
  state_->draw_batches(state_->contender, true);
  return {std::move(nearest), state_->read(state_->contender)};
}

}  // namespace zstrip::reference
