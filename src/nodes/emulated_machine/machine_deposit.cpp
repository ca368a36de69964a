// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "machine_deposit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/deposition/bead_deposit.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "lamina/geometry/voxel/voxel_view.hpp"

namespace lamina {
namespace {

constexpr double kMarginMm = 10.0;
constexpr std::size_t kMostPoints = 1000000;  // of a cloud

class VoxelsOnBed final : public MachineDeposit {
 public:
  VoxelsOnBed(const Box3& shown, double voxel_mm)
      : deposit_(voxelFrame(shown, voxel_mm), DepositionSettings{}, TopHeights::Kept) {}

  void lay(const ToolAxisMotion& motion, const MachineTimes&) override { deposit_.lay(motion); }
  double highest() const override { return deposit_.highest(); }
  std::vector<Point3> points() const override { return shownVoxels(deposit_.grid(), kMostPoints); }

  HeightSource surface() const override {
    const VoxelFrame& frame = deposit_.grid().frame();
    HeightGrid columns;
    columns.origin = frame.corner.head<2>();
    columns.cell_mm = frame.voxel_mm;
    columns.columns = frame.count[0];
    columns.rows = frame.count[1];
    return {columns, [this, columns](int column, int row) {
              const Point2 centre = columns.centre(column, row);
              return deposit_.surfaceHeight(centre.x(), centre.y());
            }};
  }

 private:
  VoxelDeposit deposit_;
};

HeightMap bareHeights(const Box3& shown, double cell_mm) {
  return HeightMap(heightGrid({shown.low.head<2>(), shown.high.head<2>()}, cell_mm), 0.0);
}

/// A map of heights as `Deposit` lays it.
template <class Deposit>
class HeightsOnBed : public MachineDeposit {
 public:
  explicit HeightsOnBed(Deposit deposit) : deposit_(std::move(deposit)) {}

  double highest() const override { return deposit_.highest(); }
  HeightSource surface() const override { return sourceOf(deposit_.surface()); }

  std::vector<Point3> points() const override {
    const HeightMap& surface = deposit_.surface();
    std::vector<Point3> points;
    for (std::size_t cell = 0; cell < surface.grid().cellCount(); ++cell) {
      if (!(surface.at(cell) > 0.0)) continue;
      const Point2 centre = surface.grid().centre(cell);
      points.emplace_back(centre.x(), centre.y(), surface.at(cell));
    }
    return points;
  }

 protected:
  Deposit& deposit() { return deposit_; }
  const Deposit& deposit() const { return deposit_; }

 private:
  Deposit deposit_;
};

class BeadsOnBed final : public HeightsOnBed<BeadDeposit> {
 public:
  using HeightsOnBed::HeightsOnBed;
  void lay(const ToolAxisMotion& motion, const MachineTimes&) override {
    deposit().lay({motion.start, motion.end, motion.volume_mm3});
  }
};

class GrownOnBed final : public HeightsOnBed<GrownDeposit> {
 public:
  using HeightsOnBed::HeightsOnBed;
  void lay(const ToolAxisMotion& motion, const MachineTimes& times) override {
    deposit().lay({motion.start, motion.end, motion.volume_mm3, times.start_s, times.end_s});
  }
  void endBead() override { deposit().endBead(); }
};

/// Heights along a tool axis that leans, over the bed, which leans the other way.
class LeaningOnBed final : public HeightsOnBed<GrownDeposit> {
 public:
  LeaningOnBed(GrownDeposit deposit, const Eigen::Isometry3d& bed_from_surface)
      : HeightsOnBed(std::move(deposit)),
        bed_from_surface_(bed_from_surface),
        surface_from_bed_(bed_from_surface.inverse()) {}
  void lay(const ToolAxisMotion& motion, const MachineTimes& times) override {
    deposit().lay({surface_from_bed_ * motion.start, surface_from_bed_ * motion.end, motion.volume_mm3,
                   times.start_s, times.end_s});
  }
  void endBead() override { deposit().endBead(); }
  Eigen::Isometry3d bedFromSurface() const override { return bed_from_surface_; }
  std::vector<Point3> points() const override {
    const HeightMap& heights = deposit().surface();
    std::vector<Point3> points;
    for (std::size_t cell = 0; cell < heights.grid().cellCount(); ++cell) {
      if (!deposit().isDeposited(cell)) continue;
      const Point2 centre = heights.grid().centre(cell);
      points.push_back(bed_from_surface_ * Point3(centre.x(), centre.y(), heights.at(cell)));
    }
    return points;
  }

