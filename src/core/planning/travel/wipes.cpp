// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/wipes.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "lamina/toolpath/wipe.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kSameTip = 1e-6;  // mm

/// From where a run ends.
std::vector<Point3> wayAlong(const Path& run, double wipe_mm) {
  const std::size_t count = run.points.size();
  std::vector<Point3> way = {run.lastPoint()};
  for (std::size_t i = 1; i < count + (run.is_closed ? 1 : 0) && wipe_mm > kSameTip; ++i) {
    const Point3& next = run.is_closed ? run.points[i % count] : run.points[count - 1 - i];
    const Point3 there = next - way.back();
    const double length_mm = there.norm();
    if (length_mm == 0.0) continue;
    way.emplace_back(length_mm > wipe_mm ? Point3(way.back() + wipe_mm / length_mm * there) : next);
    wipe_mm -= length_mm;
  }
  return way;
}

Path wipeAlong(const Path& run, const Path& travel, const TravelSettings& settings) {
  Path wipe;
  wipe.role = PathRole::Travel;
  wipe.process.is_retracted = true;
  wipe.tool = run.tool;
  wipe.orientation = travel.orientation.at(0);
  wipe.feed_mm_s = run.feed_mm_s.at(run.is_closed ? 0 : run.points.size() - 1);
  wipe.points = wayAlong(run, settings.wipe_mm);
  if (settings.wipe_share > 0.0) wipe.values.push_back({kWipeShare, settings.wipe_share});
  return wipe;
}

/// Its first point, and where it rises from there.
void startAt(Path& travel, const Point3& start) {
  const Point3 before = travel.points.front();
  for (Point3& point : travel.points) {
    if (point.head<2>() != before.head<2>()) return;
    point.head<2>() = start.head<2>();
  }
}

/// Wipes along the run that ends the paths before a retracted travel, which then starts where the wipe ends.
void wipeBefore(Path& travel, std::vector<Path>& before, const TravelSettings& settings) {
  Path wipe = wipeAlong(before.back(), travel, settings);
  const Point3 end = wipe.lastPoint();
  if (wipe.points.size() < 2 || (travel.lastPoint() - end).head<2>().norm() <= kSameTip) return;
  startAt(travel, end);
  before.push_back(std::move(wipe));
}

}  // namespace

void addWipes(std::vector<ToolpathLayer>& layers, const TravelSettings& settings) {
  if (settings.wipe_mm == 0.0) return;
  std::vector<Path>* before = nullptr;  // the paths that the nozzle comes from
  for (ToolpathLayer& layer : layers) {
    std::vector<Path> joined;
    for (Path& path : layer.paths) {
      std::vector<Path>* from = joined.empty() ? before : &joined;
      if (from != nullptr && path.process.is_retracted && laysBeads(from->back()))
        wipeBefore(path, *from, settings);
      joined.push_back(std::move(path));
    }
    layer.paths = std::move(joined);
    if (!layer.paths.empty()) before = &layer.paths;
  }
}

bool isWipeAlong(const Path& run, const Path& travel) {
  if (travel.role != PathRole::Travel || !travel.process.is_retracted || !laysBeads(run)) return false;
  double length_mm = 0.0;
  for (std::size_t i = 1; i < travel.points.size(); ++i)
    length_mm += (travel.points[i] - travel.points[i - 1]).norm();
  const std::vector<Point3> way = wayAlong(run, length_mm);
  return way.size() > 1 &&
         std::equal(way.begin(), way.end(), travel.points.begin(), travel.points.end(),
                    [](const Point3& a, const Point3& b) { return (a - b).norm() <= kSameTip; });
}

}  // namespace lamina
