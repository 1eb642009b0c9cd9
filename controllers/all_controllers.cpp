#include "all_controllers.h"

#include "cart/cart.h"
#include "player/player.h"
#include "trotter/trotter.h"

namespace murosimf::controllers {

const std::map<std::string, MakeController>& allControllers() {
  static const std::map<std::string, MakeController> all{{"cart", [] { return cart::makeCart(); }},
                                                         {"player", [] { return makePlayer(); }},
                                                         {"trotter", [] { return trotter::makeTrotter(); }}};
  return all;
}

}  // namespace murosimf::controllers
