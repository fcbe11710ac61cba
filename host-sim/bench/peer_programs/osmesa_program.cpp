// OpenGL in software: vertices in a buffer, RGB565 and a 16-bit z-buffer. Which of Mesa's renderers draws, its
// environment selects (GALLIUM_DRIVER).
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <cstddef>
#include <vector>

#include "bench/peer_programs/peer_program.hpp"

namespace zstrip::peer {
namespace {

struct DestroyContext {
  void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
};

// OpenGL takes offsets in a buffer as pointers. NOLINTNEXTLINE(performance-no-int-to-ptr)
const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

class MesaRenderer : public Renderer {
 public:
  MesaRenderer(const Scene& scene, int width, int height)
      : pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
        context_(OSMesaCreateContextExt(OSMESA_RGB_565, 16, 0, 0, nullptr)),
        indices_(static_cast<GLsizei>(3 * scene.triangles().size())) {
    if (!context_ ||
        OSMesaMakeCurrent(context_.get(), pixels_.data(), GL_UNSIGNED_SHORT_5_6_5, width, height) == GL_FALSE) {
      throw std::runtime_error("OSMesa cannot draw RGB565 into memory");
    }
    glViewport(0, 0, width, height);
    const Colour c = scene.background();
    glClearColor(static_cast<float>(c.r) / 255, static_cast<float>(c.g) / 255, static_cast<float>(c.b) / 255, 1);
    glDisable(GL_DITHER);
    glEnable(GL_DEPTH_TEST);
    if (!scene.double_sided()) glEnable(GL_CULL_FACE);
    glShadeModel(scene.smooth() ? GL_SMOOTH : GL_FLAT);
    upload(scene);
    if (scene.texture() != nullptr) upload(*scene.texture());
    if (glGetError() != GL_NO_ERROR) throw std::runtime_error("OSMesa refuses the scene");
  }

  void draw(const View& view) override {
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(view.projection.data());
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(view.modelview.data());
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, indices_, GL_UNSIGNED_SHORT, nullptr);
    glFinish();
  }

  std::span<const std::uint16_t> pixels() const override { return pixels_; }

 private:
  static void upload(const Scene& scene) {
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.vertices().size_bytes()), scene.vertices().data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.triangles().size_bytes()),
                 scene.triangles().data(), GL_STATIC_DRAW);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, x)));
    glEnableClientState(GL_VERTEX_ARRAY);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), offset(offsetof(Vertex, r)));
    glEnableClientState(GL_COLOR_ARRAY);
    if (scene.texture() == nullptr) return;
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), offset(offsetof(Vertex, u)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  }

  static void upload(const Texture& texture) {
    glEnable(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB565, 1 << texture.log2_width, 1 << texture.log2_height, 0, GL_RGB,
                 GL_UNSIGNED_SHORT_5_6_5, texture.texels.data());
  }

  std::vector<std::uint16_t> pixels_;
  std::unique_ptr<osmesa_context, DestroyContext> context_;
  GLsizei indices_;
};

}  // namespace

std::unique_ptr<Renderer> make_renderer(const Scene& scene, int width, int height) {
  return std::make_unique<MesaRenderer>(scene, width, height);
}

}  // namespace zstrip::peer
