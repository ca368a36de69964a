// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "view_points.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "passes.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLeastPoints = 100;

int passAt(const Passes& passes, double time_s) {
  for (std::size_t i = 0; i < passes.runs.size(); ++i)
    if (time_s >= passes.runs[i].begin_s && time_s <= passes.runs[i].end_s) return static_cast<int>(i);
  return -1;
}

}  // namespace

std::vector<Point3> ViewPoints::onBed(const Eigen::Isometry3d& nozzle_from_sensor) const {
  std::vector<Point3> placed;
  placed.reserve(points.size());
  for (const SeenPoint& point : points) placed.push_back(onBed(point, nozzle_from_sensor));
  return placed;
}

ViewPoints viewPoints(const SensorRecording& recording, double time_offset_s) {
  const Passes passes = passesOf(recording.poses);
  ViewPoints view;
  for (const RecordedProfile& profile : recording.profiles) {
    const double time_s = profile.time_s - time_offset_s;
    const auto pose = poseAt(recording.poses, time_s);
    if (!pose) continue;
    for (const Point3& point : profile.points) view.points.push_back({view.bed_from_nozzle.size(), point});
    view.bed_from_nozzle.push_back(*pose);
    view.pass.push_back(passAt(passes, time_s));
  }
  if (view.points.size() < kLeastPoints)
    throw InvalidInput("a view has " + std::to_string(view.points.size()) +
                       " points at times at which the nozzle's pose is known; expected at least " +
                       std::to_string(kLeastPoints));
  return view;
}

std::vector<std::size_t> evenlyChosen(const std::vector<std::size_t>& from, std::size_t most) {
  if (from.size() <= most) return from;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < most; ++i) chosen.push_back(from[i * from.size() / most]);
  return chosen;
}

}  // namespace lamina
