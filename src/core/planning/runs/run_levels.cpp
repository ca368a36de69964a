// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/run_ends.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLevelSteps = 8;  // of a rise or fall
constexpr double kLevelStepEnd = 1e-6;  // mm

/// How values rise and fall along a run.
class LevelRamp {
 public:
  LevelRamp(const LevelSettings& settings, double run_mm) : settings_(settings), run_mm_(run_mm) {}

  /// Ways from the run's start at which the values change.
  std::vector<double> steps() const {
    std::vector<double> ways_mm;
    for (std::size_t step = 1; step <= kLevelSteps; ++step) {
      const double share = static_cast<double>(step) / kLevelSteps;
      if (settings_.start_mm > 0.0) ways_mm.push_back(share * settings_.start_mm);
      if (settings_.end_mm > 0.0) ways_mm.push_back(run_mm_ - share * settings_.end_mm);
    }
    std::sort(ways_mm.begin(), ways_mm.end());
    return ways_mm;
  }

  double shareAt(double way_mm) const {
    return rising(way_mm, settings_.start_mm, settings_.start_share) *
           rising(run_mm_ - way_mm, settings_.end_mm, settings_.end_share);
  }

 private:
  static double rising(double way_mm, double over_mm, double from) {
    return way_mm >= over_mm ? 1.0 : from + (1.0 - from) * way_mm / over_mm;
  }

  const LevelSettings& settings_;
  double run_mm_;
};

/// Places of ways from the start of a path.
std::vector<CutPlace> placesAlong(const Path& path, const std::vector<double>& ways_mm) {
  std::vector<CutPlace> places;
  double begin_mm = 0.0;
  double last_mm = 0.0;
  std::size_t next = 0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const double end_mm = begin_mm + motionLength(path, m);
    for (; next < ways_mm.size() && ways_mm[next] < end_mm - kLevelStepEnd; ++next) {
      if (ways_mm[next] <= std::max(begin_mm, last_mm) + kLevelStepEnd) continue;
      last_mm = ways_mm[next];
      places.push_back({m, (last_mm - begin_mm) / (end_mm - begin_mm)});
    }
    begin_mm = end_mm;
  }
  return places;
}

double wholeLevel(const StatedLevel& level, const Path& path, std::size_t waypoint, double wire_mm) {
  if (!level.is_from_bead) return level.value;
  const double wire_mm2 = 0.25 * M_PI * wire_mm * wire_mm;
  return crossSection(path.bead.at(waypoint)) * path.feed_mm_s.at(waypoint) / wire_mm2;
}

/// @param begin_mm  way from the run's start to that of the path
void stateAlong(Path& path, double begin_mm, const LevelRamp& ramp, const std::vector<StatedLevel>& levels,
                double wire_mm) {
  std::vector<double> ways_mm = ramp.steps();
  for (double& way_mm : ways_mm) way_mm -= begin_mm;
  path = withWaypoints(path, placesAlong(path, ways_mm));
  std::vector<double> shares(path.points.size(), 1.0);
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const double length_mm = motionLength(path, m);
    shares[path.motionEnd(m)] = ramp.shareAt(begin_mm + 0.5 * length_mm);
    begin_mm += length_mm;
  }
  if (!path.is_closed) shares[0] = shares[1];  // not used
  for (const StatedLevel& level : levels) {
    std::vector<double> values;
    for (std::size_t i = 0; i < path.points.size(); ++i)
      values.push_back(shares[i] * wholeLevel(level, path, i == 0 && !path.is_closed ? 1 : i, wire_mm));
    const bool is_common =
        std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
    path.values.push_back(
        {level.name, is_common ? AlongPath<double>(values.front()) : AlongPath<double>(std::move(values))});
  }
}

}  // namespace

void stateLevels(Toolpath& toolpath, const LevelSettings& settings) {
  const std::vector<StatedLevel> levels = statedLevels(settings.values);
  if (levels.empty()) return;
  const std::vector<RunPlace> places = placesOf(toolpath);
  for (const RunSpan& run : beadRunsOf(toolpath, places)) {
    double run_mm = 0.0;
    for (std::size_t i = run.begin; i < run.end; ++i) run_mm += length(pathAt(toolpath, places[i]));
    const LevelRamp ramp(settings, run_mm);
    double begin_mm = 0.0;
    for (std::size_t i = run.begin; i < run.end; ++i) {
      Path& path = pathAt(toolpath, places[i]);
      const double length_mm = length(path);
      stateAlong(path, begin_mm, ramp, levels, settings.wire_diameter_mm);
      begin_mm += length_mm;
    }
  }
}

}  // namespace lamina
