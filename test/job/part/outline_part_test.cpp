// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(OutlinePart, IsExtruded) {
  const test::ScratchFolder folder;
  const std::string svg = folder.file("plate.svg");
  writeFile(
      svg,
      "<svg width='30mm' height='30mm' viewBox='0 0 30 30'><rect x='5' y='5' width='20' height='10'/></svg>");
  SliceJob job = {svg, "", {}};
  NoProgress nobody;
  EXPECT_THROW(runSliceJob(job, nobody), InvalidConfig);
  job.settings.input.extrude_mm = 2.0;
  const SlicedPart sliced = runSliceJob(job, nobody);
  EXPECT_EQ(sliced.summary.layers, 10U);
  EXPECT_NEAR(sliced.summary.mesh_volume_mm3, 20.0 * 10.0 * 2.0, 1e-6);
  EXPECT_TRUE(sliced.summary.repairs.empty());
  job.settings.input.units.scale = 2.0;
  EXPECT_NEAR(runSliceJob(job, nobody).summary.mesh_volume_mm3, 40.0 * 20.0 * 2.0, 1e-6);
  job.settings.input.units.unit = LengthUnit::Inch;
  EXPECT_THROW(runSliceJob(job, nobody), InvalidConfig) << "the file states its own unit";
  job.part = "box";
  EXPECT_THROW(runSliceJob(job, nobody), InvalidConfig) << "its lengths are in mm";
}

}  // namespace
}  // namespace lamina
