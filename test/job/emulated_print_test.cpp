// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// From mesh to measured heights without a machine in between: what the toolpath says is deposited into a map
// or into voxels, a simulated sensor looks at it during the scan passes, and the monitor compares.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "lamina/deposition/bead_deposit.hpp"
#include "lamina/deposition/voxel_deposit.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kNoise = 0.005;  // mm

constexpr double kCell = 0.1;  // mm

/// A bed that a nozzle pointing down deposits on.
class Bed {
 public:
  virtual ~Bed() = default;
  virtual void lay(const DepositedMotion& motion) = 0;
  virtual HeightSource surface() const = 0;
  virtual double highest() const = 0;
};

class BedOfHeights final : public Bed {
 public:
  explicit BedOfHeights(const Box2& area) : deposit_(HeightMap(heightGrid(area, kCell), 0.0)) {}
  void lay(const DepositedMotion& motion) override { deposit_.lay(motion); }
  HeightSource surface() const override { return sourceOf(deposit_.surface()); }
  double highest() const override { return deposit_.highest(); }

 private:
  BeadDeposit deposit_;
};

class BedOfVoxels final : public Bed {
 public:
  explicit BedOfVoxels(const Box2& area)
      : deposit_(voxelFrame({{area.low.x(), area.low.y(), 0}, {area.high.x(), area.high.y(), 5}}, kCell), {},
                 TopHeights::Kept) {}
  void lay(const DepositedMotion& motion) override {
    const Eigen::Vector3d down(0, 0, -1);
    deposit_.lay({motion.start, motion.end, down, down, motion.volume_mm3});
  }
  HeightSource surface() const override {
    const HeightGrid grid = heightGrid({low(), high()}, kCell);
    return {grid, [this, grid](int column, int row) {
              const Point2 at = grid.centre(column, row);
              return deposit_.surfaceHeight(at.x(), at.y());
            }};
  }
  double highest() const override { return deposit_.highest(); }

 private:
  Point2 low() const { return deposit_.grid().frame().box().low.head<2>(); }
  Point2 high() const { return deposit_.grid().frame().box().high.head<2>(); }

  VoxelDeposit deposit_;
};

class EmulatedPrint {
 public:
  enum class Kept { Heights, Voxels };

  /// @param flow     part of the planned volume that comes out
  /// @param density  of the infill
  explicit EmulatedPrint(double flow, Kept kept = Kept::Heights, double density = 0.2)
      : flow_(flow), part_(slice(density)), monitor_(part_.toolpath, part_.bed_from_part, {}) {
    const Box3 box = depositionBox(part_.toolpath);
    const Point2 middle = (part_.bed_from_part * box.centre()).head<2>();
    const Point2 half = 0.5 * box.size().head<2>() + Point2(5, 5);
    const Box2 area{middle - half, middle + half};
    if (kept == Kept::Heights)
      bed_ = std::make_unique<BedOfHeights>(area);
    else
      bed_ = std::make_unique<BedOfVoxels>(area);
  }

  std::vector<LayerHeightReport> run() {
    for (const ToolpathLayer& layer : part_.toolpath.layers)
      for (const Path& path : layer.paths) run(path);
    note(monitor_.finish());
    return reports_;
  }

 private:
  static SlicedPart slice(double density) {
    const test::ScratchFolder folder;
    SliceJob job;
    job.part = folder.file("box.stl");
    writeStl(job.part, test::boxBetween({0, 0, 0}, {12, 8, 2}));
    job.settings.scan.every_layers = 1;
    job.settings.planning.infill.density = density;
    NoProgress progress;
    return runSliceJob(job, progress);
  }

  void run(const Path& path) {
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const Point3 from = part_.bed_from_part * path.points[m];
      const Point3 to = part_.bed_from_part * path.points[end];
      if (path.role == PathRole::Travel)
        measureAlong(from, to);
      else
        bed_->lay({from, to, flow_ * (to - from).norm() * crossSection(path.bead.at(end))});
    }
  }

  void measureAlong(const Point3& from, const Point3& to) {
    const int profiles = 1 + static_cast<int>((to - from).norm() / 0.1);
    for (int i = 1; i <= profiles; ++i) {
      const Point3 tip = from + (to - from) * (double(i) / profiles);
      const Eigen::Isometry3d bed_from_sensor =
          bedFromNozzle(machine_, axisValues(machine_, tip)) * machine_.nozzle_from_sensor;
      std::vector<Point3> points = sensor_.measure(bed_->surface(), bed_from_sensor, bed_->highest());
      for (Point3& point : points) point = bed_from_sensor * point;
      note(monitor_.insert(points, tip.z()));
    }
  }

  void note(const LayerHeightReports& reports) {
    reports_.insert(reports_.end(), reports.begin(), reports.end());
  }

  static ProfileSensorSettings sensorSettings() {
    ProfileSensorSettings settings;
    settings.noise_mm = kNoise;
    return settings;
  }

  double flow_;
  SlicedPart part_;
  CartesianMachine machine_ = machineByName("cartesian_gantry");
  HeightMonitor monitor_;
  ProfileSensor sensor_{sensorSettings()};
  std::unique_ptr<Bed> bed_;
  std::vector<LayerHeightReport> reports_;
};

void expectAsHighAsPlanned(const std::vector<LayerHeightReport>& reports) {
  ASSERT_EQ(reports.size(), 10u);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const HeightStatistics& of = reports[i].statistics;
    EXPECT_EQ(reports[i].layer, i);
    EXPECT_NEAR(reports[i].expected_height_mm, 0.2 * double(i + 1), 1e-9);
    EXPECT_GT(of.coverage, 0.95) << "layer " << i;
    EXPECT_NEAR(of.mean_mm, 0.0, 0.005) << "layer " << i;
    EXPECT_LT(of.rms_mm, 0.03) << "layer " << i;
  }
}

TEST(EmulatedPrint, IsMeasuredAsHighAsPlanned) { expectAsHighAsPlanned(EmulatedPrint(1.0).run()); }

TEST(EmulatedPrint, SolidInVoxelsIsMeasuredAsHighAsPlanned) {
  expectAsHighAsPlanned(EmulatedPrint(1.0, EmulatedPrint::Kept::Voxels, 1.0).run());
}

TEST(EmulatedPrint, ThatStarvesIsTooLow) {
  // A third of the volume makes strands of 0.17 mm where the nozzle runs 0.2 mm above the bed.
  const auto reports = EmulatedPrint(1.0 / 3.0).run();
  ASSERT_EQ(reports.size(), 10u);
  const double strand = 2.0 * std::sqrt(crossSection({0.4, 0.2}) / 3.0 / M_PI);
  EXPECT_LT(reports[0].statistics.mean_mm, strand - 0.2);
  for (const LayerHeightReport& report : reports) EXPECT_LT(report.statistics.mean_mm, -0.02);
}

}  // namespace
}  // namespace lamina
