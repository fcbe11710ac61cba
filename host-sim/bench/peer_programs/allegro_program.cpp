// Allegro 4 draws triangles; what comes before, each vertex transformed once and back faces culled, is here.
#define ALLEGRO_NO_MAGIC_MAIN
#define ALLEGRO_NO_FIX_ALIASES
#include <allegro.h>

#include <vector>

#include "bench/peer_programs/peer_program.hpp"

namespace zstrip::peer {
namespace {

struct DestroyBitmap {
  void operator()(BITMAP* bitmap) const { destroy_bitmap(bitmap); }
};
struct DestroyZBuffer {
  void operator()(ZBUFFER* zbuffer) const { destroy_zbuffer(zbuffer); }
};
using Bitmap = std::unique_ptr<BITMAP, DestroyBitmap>;

Bitmap make_bitmap(int width, int height) {
  Bitmap bitmap(create_bitmap_ex(16, width, height));
  if (!bitmap) throw std::runtime_error("Allegro has no memory for a bitmap");
  return bitmap;
}

class AllegroRenderer : public Renderer {
 public:
  AllegroRenderer(const Scene& scene, int width, int height)
      : scene_(scene), width_(width), height_(height), snapped_(scene.vertices().size()) {
    if (install_allegro(SYSTEM_NONE, &errno, nullptr) != 0) throw std::runtime_error("Allegro does not start");
    set_color_depth(16);
    picture_ = make_bitmap(width, height);
    zbuffer_.reset(create_zbuffer(picture_.get()));
    if (!zbuffer_) throw std::runtime_error("Allegro has no memory for a z-buffer");
    set_zbuffer(zbuffer_.get());
    const Colour c = scene.background();
    background_ = makecol16(c.r, c.g, c.b);
    type_ = POLYTYPE_ZBUF | (scene.smooth() ? POLYTYPE_GRGB : POLYTYPE_FLAT);
    if (const Texture* texture = scene.texture()) {
      type_ = POLYTYPE_ZBUF | POLYTYPE_PTEX;
      texture_ = make_bitmap(1 << texture->log2_width, 1 << texture->log2_height);
      for (int y = 0; y < texture_->h; ++y) {
        for (int x = 0; x < texture_->w; ++x) {
          putpixel(texture_.get(), x, y,
                   texture->texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(texture_->w) +
                                   static_cast<std::size_t>(x)]);
        }
      }
    }
    for (std::size_t i = 0; i < snapped_.size(); ++i) {
      const Vertex& vertex = scene.vertices()[i];
      snapped_[i].c =
          scene.smooth() ? vertex.r << 16 | vertex.g << 8 | vertex.b : makecol16(vertex.r, vertex.g, vertex.b);
      if (texture_) {
        snapped_[i].u = vertex.u * static_cast<float>(texture_->w);
        snapped_[i].v = vertex.v * static_cast<float>(texture_->h);
      }
    }
  }

  void draw(const View& view) override {
    clear_to_color(picture_.get(), background_);
    clear_zbuffer(zbuffer_.get(), 0);
    transform(view);
    for (const Triangle& t : scene_.triangles()) {
      V3D_f &a = snapped_[t.a], &b = snapped_[t.b], &c = snapped_[t.c];
      if (!scene_.double_sided() && (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y) >= 0) continue;
      triangle3d_f(picture_.get(), type_, texture_.get(), &a, &b, &c);
    }
  }

  std::span<const std::uint16_t> pixels() const override {
    return {reinterpret_cast<const std::uint16_t*>(picture_->dat),
            static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)};
  }

 private:
  /// Nothing of the workloads reaches behind the camera.
  void transform(const View& view) {
    const std::array<float, 16>& m = view.modelview;
    const float across = view.projection[0] * static_cast<float>(width_) / 2;
    const float down = view.projection[5] * static_cast<float>(height_) / 2;
    const float middle_x = static_cast<float>(width_) / 2, middle_y = static_cast<float>(height_) / 2;
    for (std::size_t i = 0; i < snapped_.size(); ++i) {
      const Vertex& v = scene_.vertices()[i];
      const float depth = -(m[2] * v.x + m[6] * v.y + m[10] * v.z + m[14]);
      if (depth <= 0) throw std::runtime_error("a vertex behind the camera, which is not clipped here");
      const float reciprocal = 1 / depth;
      snapped_[i].x = middle_x + (m[0] * v.x + m[4] * v.y + m[8] * v.z + m[12]) * across * reciprocal;
      snapped_[i].y = middle_y - (m[1] * v.x + m[5] * v.y + m[9] * v.z + m[13]) * down * reciprocal;
      snapped_[i].z = depth;
    }
  }

  const Scene& scene_;
  int width_, height_;
  Bitmap picture_, texture_;
  std::unique_ptr<ZBUFFER, DestroyZBuffer> zbuffer_;
  int background_ = 0, type_ = 0;
  std::vector<V3D_f> snapped_;
};

}  // namespace

std::unique_ptr<Renderer> make_renderer(const Scene& scene, int width, int height) {
  return std::make_unique<AllegroRenderer>(scene, width, height);
}

}  // namespace zstrip::peer
