// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The profile sensor, and what follows the heights it measures.
#include "job/settings/setting_probe.hpp"
#include "lamina/monitoring/height_monitor.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/monitoring/stamped_heights.hpp"
#include "support/scanned_plates.hpp"

namespace lamina::test {
namespace {

/// A plate with a step, from 61 mm above it.
std::string seen(const SettingTexts& set) {
  HeightMap map(heightGrid({Point2(0, 0), Point2(100, 100)}, 0.5), 0.0);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Point3(50, 50, 75);
  pose.linear() = Eigen::AngleAxisd(M_PI, Point3::UnitX()).toRotationMatrix();
  ProfileSensor sensor(settingsWith<ProfileSensorSettings>(set));
  std::vector<double> numbers{sensor.stampError()};
  for (const Point3& point : sensor.measure(map, pose, 1.0, 600.0)) {
    numbers.push_back(point.x());
    numbers.push_back(point.z());
  }
  return numbersText(numbers) + "points";
}

std::string monitored(const SettingTexts& set) {
  const Box2 plate{Point2(5, 5), Point2(15, 12)};
  HeightMonitor monitor(scannedPlates({plate}), Eigen::Isometry3d::Identity(),
                        settingsWith<MonitorSettings>(set));
  for (double y = 2.05; y < 16.0; y += 0.1) {
    std::vector<Point3> profile;
    for (double x = 2.05; x < 18.0; x += 0.1) profile.emplace_back(x, y, 0.21 + 0.001 * x);
    monitor.insert(profile, 1.3);
  }
  std::string text;
  for (const LayerHeightReport& report : monitor.finish())
    text += numbersText({report.statistics.mean_mm, double(report.statistics.cells),
                         report.statistics.coverage, double(report.profiles), double(report.sight)});
  return text + numbersText({double(monitor.pointsOutside())});
}

/// A scan of half a second in steps of 0.5 mm, the last of which is of 3 mm, and a rest over what was seen.
std::string stamped(const SettingTexts& set) {
  StampedHeights heights(scannedPlates({{Point2(5, 5), Point2(15, 12)}}), Eigen::Isometry3d::Identity(),
                         settingsWith<MonitorSettings>(set));
  std::vector<double> numbers;
  const auto note = [&](const LayerHeightReports& reports) {
    for (const LayerHeightReport& report : reports)
      numbers.insert(numbers.end(), {double(report.profiles), report.statistics.coverage});
  };
  const auto look = [&](int i, double y) {
    const std::int64_t stamp_ns = 50'000'000LL * i;
    note(heights.observe({stamp_ns, Point3(0, y, 1.3)}));
    StampedProfile profile{stamp_ns - 1, {}};
    for (double x = 4.05; x < 16.0; x += 0.1) profile.points.emplace_back(x, y, 0.21);
    note(heights.insert(profile));
  };
  heights.observe({1, Point3(5, 5, 0.2)});
  heights.observe({2, Point3(10, 5, 0.2)});
  heights.observe({3, Point3(0, 5, 1.3)});
  for (int i = 1; i <= 10; ++i) look(i, 5.0 + 0.5 * i);
  for (int i = 11; i <= 80; ++i) look(i, 13.0);
  return numbersText(numbers) + numbersText({double(heights.use().in_gap.profiles)});
}

}  // namespace

std::vector<SettingProbe> monitorProbes() {
  return {{"heights by stamps", "", stamped, {{"pose_gap_mm=1"}, {"quiet_s=1"}}},
          {"a profile sensor",
           "",
           seen,
           {{"sensor.width_mm=20"},
            {"sensor.points=100"},
            {"sensor.stand_off_mm=70"},
            {"sensor.range_mm=10"},
            {"sensor.noise_mm=0.05"},
            {"sensor.seed=2"},
            {"sensor.noise_correlation=0.5"},
            {"sensor.lateral_noise_mm=0.05"},
            {"sensor.time_offset_s=0.1"},
            {"sensor.stamp_jitter_s=0.01"},
            {"sensor.spray_rate=0.1"},
            {"sensor.mirror_rate=0.1"},
            {"sensor.dropout_rate=0.1"},
            {"sensor.bias_mm=0.2"},
            {"sensor.drift_mm_h=0.1"},
            {"sensor.moved_mm=0,0,0.5"},
            {"sensor.moved_at_s=700", "sensor.moved_mm=0,0,0.5"}}},
          {"a monitor of heights",
           "",
           monitored,
           {{"monitor.cell_mm=0.2"}, {"monitor.margin_mm=1"}, {"scan.clearance_mm=3"}}}};
}

}  // namespace lamina::test
