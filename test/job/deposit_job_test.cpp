// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/deposit_job.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/geometry/mesh_io/mesh_reader.hpp"
#include "support/scratch_folder.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

/// Cancelled as soon as a stage begins.
class CancelledAt final : public Progress {
 public:
  explicit CancelledAt(std::string stage) : stage_(std::move(stage)) {}
  void report(const std::string& stage, double) override { is_cancelled_ = is_cancelled_ || stage == stage_; }
  bool isCancelled() const override { return is_cancelled_; }

 private:
  std::string stage_;
  bool is_cancelled_ = false;
};

DepositJob job(const std::string& output) { return {test::twoLayers(), output, "", {}}; }

TEST(DepositJobTest, ReportsVolumesPorosityAndSurfaceAndWritesTheSurface) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  const DepositedPart deposited = runDepositJob(job(folder.file("square.stl")), nobody);
  const DepositSummary& summary = deposited.summary;
  const double extruded = totals(test::twoLayers()).deposited_mm3;
  const double voxel = 1e-3;  // mm3
  EXPECT_NEAR(summary.totals.extruded_mm3, extruded, 1e-9);
  EXPECT_NEAR(static_cast<double>(summary.voxels) * voxel, extruded, voxel);
  EXPECT_NEAR(summary.totals.path_mm, 50.0, 1e-9);
  EXPECT_NEAR(summary.highest_mm, 0.4, 1e-6);
  // A square of 10 mm of beads 0.4 mm wide, in a box of about 10.4 x 10.4 x 0.4 mm.
  EXPECT_NEAR(summary.porosity, 1.0 - extruded / (10.4 * 10.4 * 0.4), 0.02);
  const Mesh surface = readMesh(folder.file("square.stl"));
  EXPECT_NEAR(volume(surface), extruded, 0.1 * extruded);
  EXPECT_GT(summary.surface_mm2, surfaceArea(surface)) << "faces of voxels are stairs";
}

TEST(DepositJobTest, ACancelledOneWritesNothing) {
  const test::ScratchFolder folder;
  for (const std::string stage : {"deposit", "surface"}) {
    CancelledAt progress(stage);
    EXPECT_THROW(runDepositJob(job(folder.file("square.stl")), progress), Cancelled) << stage;
    EXPECT_FALSE(std::filesystem::exists(folder.file("square.stl")));
  }
}

TEST(DepositJobTest, RefusesOtherOutputsAndItsOwnSource) {
  const test::ScratchFolder folder;
  NoProgress nobody;
  EXPECT_THROW(runDepositJob(job(folder.file("square.obj")), nobody), InvalidInput);
  DepositJob onto_itself = job(folder.file("square.stl"));
  onto_itself.source = onto_itself.output;
  EXPECT_THROW(runDepositJob(onto_itself, nobody), InvalidInput);
}

TEST(DepositJobTest, RefusesWhatDoesNotFitIntoMemory) {
  NoProgress nobody;
  DepositJob large = job("");
  large.settings.voxel_mm = 0.001;
  large.settings.memory_limit_mb = 1.0;
  try {
    runDepositJob(large, nobody);
    FAIL() << "deposited";
  } catch (const InvalidInput& error) {
    EXPECT_NE(std::string(error.what()).find("fit"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace lamina
