/// @file The flattened table moves every body as the tree of elements does, and weighs the same.

#include "murosimf/robot/flatten_tree.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "built_ks21.h"
#include "murosimf/math/random.h"
#include "murosimf/robot/tree_builder.h"
#include "murosimf/robot/urdf_reader.h"

namespace murosimf {
namespace {

using testing::builtKs21;

void expectSameRow(const TreeRow& a, const TreeRow& b, const std::string& name) {
  EXPECT_EQ(a.parent, b.parent) << name;
  EXPECT_EQ(a.kind, b.kind) << name;
  EXPECT_EQ(a.axis, b.axis) << name;
  EXPECT_EQ(a.turned, b.turned) << name;
  EXPECT_EQ(a.X_PF, b.X_PF) << name;
}

void expectNear(const MassProperties& a, const MassProperties& b, double tolerance) {
  EXPECT_NEAR(a.mass, b.mass, tolerance * a.mass);
  EXPECT_NEAR(norm(a.p_BC_B - b.p_BC_B), 0, tolerance);
  const SymmetricMatrix& i = a.I_C_B;
  const SymmetricMatrix& k = b.I_C_B;
  const double scale = tolerance * (i.xx + i.yy + i.zz);
  EXPECT_NEAR(i.xx, k.xx, scale);
  EXPECT_NEAR(i.yy, k.yy, scale);
  EXPECT_NEAR(i.zz, k.zz, scale);
  EXPECT_NEAR(i.xy, k.xy, scale);
  EXPECT_NEAR(i.xz, k.xz, scale);
  EXPECT_NEAR(i.yz, k.yz, scale);
}

TEST(FlattenTree, Ks21BuiltInCppIsTheOneReadFromItsFile) {
  Diagnostics diagnostics;
  const ReadResult model = readUrdf(MUROSIMF_SOURCE_DIR "/robots/ks21.urdf", diagnostics);
  ASSERT_TRUE(model.has_value()) << diagnostics.text();
  const KinematicTree built = builtKs21();
  const FlatTree a = flattenTree(model->tree), b = flattenTree(built);
  EXPECT_EQ(a.row_names, b.row_names);
  ASSERT_EQ(a.table.rows.size(), b.table.rows.size());
  for (std::size_t row = 0; row < a.table.rows.size(); ++row) {
    expectSameRow(a.table.rows[row], b.table.rows[row], a.row_names[row]);
    expectNear(a.row_mass[row], b.row_mass[row], 1e-9);
  }
  ASSERT_EQ(model->tree.joints.size(), built.joints.size());
  for (std::size_t j = 0; j < built.joints.size(); ++j) {
    const Joint& read = model->tree.joints[j];
    EXPECT_EQ(read.name, built.joints[j].name);
    EXPECT_NEAR(read.limits.lower, built.joints[j].limits.lower, 1e-9);
    EXPECT_NEAR(read.limits.upper, built.joints[j].limits.upper, 1e-9);
    EXPECT_EQ(read.servo, built.joints[j].servo);
    EXPECT_EQ(read.damping, built.joints[j].damping);
  }
}

TEST(FlattenTree, Ks21NeedsNoTurnedRow) {
  for (const TreeRow& row : flattenTree(builtKs21()).table.rows) {
    EXPECT_FALSE(row.turned);
    EXPECT_EQ(row.X_PF.rotation, Rotation3{});
  }
}

TEST(FlattenTree, NegativeCoordinateAxisIsReframedWithoutRounding) {
  for (int k = 0; k < 3; ++k) {
    Vector3 axis;
    axis[k] = -1;
    const AxisFrame frame = frameOfAxis(axis);
    EXPECT_EQ(frame.k, k);
    EXPECT_EQ(transposed(frame.R_ER) * frame.R_ER, Rotation3{});
    Vector3 coordinate;
    coordinate[k] = 1;
    EXPECT_EQ(frame.R_ER * coordinate, axis);
  }
}

TEST(FlattenTree, BodiesOnFixedElementsShareARowAndKeepTheirPlaces) {
  const MassProperties cube = boxMass(1, {0.1, 0.1, 0.1}, {});
  TreeBuilder builder;
  const TreePlace fork = builder.base("base").body({.name = "left", .mass = cube}).fork();
  fork.translation({0, 0.2, 0}).body({.name = "right", .mass = cube}).translation({0, 0, 1}).body({.name = "mark"});
  fork.revolute("hinge", kAxisY).translation({1, 0, 0}).body({.name = "arm", .mass = cube});
  const FlatTree flat = flattenTree(builder.build());
  ASSERT_EQ(flat.table.bodyCount(), 2);
  EXPECT_EQ(flat.row_names, (std::vector<std::string>{"left", "arm"}));
  EXPECT_EQ(flat.row_bodies[0], (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(flat.bodies[2].X_RB.translation, (Vector3{0, 0.2, 1}));
  EXPECT_EQ(flat.bodies[3].row, 1);
  EXPECT_EQ(flat.row_mass[0].mass, 2);
  EXPECT_EQ(flat.row_mass[0].p_BC_B, (Vector3{0, 0.1, 0}));
  // Two cubes at distance .2: I_xx = 2 m (a^2/6 + .1^2), I_yy = 2 m a^2/6.
  EXPECT_NEAR(flat.row_mass[0].I_C_B.xx, 2 * (0.01 / 6 + 0.01), 1e-15);
  EXPECT_NEAR(flat.row_mass[0].I_C_B.yy, 2 * (0.01 / 6), 1e-15);
}

/// Random numbers of one tree, in order.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : stream_(seed, "tree", 0) {}
  double number(double low, double high) { return stream_.uniform(step_++, low, high); }
  int below(int n) { return static_cast<int>(number(0, n)); }
  Vector3 vector(double size) {
    const double x = number(-size, size), y = number(-size, size), z = number(-size, size);
    return {x, y, z};
  }

 private:
  RandomStream stream_;
  std::uint64_t step_ = 0;
};

/// One to four elements on a place, with skew and coordinate axes of either sign, and a body at the end.
TreePlace growLimb(const TreePlace& from, int index, Dice& dice) {
  TreePlace place = from;
  if (dice.below(3) > 0) place = place.translation(dice.vector(0.5));
  if (dice.below(3) == 0) place = place.rotation(rotationExp(dice.vector(1.5)));
  Vector3 axis = dice.vector(1);
  if (dice.below(2) == 0) axis = Vector3{}, axis[dice.below(3)] = dice.below(2) == 0 ? -1 : 1;
  const std::string number = std::to_string(index);
  place = dice.below(4) == 0 ? place.prismatic("joint" + number, axis) : place.revolute("joint" + number, axis);
  if (dice.below(3) == 0) place = place.rotation(rotationExp(dice.vector(1.5)));
  const Vector3 edges{dice.number(0.1, 1), dice.number(0.1, 1), dice.number(0.1, 1)};
  const MassProperties mass =
      moved({rotationExp(dice.vector(1)), {}}, boxMass(dice.number(0.1, 2), edges, dice.vector(1)));
  place = place.body({.name = "body" + number, .mass = mass});
  if (dice.below(2) == 0) {
    place = place.translation(dice.vector(0.2)).body({.name = "welded" + number, .mass = boxMass(0.3, edges, {})});
  }
  return place.fork();
}

KinematicTree randomTree(Dice& dice) {
  TreeBuilder builder;
  std::vector<TreePlace> forks{builder.base("base").body({.name = "root", .mass = boxMass(1, {1, 1, 1}, {})}).fork()};
  const int joints = 1 + dice.below(20);
  for (int i = 0; i < joints; ++i) {
    const TreePlace from = forks[static_cast<std::size_t>(dice.below(static_cast<int>(forks.size())))];
    forks.push_back(growLimb(from, i, dice));
  }
  return builder.build();
}

/// Frames of the rows in the base, as kernels compute them: X_PB = X_PF J(q), J about one coordinate axis.
std::vector<Pose> rowPoses(const TreeTable& table, const std::vector<double>& q) {
  std::vector<Pose> poses{Pose{}};
  for (std::size_t row = 1; row < table.rows.size(); ++row) {
    const TreeRow& r = table.rows[row];
    Pose J;
    if (r.kind == JointKind::kPrismatic)
      J.translation[r.axis] = q[row - 1];
    else if (r.axis == 0)
      J.rotation = rotationX(q[row - 1]);
    else if (r.axis == 1)
      J.rotation = rotationY(q[row - 1]);
    else
      J.rotation = rotationZ(q[row - 1]);
    poses.push_back(poses[static_cast<std::size_t>(r.parent)] * r.X_PF * J);
  }
  return poses;
}

double difference(const Pose& a, const Pose& b) {
  const Rotation3 r = transposed(a.rotation) * b.rotation;
  return norm(a.translation - b.translation) + norm(r.x - kAxisX) + norm(r.y - kAxisY) + norm(r.z - kAxisZ);
}

RC_GTEST_PROP(FlattenTree, RandomTreesWithSkewAxesHaveTheSameForwardKinematics, (std::uint64_t seed)) {
  Dice dice(seed);
  const KinematicTree tree = randomTree(dice);
  std::vector<double> q;
  for (std::size_t j = 0; j < tree.joints.size(); ++j) q.push_back(dice.number(-3, 3));
  const FlatTree flat = flattenTree(tree);
  RC_ASSERT(flat.table.jointCount() == static_cast<int>(tree.joints.size()));
  const std::vector<Pose> rows = rowPoses(flat.table, q), elements = elementPoses(tree, q);
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const Pose X_WB = rows[static_cast<std::size_t>(flat.bodies[i].row)] * flat.bodies[i].X_RB;
    RC_ASSERT(difference(X_WB, elements[static_cast<std::size_t>(tree.bodies[i].element)]) < 1e-12 * 21);
  }
}

RC_GTEST_PROP(FlattenTree, RandomTreesWeighTheSameByRowsAsByBodies, (std::uint64_t seed)) {
  Dice dice(seed);
  const KinematicTree tree = randomTree(dice);
  const std::vector<double> q(tree.joints.size(), dice.number(-3, 3));
  const FlatTree flat = flattenTree(tree);
  const std::vector<Pose> rows = rowPoses(flat.table, q), elements = elementPoses(tree, q);
  MassProperties by_rows, by_bodies;
  for (std::size_t r = 0; r < rows.size(); ++r) by_rows = welded(by_rows, moved(rows[r], flat.row_mass[r]));
  for (const Body& body : tree.bodies) {
    by_bodies = welded(by_bodies, moved(elements[static_cast<std::size_t>(body.element)], body.mass));
  }
  expectNear(by_rows, by_bodies, 1e-11);
}

RC_GTEST_PROP(FlattenTree, OnlyRowsWithARotationAreTurned, (std::uint64_t seed)) {
  Dice dice(seed);
  for (const TreeRow& row : flattenTree(randomTree(dice)).table.rows) {
    RC_ASSERT(row.turned == !(row.X_PF.rotation == Rotation3{}));
  }
}

}  // namespace
}  // namespace murosimf
