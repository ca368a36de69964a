// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// An arm of three parallel axes beside a bed at the height of its base: one elbow is over the bed, the other
// under it.
#include "job/arm/clear_branches.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/job/program_file.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

std::string turning(const std::string& name, const std::string& parent, const std::string& child,
                    const std::string& origin) {
  return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/><origin " + origin +
         "/><axis xyz=\"0 0 1\"/><limit lower=\"-3.14\" upper=\"3.14\" velocity=\"3\" effort=\"1\"/></joint>";
}

std::string fixedAt(const std::string& parent, const std::string& child, const std::string& origin) {
  return "<joint name=\"to_" + child + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/><origin " + origin + "/></joint>";
}

/// A body round the way from a link to the next, which lies on its -x.
std::string beam(const std::string& name, const std::string& length_m) {
  return "<link name=\"" + name +
         "\"><collision><origin xyz=\"-0.3 0 0.08\" rpy=\"0 1.570796 0\"/><geometry>"
         "<cylinder radius=\"0.04\" length=\"" +
         length_m + "\"/></geometry></collision></link>";
}

/// 600 mm from shoulder to elbow, and as much to the wrist.
std::string tableArm() {
  return "<robot name=\"table_arm\"><link name=\"base_link\"/><link name=\"shoulder\"/>" +
         beam("upper_arm", "0.5") + beam("forearm", "0.5") +
         "<link name=\"wrist_1\"/><link name=\"wrist_2\"/><link name=\"wrist_3\"/><link "
         "name=\"tool0\"/><link name=\"nozzle\"/>"
         "<link name=\"bed\"><collision><origin xyz=\"0 0 -0.01\"/><geometry><box size=\"0.4 0.4 0.02\"/>"
         "</geometry></collision></link>" +
         turning("pan", "base_link", "shoulder", "xyz=\"0 0 0.18\"") +
         turning("lift", "shoulder", "upper_arm", "xyz=\"0 0 0\" rpy=\"1.5707963267948966 0 0\"") +
         turning("elbow", "upper_arm", "forearm", "xyz=\"-0.6 0 0\"") +
         turning("wrist_1_turn", "forearm", "wrist_1", "xyz=\"-0.6 0 0.17\"") +
         turning("wrist_2_turn", "wrist_1", "wrist_2", "xyz=\"0 -0.12 0\" rpy=\"1.5707963267948966 0 0\"") +
         turning("wrist_3_turn", "wrist_2", "wrist_3",
                 "xyz=\"0 0.12 0\" rpy=\"1.5707963267948966 3.141592653589793 3.141592653589793\"") +
         fixedAt("wrist_3", "tool0", "xyz=\"0 0 0\"") + fixedAt("tool0", "nozzle", "xyz=\"0 0 0.2\"") +
         fixedAt("base_link", "bed", "xyz=\"0.7 0 0\"") + "</robot>";
}

/// What a program runs into, as the arm reads it.
MachineCheck checkOf(const SliceJob& job, Progress& progress) {
  const auto model = kinematicModelOf(job.settings.machine);
  auto stated = readStatedMotion(job.output, job.settings.program, *model);
  const CheckedMachine machine(*model);
  return checkRun(runAsStated(*model, std::move(*stated), job.settings.joints), machine,
                  job.settings.clearance, progress);
}

TEST(ClearBranches, AnArmReachesOverTheBedAndNotThroughIt) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  SliceJob job;
  job.part = folder.file("box.stl");
  job.output = folder.file("box.script");
  job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 0.5;
  job.settings.planning.skirt.count = 0;
  job.settings.machine.urdf = folder.file("arm.urdf");
  writeStl(job.part, test::boxBetween({0, 0, 0}, {12, 8, 1}));
  writeFile(job.settings.machine.urdf, tableArm());
  // The branch that comes first has the elbow below.
  job.settings.clearance.need = ClearanceNeed::Never;
  runSliceJob(job, nobody);
  const MachineCheck through = checkOf(job, nobody);
  ASSERT_FALSE(through.collisions.empty());
  EXPECT_EQ(through.collisions.front().meeting, "link 'forearm' in the bed");
  job.settings.clearance.need = ClearanceNeed::Always;
  runSliceJob(job, nobody);
  EXPECT_TRUE(checkOf(job, nobody).isClear());
}

/// Layers that are not plane are checked before their program is, a few of them alone first.
TEST(ClearBranches, CurvedLayersAreNotRefusedForTheElbowThatComesFirst) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  SliceJob job;
  job.part = folder.file("cone.stl");
  job.output = folder.file("cone.script");
  job.settings.slicing.mode = "curved";
  job.settings.curved.largest_gap_percent = 100.0;
  job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 0.5;
  job.settings.planning.bead.width_mm = 0.8;
  job.settings.planning.walls.count = 1;
  job.settings.planning.skirt.count = 0;
  job.settings.machine.urdf = folder.file("arm.urdf");
  writeStl(job.part, makePart("cone", {{"radius_mm", "4"}, {"height_mm", "1"}, {"segments", "12"}}));
  writeFile(job.settings.machine.urdf, tableArm());
  ASSERT_NO_THROW(runSliceJob(job, nobody));
  EXPECT_TRUE(checkOf(job, nobody).isClear());
}

/// A nozzle in the bed is there with any elbow.
TEST(ClearBranches, WhatIsRigidWithTheNozzleIsNotTriedInOtherBranches) {
  std::string urdf = tableArm();
  for (const char* link : {"upper_arm", "forearm"}) {
    const std::string solid = beam(link, "0.5");
    ASSERT_NE(urdf.find(solid), std::string::npos);
    urdf.replace(urdf.find(solid), solid.size(), "<link name=\"" + std::string(link) + "\"/>");
  }
  const std::string nozzle = "<link name=\"nozzle\"/>";
  ASSERT_NE(urdf.find(nozzle), std::string::npos);
  urdf.replace(urdf.find(nozzle), nozzle.size(),
               "<link name=\"nozzle\"><collision><geometry><sphere radius=\"0.01\"/></geometry></collision>"
               "</link>");
  const auto model = kinematicModelFromUrdf(urdf);
  const CheckedMachine machine(*model);
  NoProgress nobody;
  int plans = 0;
  const Toolpath toolpath = test::twoLayers();
  const CheckedRun checked = checkedRun(
      machine,
      [&](const JointGuard& guard) {
        ++plans;
        return runOn(GuardedModel{*model, guard}, toolpath, Eigen::Isometry3d::Identity(), {}, nobody);
      },
      {}, nobody);
  ASSERT_FALSE(checked.check.collisions.empty());
  EXPECT_EQ(checked.check.collisions.front().meeting, "link 'nozzle' in the bed");
  EXPECT_EQ(plans, 1);
}

}  // namespace
}  // namespace lamina
