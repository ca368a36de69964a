// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A path and its position in its toolpath, which must outlive this object.
struct ListedPath {
  const Path* path = nullptr;
  std::size_t layer = 0;
  std::size_t index = 0;  ///< index of the path in its layer
};

/// All paths of a toolpath, in the order in which they are run.
/// @throws InvalidInput if there are no paths
std::vector<ListedPath> listedPaths(const Toolpath& toolpath);

/// Refuses a waypoint of a path.
/// @throws InvalidInput naming the waypoint and the fault
[[noreturn]] void refuseWaypoint(const ListedPath& at, std::size_t waypoint, const std::string& what);

/// Refuses feeds outside 0.001 mm/s to 100 m/s.
void requireWritableFeeds(const ListedPath& at);

}  // namespace lamina
