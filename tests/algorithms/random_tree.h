#pragma once

/// @file Trees of random shape, mass and motion, for tests of dynamics on any scalar.

#include <random>
#include <vector>

#include "murosimf/algorithms/articulated_body.h"
#include "murosimf/algorithms/composite_body.h"
#include "murosimf/algorithms/ground_contact.h"
#include "murosimf/algorithms/tree_motion.h"

namespace murosimf::test {

/// A tree and all columns that dynamics read and write, for S = double or a pack whose lanes hold different robots.
template <class S>
struct RandomTree {
  static constexpr int kLanes = static_cast<int>(sizeof(S) / sizeof(double));

  TreeTable table;
  std::vector<KernelRow> rows;
  GatherPlan gather;
  MassMatrixPlan matrix_plan;
  std::vector<S> q, dq, torque, joint_inertia, ddq, up_height, touch, matrix;
  std::vector<SinCos<S>> turn;
  std::vector<RigidInertia<S>> inertia;
  std::vector<SpatialMotion<S>> velocity, acceleration;
  std::vector<SpatialForce<S>> force;
  std::vector<Vec3<S>> up;
  std::vector<JointResponse<S>> response;
  std::vector<ArticulatedInertia<S>> slot_inertia, contact;
  std::vector<SpatialForce<S>> slot_bias;

  std::size_t bodies() const { return rows.size(); }

  /// @param seeds  one for the numbers of each lane; the shape of the tree comes from `shape`
  RandomTree(int joints, unsigned shape, const std::vector<unsigned>& seeds) {
    std::mt19937 random(shape);
    table = shapeOf(joints, random);
    rows = kernelRows(table);
    gather = planGathering(table);
    matrix_plan = planMassMatrix(table);
    resize(static_cast<std::size_t>(joints));
    for (int lane = 0; lane < kLanes; ++lane) fill(lane, seeds[static_cast<std::size_t>(lane)]);
    for (std::size_t j = 0; j < q.size(); ++j) turn[j] = jointTurn(rows[j + 1], q[j]);
    treeMotion(rows.data(), static_cast<int>(bodies()),
               TreeMotion<S>{turn.data(), dq.data(), velocity.data(), up.data(), up_height.data()});
  }
  ArticulatedTree tree() const { return {rows.data(), gather.rows.data(), static_cast<int>(bodies())}; }
  ArticulatedBody<S> articulated() { return {columns(), response.data()}; }
  CompositeBody<S> composite() { return {columns(), matrix_plan.rows.data(), matrix.data()}; }
  /// What the contacts of touched bodies add to their inertia.
  void addContact(int i, ArticulatedInertia<S>& Ic) const {
    const std::size_t body = static_cast<std::size_t>(i);
    ArticulatedInertia<S> with = Ic;
    with += contact[body];
    Ic = select(touch[body] > S(0), with, Ic);
  }
  /// Four points of some kilograms each on every third body or so, as contacts of steps of milliseconds are; not on the
  /// same bodies in all lanes.
  void touchGround(const std::vector<unsigned>& seeds) {
    for (int lane = 0; lane < kLanes; ++lane) {
      std::mt19937 random(seeds[static_cast<std::size_t>(lane)] + 77);
      std::uniform_real_distribution<double> number(-1, 1);
      for (std::size_t i = 0; i < bodies(); ++i) {
        const bool touches = random() % 3 == 0;
        ArticulatedInertia<double> sum{};
        const Vector3 normal = rotationExp(Vector3{number(random), number(random), number(random)}).z;
        for (int point = 0; point < 4; ++point) {
          const Vector3 r{0.1 * number(random), 0.1 * number(random), 0.1 * number(random)};
          addPointMass(sum, r, normal, 1.0, 3 + 2 * number(random));
        }
        put(touch[i], lane, touches ? 1 : 0);
        const auto* numbers = reinterpret_cast<const double*>(&sum);
        for (std::size_t k = 0; k < sizeof(sum) / sizeof(double); ++k)
          put(reinterpret_cast<S*>(&contact[i])[k], lane, touches ? numbers[k] : 0);
      }
    }
  }

