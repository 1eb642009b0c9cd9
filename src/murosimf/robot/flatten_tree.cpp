#include "murosimf/robot/flatten_tree.h"

#include <utility>

namespace murosimf {
namespace {

/// Walks the elements once, parents before children.
class Flattener {
 public:
  explicit Flattener(const KinematicTree& tree) : tree_(tree) {}

  FlatTree run() {
    for (const TreeElement& element : tree_.elements) place(element);
    for (std::size_t body = 0; body < tree_.bodies.size(); ++body) carry(static_cast<int>(body));
    return std::move(flat_);
  }

 private:
  void place(const TreeElement& element) {
    if (element.parent < 0) {
      addRow({}, element.name);
      return places_.push_back({0, Pose{}});
    }
    const RowPlace parent = places_[static_cast<std::size_t>(element.parent)];
    if (element.joint >= 0) return places_.push_back(placeJoint(element, parent));
    places_.push_back({parent.row, parent.X_RB * Pose{element.rotation, element.translation}});
  }

  /// The element's frame E before and after the motion, re-framed to F: X_PF = X_PE X_EF, and E on the new row is X_FE.
  RowPlace placeJoint(const TreeElement& element, const RowPlace& parent) {
    const Joint& joint = tree_.joints[static_cast<std::size_t>(element.joint)];
    const AxisFrame frame = frameOfAxis(joint.axis);
    const Pose X_PF{parent.X_RB.rotation * frame.R_ER, parent.X_RB.translation};
    const bool turned = !(X_PF.rotation == Rotation3{});
    addRow({parent.row, joint.kind, frame.k, turned, X_PF}, element.name);
    return {flat_.table.jointCount(), {transposed(frame.R_ER), Vector3{}}};
  }

  void addRow(const TreeRow& row, const std::string& name) {
    flat_.table.rows.push_back(row);
    flat_.row_mass.emplace_back();
    flat_.row_bodies.emplace_back();
    flat_.row_names.push_back(name);
  }

  void carry(int index) {
    const Body& body = tree_.bodies[static_cast<std::size_t>(index)];
    const RowPlace place = places_[static_cast<std::size_t>(body.element)];
    const auto row = static_cast<std::size_t>(place.row);
    flat_.bodies.push_back(place);
    flat_.row_mass[row] = welded(flat_.row_mass[row], moved(place.X_RB, body.mass));
    if (flat_.row_bodies[row].empty()) flat_.row_names[row] = body.name;
    flat_.row_bodies[row].push_back(index);
  }

  const KinematicTree& tree_;
  std::vector<RowPlace> places_;  ///< of each element
  FlatTree flat_;
};

}  // namespace

FlatTree flattenTree(const KinematicTree& tree) { return Flattener(tree).run(); }

AxisFrame frameOfAxis(const Vector3& axis) {
  int k = 0;
  for (int i = 1; i < 3; ++i) {
    if (abs(axis[i]) > abs(axis[k])) k = i;
  }
  Vector3 next;  // e_(k+1), made perpendicular to the axis
  next[(k + 1) % 3] = 1;
  next = normalized(next - axis * axis[(k + 1) % 3]);
  Vector3 columns[3];
  columns[k] = axis;
  columns[(k + 1) % 3] = next;
  columns[(k + 2) % 3] = cross(axis, next);
  return {k, {columns[0], columns[1], columns[2]}};
}

}  // namespace murosimf
