// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {
namespace {

constexpr double kJoinTolerance = 1e-6;  // mm: far below any machine, far above rounding

template <class Value>
bool fits(const AlongPath<Value>& along, std::size_t waypoints) {
  return along.isCommon() || along.values().size() == waypoints;
}

[[noreturn]] void refuse(std::size_t layer, std::size_t path, const std::string& what) {
  throw InvalidInput("toolpath layer " + std::to_string(layer) + ", path " + std::to_string(path) + ": " +
                     what);
}

std::string faultOfValues(const Path& path) {
  for (std::size_t c = 0; c < path.values.size(); ++c) {
    const ProcessValue& each = path.values[c];
    const std::string which = "process value '" + each.name + "' ";
    if (each.name.empty()) return "a process value has no name";
    if (!fits(each.value, path.points.size()))
      return which + "needs one value or " + std::to_string(path.points.size()) + ", one per waypoint";
    for (const double value : each.value.values())
      if (!std::isfinite(value)) return which + "has a value that is not finite";
    for (std::size_t other = 0; other < c; ++other)
      if (path.values[other].name == each.name) return which + "stands twice";
  }
  return {};
}

std::string firstFault(const Path& path) {
  const std::size_t count = path.points.size();
  const std::size_t least = path.deposit == Deposit::Drops ? 1 : 2;
  if (count < least)
    return std::to_string(count) + " waypoints; at least " + std::to_string(least) + " are needed";
  if (!fits(path.orientation, count) || !fits(path.bead, count) || !fits(path.feed_mm_s, count))
    return "orientation, bead and feed need one value or " + std::to_string(count) + ", one per waypoint";
  for (std::size_t i = 0; i < count; ++i)
    if (!path.points[i].allFinite()) return "waypoint " + std::to_string(i) + " is not finite";
  for (const double feed : path.feed_mm_s.values())
    if (!(feed > 0.0 && std::isfinite(feed)))
      return "feed is " + numberText(feed) + " mm/s; must be positive";
  for (const Bead& bead : path.bead.values())
    if (!(bead.width_mm >= 0.0 && bead.height_mm >= 0.0 && std::isfinite(bead.width_mm + bead.height_mm)))
      return "bead is " + numberText(bead.width_mm) + " x " + numberText(bead.height_mm) + " mm";
  for (const Eigen::Quaterniond& q : path.orientation.values())
    if (!(std::abs(q.norm() - 1.0) < 1e-6)) return "orientation is no unit quaternion";
  const std::string fault = faultOfEvents(path);
  return fault.empty() ? faultOfValues(path) : fault;
}

}  // namespace

std::string faultOfEvents(const Path& path) {
  std::size_t last = 0;
  for (const PathEvent& placed : path.events) {
    if (placed.motion < last || placed.motion > path.motionCount())
      return std::string(nameOf(placed.event)) + " stands before motion " + std::to_string(placed.motion) +
             "; must be " + std::to_string(last) + " to " + std::to_string(path.motionCount());
    last = placed.motion;
    std::string defect = defectOf(placed.event);
    if (!defect.empty()) return defect;
  }
  return {};
}

void validate(const Toolpath& toolpath) {
  if (!(std::abs(toolpath.part_from_layers.norm() - 1.0) < 1e-6))
    throw InvalidInput("toolpath: the turn of the layers is no unit quaternion");
  const Path* previous = nullptr;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
    const auto& paths = toolpath.layers[l].paths;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const std::string fault = firstFault(paths[p]);
      if (!fault.empty()) refuse(l, p, fault);
      if (previous != nullptr && !((previous->lastPoint() - paths[p].firstPoint()).norm() <= kJoinTolerance))
        refuse(l, p, "does not start where the path before it ends");
      previous = &paths[p];
    }
  }
  for (const ToolpathEvent& event : toolpath.events_at_end) {
    const std::string defect = defectOf(event);
    if (!defect.empty()) throw InvalidInput("end of the toolpath: " + defect);
  }
}

}  // namespace lamina
