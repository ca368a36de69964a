// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/jog.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "support/joint_paths.hpp"

namespace lamina {
namespace {

using test::PlanarArm;
using test::TiltingGantry;

constexpr double kRamp = 0.2;  // s

JogOrder jointOrder(const JointValues& rates) {
  JogOrder order;
  order.rates = rates;
  return order;
}

JogOrder tipOrder(const Point3& velocity, const Point3& turn = Point3::Zero()) {
  JogOrder order;
  order.kind = JogOrder::Kind::Nozzle;
  order.linear_mm_s = velocity;
  order.angular_velocity_rad_s = turn;
  return order;
}

JointValues jogStart(double x = 0.0, double tilt = 0.0) {
  JointValues q(4);
  q << x, 0.0, 0.0, tilt;
  return q;
}

JointValues alongX(double rate) {
  JointValues rates = JointValues::Zero(4);
  rates[0] = rate;
  return rates;
}

/// A lease of 0.3 s on a grid of 10 ms, with a reaction of 0.1 s.
JogSettings testJog() {
  JogSettings settings;
  settings.lease_s = 0.3;
  settings.reaction_s = 0.1;
  settings.rate_hz = 100.0;
  return settings;
}

TEST(JogLease, IsHeldByOneAtATimeAndRunsOut) {
  JogLease lease(0.2);
  EXPECT_EQ(lease.holder(0.0), "");
  EXPECT_EQ(lease.renew("/pendant", 1.0), "");
  EXPECT_EQ(lease.holder(1.1), "/pendant");
  EXPECT_NE(lease.renew("/page", 1.1), "");
  EXPECT_EQ(lease.renew("/pendant", 1.19), "");
  EXPECT_NE(lease.renew("/page", 1.38), "") << "it was renewed";
  EXPECT_EQ(lease.renew("/page", 1.39), "");
  EXPECT_EQ(lease.holder(1.4), "/page");
}

TEST(Jog, MovesForTheLeaseAndRestsByItself) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart());
  // x takes 200 mm/s, jogged 20, and 1000 mm/s²: 0.02 s up, 0.2 mm; from 0.1 s to the lease's end at 0.3 s.
  const JogAnswer answer = jog.order(jointOrder(alongX(15.0)), 0.0);
  EXPECT_EQ(answer.scale, 1.0);
  EXPECT_EQ(jog.chunk().points.front().time_s, 0.1);
  EXPECT_EQ(jog.at(0.1).velocity.norm(), 0.0);
  EXPECT_NEAR(jog.at(0.12).velocity[0], 15.0, 1e-9);
  EXPECT_NEAR(jog.at(0.3).velocity[0], 15.0, 1e-9);
  EXPECT_NEAR(jog.restTime(), 0.32, 1e-9);
  EXPECT_EQ(jog.at(1.0).velocity.norm(), 0.0);
  // On the grid 10 and 5 mm/s in the first and last two steps: 0.05, 0.125, 2.7 - 0.0.
  EXPECT_NEAR(jog.at(1.0).position[0], 0.05 + 0.125 + 15.0 * 0.18 + 0.1 + 0.025, 1e-9);
}

TEST(Jog, GoesOnWithoutAJumpWhenTheLeaseIsRenewed) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart());
  JointState before = jog.at(0.0);
  double fastest_change = 0.0;
  for (int i = 0; i < 40; ++i) {
    const double now_s = 0.05 * i;
    jog.order(jointOrder(alongX(i < 20 ? 20.0 : -20.0)), now_s);
    for (double t = now_s; t < now_s + 0.05 - 1e-9; t += 0.01) {
      const JointState state = jog.at(t + 0.01);
      fastest_change = std::max(fastest_change, std::abs(state.velocity[0] - before.velocity[0]));
      EXPECT_NEAR(state.position[0] - before.position[0], 0.005 * (state.velocity[0] + before.velocity[0]),
                  1e-9);
      before = state;
    }
  }
  EXPECT_NEAR(fastest_change, 10.0, 1e-6) << "1000 mm/s² for 10 ms";
  EXPECT_NEAR(before.velocity[0], -20.0, 1e-9);
}

TEST(Jog, IsNoFasterThanAllowedAndKeepsItsDirection) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart());
  JointValues rates = JointValues::Zero(4);
  rates[0] = 200.0;
  rates[2] = 5.0;
  const JogAnswer answer = jog.order(jointOrder(rates), 0.0);
  EXPECT_NEAR(answer.scale, 0.1, 1e-9) << "jog.joint_share";
  EXPECT_NE(answer.reason.find("joint 'x'"), std::string::npos) << answer.reason;
  EXPECT_NEAR(jog.at(0.3).velocity[0], 20.0, 1e-9);
  EXPECT_NEAR(jog.at(0.3).velocity[2], 0.5, 1e-9);
  JogSettings slow = testJog();
  slow.tip_mm_s = 5.0;
  slow.joint_share = 1.0;
  slow.turn_deg_s = 9.0;
  Jog tip(gantry, slow, kRamp, jogStart());
  EXPECT_NEAR(tip.order(tipOrder({30, 40, 0}), 0.0).scale, 0.1, 1e-9) << "50 mm/s";
  EXPECT_NEAR(tip.at(0.3).velocity[0], 3.0, 1e-9);
  EXPECT_NEAR(tip.at(0.3).velocity[1], 4.0, 1e-9);
  Jog turn(gantry, slow, kRamp, jogStart());
  EXPECT_NEAR(turn.order(tipOrder(Point3::Zero(), {M_PI / 10, 0, 0}), 0.0).scale, 0.5, 1e-6) << "18 deg/s";
}

