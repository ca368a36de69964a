// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/stiffness_job.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

StiffnessJob stiffnessJobBoxJob() {
  StiffnessJob job;
  job.input = "box";
  job.settings.deposition.voxel_mm = 1.0;
  return job;
}

TEST(StiffnessJob, ABoxAsDrawnIsAsStiffAsItsMaterial) {
  const test::ScratchFolder folder;
  StiffnessJob job = stiffnessJobBoxJob();
  job.output = folder.file("box.vtk");
  job.deck = folder.file("box.inp");
  NoProgress nobody;
  EXPECT_NEAR(runStiffnessJob(job, nobody).result.modulus_mpa, 3861.0, 0.1);
  EXPECT_TRUE(std::filesystem::exists(job.output));
  EXPECT_TRUE(std::filesystem::exists(job.deck));
}

TEST(StiffnessJob, APartAsDepositedIsTheProgramThatLaysIt) {
  const test::ScratchFolder folder;
  StiffnessJob job = stiffnessJobBoxJob();
  job.settings.deposition.voxel_mm = 0.5;
  job.settings.planning.infill.density = 1.0;
  job.settings.slicing.layer_height_mm = 0.8;
  job.settings.slicing.first_layer_height_mm = 0.8;
  NoProgress nobody;
  runSliceJob({"box", folder.file("box.gcode"), job.settings}, nobody);
  job.solid = PartSolid::AsDeposited;
  const double sliced_mpa = runStiffnessJob(job, nobody).result.modulus_mpa;
  job.input = folder.file("box.gcode");
  const double read_mpa = runStiffnessJob(job, nobody).result.modulus_mpa;
  EXPECT_LT(sliced_mpa, 3861.0);
  EXPECT_NEAR(read_mpa / sliced_mpa, 1.0, 0.02);
}

TEST(StiffnessJob, RefusesBeforeItWrites) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  StiffnessJob wrong = stiffnessJobBoxJob();
  wrong.output = folder.file("box.stl");
  EXPECT_THROW(runStiffnessJob(wrong, nobody), InvalidInput);
  StiffnessJob fine = stiffnessJobBoxJob();
  fine.settings.deposition.voxel_mm = 0.002;
  fine.output = folder.file("box.vtk");
  EXPECT_THROW(runStiffnessJob(fine, nobody), InvalidInput);
  EXPECT_FALSE(std::filesystem::exists(fine.output));
}

/// Reports what is begun.
class Stages final : public Progress {
 public:
  void report(const std::string& stage, double /*share*/) override { seen_.insert(stage); }
  bool isCancelled() const override { return false; }
  const std::set<std::string>& seen() const { return seen_; }

 private:
  std::set<std::string> seen_;
};

TEST(StiffnessJob, RefusesTooFineVoxelsBeforeItDeposits) {
  const test::ScratchFolder folder;
  StiffnessJob job = stiffnessJobBoxJob();
  NoProgress nobody;
  runSliceJob({"box", folder.file("box.gcode"), job.settings}, nobody);
  job.input = folder.file("box.gcode");
  job.settings.deposition.voxel_mm = 0.1;
  job.settings.stiffness.memory_mb = 1;
  Stages stages;
  EXPECT_THROW(runStiffnessJob(job, stages), InvalidInput);
  EXPECT_EQ(stages.seen().count("deposit"), 0U);
}

}  // namespace
}  // namespace lamina
