// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the loop tells a sensor that is as it is said to be from one that is not, on layers that it does
// not look at squarely.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/profile_reading.hpp"
#include "lamina/control/supervision.hpp"
#include "lamina/deposition/growth_plant.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "support/measured_layers.hpp"

namespace lamina {
namespace {

constexpr Bead kInclinedBead{3.0, 1.5};
constexpr std::size_t kBeadsAbreast = 3;
constexpr std::size_t kInclinedLayers = 6;
constexpr double kCellSpread = 0.05;  // of growth, from layer to layer
constexpr double kAlikeMm = 5.0;      // along which it is alike

/// Layers at an angle, under a sensor that looks straight down.
struct InclinedPrint {
  double angle_deg = 45.0;
  bool is_line_across = true;  ///< the line of light, over the beads; else along them
  ProfileSensorSettings sensor;
  SightSettings sight;
};

InclinedPrint inclinedPrint() {
  InclinedPrint print;
  print.sensor.noise_mm = 0.02;
  print.sensor.width_mm = 4.0;  // rays that hardly fan out meet tops of cells, not their sides
  print.sensor.points = 41;
  print.sight.sigma_mm = 0.02;
  return print;
}

struct Judged {
  double repeatability = 0.0;  ///< mean over the layers
  std::size_t alarms = 0;      ///< 6106
};

/// Where the sensor is over a place of the layers, in the frame of the toolpath.
Eigen::Isometry3d sensorAbove(const Point3& at, bool is_line_across) {
  Eigen::Isometry3d pose(Eigen::Translation3d(at + Point3(0, 0, 60.0)));
  const Eigen::Vector3d line = is_line_across ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX();
  pose.linear() << line, -Eigen::Vector3d::UnitZ().cross(line), -Eigen::Vector3d::UnitZ();
  return pose;
}

class InclinedPrinter {
 public:
  explicit InclinedPrinter(const InclinedPrint& print)
      : print_(print),
        sensor_(print.sensor),
        layers_from_part_(
            Eigen::AngleAxisd(-print.angle_deg * kDegree, Eigen::Vector3d::UnitX()).toRotationMatrix()),
        loop_(settings(), layers_from_part_.transpose() * Eigen::Vector3d::UnitZ()),
        surface_(heightGrid({Point2(-5, -20), Point2(45, 20)}, test::kMeasuredCell), 0.0) {
    status_.state = LoopState::Active;
  }

  Judged print() {
    Judged judged;
    for (std::size_t k = 0; k < kInclinedLayers; ++k) {
      const LayerFigures figures = printLayer(k);
      judged.repeatability += figures.repeatability / static_cast<double>(kInclinedLayers);
      const LoopStep step = afterLayer(status_, figures, settings());
      status_ = step.status;
      for (const RaisedAlarm& alarm : step.alarms)
        judged.alarms += alarm.alarm == LoopAlarm::Inconsistent ? 1 : 0;
    }
    return judged;
  }

 private:
  static LoopSettings settings() {
    LoopSettings settings;
    settings.growth_spread = kCellSpread;
    settings.reading_correlation = 0.0;
    return settings;
  }

  LayerFigures printLayer(std::size_t k) {
    const test::MeasuredLayer measured =
        test::inclinedLayer(print_.angle_deg, kBeadsAbreast, kInclinedBead, k);
    loop_.beginLayer(test::cellsOf(measured, k));
    const LayerCorrection correction = loop_.correction(status_.state);
    loop_.lay(correction);
    grow(correction.amount);
    CellAtlas atlas;
    atlas.add(std::make_shared<const LayerCells>(loop_.cells()));
    for (std::size_t bead = 0; bead < kBeadsAbreast; ++bead)
      for (int i = 0; i < 160; ++i) look(atlas, measured.place(bead, (0.25 * i + 0.125) / 40.0, 0.0, 0.0), k);
    return loop_.endLayer();
  }