TEST(Jog, KeepsTheTipWhereTheNozzleTurnsAboutIt) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart(0.0, 0.3));
  const Point3 tip = gantry.bedFromNozzle(jogStart(0.0, 0.3)).translation();
  for (int i = 0; i < 20; ++i) jog.order(tipOrder(Point3::Zero(), {0.1, 0, 0}), 0.1 * i);
  const JointState end = jog.at(jog.restTime());
  EXPECT_GT(end.position[3], 0.4);
  EXPECT_LT((gantry.bedFromNozzle(end.position).translation() - tip).norm(), 0.05);
  EXPECT_THROW(jog.order(tipOrder(Point3::Zero(), {0, 0, 0.1}), 3.0), InvalidInput) << "it cannot turn so";
  EXPECT_THROW(jog.order(jointOrder(JointValues::Zero(3)), 3.0), InvalidInput);
  EXPECT_THROW(jog.order(tipOrder({std::nan(""), 0, 0}), 3.0), InvalidInput);
  EXPECT_EQ(jog.at(jog.restTime()).velocity.norm(), 0.0);
}

TEST(Jog, RestsInFrontOfLimitsFromAnySpeedAndComesBack) {
  EXPECT_TRUE(rc::check("joints stay their margin away from their limits, within accelerations", [] {
    const TiltingGantry gantry;
    JogSettings settings = testJog();
    settings.joint_share = 0.1 * *rc::gen::inRange(1, 11);
    settings.limit_margin_mm = *rc::gen::element(0.0, 2.0, 30.0);
    settings.limit_margin_deg = *rc::gen::element(0.0, 2.0);
    settings.tip_mm_s = 1e3;
    JointValues start = jogStart(*rc::gen::inRange(-960, 960));
    Jog jog(gantry, settings, kRamp, start);
    JointValues rates(4);
    for (Eigen::Index j = 0; j < 4; ++j) rates[j] = *rc::gen::inRange(-400, 400);
    JointState before = jog.at(0.0);
    for (int i = 0; i < 300; ++i) {
      jog.order(jointOrder(rates), 0.1 * i);
      for (int k = 0; k < 10; ++k) {
        const JointState state = jog.at(0.1 * i + 0.01 * k);
        for (Eigen::Index j = 0; j < 4; ++j) {
          const DrivenJoint& joint = gantry.joints()[static_cast<std::size_t>(j)];
          const double margin = joint.kind == JointKind::Linear ? settings.limit_margin_mm
                                                                : settings.limit_margin_deg * M_PI / 180.0;
          const double edge = std::max(joint.high - margin, std::abs(start[j]));
          RC_ASSERT(std::abs(state.position[j]) <= edge + 1e-9);
          RC_ASSERT(std::abs(state.velocity[j] - before.velocity[j]) <=
                    joint.max_speed / kRamp * 0.01 + 1e-9);
        }
        before = state;
      }
    }
    jog.order(jointOrder(-rates), 31.0);
    RC_ASSERT(rates.isZero(0.0) || (jog.at(jog.restTime()).position - before.position).norm() > 1e-3);
  }));
}

