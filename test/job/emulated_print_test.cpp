// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// From mesh to measured heights without a machine in between: what the toolpath says is laid into a map, a
// simulated sensor looks at it during the scan passes, and the monitor compares.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "lamina/deposition/bead_deposit.hpp"
#include "lamina/geometry/mesh_writer.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/kinematics/machine.hpp"
#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kNoise = 0.005;  // mm

class EmulatedPrint {
 public:
  /// @param flow  part of the planned volume that comes out
  explicit EmulatedPrint(double flow)
      : flow_(flow), part_(slice()), monitor_(part_.toolpath, part_.bed_from_part, {}) {
    const Box3 box = depositionBox(part_.toolpath);
    const Point2 middle = (part_.bed_from_part * box.centre()).head<2>();
    const Point2 half = 0.5 * box.size().head<2>() + Point2(5, 5);
    deposit_ = std::make_unique<BeadDeposit>(HeightMap(heightGrid({middle - half, middle + half}, 0.1), 0.0));
  }

  std::vector<LayerHeightReport> run() {
    for (const ToolpathLayer& layer : part_.toolpath.layers)
      for (const Path& path : layer.paths) run(path);
    note(monitor_.finish());
    return reports_;
  }

 private:
  static SlicedPart slice() {
    const test::ScratchFolder folder;
    SliceJob job;
    job.part = folder.file("box.stl");
    writeStl(job.part, test::boxBetween({0, 0, 0}, {12, 8, 2}));
    job.settings.scan.every_layers = 1;
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
        deposit_->lay({from, to, flow_ * (to - from).norm() * crossSection(path.bead.at(end))});
    }
  }

  void measureAlong(const Point3& from, const Point3& to) {
    const int profiles = 1 + static_cast<int>((to - from).norm() / 0.1);
    for (int i = 1; i <= profiles; ++i) {
      const Point3 tip = from + (to - from) * (double(i) / profiles);
      const Eigen::Isometry3d bed_from_sensor =
          bedFromNozzle(machine_, axisValues(machine_, tip)) * machine_.nozzle_from_sensor;
      std::vector<Point3> points = sensor_.measure(deposit_->surface(), bed_from_sensor, deposit_->highest());
      for (Point3& point : points) point = bed_from_sensor * point;
      note(monitor_.insert(points, tip.z()));
    }
  }

  void note(const std::optional<LayerHeightReport>& report) {
    if (report) reports_.push_back(*report);
  }

  static ProfileSensorSettings sensorSettings() {
    ProfileSensorSettings settings;
    settings.noise_mm = kNoise;
    return settings;
  }

  double flow_;
  SlicedPart part_;
  Machine machine_ = machineByName("cartesian_gantry");
  HeightMonitor monitor_;
  ProfileSensor sensor_{sensorSettings()};
  std::unique_ptr<BeadDeposit> deposit_;
  std::vector<LayerHeightReport> reports_;
};

TEST(EmulatedPrint, IsMeasuredAsHighAsPlanned) {
  const auto reports = EmulatedPrint(1.0).run();
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
