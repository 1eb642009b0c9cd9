#include "murosimf/modules/camera/sight_errors.h"

namespace murosimf {

const std::vector<ErrorParameter<SightErrors>>& sightParameters() {
  using E = SightErrors;
  static const std::vector<ErrorParameter<SightErrors>> parameters = {
      {"bearing_noise", "rad", 0, 1, &E::bearing_noise, "standard deviation of the bearing"},
      {"distance_noise", "1", 0, 1, &E::distance_noise, "standard deviation of the distance, share of it"},
      {"bearing_bias", "rad", -1, 1, &E::bearing_bias, "always added to the bearing; positive: to the left"},
      {"distance_bias", "1", -0.9, 10, &E::distance_bias, "always added to the distance, share of it"},
      {"miss", "1", 0, 1, &E::miss, "probability that a thing is overlooked"},
      {"false_rate", "1/s", 0, 100, &E::false_rate, "how often something is told that is not there"},
      {"delay", "s", 0, 10, &E::delay, "from the look to the arrival"},
      {"outage_rate", "1/s", 0, 10, &E::outage_rate, "how often phases begin in which nothing is seen"},
      {"outage_length", "s", 0, 60, &E::outage_length, "how long such a phase lasts"},
      {"range", "m", 0.3, 1000, &E::range, "farther things are not seen"},
      {"occlusion", "", 0, 1, &E::occlusion, "1: things hide what is behind them; 0: they do not"}};
  return parameters;
}

}  // namespace murosimf
