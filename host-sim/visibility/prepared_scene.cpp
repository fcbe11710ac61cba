// Chooses what the method needs.
#include "visibility/prepared_scene.hpp"

#include <utility>

#include "visibility/methods.hpp"
#include "visibility/newell.hpp"

namespace zstrip::sim {

Result<PreparedScene> PreparedScene::of(const Staging& original, Effects method) {
  // Of the scene as it is: what is made of it below has lost what it cannot have.
  if (const Result<Done> checked = check_visibility(effects_of(original.scene, original.camera) | method); !checked) {
    return checked.failure();
  }
  PreparedScene prepared(original);
  if (!method.any(method::orders)) return prepared;
  Result<PolygonSoup> soup = soup_of(original.scene);
  if (!soup) return soup.failure();
  if (method.has(method::bsp)) {
    Result<BakedBsp> baked = bake_bsp(*soup);
    if (!baked) return baked.failure();
    prepared.made_ = std::make_shared<const BakedBsp>(std::move(*baked));
    prepared.tree_ = prepared.made_->tree();
    return prepared;
  }
  Result<NewellOrder> order = newell_order(*soup, original.camera);
  if (!order) return order.failure();
  Result<SoupScene> scene = SoupScene::of(order->soup);
  if (!scene) return scene.failure();
  prepared.made_ = std::make_shared<const BakedBsp>(BakedBsp{std::move(*scene), {}, 0, order->splits});
  return prepared;
}

}  // namespace zstrip::sim