 private:
  Eigen::Isometry3d bed_from_surface_;
  Eigen::Isometry3d surface_from_bed_;
};

bool isUpright(const Eigen::Vector3d& tool_axis) {
  constexpr double kUpright = 1e-6;
  return (tool_axis + Eigen::Vector3d::UnitZ()).norm() <= kUpright;
}

/// What a machine shows of its bed, seen along a tool axis that leans.
Box3 shownAlong(const Eigen::Matrix3d& surface_from_bed, const Box3& shown) {
  Box3 seen;
  seen.low = seen.high = surface_from_bed * shown.low;
  for (unsigned corner = 1; corner < 8; ++corner) {
    Point3 at = shown.low;
    for (unsigned i = 0; i < 3; ++i)
      if ((corner >> i) % 2 == 1) at[i] = shown.high[i];
    seen.low = seen.low.cwiseMin(surface_from_bed * at);
    seen.high = seen.high.cwiseMax(surface_from_bed * at);
  }
  return seen;
}

std::unique_ptr<MachineDeposit> leaningBed(const Box3& shown, const Eigen::Vector3d& tool_axis,
                                           const EmulatedMachineSettings& settings) {
  if (settings.plant.detach_at_layer > 0)
    throw InvalidConfig("plant.detach_at_layer is " + std::to_string(settings.plant.detach_at_layer) +
                        " on a machine whose tool axis leans by " +
                        numberText(toDegrees(std::acos(std::clamp(-tool_axis.z(), -1.0, 1.0)))) +
                        " deg; expected 0, or an upright one");
  const Eigen::Vector3d up = -tool_axis;
  const Eigen::Isometry3d bed_from_surface(shortestRotation(Eigen::Vector3d::UnitZ(), up));
  HeightMap bed =
      bareHeights(shownAlong(bed_from_surface.linear().transpose(), shown), settings.deposit_cell_mm);
  const Eigen::RowVector3d slope = bed_from_surface.linear().row(2);
  for (std::size_t cell = 0; cell < bed.grid().cellCount(); ++cell) {
    const Point2 centre = bed.grid().centre(cell);
    bed.set(cell, -(slope[0] * centre.x() + slope[1] * centre.y()) / slope[2]);
  }
  return std::make_unique<LeaningOnBed>(GrownDeposit(std::move(bed), settings.plant, settings.grown),
                                        bed_from_surface);
}

/// What the machine reaches over its bed; of a bed without end, `belt_mm`.
Box3 shownBed(BuildSpace space, double belt_mm) {
  for (int i = 0; i < 3; ++i)
    if (space.is_endless[static_cast<std::size_t>(i)]) space.range.high[i] = space.range.low[i] + belt_mm;
  Box3 reach = boundingBox(space);
  const Point3 margin(kMarginMm, kMarginMm, kMarginMm);
  reach.low -= margin;
  reach.high += margin;
  reach.low.z() = 0.0;
  return reach;
}

DepositModel modelFor(const BuildSpace& space, DepositModel asked) {
  if (asked != DepositModel::Auto) return asked;
  const bool is_belt = std::any_of(space.is_endless.begin(), space.is_endless.end(),
                                   [](bool is_endless) { return is_endless; });
  return is_belt ? DepositModel::Heights : DepositModel::Voxels;
}

}  // namespace

std::unique_ptr<MachineDeposit> bareBed(BuildSpace space, const Eigen::Vector3d& tool_axis,
                                        const EmulatedMachineSettings& settings) {
  const DepositModel model = modelFor(space, settings.deposit_model);
  const Box3 shown = shownBed(std::move(space), settings.deposit_belt_mm);
  const double cell_mm = settings.deposit_cell_mm;
  if (isDisturbed(settings.plant)) {
    if (!isUpright(tool_axis)) return leaningBed(shown, tool_axis, settings);
    return std::make_unique<GrownOnBed>(
        GrownDeposit(bareHeights(shown, cell_mm), settings.plant, settings.grown));
  }
  if (model == DepositModel::Heights)
    return std::make_unique<BeadsOnBed>(BeadDeposit(bareHeights(shown, cell_mm)));
  return std::make_unique<VoxelsOnBed>(shown, cell_mm);
}

}  // namespace lamina
