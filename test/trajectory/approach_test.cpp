// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/approach.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

struct Ends {
  JointValues from, to;
};

/// Within the limits, wrists bent and tool axes tilted.
Ends endsOn(const KinematicModel& model) {
  const auto count = static_cast<Eigen::Index>(model.joints().size());
  Ends ends{JointValues(count), JointValues(count)};
  for (Eigen::Index j = 0; j < count; ++j) {
    const DrivenJoint& joint = model.joints()[static_cast<std::size_t>(j)];
    const bool is_endless = !std::isfinite(joint.high - joint.low);
    ends.from[j] = is_endless ? 0.0 : joint.low + 0.6 * (joint.high - joint.low);
    ends.to[j] = is_endless ? 1.0 : joint.low + 0.55 * (joint.high - joint.low);
  }
  return ends;
}

class ApproachOn : public testing::TestWithParam<const char*> {};

TEST_P(ApproachOn, GoesFromRestToRestWithinItsSpeedsAndDepositsNothing) {
  const auto model = kinematicModelByName(GetParam());
  const Ends ends = endsOn(*model);
  const ApproachSettings settings;
  const Approach way = approach(ends.from, ends.to, *model, settings, {});
  EXPECT_EQ(way.stations.front(), ends.from);
  EXPECT_EQ(way.stations.back(), ends.to);
  const double end_s = way.motion->duration();
  EXPECT_LT((way.motion->at(0.0).position - ends.from).norm(), 1e-9);
  EXPECT_LT((way.motion->at(end_s).position - ends.to).norm(), 1e-9);
  EXPECT_EQ(way.motion->at(0.0).velocity.norm(), 0.0);
  EXPECT_LT(way.motion->at(end_s).velocity.norm(), 1e-9);
  for (double t = 0.0; t < end_s; t += 0.01) {
    const JointState state = way.motion->at(t);
    ASSERT_EQ(state.process, safeSignals());
    for (std::size_t j = 0; j < model->joints().size(); ++j)
      ASSERT_LE(std::abs(state.velocity[static_cast<Eigen::Index>(j)]),
                model->joints()[j].max_speed * (1.0 + 1e-9));
  }
}

TEST_P(ApproachOn, LiftsAgainstTheToolAxisAndComesDownAlongIt) {
  const auto model = kinematicModelByName(GetParam());
  const Ends ends = endsOn(*model);
  const Approach way = approach(ends.from, ends.to, *model, {}, {});
  const auto nozzle = [&](double time_s) { return model->bedFromNozzle(way.motion->at(time_s).position); };
  const auto off = [](const Eigen::Isometry3d& at, const Eigen::Isometry3d& end) {
    const Eigen::Vector3d along = end.linear().col(2);
    const Eigen::Vector3d way_left = end.translation() - at.translation();
    return (way_left - along * along.dot(way_left)).norm();
  };
  const double end_s = way.motion->duration();
  // 0.5 s at 20 mm/s is within the lift of 20 mm.
  EXPECT_LT(off(nozzle(0.5), nozzle(0.0)), 0.05);
  EXPECT_LT(off(nozzle(end_s - 0.5), nozzle(end_s)), 0.05);
  EXPECT_GT((nozzle(0.5).translation() - nozzle(0.0).translation()).norm(), 8.0);
  EXPECT_LT((nozzle(0.5).translation() - nozzle(0.0).translation()).dot(nozzle(0.0).linear().col(2)), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Machines, ApproachOn,
                         testing::Values("cartesian_gantry", "five_axis_head_table", "irb_4600",
                                         "rus_platform"));

TEST(ApproachTest, RefusesEndsOutsideTheLimitsAndNoWayAtAll) {
  const auto model = kinematicModelByName("irb_4600");
  Ends ends = endsOn(*model);
  EXPECT_THROW(approach(ends.from, ends.from, *model, {}, {}), InvalidInput);
  EXPECT_THROW(approach(JointValues::Zero(3), ends.to, *model, {}, {}), InvalidInput);
  ends.from[2] = model->joints()[2].high + 0.1;
  try {
    approach(ends.from, ends.to, *model, {}, {});
    FAIL() << "expected Unreachable";
  } catch (const Unreachable& error) {
    EXPECT_NE(std::string(error.what()).find("joint_3"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
