// Prepares a scene as its method requires.
#include "visibility/prepared_scene.hpp"

#include <fmt/format.h>

#include <utility>

#include "visibility/methods.hpp"
#include "visibility/newell.hpp"

namespace zstrip::sim {
namespace {

/// Adds the name of the method to a failure.
Failure of_method(Effects method, const Failure& failure) {
  return {failure.status,
          fmt::format("--visibility {}: {}; choose another method", visibility_name(method), failure.message)};
}

}  // namespace

Result<PreparedScene> PreparedScene::of(const Staging& original, Effects method) {
  // Checks the original scene: the scene that is made below no longer has its features.
  if (const Result<Done> checked = check_visibility(effects_of(original.scene, original.camera) | method); !checked) {
    return checked.failure();
  }
  PreparedScene prepared(original);
  if (!method.any(method::orders)) return prepared;
  if (method.has(method::bsp) && !original.tree.nodes.empty()) return prepared;  // the tree was baked
  Result<PolygonSoup> soup = soup_of(original.scene);
  if (!soup) return of_method(method, soup.failure());
  if (method.has(method::bsp)) {
    Result<BakedBsp> baked = bake_bsp(*soup);
    if (!baked) return of_method(method, baked.failure());
    prepared.made_ = std::make_shared<const BakedBsp>(std::move(*baked));
    return prepared;
  }
  Result<NewellOrder> order = newell_order(*soup, original.camera);
  if (!order) return of_method(method, order.failure());
  Result<SoupScene> scene = SoupScene::of(order->soup);
  if (!scene) return of_method(method, scene.failure());
  prepared.made_ = std::make_shared<const BakedBsp>(BakedBsp{std::move(*scene), {}, 0, order->splits});
  return prepared;
}

}  // namespace zstrip::sim
