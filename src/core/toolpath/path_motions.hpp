// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Length of a motion [mm].
inline double motionLength(const Path& path, std::size_t motion) {
  return (path.points[path.motionEnd(motion)] - path.points[motion]).norm();
}

/// Orientation with which the nozzle begins a path, and with which it ends it (a closed one at its start).
inline const Eigen::Quaterniond& startOrientation(const Path& path) { return path.orientation.at(0); }
inline const Eigen::Quaterniond& endOrientation(const Path& path) {
  return path.orientation.at(path.is_closed ? 0 : path.points.size() - 1);
}

/// The values of a quantity along a path, for a path made of waypoints of this one.
/// @param from  for each waypoint of the new path, the one of the old path
template <class Value>
AlongPath<Value> picked(const AlongPath<Value>& quantity, const std::vector<std::size_t>& from) {
  if (quantity.isCommon()) return quantity;
  std::vector<Value> values;
  values.reserve(from.size());
  for (const std::size_t waypoint : from) values.push_back(quantity.at(waypoint));
  return AlongPath<Value>(std::move(values));
}

/// The last path of all layers; null if there is none.
inline const Path* lastPath(const Toolpath& toolpath) {
  for (auto layer = toolpath.layers.rbegin(); layer != toolpath.layers.rend(); ++layer)
    if (!layer->paths.empty()) return &layer->paths.back();
  return nullptr;
}

}  // namespace lamina
