// Friction of gears: the six models of its source, each written out, are what the one formula gives.

#include "murosimf/algorithms/gear_friction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"

namespace murosimf {
namespace {

constexpr double kBase = 0.06, kStribeck = 0.024, kSpeed = 1.5, kExponent = 1.33;
constexpr double kMotor = 0.2, kExternal = 0.05, kMotorAtRest = 0.23, kExternalAtRest = 0.09;
constexpr double kMotorQuadratic = 0.01, kExternalQuadratic = 0.004;

double share(double w) { return std::exp(-std::pow(std::abs(w / kSpeed), kExponent)); }

struct Model {
  const char* name;
  GearFriction<double> parameters;
  double (*size)(double t_m, double t_e, double w);  ///< as its source writes it, without K_v |w|
};

const Model kModels[] = {
    {"M1", {kBase, 0, 0, 0, 0, 0, 0, 0, kSpeed, kExponent}, [](double, double, double) { return kBase; }},
    {"M2",
     {kBase, kStribeck, 0, 0, 0, 0, 0, 0, kSpeed, kExponent},
     [](double, double, double w) { return kBase + share(w) * kStribeck; }},
    {"M3",
     {kBase, 0, kMotor, kMotor, 0, 0, 0, 0, kSpeed, kExponent},
     [](double t_m, double t_e, double) { return kBase + kMotor * std::abs(t_m - t_e); }},
    {"M4",
     {kBase, kStribeck, kMotor, kMotor, kMotorAtRest, kMotorAtRest, 0, 0, kSpeed, kExponent},
     [](double t_m, double t_e, double w) {
       const double load = std::abs(t_m - t_e);
       return kBase + kMotor * load + share(w) * (kStribeck + kMotorAtRest * load);
     }},
    {"M5",
     {kBase, kStribeck, kMotor, kExternal, kMotorAtRest, kExternalAtRest, 0, 0, kSpeed, kExponent},
     [](double t_m, double t_e, double w) {
       return kBase + std::abs(kMotor * t_m - kExternal * t_e) +
              share(w) * (kStribeck + std::abs(kMotorAtRest * t_m - kExternalAtRest * t_e));
     }},
    {"M6",
     {kBase, kStribeck, kMotor, kExternal, kMotorAtRest, kExternalAtRest, kMotorQuadratic, kExternalQuadratic, kSpeed,
      kExponent},
     [](double t_m, double t_e, double w) {
       double quadratic = 0;
       if (std::signbit(t_m) != std::signbit(t_e)) {
         quadratic = std::abs(t_m) > std::abs(t_e) ? kExternalQuadratic * t_e * t_e : kMotorQuadratic * t_m * t_m;
       }
       return kBase + std::abs(kMotor * t_m - kExternal * t_e) +
              share(w) * (kStribeck + std::abs(kMotorAtRest * t_m - kExternalAtRest * t_e) + quadratic);
     }},
};

TEST(GearFriction, IsThatOfEachModelOfItsSource) {
  book::Page page(
      {book::Chapter::kServos,
       "Friction of gears is that of each model of its source",
       "f = K_c + |K_m \\tau_m - K_e \\tau_e| + s(\\omega) (K_{cs} + |K_{ms} \\tau_m - K_{es} \\tau_e| + q)\n"
       R"(s(\omega) = e^{-|\omega / \omega_s|^\alpha})",
       "[Duclusaud et al. 2025], models M1 to M6; here for a load of 4.1 N m against the motor's 4 N m",
       {{"K", "coefficients of the model, 0 where it has none", ""}, {"q", "quadratic part of M6", "N m"}},
       {"speed $\\omega$", "rad/s"},
       {"friction $f$", "N m"}});
  for (const Model& model : kModels) {
    for (const double t_m : {-3.0, -0.4, 0.0, 1.0, 4.0}) {
      for (const double t_e : {-4.1, -0.5, 0.0, 0.3, 2.0}) {
        for (const double w : {-5.0, -0.7, 0.0, 1e-4, 0.3, 2.0}) {
          const double found = gearFriction(model.parameters, t_m, t_e, w);
          EXPECT_NEAR(found, model.size(t_m, t_e, w), 1e-14) << model.name << " " << t_m << " " << t_e << " " << w;
          if (t_m != 4.0 || t_e != -4.1) continue;
          page.series(model.name).curve(-5, 2, [&](double speed) { return model.size(4.0, -4.1, speed); });
          EXPECT_TRUE(page.near(w, found, model.size(t_m, t_e, w), 1e-14));
        }
      }
    }
  }
}

TEST(GearFriction, LanesEqualScalarBitForBitAlsoWhereModelsMix) {
  using Four = Pack<double, 4>;
  const double t_m[] = {1, -2, 0.5, 3}, t_e[] = {-0.8, 2.5, 0.5, -3.5}, w[] = {0, 0.2, -1, 4};
  const auto lanes = [](auto&& of) { return Four(Four::Vector{of(0), of(1), of(2), of(3)}); };
  for (const int first : {0, 2}) {
    const auto one = [&](int lane) -> const GearFriction<double>& { return kModels[first + lane].parameters; };
    GearFriction<Four> together;
    together.base = lanes([&](int i) { return one(i).base; });
    together.stribeck = lanes([&](int i) { return one(i).stribeck; });
    together.motor_load = lanes([&](int i) { return one(i).motor_load; });
    together.external_load = lanes([&](int i) { return one(i).external_load; });
    together.motor_stribeck = lanes([&](int i) { return one(i).motor_stribeck; });
    together.external_stribeck = lanes([&](int i) { return one(i).external_stribeck; });
    together.motor_quadratic = lanes([&](int i) { return one(i).motor_quadratic; });
    together.external_quadratic = lanes([&](int i) { return one(i).external_quadratic; });
    together.speed = lanes([&](int i) { return one(i).speed; });
    together.exponent = lanes([&](int i) { return one(i).exponent; });
    const Four f = gearFriction(together, lanes([&](int i) { return t_m[i]; }), lanes([&](int i) { return t_e[i]; }),
                                lanes([&](int i) { return w[i]; }));
    for (int i = 0; i < 4; ++i) EXPECT_EQ(f[i], gearFriction(one(i), t_m[i], t_e[i], w[i])) << first + i;
  }
}

TEST(DryFriction, ShareOfStribeckIsOneAtRestAndFallsWithSpeed) {
  EXPECT_EQ(stribeckShare(0.0, 0.1, 2.0), 1);
  EXPECT_NEAR(stribeckShare(-0.1, 0.1, 2.0), std::exp(-1), 1e-15);
  EXPECT_NEAR(stribeckShare(0.3, 0.1, 1.5), std::exp(-std::pow(3, 1.5)), 1e-16);
  EXPECT_LT(stribeckShare(1e6, 0.1, 10.0), 1e-300);
}

}  // namespace
}  // namespace murosimf
