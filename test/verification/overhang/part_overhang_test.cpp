// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts whose overhang is known, in level and in inclined layers.
#include <gtest/gtest.h>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/verification/overhang/overhang.hpp"
#include "support/plain_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// Solid, on a machine whose head is made for layers at 45 deg that follow each other towards -y.
SliceJob solid(const std::string& part) {
  SliceJob job = test::plainJob();
  job.part = part;
  job.settings.planning.infill.density = 1.0;
  job.settings.machine.name = "gantry_45";
  job.settings.slicing.plane.angle_deg = 45.0;
  return job;
}

OverhangReport partOverhangFind(const SlicedPart& sliced) {
  NoProgress nobody;
  return findOverhangs(sliced.toolpath, sliced.bed_from_part, OverhangSettings(), nobody);
}

OverhangReport inclined(const SliceJob& job) {
  NoProgress nobody;
  return partOverhangFind(runSliceJob(job, nobody));
}

OverhangReport level(const SliceJob& job) {
  NoProgress nobody;
  return partOverhangFind(runLevelSliceJob(job, nobody));
}

/// A column of 10 x 10 x 20 mm with an arm of 10 x 10 x 10 mm at its top.
Mesh invertedL(double arm_y) {
  const Mesh column = test::boxBetween({0, 0, 0}, {10, 10, 20});
  return joined(column, test::boxBetween({0, arm_y, 10}, {10, arm_y + 10, 20}));
}

TEST(PartOverhang, AnArmHangsInLevelLayersByItsUndersideAndNotAtAllIn45Degrees) {
  const test::ScratchFolder folder;
  const SliceJob job = solid(folder.file("l.stl"));
  writeStl(job.part, invertedL(-10.0));
  const OverhangReport before = level(job);
  // The underside is in the layer from 10.0 to 10.2 mm; its beads are a plan width apart.
  const double expected = 10.0 * 10.0 / planWidth({0.4, 0.2});
  EXPECT_NEAR(before.layers[50].unsupported(), expected, 0.06 * expected) << "turns and overlap add some";
  EXPECT_EQ(totals(before).worst_layer, 50U);
  EXPECT_NEAR(totals(before).all.unsupported(), before.layers[50].unsupported(), 1.0);
  const OverhangTotals after = totals(inclined(job));
  EXPECT_LT(after.all.unsupported(), 1.0) << "gaps of a hundredth of a millimetre between wall and infill";
  EXPECT_EQ(after.all.starts_in_air, 0U);
}

TEST(PartOverhang, AnArmOnTheSideWhereInclinedLayersBeginStartsInTheAir) {
  const test::ScratchFolder folder;
  SliceJob job = solid(folder.file("l.stl"));
  writeStl(job.part, invertedL(10.0));
  job.settings.planning.anchoring.strategy = Anchoring::WherePossible;
  const OverhangReport after = inclined(job);
  EXPECT_GT(totals(after).all.starts_in_air, 0U);
  EXPECT_GT(totals(after).all.overhang_mm, 10.0) << "the first bead of the arm is as long as that is wide";
}

TEST(PartOverhang, ACubeHasNoneAtEitherAngle) {
  const SliceJob job = solid("box");
  for (const OverhangReport& report : {level(job), inclined(job)}) {
    const OverhangTotals sums = totals(report);
    EXPECT_GT(sums.all.deposited_mm, 1e5);
    EXPECT_EQ(sums.all.overhang_mm, 0.0);
    EXPECT_LT(sums.all.bridge_mm, 0.1);
    EXPECT_EQ(sums.all.starts_in_air, 0U);
  }
}

TEST(PartOverhang, IsTheSameWhateverTheNumberOfThreads) {
  NoProgress nobody;
  SliceJob job = solid("sphere");
  job.settings.planning.infill.density = 0.2;
  job.settings.planning.anchoring.strategy = Anchoring::None;  // inclined layers of a ball begin in the air
  const SlicedPart sliced = runSliceJob(job, nobody);
  const OverhangReport many = partOverhangFind(sliced);
  const ThreadLimit limit(1);
  const OverhangReport one = partOverhangFind(sliced);
  ASSERT_EQ(one.stretches.size(), many.stretches.size());
  EXPECT_GT(one.stretches.size(), 10U);
  for (std::size_t i = 0; i < one.stretches.size(); ++i)
    EXPECT_EQ(one.stretches[i].points, many.stretches[i].points);
  EXPECT_EQ(totals(one).all.overhang_mm, totals(many).all.overhang_mm);
}

}  // namespace
}  // namespace lamina
