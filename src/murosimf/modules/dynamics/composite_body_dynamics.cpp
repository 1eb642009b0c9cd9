#include "murosimf/modules/dynamics/composite_body_dynamics.h"

#include <fmt/format.h>

#include <stdexcept>

#include "murosimf/linking/links.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

namespace {

/// Room for the matrix in a column with one place a body. Rows are short where a tree branches, and long along a chain:
/// this is their longest mean.
struct MatrixShare {
  double numbers[48] = {};
};
constexpr Variable<MatrixShare> kMassMatrix{"mass_matrix", "SI", "rows of the mass matrix", Storage::kStep};

}  // namespace

void CompositeBodyDynamics::declare(Declaration& d) const {
  FullDynamics::declare(d);
  d.adds(kMassMatrix, subset::kBodies);
}

void CompositeBodyDynamics::link(Links& links) {
  plan_ = planMassMatrix(bind(links, arguments_));
  const int room = arguments_.tree.bodies * Variable<MatrixShare>::kComponents;
  if (plan_.entries > room) {
    throw std::invalid_argument(
        fmt::format("the mass matrix of a tree with so long chains has {} numbers; expected at most {}, {} a body: "
                    "choose multibody_dynamics, whose cost does not grow with depth",
                    plan_.entries, room, Variable<MatrixShare>::kComponents));
  }
  arguments_.matrix_rows = plan_.rows.data();
  arguments_.matrix = links.column(kMassMatrix, subset::kBodies);
  kernel_ = kernelOfWidth<CompositeBodyArguments>(links.width());
}

}  // namespace murosimf
