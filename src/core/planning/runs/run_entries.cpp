// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "lamina/planning/runs/runs.hpp"
#include "planning/runs/run_ends.hpp"

namespace lamina {
namespace {

constexpr double kSameEntry = 1e-6;  // mm

Point3 entryOffset(const Eigen::Quaterniond& nozzle, const EntrySettings& settings) {
  const Point3 away =
      settings.direction == EntryDirection::Jet ? Point3(-(nozzle * Point3::UnitZ())) : Point3::UnitZ();
  return settings.distance_mm * away;
}

template <class Value>
AlongPath<Value> without(const AlongPath<Value>& along, std::size_t waypoint) {
  if (along.isCommon()) return along;
  std::vector<Value> values = along.values();
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(waypoint));
  return AlongPath<Value>(std::move(values));
}

void removeWaypoint(Path& travel, std::size_t waypoint) {
  travel.points.erase(travel.points.begin() + static_cast<std::ptrdiff_t>(waypoint));
  travel.orientation = without(travel.orientation, waypoint);
  travel.bead = without(travel.bead, waypoint);
  travel.feed_mm_s = without(travel.feed_mm_s, waypoint);
  for (ProcessValue& value : travel.values) value.value = without(value.value, waypoint);
  for (PathEvent& placed : travel.events) placed.motion = std::min(placed.motion, travel.motionCount());
}

/// A travel that ends, or starts, elsewhere: the waypoint next to that may be there already.
void leadTo(Path& travel, std::size_t waypoint, std::size_t next, const Point3& to) {
  travel.points[waypoint] = to;
  if (travel.points.size() > 2 && (travel.points[next] - to).norm() <= kSameEntry)
    removeWaypoint(travel, next);
}

Path entryTravel(const Point3& from, const Point3& to, const Eigen::Quaterniond& nozzle, double feed_mm_s) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, to};
  path.orientation = nozzle;
  path.feed_mm_s = feed_mm_s;
  return path;
}

/// Ways to a path and from it.
struct PathEntries {
  std::optional<Path> to;
  std::optional<Path> from;
};

class Entries {
 public:
  Entries(Toolpath& toolpath, const EntrySettings& settings)
      : toolpath_(toolpath), settings_(settings), places_(placesOf(toolpath)) {
    for (const ToolpathLayer& layer : toolpath.layers) entries_.emplace_back(layer.paths.size());
  }

  std::size_t add() {
    for (const RunSpan& run : runsOf(toolpath_, places_)) {
      const RunSpan whole = withLeads(run);
      addTo(whole.begin);
      addFrom(whole.end - 1);
    }
    for (std::size_t l = 0; l < toolpath_.layers.size(); ++l) insert(toolpath_.layers[l].paths, entries_[l]);
    return count_;
  }

 private:
  bool isTravel(std::size_t index) const {
    return pathAt(toolpath_, places_[index]).role == PathRole::Travel;
  }

  /// A dry lead is a travel that is followed by the run, and follows one.
  RunSpan withLeads(RunSpan run) const {
    if (run.begin > 1 && isTravel(run.begin - 1) && isTravel(run.begin - 2)) --run.begin;
    if (run.end + 1 < places_.size() && isTravel(run.end) && isTravel(run.end + 1)) ++run.end;
    return run;
  }

  void addTo(std::size_t index) {
    if (index > 0 && !isTravel(index - 1)) return;
    const Path& path = pathAt(toolpath_, places_[index]);
    const Eigen::Quaterniond nozzle = path.orientation.at(0);
    const Point3 entry = path.firstPoint() + entryOffset(nozzle, settings_);
    if (index > 0) {
      Path& travel = pathAt(toolpath_, places_[index - 1]);
      leadTo(travel, travel.points.size() - 1, travel.points.size() - 2, entry);
    }
    at(index).to = entryTravel(entry, path.firstPoint(), nozzle, settings_.feed_mm_s);
    ++count_;
  }

  void addFrom(std::size_t index) {
    const bool is_last = index + 1 == places_.size();
    if (!is_last && !isTravel(index + 1)) return;
    const Path& path = pathAt(toolpath_, places_[index]);
    const Eigen::Quaterniond nozzle = nozzleAtEnd(path);
    const Point3 exit = path.lastPoint() + entryOffset(nozzle, settings_);
    if (!is_last) leadTo(pathAt(toolpath_, places_[index + 1]), 0, 1, exit);
    at(index).from = entryTravel(path.lastPoint(), exit, nozzle, settings_.feed_mm_s);
    ++count_;
  }

  PathEntries& at(std::size_t index) { return entries_[places_[index].layer][places_[index].path]; }

  static void insert(std::vector<Path>& paths, std::vector<PathEntries>& entries) {
    std::vector<Path> all;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      if (entries[p].to) all.push_back(std::move(*entries[p].to));
      all.push_back(std::move(paths[p]));
      if (entries[p].from) all.push_back(std::move(*entries[p].from));
    }
    paths = std::move(all);
  }

  Toolpath& toolpath_;
  const EntrySettings& settings_;
  std::vector<RunPlace> places_;
  std::vector<std::vector<PathEntries>> entries_;
  std::size_t count_ = 0;
};

}  // namespace

std::size_t addEntries(Toolpath& toolpath, const EntrySettings& settings) {
  return settings.distance_mm == 0.0 ? 0 : Entries(toolpath, settings).add();
}

}  // namespace lamina
