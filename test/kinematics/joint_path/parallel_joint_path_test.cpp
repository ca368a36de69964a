// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A joint path is the same, bit for bit, however many threads solve its rungs.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "lamina/base/parallel.hpp"
#include "lamina/kinematics/description_files/cell_description.hpp"
#include "lamina/kinematics/joint_path/divided_joint_path.hpp"
#include "support/arms.hpp"
#include "support/tilting_arm.hpp"

namespace lamina {
namespace {

/// A wall that leans outwards, of several blocks of rungs, in pieces long enough to be divided.
Toolpath leaningRings() {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 10.0;
  path.bead = Bead{3.0, 1.0};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 140; ++i) {
    const double azimuth = 4.0 * M_PI * i / 140.0;
    path.points.emplace_back(60.0 * std::cos(azimuth), 60.0 * std::sin(azimuth), 10.0 + i / 70.0);
    nozzles.push_back(test::nozzleOnWall(azimuth, 0.3));
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  Toolpath toolpath;
  toolpath.layers.push_back({10.0, 1.0, {path}});
  return toolpath;
}

std::vector<JointValues> plannedOn(int threads, const KinematicModel& model,
                                   const JointPathSettings& settings) {
  const ThreadLimit limit(threads);
  NoProgress progress;
  const DividedJointPath found =
      planDividedJointPath(leaningRings(), Eigen::Isometry3d::Identity(), model, settings, progress);
  EXPECT_TRUE(found.joints.isRunnable());
  return found.joints.values;
}

void expectSameOnAnyThreads(const KinematicModel& model, const JointPathSettings& settings) {
  const std::vector<JointValues> on_one = plannedOn(1, model, settings);
  ASSERT_GT(on_one.size(), 141U);
  for (const int threads : {2, 8}) {
    const std::vector<JointValues> on_several = plannedOn(threads, model, settings);
    ASSERT_EQ(on_several.size(), on_one.size());
    for (std::size_t i = 0; i < on_one.size(); ++i)
      ASSERT_EQ(on_several[i], on_one[i]) << threads << ", " << i;
  }
}

JointPathSettings fewSamples() {
  JointPathSettings settings;
  settings.yaw_samples = 18;
  settings.redundancy_samples = 6;
  return settings;
}

TEST(ParallelJointPath, IsTheSameOnOneTwoAndEightThreads) {
  expectSameOnAnyThreads(*kinematicModelByName("irb_4600"), {});
}

TEST(ParallelJointPath, OverAPositionerToo) {
  JointPathSettings settings = fewSamples();
  settings.external = ExternalChoice::Gravity;
  expectSameOnAnyThreads(*kinematicModelFromUrdf(readMachineDescription(
                             std::string(LAMINA_SOURCE_DIR) + "/examples/robots/tilting_cell/cell.yaml")),
                         settings);
}

TEST(ParallelJointPath, OfSevenAxesToo) {
  expectSameOnAnyThreads(*kinematicModelFromUrdf(test::sphericalSevenOverPlate()), fewSamples());
}

}  // namespace
}  // namespace lamina