/// A planar arm whose nozzle is held, straightened at j2 = 0.
class HeldElbow final : public test::HandMadeModel {
 public:
  HeldElbow() : HandMadeModel(PlanarArm().joints()) {}
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

TEST(Jog, SlowsDownInFrontOfASingularity) {
  const HeldElbow elbow;
  JogSettings settings = testJog();
  settings.least_margin_deg = 5.0;
  settings.joint_share = 1.0;
  JointValues start(3);
  start << -0.25, 0.5, 0.0;  // the tip on the x axis
  Jog jog(elbow, settings, kRamp, start);
  JogAnswer last;
  for (int i = 0; i < 100; ++i) {
    last = jog.order(tipOrder({100, 0, 0}), 0.1 * i);
    EXPECT_GT(jog.at(jog.restTime()).position[1], 5.0 * M_PI / 180.0);
  }
  EXPECT_EQ(last.reason, "a singularity is near");
  EXPECT_LT(jog.at(jog.restTime()).position[1], 8.0 * M_PI / 180.0);
  EXPECT_EQ(jog.order(tipOrder({-20, 0, 0}), 10.0).scale, 1.0) << "away from it";
}

TEST(Jog, StaysInItsWorkspaceAndWhereTheGuardLetsIt) {
  const TiltingGantry gantry;
  JogSettings settings = testJog();
  settings.workspace_mm = {-10, -10, -10, 10, 10, 10};
  Jog jog(gantry, settings, kRamp, jogStart());
  JogAnswer answer;
  for (int i = 0; i < 30; ++i) {
    answer = jog.order(tipOrder({20, 0, 0}), 0.1 * i);
    EXPECT_LE(jog.at(jog.restTime()).position[0], 10.0);
  }
  EXPECT_EQ(answer.scale, 0.0);
  EXPECT_NE(answer.reason.find("jog.workspace_mm"), std::string::npos) << answer.reason;
  EXPECT_GT(jog.at(jog.restTime()).position[0], 8.0);
  EXPECT_EQ(jog.order(tipOrder({-20, 0, 0}), 4.0).scale, 1.0) << "it comes back";

  Jog outside(gantry, settings, kRamp, jogStart(40.0));
  for (int i = 0; i < 30; ++i) outside.order(tipOrder({0, 20, 0}), 0.1 * i);
  EXPECT_LE(outside.at(outside.restTime()).position[1], 10.0) << "each axis by itself";
  EXPECT_GT(outside.at(outside.restTime()).position[1], 8.0);

  settings.workspace_mm.clear();
  settings.clearance_mm = 1.5;
  Jog guarded(gantry, settings, kRamp, jogStart());
  double farthest = 0.0;
  const JogGuard wall = [&](const std::vector<JointValues>& places) {
    for (const JointValues& place : places) farthest = std::max(farthest, place[0]);
    return places.back()[0] > 5.0 ? std::string("a wall is there") : std::string();
  };
  for (int i = 0; i < 30; ++i) answer = guarded.order(jointOrder(alongX(20.0)), 0.1 * i, wall);
  EXPECT_EQ(answer.reason, "a wall is there");
  const double rest = guarded.at(guarded.restTime()).position[0];
  EXPECT_LE(rest, 5.0);
  EXPECT_GT(rest, 2.0);
  EXPECT_GT(farthest, 5.0);
}

/// Where a jog towards a wall at x = 20 mm rests in the end.
double restInFrontOfAWall(double rate_mm_s) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart());
  const JogGuard wall = [](const std::vector<JointValues>& places) {
    return places.back()[0] > 20.0 ? std::string("a wall is there") : std::string();
  };
  for (int i = 0; i < 400; ++i) jog.order(jointOrder(alongX(rate_mm_s)), 0.1 * i, wall);
  return jog.at(jog.restTime()).position[0];
}

TEST(Jog, ComesTheNearerTheSlowerItIs) {
  // At an eighth of the speed, the least that is tried, it looks ahead by what it goes in 0.1 s.
  EXPECT_GT(restInFrontOfAWall(16.0), 20.0 - 2.0 * 0.1 * 16.0 / 8.0 - 1.0);
  EXPECT_GT(restInFrontOfAWall(2.0), 19.8) << "far nearer than jog.clearance_mm";
  EXPECT_LE(restInFrontOfAWall(2.0), 20.0);
}

TEST(Jog, ChangesNothingOnceItsFirstPointIsPast) {
  const TiltingGantry gantry;
  Jog jog(gantry, testJog(), kRamp, jogStart());
  jog.order(jointOrder(alongX(15.0)), 0.0);
  const double rest_s = jog.restTime();
  const JointValues end = jog.at(rest_s).position;
  double time_s = 0.15;
  const JogClock clock = [&] { return time_s; };
  const JogGuard slow = [&](const std::vector<JointValues>&) {
    time_s += 0.2;
    return std::string();
  };
  const JogAnswer late = jog.order(jointOrder(alongX(-15.0)), time_s, slow, clock);
  EXPECT_EQ(late.scale, 0.0);
  EXPECT_NE(late.reason.find("too late"), std::string::npos) << late.reason;
  EXPECT_TRUE(jog.chunk().points.empty());
  EXPECT_EQ(jog.restTime(), rest_s);
  EXPECT_EQ(jog.at(rest_s).position, end);
  EXPECT_THROW(jog.order(tipOrder({std::nan(""), 0, 0}), 0.15, {}, clock), InvalidInput);
  EXPECT_TRUE(jog.chunk().points.empty()) << "nor is it braked in the past";
  time_s = 0.4;
  EXPECT_EQ(jog.order(jointOrder(alongX(15.0)), time_s, {}, clock).scale, 1.0);
  EXPECT_EQ(jog.chunk().points.front().time_s, 0.5);
}

TEST(Jog, RefusesSettingsOutOfBounds) {
  const TiltingGantry gantry;
  JogSettings settings;
  settings.lease_s = 0.0;
  EXPECT_THROW(Jog(gantry, settings, kRamp, jogStart()), InvalidConfig);
  settings = {};
  settings.reaction_s = settings.lease_s;
  EXPECT_THROW(Jog(gantry, settings, kRamp, jogStart()), InvalidConfig) << "nothing would move";
  settings = {};
  settings.workspace_mm = {0, 0, 0};
  EXPECT_THROW(Jog(gantry, settings, kRamp, jogStart()), InvalidConfig);
}

}  // namespace
}  // namespace lamina
