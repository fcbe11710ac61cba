// Makes a model smaller before it is converted: halves textures, removes triangles.
#include "import/reduction.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "image/resample.hpp"
#include "import/surface.hpp"

namespace zstrip::sim {
namespace {

using Indices = std::vector<std::uint32_t>;

/// The largest difference of a colour's channel across a triangle that may be removed.
constexpr int kSameColour = 24;

bool changes_colour(const SourceMesh& mesh, std::size_t triangle) {
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const auto at = [&](std::size_t corner) {
      return int{mesh.vertices[mesh.indices[triangle + corner]].colour[channel]};
    };
    const auto [low, high] = std::minmax({at(0), at(1), at(2)});
    if (high - low > kSameColour) return true;
  }
  return false;
}

/// A mesh whose triangles are removed.
class Simplified {
 public:
  explicit Simplified(const SourceMesh& mesh) : mesh_(mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      Indices& indices = mesh.has_colours && changes_colour(mesh, i) ? kept_ : free_;
      indices.insert(indices.end(), mesh.indices.begin() + static_cast<std::ptrdiff_t>(i),
                     mesh.indices.begin() + static_cast<std::ptrdiff_t>(i + 3));
    }
    scale_ =
        double{meshopt_simplifyScale(mesh.vertices[0].position.data(), mesh.vertices.size(), sizeof(SourceVertex))};
    result_ = mesh.indices;
  }

  double scale() const { return scale_; }
  std::size_t triangles() const { return result_.size() / 3; }
  double error() const { return error_; }
  Indices& result() { return result_; }

  /// Removes as much as `error`, a length, allows. A mesh never vanishes.
  void simplify(double error) {
    Indices left(free_.size());
    float reached = 0;
    if (!free_.empty() && scale_ > 0) {
      left.resize(meshopt_simplify(left.data(), free_.data(), free_.size(), mesh_.vertices[0].position.data(),
                                   mesh_.vertices.size(), sizeof(SourceVertex), 0, static_cast<float>(error / scale_),
                                   meshopt_SimplifyLockBorder, &reached));
    }
    if (left.size() + kept_.size() == 0) return;
    left.insert(left.end(), kept_.begin(), kept_.end());
    result_ = std::move(left);
    error_ = double{reached} * scale_;
  }

 private:
  const SourceMesh& mesh_;
  Indices free_, kept_;
  double scale_ = 0;
  Indices result_;
  double error_ = 0;
};

}  // namespace

void shrink_textures(SourceModel& model, std::uint32_t side) {
  for (RgbImage& texture : model.textures) {
    while (std::max(texture.width, texture.height) > side) {
      texture = halve(texture, texture.width > 1, texture.height > 1);
    }
  }
}

Reduced remove_triangles(SourceModel& model, const Reduction& reduction) {
  std::vector<Simplified> meshes;
  meshes.reserve(model.meshes.size());
  Reduced reduced;
  double largest = 0;
  for (const SourceMesh& mesh : model.meshes) {
    meshes.emplace_back(mesh);
    reduced.triangles_before += meshes.back().triangles();
    largest = std::max(largest, meshes.back().scale());
  }
  const auto count = [&] {
    std::uint64_t sum = 0;
    for (const Simplified& mesh : meshes) sum += mesh.triangles();
    return sum;
  };
  std::uint64_t limit = reduced.triangles_before;
  if (reduction.triangles > 0) limit = std::min(limit, reduction.triangles);
  if (reduction.triangle_share < 1) {
    limit = std::min(limit, static_cast<std::uint64_t>(
                                std::ceil(static_cast<double>(reduced.triangles_before) * reduction.triangle_share)));
  }
  const auto keeps_limit = [&](double error) {
    for (Simplified& mesh : meshes) mesh.simplify(error);
    return count() <= limit;
  };
  if (count() > limit && largest > 0) {
    // The smallest error, in even steps of its logarithm, whose result keeps the limit.
    constexpr double kSmallest = 1e-6;
    constexpr int kSteps = 10;
    double low = std::log(largest * kSmallest), high = std::log(largest);
    if (keeps_limit(largest)) {
      for (int step = 0; step < kSteps; ++step) {
        const double middle = (low + high) / 2;
        (keeps_limit(std::exp(middle)) ? high : low) = middle;
      }
      keeps_limit(std::exp(high));
    }
  }
  reduced.triangles = count();
  reduced.keeps_limit = reduced.triangles <= limit;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    reduced.error = std::max(reduced.error, meshes[i].error());
    model.meshes[i].indices = std::move(meshes[i].result());
    weld(model.meshes[i]);
  }
  return reduced;
}

}  // namespace zstrip::sim
