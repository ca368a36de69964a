// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Machines that are moved by hand.
#include "lamina/trajectory/jog.hpp"
#include "nodes/trajectory_driver/driver_settings.hpp"
#include "ros/settings/node_probes.hpp"
#include "support/joint_paths.hpp"

namespace lamina::test {
namespace {

constexpr double kRamp = 0.2;  // s

JogSettings jogWith(const SettingTexts& set) { return settingsWith<DriverSettings>(set).jog; }

JogOrder jointsBy(const JointValues& rates) {
  JogOrder order;
  order.rates = rates;
  return order;
}

JogOrder nozzleBy(const Point3& velocity, const Point3& turn) {
  JogOrder order;
  order.kind = JogOrder::Kind::Nozzle;
  order.linear_mm_s = velocity;
  order.angular_velocity_rad_s = turn;
  return order;
}

JointValues gantryAt(double x, double tilt) {
  JointValues q(4);
  q << x, 0.0, 0.0, tilt;
  return q;
}

/// How much of one order is done, when and where it rests, and how it is handed over.
std::string orderedOnce(const JogOrder& order, const SettingTexts& set) {
  const TiltingGantry gantry;
  const JogSettings settings = jogWith(set);
  Jog jog(gantry, settings, kRamp, gantryAt(0.0, 0.3));
  const JogAnswer answer = jog.order(order, 0.0);
  const JointValues rest = jog.at(jog.restTime()).position;
  JogLease lease(settings.lease_s);
  lease.renew("/pendant", 0.0);
  return numbersText({answer.scale, jog.restTime(), double(jog.chunk().points.size()),
                      jog.chunk().points.front().time_s, rest[0], rest[3]}) +
         lease.holder(0.25) + answer.reason;
}

/// Where a motion rests that is ordered again and again for three seconds.
std::string orderedOn(const KinematicModel& model, const JogOrder& order, const JointValues& start,
                      const JogGuard& guard, const SettingTexts& set) {
  Jog jog(model, jogWith(set), kRamp, start);
  for (int i = 0; i < 30; ++i) jog.order(order, 0.1 * i, guard);
  const JointValues rest = jog.at(jog.restTime()).position;
  return numbersText({rest.data(), rest.data() + rest.size()});
}

std::string towardsALimit(const JointValues& start, const SettingTexts& set) {
  JointValues rates(4);
  rates << 15.0, 0.0, 0.0, 0.2;
  return orderedOn(TiltingGantry(), jointsBy(rates), start, {}, set);
}

/// How far a tip goes by itself, and how far beyond that it looks for collisions.
std::string looksAhead(const SettingTexts& set) {
  double farthest = 0.0;
  const JogGuard nothing = [&](const std::vector<JointValues>& places) {
    for (const JointValues& place : places) farthest = std::max(farthest, place[0]);
    return std::string();
  };
  const std::string rest =
      orderedOn(TiltingGantry(), nozzleBy({15, 0, 0}, {0, 0, 0}), gantryAt(0.0, 0.0), nothing, set);
  return rest + numbersText({farthest});
}

/// A planar arm whose nozzle is held, straightened at j2 = 0.
class StraightenedArm final : public HandMadeModel {
 public:
  StraightenedArm() : HandMadeModel(PlanarArm().joints()) {}
  Eigen::Isometry3d bedFromNozzle(const JointValues& q) const override { return arm_.bedFromNozzle(q); }
  Jacobian jacobian(const JointValues& q) const override {
    Jacobian jacobian = arm_.jacobian(q);
    jacobian.bottomRows<3>().setZero();
    return jacobian;
  }
  double singularityMargin(const JointValues& q) const override { return std::abs(std::sin(q[1])); }

 private:
  PlanarArm arm_;
};

std::string towardsASingularity(const SettingTexts& set) {
  JointValues start(3);
  start << -0.15, 0.3, 0.0;
  return orderedOn(StraightenedArm(), nozzleBy({10, 0, 0}, {0, 0, 0}), start, {}, set);
}

}  // namespace

std::vector<SettingProbe> jogProbes() {
  const auto joints = [](const SettingTexts& set) {
    return orderedOnce(jointsBy(JointValues::Constant(4, 50.0)), set);
  };
  const auto tip = [](const SettingTexts& set) { return orderedOnce(nozzleBy({15, 5, 0}, {0, 0, 0}), set); };
  const auto turn = [](const SettingTexts& set) {
    return orderedOnce(nozzleBy({0, 0, 0}, {0.1, 0, 0}), set);
  };
  return {{"joints that are jogged",
           "",
           joints,
           {{"jog.lease_s=0.3"}, {"jog.reaction_s=0.1"}, {"jog.rate_hz=200"}, {"jog.joint_share=0.2"}}},
          {"a tip that is jogged", "", tip, {{"jog.tip_mm_s=5"}}},
          {"a nozzle that is turned", "", turn, {{"jog.turn_deg_s=2"}}},
          {"a linear joint towards its limit",
           "",
           [](const SettingTexts& set) { return towardsALimit(gantryAt(980.0, 0.0), set); },
           {{"jog.limit_margin_mm=5"}}},
          {"a rotary joint towards its limit",
           "",
           [](const SettingTexts& set) { return towardsALimit(gantryAt(0.0, 1.8), set); },
           {{"jog.limit_margin_deg=5"}}},
          {"a tip that looks ahead",
           "",
           looksAhead,
           {{"jog.clearance_mm=0.5"}, {"jog.workspace_mm=-10,-10,-10,10,10,10"}}},
          {"a tip towards a singularity", "", towardsASingularity, {{"jog.least_margin_deg=6"}}}};
}

}  // namespace lamina::test
