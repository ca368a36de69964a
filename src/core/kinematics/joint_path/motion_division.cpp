// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/joint_path/motion_division.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lamina/base/angle.hpp"

namespace lamina {

namespace {

using Origins = std::vector<std::uint32_t>;

constexpr double kRounding = 1e-9;  // of a step: a motion as long as the greatest step is one step

/// Where a waypoint of a divided path is in the path it is from: so far from the start to the end of a
/// motion.
struct Place {
  std::size_t start = 0;
  std::size_t end = 0;
  double fraction = 1.0;

  bool isNew() const { return fraction < 1.0; }
};

/// All waypoints of a divided path.
std::vector<Place> places(const Path& path, const int* steps) {
  std::vector<Place> found{{0, 0, 1.0}};
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const int count = steps[m + 1];
    for (int s = 1; s < count; ++s) found.push_back({m, end, static_cast<double>(s) / count});
    if (end != 0) found.push_back({m, end, 1.0});
  }
  return found;
}

template <class Value, class At>
AlongPath<Value> along(const AlongPath<Value>& from, const std::vector<Place>& where, const At& at) {
  if (from.isCommon()) return from;
  std::vector<Value> values;
  values.reserve(where.size());
  for (const Place& place : where) values.push_back(at(place));
  return AlongPath<Value>(std::move(values));
}

/// The bead of the motion, and no drop where none was.
AlongPath<Bead> beadsAlong(const Path& path, const std::vector<Place>& where) {
  if (path.deposit == Deposit::Bead)
    return along(path.bead, where, [&](const Place& place) { return path.bead.at(place.end); });
  std::vector<Bead> beads;
  beads.reserve(where.size());
  for (const Place& place : where) {
    beads.push_back(path.bead.at(place.end));
    if (place.isNew()) beads.back().width_mm = 0.0;
  }
  return AlongPath<Bead>(std::move(beads));
}

/// Each before the motion that it was before.
std::vector<PathEvent> eventsAlong(const Path& path, const std::vector<Place>& where) {
  std::vector<PathEvent> events = path.events;
  for (PathEvent& placed : events)
    placed.motion += static_cast<std::size_t>(std::count_if(
        where.begin(), where.end(),
        [motion = placed.motion](const Place& place) { return place.isNew() && place.start < motion; }));
  return events;
}

Path dividedPath(const Path& path, const std::vector<Place>& where) {
  Path result;
  result.role = path.role;
  result.is_closed = path.is_closed;
  result.deposit = path.deposit;
  result.process = path.process;
  result.tool = path.tool;
  result.events = eventsAlong(path, where);
  result.points.reserve(where.size());
  for (const Place& place : where) {
    const Point3& end = path.points[place.end];
    const Point3& start = path.points[place.start];
    result.points.push_back(place.isNew() ? Point3(start + place.fraction * (end - start)) : end);
  }
  result.orientation = along(path.orientation, where, [&](const Place& place) {
    const Eigen::Quaterniond& end = path.orientation.at(place.end);
    return place.isNew() ? path.orientation.at(place.start).slerp(place.fraction, end) : end;
  });
  result.bead = beadsAlong(path, where);
  result.feed_mm_s =
      along(path.feed_mm_s, where, [&](const Place& place) { return path.feed_mm_s.at(place.end); });
  for (const ProcessValue& each : path.values)
    result.values.push_back(
        {each.name, along(each.value, where, [&](const Place& place) { return each.value.at(place.end); })});
  return result;
}

int stepsOf(double amount, double most) {
  return std::max(1, static_cast<int>(std::ceil(amount / most - kRounding)));
}

/// Of one path, with a 1 for its first waypoint.
void addSteps(const Path& path, const MotionDivision& division, std::vector<int>& steps) {
  steps.push_back(1);
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const double turn = path.orientation.at(m).angularDistance(path.orientation.at(end));
    steps.push_back(std::max(stepsOf((path.points[end] - path.points[m]).norm(), division.max_step_mm),
                             stepsOf(turn, toRadians(division.max_step_deg))));
  }
}

}  // namespace

void describe(SettingsSchema& schema, MotionDivision& division) {
  schema.number("joints.max_step_mm", division.max_step_mm, {0.01, 1e6},
                "Length above which a motion is divided before joints are found.");
  schema.number("joints.max_step_deg", division.max_step_deg, {0.1, 180.0},
                "Turn of the nozzle above which a motion is divided before joints are found.");
  schema.number("joints.tip_tolerance_mm", division.tip_tolerance_mm, {1e-4, 100.0},
                "How far steady joints may lead the nozzle tip off a motion's straight line.");
  schema.number("joints.tool_axis_tolerance_deg", division.tool_axis_tolerance_deg, {1e-3, 90.0},
                "How far steady joints may lead the tool axis off a motion's steady turn.");
  schema.renamed("joints.jet_tolerance_deg", "joints.tool_axis_tolerance_deg");
}

DividedToolpath undivided(Toolpath toolpath) {
  DividedToolpath result;
  result.original.reserve(toolpath.layers.size());
  for (const ToolpathLayer& layer : toolpath.layers) {
    result.original.emplace_back();
    for (const Path& path : layer.paths) {
      Origins own(path.points.size());
      std::iota(own.begin(), own.end(), 0U);
      result.original.back().push_back(std::move(own));
    }
  }
  result.toolpath = std::move(toolpath);
  return result;
}

DividedToolpath divided(const DividedToolpath& from, const std::vector<int>& steps) {
  DividedToolpath result;
  result.toolpath.part_name = from.toolpath.part_name;
  result.toolpath.part_from_layers = from.toolpath.part_from_layers;
  result.toolpath.events_at_end = from.toolpath.events_at_end;
  const int* own = steps.data();
  for (std::size_t l = 0; l < from.toolpath.layers.size(); ++l) {
    const ToolpathLayer& layer = from.toolpath.layers[l];
    result.toolpath.layers.push_back({layer.z_mm, layer.height_mm, {}});
    result.original.emplace_back();
    for (std::size_t p = 0; p < layer.paths.size(); ++p) {
      const std::vector<Place> where = places(layer.paths[p], own);
      own += layer.paths[p].motionCount() + 1;
      result.toolpath.layers.back().paths.push_back(dividedPath(layer.paths[p], where));
      Origins origins;
      origins.reserve(where.size());
      for (const Place& place : where) origins.push_back(from.original[l][p][place.end]);
      result.original.back().push_back(std::move(origins));
    }
  }
  return result;
}

std::vector<int> stepsWithin(const Toolpath& toolpath, const MotionDivision& division) {
  std::vector<int> steps;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths) addSteps(path, division, steps);
  return steps;
}

DividedToolpath divideMotions(Toolpath toolpath, const MotionDivision& division) {
  const std::vector<int> steps = stepsWithin(toolpath, division);
  return divided(undivided(std::move(toolpath)), steps);
}

}  // namespace lamina
