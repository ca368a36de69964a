// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/calibration/calibration_program.hpp"
#include "lamina/calibration/sensor_recording.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina::test {

/// The sensor beside the nozzle, 60 mm above its tip, looking along it.
inline Eigen::Isometry3d nominalSensor() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Point3(25.0, 0.0, -60.0);
  return pose;
}

/// The nozzle straight down.
inline Eigen::Isometry3d nozzleAt(const Point3& tip) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = nozzleDown().toRotationMatrix();
  pose.translation() = tip;
  return pose;
}

/// Through points, each at its own speed.
class LinearMotion {
 public:
  struct Way {
    Point3 to = Point3::Zero();
    double speed_mm_s = 1.0;
  };

  LinearMotion(const Point3& start, const std::vector<Way>& ways) : points_(1, start), times_(1, 0.0) {
    for (const Way& way : ways) {
      times_.push_back(times_.back() + (way.to - points_.back()).norm() / way.speed_mm_s);
      points_.push_back(way.to);
    }
  }

  double duration() const { return times_.back(); }
  Point3 at(double time_s) const {
    std::size_t next = 1;
    while (next + 1 < times_.size() && times_[next] < time_s) ++next;
    const double part = (time_s - times_[next - 1]) / (times_[next] - times_[next - 1]);
    return points_[next - 1] + std::min(std::max(part, 0.0), 1.0) * (points_[next] - points_[next - 1]);
  }

 private:
  std::vector<Point3> points_;
  std::vector<double> times_;
};

/// A profile sensor on a head over a surface, and how its recording is spoilt.
struct RecordedCell {
  std::function<double(const Point2&)> surface = [](const Point2&) { return 0.0; };  ///< height by place
  Eigen::Isometry3d nozzle_from_sensor = nominalSensor();
  double offset_s = 0.0;  ///< stamps are so late
  double jitter_s = 0.0;  ///< standard deviation of stamps
  double noise_mm = 0.0;
  int points = 57;
  double width_mm = 28.0;
  double profile_s = 0.005;
  double pose_s = 0.01;
  std::uint64_t seed = 1;
};

/// How far along the ray of direction (across, 0, 1) the surface lies; no number if it is out of range.
inline double depthOf(const RecordedCell& cell, const Eigen::Isometry3d& bed_from_sensor, double across) {
  const Point3 from = bed_from_sensor.translation();
  const Eigen::Vector3d ray = bed_from_sensor.linear() * Eigen::Vector3d(across, 0.0, 1.0);
  const auto above = [&](double depth) {
    const Point2 at(from[0] + depth * ray[0], from[1] + depth * ray[1]);
    return from[2] + depth * ray[2] - cell.surface(at);
  };
  double near = 30.0;
  if (above(near) < 0.0) return std::nan("");
  double far = near;
  while (above(far) >= 0.0) {
    near = far;
    far += 1.0;
    if (far > 110.0) return std::nan("");
  }
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (near + far);
    (above(middle) >= 0.0 ? near : far) = middle;
  }
  return near;
}

inline RecordedProfile profileOf(const RecordedCell& cell, const Eigen::Isometry3d& bed_from_nozzle,
                                 Random& random) {
  RecordedProfile profile;
  const Eigen::Isometry3d bed_from_sensor = bed_from_nozzle * cell.nozzle_from_sensor;
  for (int i = 0; i < cell.points; ++i) {
    const double across = (i / (cell.points - 1.0) - 0.5) * cell.width_mm / 60.0;
    const double depth = depthOf(cell, bed_from_sensor, across) + random.normal(0.0, 1.0) * cell.noise_mm;
    if (std::isfinite(depth)) profile.points.emplace_back(across * depth, 0.0, depth);
  }
  return profile;
}

/// What is recorded while the nozzle moves: poses exact, profiles stamped late and unevenly, in the order of
/// their stamps.
inline SensorRecording record(const RecordedCell& cell,
                              const std::function<Eigen::Isometry3d(double)>& bed_from_nozzle,
                              double duration_s, double start_s = 1000.0) {
  SensorRecording recording;
  Random random(cell.seed);
  for (double time = 0.0; time <= duration_s; time += cell.pose_s)
    recording.poses.push_back({start_s + time, bed_from_nozzle(time)});
  for (double time = 0.0; time <= duration_s; time += cell.profile_s) {
    RecordedProfile profile = profileOf(cell, bed_from_nozzle(time), random);
    profile.time_s = start_s + time + cell.offset_s + random.normal(0.0, 1.0) * cell.jitter_s;
    if (!profile.points.empty()) recording.profiles.push_back(profile);
  }
  std::sort(recording.profiles.begin(), recording.profiles.end(),
            [](const RecordedProfile& a, const RecordedProfile& b) { return a.time_s < b.time_s; });
  return recording;
}

inline SensorRecording record(const RecordedCell& cell, const LinearMotion& motion) {
  return record(
      cell, [&](double time) { return nozzleAt(motion.at(time)); }, motion.duration());
}

/// As the program for bobbing asks for, at its speeds.
inline LinearMotion bobbing(const CalibrationSettings& settings) {
  const Toolpath toolpath = bobbingToolpath(settings, {25.0, 0.0});
  std::vector<LinearMotion::Way> ways;
  for (const Path& path : toolpath.layers[0].paths)
    for (std::size_t i = 0; i < path.points.size(); ++i)
      if (ways.empty() || path.points[i] != ways.back().to)
        ways.push_back({path.points[i], path.feed_mm_s.at(i)});
  return {toolpath.layers[0].paths[0].firstPoint() + Point3(0, 0, 1), ways};
}

}  // namespace lamina::test