  /// Each cell by what it is commanded, and at random along each bead.
  void grow(const std::vector<double>& amount) {
    const HeightGrid& grid = surface_.grid();
    const LayerCells& cells = loop_.cells();
    const std::size_t cells_a_bead = cells.size() / kBeadsAbreast;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const Point3 middle = layers_from_part_ * cells.middle[i];
      const double growth =
          1.5 *
          (1.0 + amount[i] + kCellSpread * correlatedNoise(beads_ + i / cells_a_bead, middle.x(), kAlikeMm));
      for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
        const Point2 off = grid.centre(cell) - middle.head<2>();
        if (std::abs(off.x()) < 0.25 && std::abs(off.y()) < 1.5)
          surface_.set(cell, surface_.at(cell) + growth);
      }
    }
    beads_ += kBeadsAbreast;
  }

  void look(const CellAtlas& atlas, const Point3& at, std::size_t layer) {
    SensorProfile profile;
    profile.toolpath_from_sensor = sensorAbove(at, print_.is_line_across);
    profile.points =
        sensor_.measure(surface_, Eigen::Isometry3d(layers_from_part_) * profile.toolpath_from_sensor);
    const ProfileReadings read = readProfile(profile, atlas, {{layer, &loop_.estimates()}}, print_.sight);
    for (const LayerReading& reading : read.readings) loop_.see(reading.cell, reading.reading);
    loop_.endCloud();
  }

  InclinedPrint print_;
  ProfileSensor sensor_;
  Eigen::Matrix3d layers_from_part_;
  HeightLoop loop_;
  HeightMap surface_;
  LoopStatus status_;
  std::uint64_t beads_ = 7;  ///< below, and a seed
};

Judged judged(const InclinedPrint& print) { return InclinedPrinter(print).print(); }

TEST(InclinedNoise, OfASensorAsStatedIsExpectedAtAnyAngle) {
  for (const double angle_deg : {0.0, 30.0, 45.0, 60.0}) {
    for (const bool is_line_across : {true, false}) {
      InclinedPrint print = inclinedPrint();
      print.angle_deg = angle_deg;
      print.is_line_across = is_line_across;
      const Judged found = judged(print);
      EXPECT_NEAR(found.repeatability, 1.0, 0.2) << angle_deg << " deg, across " << is_line_across;
      EXPECT_EQ(found.alarms, 0U) << angle_deg << " deg, across " << is_line_across;
    }
  }
}

TEST(InclinedNoise, OfASensorThatScattersMoreOrLessIsTold) {
  for (const double angle_deg : {0.0, 45.0}) {
    InclinedPrint print = inclinedPrint();
    print.angle_deg = angle_deg;
    print.sensor.noise_mm = 0.04;
    const Judged noisy = judged(print);
    EXPECT_GT(noisy.repeatability, 2.0) << angle_deg << " deg";
    EXPECT_GE(noisy.alarms, kInclinedLayers - 2) << angle_deg << " deg: from the third layer on";
    print.sensor.noise_mm = 0.01;
    const Judged quiet = judged(print);
    EXPECT_NEAR(quiet.repeatability, 0.25, 0.05) << angle_deg << " deg: of variances";
    EXPECT_GE(quiet.alarms, kInclinedLayers - 2) << angle_deg << " deg";
  }
}

TEST(InclinedNoise, AlongTheLineOfLightCountsWhereTheLineClimbs) {
  InclinedPrint print = inclinedPrint();
  print.sensor.lateral_noise_mm = 0.04;
  const Judged unknown = judged(print);
  EXPECT_NEAR(unknown.repeatability, 5.0, 1.5) << "(0.02² + 0.04²) / 0.02², less what is contested";
  EXPECT_GE(unknown.alarms, kInclinedLayers - 2);
  print.sight.lateral_sigma_mm = 0.04;
  EXPECT_NEAR(judged(print).repeatability, 1.0, 0.2);
  EXPECT_EQ(judged(print).alarms, 0U);
  print.is_line_across = false;
  print.sight.lateral_sigma_mm = 0.0;
  EXPECT_NEAR(judged(print).repeatability, 1.0, 0.2) << "a line that is level";
  EXPECT_EQ(judged(print).alarms, 0U);
}

}  // namespace
}  // namespace lamina