 private:
  TreeDynamics<S> columns() {
    return {turn.data(),  dq.data(),           torque.data(), joint_inertia.data(), inertia.data(),  velocity.data(),
            force.data(), acceleration.data(), ddq.data(),    slot_inertia.data(),  slot_bias.data()};
  }
  static TreeTable shapeOf(int joints, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    TreeTable table;
    table.rows.emplace_back();
    for (int i = 1; i <= joints; ++i) {
      TreeRow row;
      const bool branches = random() % 4 == 0;
      row.parent = branches ? static_cast<int>(random() % static_cast<unsigned>(i)) : i - 1;
      row.kind = random() % 4 == 0 ? JointKind::kPrismatic : JointKind::kRevolute;
      row.axis = static_cast<int>(random() % 3);
      row.turned = random() % 3 == 0;
      if (row.turned) row.X_PF.rotation = rotationExp(Vector3{2 * number(random), 2 * number(random), number(random)});
      row.X_PF.translation = {0.3 * number(random), 0.3 * number(random), 0.3 * number(random)};
      table.rows.push_back(row);
    }
    return table;
  }
  void resize(std::size_t joints) {
    for (auto* column : {&q, &dq, &torque, &joint_inertia, &ddq}) column->resize(joints);
    turn.resize(joints), response.resize(joints);
    inertia.resize(joints + 1), velocity.resize(joints + 1), acceleration.resize(joints + 1);
    force.resize(joints + 1), up.resize(joints + 1), up_height.resize(joints + 1);
    touch.assign(joints + 1, S(0)), contact.resize(joints + 1);
    matrix.resize(static_cast<std::size_t>(matrix_plan.entries));
    slot_inertia.resize(static_cast<std::size_t>(gather.slots)), slot_bias.resize(slot_inertia.size());
  }
  static void put(S& target, int lane, double value) { reinterpret_cast<double*>(&target)[lane] = value; }
  static void put(Vec3<S>& target, int lane, const Vector3& value) {
    put(target.x, lane, value.x), put(target.y, lane, value.y), put(target.z, lane, value.z);
  }
  void fill(int lane, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1), share(0.1, 1);
    const auto vector = [&](double size) {
      return Vector3{size * number(random), size * number(random), size * number(random)};
    };
    for (std::size_t j = 0; j < q.size(); ++j) {
      put(q[j], lane, 2 * number(random)), put(dq[j], lane, 5 * number(random));
      put(torque[j], lane, 3 * number(random)), put(joint_inertia[j], lane, random() % 2 ? 0.01 * share(random) : 0);
    }
    for (std::size_t i = 0; i < bodies(); ++i) {
      const double m = share(random);
      const Vector3 edges{0.1 * share(random), 0.1 * share(random), 0.1 * share(random)}, c = vector(0.05);
      const Rotation3 R = rotationExp(vector(1));
      const Symmetric3<double> box{m / 12 * (edges.y * edges.y + edges.z * edges.z),
                                   m / 12 * (edges.x * edges.x + edges.z * edges.z),
                                   m / 12 * (edges.x * edges.x + edges.y * edges.y)};
      const RigidInertia<double> rigid = shifted(RigidInertia<double>{m, {0, 0, 0}, turned(R, box)}, c);
      put(inertia[i].m, lane, rigid.m), put(inertia[i].mc, lane, rigid.mc);
      const double numbers[6] = {rigid.I.xx, rigid.I.yy, rigid.I.zz, rigid.I.xy, rigid.I.xz, rigid.I.yz};
      S* targets[6] = {&inertia[i].I.xx, &inertia[i].I.yy, &inertia[i].I.zz,
                       &inertia[i].I.xy, &inertia[i].I.xz, &inertia[i].I.yz};
      for (int k = 0; k < 6; ++k) put(*targets[k], lane, numbers[k]);
      put(force[i].n, lane, vector(1)), put(force[i].f, lane, vector(5));
    }
    put(velocity[0].w, lane, vector(3)), put(velocity[0].v, lane, vector(2));
    put(up[0], lane, rotationExp(vector(2)).z), put(up_height[0], lane, 0.3);
  }
};

}  // namespace murosimf::test
