// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/raised_axes.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kLeanDeg = 20.0;

constexpr std::size_t kBeads = 5;

/// Beads far above the bed and from each other, with a tool axis that leans.
Toolpath leaningBeads() {
  Toolpath toolpath;
  toolpath.layers.push_back({150, 150, {}});
  for (std::size_t i = 0; i < kBeads; ++i) {
    const double y = 10.0 * static_cast<double>(i);
    Path bead = test::straightPath({0, y, 150}, {1, y, 150});
    const Eigen::Quaterniond lean(Eigen::AngleAxisd(toRadians(kLeanDeg), Point3::UnitX()));
    bead.orientation = AlongPath<Eigen::Quaterniond>(lean * Eigen::Quaterniond(0, 1, 0, 0));
    toolpath.layers.front().paths.push_back(std::move(bead));
  }
  return toolpath;
}

/// Raises beads of which one round after the other finds so many that the machine cannot run.
class Rounds {
 public:
  explicit Rounds(std::vector<std::size_t> findings) : findings_(std::move(findings)) {
    settings_.machine.name = "five_axis_head_table";
    model_ = kinematicModelOf(settings_.machine);
  }

  RaisedToolpath raised(RaiseGoal goal) {
    const Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
    return raiseToolAxes(
        leaningBeads(), {*model_, bed_from_part, settings_},
        [&](const Toolpath&) {
          MachineCheck check;
          check.collisions.resize(findings_[std::min(checks_++, findings_.size() - 1)]);
          for (std::size_t i = 0; i < check.collisions.size(); ++i) check.collisions[i].at = {0, i, 0};
          return check;
        },
        goal);
  }

  std::size_t checks() const { return checks_; }

 private:
  std::vector<std::size_t> findings_;
  JobSettings settings_;
  std::unique_ptr<KinematicModel> model_;
  std::size_t checks_ = 0;
};

double leanDeg(const RaisedToolpath& raised) {
  const Point3 jet = raised.toolpath.layers[0].paths[0].orientation.at(0) * Point3::UnitZ();
  return toDegrees(std::acos(-jet.z()));
}

// A quarter of the lean goes in each round.
TEST(RaiseToolAxes, ForTheFewestFindingsReturnsTheRoundBeforeTwoThatLeaveMore) {
  Rounds rounds({5, 3, 4, 5, 0});
  const RaisedToolpath raised = rounds.raised(RaiseGoal::Fewest);
  EXPECT_EQ(rounds.checks(), 4U);
  EXPECT_EQ(raised.check.collisions.size(), 3U);
  EXPECT_NEAR(leanDeg(raised), 0.75 * kLeanDeg, 1e-4);
  EXPECT_NEAR(raised.least_kept, 0.75, 1e-12);
  EXPECT_EQ(raised.waypoints, 10U);
}

// More than the fewest twice, but not in a row.
TEST(RaiseToolAxes, ForTheFewestFindingsGoesOnAfterOneRoundThatLeavesMore) {
  Rounds rounds({5, 4, 5, 3, 4, 2, 2});
  EXPECT_EQ(rounds.raised(RaiseGoal::Fewest).check.collisions.size(), 2U);
}

TEST(RaiseToolAxes, ReturnsTheLastRoundOtherwise) {
  Rounds rounds({5, 3, 4, 5});
  const RaisedToolpath raised = rounds.raised(RaiseGoal::Clear);
  EXPECT_EQ(raised.check.collisions.size(), 5U);
  EXPECT_NEAR(leanDeg(raised), 0.0, 1e-4);
}

TEST(RaiseToolAxes, EndsOnceNothingIsFoundWhateverRoundsBeforeFound) {
  for (const RaiseGoal goal : {RaiseGoal::Clear, RaiseGoal::Fewest}) {
    Rounds rounds({5, 3, 4, 0});
    const RaisedToolpath raised = rounds.raised(goal);
    EXPECT_EQ(rounds.checks(), 4U);
    EXPECT_TRUE(raised.check.isClear());
    EXPECT_NEAR(leanDeg(raised), 0.25 * kLeanDeg, 1e-4);
  }
}

TEST(RaiseToolAxes, EndsWithTheLean) {
  Rounds rounds({1});
  EXPECT_NEAR(leanDeg(rounds.raised(RaiseGoal::Clear)), 0.0, 1e-4);
  EXPECT_EQ(rounds.checks(), 5U);
}

}  // namespace
}  // namespace lamina
