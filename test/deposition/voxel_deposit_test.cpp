// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/voxel_deposit.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/deposition/strand.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

const Bead kBead{0.48, 0.3};  // A = 0.124686 mm2

JetMotion strand(const Point3& start, const Point3& end, const Bead& bead = kBead) {
  JetMotion motion;
  motion.start = start;
  motion.end = end;
  motion.volume_mm3 = crossSection(bead) * (end - start).norm();
  motion.radius_mm = strandRadius(crossSection(bead));
  return motion;
}

VoxelFrame frame(const Point3& low, const Point3& high, double voxel_mm) {
  Box3 box;
  box.include(low);
  box.include(high);
  return voxelFrame(box, voxel_mm);
}

TEST(VoxelDepositTest, laysWhatIsExtrudedButForLessThanAVoxel) {
  VoxelDeposit deposit(frame({-2, -2, 0}, {12, 2, 1}, 0.05), {});
  deposit.lay(strand({0, 0, 0.3}, {10, 0, 0.3}));
  const DepositTotals totals = deposit.totals();
  EXPECT_NEAR(totals.extruded_mm3, 1.24686, 1e-5);
  EXPECT_NEAR(totals.laid_mm3, deposit.grid().solidVolume(), 1e-12);
  EXPECT_LT(totals.extruded_mm3 - totals.laid_mm3, deposit.grid().frame().voxelVolume());
  EXPECT_NEAR(totals.laid_mm3 + totals.held_mm3, totals.extruded_mm3, 1e-12);
  EXPECT_EQ(totals.excess_mm3 + totals.outside_mm3, 0.0);
  EXPECT_NEAR(deposit.highest(), 0.3, 1e-12);
}

}  // namespace
}  // namespace lamina
