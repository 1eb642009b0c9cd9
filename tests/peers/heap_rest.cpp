#include "peers/heap_rest.h"

#include <algorithm>

#include "murosimf/algorithms/collision/detect_contact.h"
#include "murosimf/algorithms/tree_rows.h"

namespace murosimf::peers {

namespace {

std::vector<Pose> rowPoses(const RobotBlueprint& print, const PeerState& state) {
  const std::vector<KernelRow> rows = kernelRows(print.flat.table);
  std::vector<Pose> X_WR{state.X_WB};
  for (std::size_t i = 1; i < rows.size(); ++i)
    X_WR.push_back(childPose(X_WR[static_cast<std::size_t>(rows[i].parent)], rows[i], state.q[i - 1]));
  return X_WR;
}

/// V of the body on a row, in its own axes, about its origin.
SpatialMotion<double> motionOn(const TreeRow& row, const Pose& X_WP, const Pose& X_WR, const SpatialMotion<double>& V_P,
                               double dq) {
  const Vector3 p_PR = applyInverse(X_WP, X_WR.translation);
  const auto turned = [&](const Vector3& v_P) { return applyTransposed(X_WR.rotation, X_WP.rotation * v_P); };
  SpatialMotion<double> V{turned(V_P.w), turned(V_P.v + cross(V_P.w, p_PR))};
  const Vector3 axis = row.axis == 0 ? kAxisX : row.axis == 1 ? kAxisY : kAxisZ;
  (row.kind == JointKind::kRevolute ? V.w : V.v) += axis * dq;
  return V;
}

/// Twice the energy: w . I_C w + m |v_C|^2.
double twiceTheEnergy(const MassProperties& body, const SpatialMotion<double>& V) {
  const SymmetricMatrix& I = body.I_C_B;
  const Vector3& w = V.w;
  const Vector3 Iw{I.xx * w.x + I.xy * w.y + I.xz * w.z, I.xy * w.x + I.yy * w.y + I.yz * w.z,
                   I.xz * w.x + I.yz * w.y + I.zz * w.z};
  return dot(w, Iw) + body.mass * squaredNorm(V.v + cross(w, body.p_BC_B));
}

}  // namespace

void HeapRest::add(const PeerBody& a, const PeerBody& b, double depth) {
  ++points;
  pairs.insert(std::minmax(a, b));
  deepest = std::max(deepest, depth);
}

void addGroundContacts(const RobotBlueprint& print, int robot, const PeerState& state, HeapRest& rest) {
  const std::vector<Pose> X_WR = rowPoses(print, state);
  for (std::size_t i = 0; i < print.model.tree.bodies.size(); ++i) {
    const RowPlace& body = print.flat.bodies[i];
    for (const BodyShape& shape : print.model.tree.bodies[i].shapes) {
      if (!shape.collides) continue;
      ContactManifold manifold;
      detectContact(collisionShapeOf(shape.shape), X_WR[static_cast<std::size_t>(body.row)] * (body.X_RB * shape.X_BS),
                    collisionPlane(), {}, manifold);
      for (int k = 0; k < manifold.count; ++k) rest.add({robot, body.row}, {}, manifold.points[k].depth);
    }
  }
}

double kineticEnergy(const RobotBlueprint& print, const PeerState& state) {
  const std::vector<Pose> X_WR = rowPoses(print, state);
  std::vector<SpatialMotion<double>> V{state.V_B};
  double twice = twiceTheEnergy(print.flat.row_mass[0], V[0]);
  for (std::size_t i = 1; i < X_WR.size(); ++i) {
    const TreeRow& row = print.flat.table.rows[i];
    const auto parent = static_cast<std::size_t>(row.parent);
    const double dq = state.dq[i - 1];
    V.push_back(motionOn(row, X_WR[parent], X_WR[i], V[parent], dq));
    const auto& servo = print.model.tree.joints[i - 1].servo;
    twice += twiceTheEnergy(print.flat.row_mass[i], V[i]) + (servo ? servo->armature : 0.0) * dq * dq;
  }
  return twice / 2;
}

}  // namespace murosimf::peers
