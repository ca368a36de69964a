// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/level_lead.hpp"

#include <algorithm>
#include <utility>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kLevelStepEnd = 1e-6;  // mm

/// A value from a time on.
struct TimedLevel {
  double from_s = 0.0;
  double value = 0.0;
};

double motionTime(const Path& path, std::size_t motion) {
  return motionLength(path, motion) / path.feed_mm_s.at(path.motionEnd(motion));
}

AlongPath<double>* levelOf(Path& path, const std::string& name) {
  for (ProcessValue& value : path.values)
    if (value.name == name) return &value.value;
  return nullptr;
}

/// The times at which a channel changes, over the whole toolpath.
std::vector<TimedLevel> timesOf(Toolpath& toolpath, const std::string& name) {
  std::vector<TimedLevel> levels;
  double time_s = 0.0;
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      const AlongPath<double>* value = levelOf(path, name);
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const double level = value == nullptr ? 0.0 : value->at(path.motionEnd(m));
        if (value != nullptr && (levels.empty() || levels.back().value != level))
          levels.push_back({time_s, level});
        time_s += motionTime(path, m);
      }
    }
  return levels;
}

/// The value at a time; the first one before all.
double levelAt(const std::vector<TimedLevel>& levels, double time_s) {
  const auto after = std::upper_bound(levels.begin(), levels.end(), time_s,
                                      [](double at, const TimedLevel& level) { return at < level.from_s; });
  return after == levels.begin() ? levels.front().value : (after - 1)->value;
}

/// Ways along a path at which a channel that leads by a time changes.
/// @param begin_s  when the path begins
std::vector<double> changesAlong(const Path& path, const std::vector<TimedLevel>& levels, double begin_s,
                                 double lead_s) {
  std::vector<double> ways_mm;
  auto next = std::upper_bound(levels.begin(), levels.end(), begin_s + lead_s,
                               [](double at, const TimedLevel& level) { return at < level.from_s; });
  double way_mm = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const double feed_mm_s = path.feed_mm_s.at(path.motionEnd(m));
    const double end_s = begin_s + motionTime(path, m);
    for (; next != levels.end() && next->from_s - lead_s < end_s; ++next)
      ways_mm.push_back(way_mm + (next->from_s - lead_s - begin_s) * feed_mm_s);
    begin_s = end_s;
    way_mm += motionLength(path, m);
  }
  return ways_mm;
}

void leadChannel(Toolpath& toolpath, const std::string& name, double lead_s) {
  const std::vector<TimedLevel> levels = timesOf(toolpath, name);
  double time_s = 0.0;
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) {
      if (levelOf(path, name) != nullptr)
        path = withWaypoints(path, levelSteps(path, changesAlong(path, levels, time_s, lead_s)));
      std::vector<double> values(path.points.size());
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const double motion_s = motionTime(path, m);
        values[path.motionEnd(m)] = levels.empty() ? 0.0 : levelAt(levels, time_s + 0.5 * motion_s + lead_s);
        time_s += motion_s;
      }
      if (!path.is_closed && values.size() > 1) values[0] = values[1];  // not used
      if (AlongPath<double>* value = levelOf(path, name)) *value = AlongPath<double>(std::move(values));
    }
}

}  // namespace

std::vector<CutPlace> levelSteps(const Path& path, const std::vector<double>& ways_mm) {
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

void leadLevels(Toolpath& toolpath, const std::vector<LevelChannel>& channels) {
  for (const LevelChannel& channel : channels)
    if (channel.dead_time_s > 0.0) leadChannel(toolpath, channel.stated.name, channel.dead_time_s);
}

}  // namespace lamina
