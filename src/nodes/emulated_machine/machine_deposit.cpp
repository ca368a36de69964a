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

void requireUpright(const Eigen::Vector3d& tool_axis) {
  constexpr double kUpright = 1e-6;
  if ((tool_axis + Eigen::Vector3d::UnitZ()).norm() <= kUpright) return;
  throw InvalidConfig("plant.* is set on a machine whose tool axis leans by " +
                      numberText(toDegrees(std::acos(std::clamp(-tool_axis.z(), -1.0, 1.0)))) +
                      " deg; expected an upright one, along which beads grow");
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
    requireUpright(tool_axis);
    return std::make_unique<GrownOnBed>(
        GrownDeposit(bareHeights(shown, cell_mm), settings.plant, settings.grown));
  }
  if (model == DepositModel::Heights)
    return std::make_unique<BeadsOnBed>(BeadDeposit(bareHeights(shown, cell_mm)));
  return std::make_unique<VoxelsOnBed>(shown, cell_mm);
}

}  // namespace lamina
