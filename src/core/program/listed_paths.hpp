// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A path and where it stands in its toolpath, which must outlive it.
struct ListedPath {
  const Path* path = nullptr;
  std::size_t layer = 0;
  std::size_t index = 0;  ///< in its layer
};

/// All paths, in the order they are run.
/// @throws InvalidInput if there are none
std::vector<ListedPath> listedPaths(const Toolpath& toolpath);

/// @throws InvalidInput naming the waypoint and what is wrong with it
[[noreturn]] void refuseWaypoint(const ListedPath& at, std::size_t waypoint, const std::string& what);

/// @throws InvalidInput naming the first feed that is not from 0.001 mm/s to 100 m/s
void requireWritableFeeds(const ListedPath& at);

}  // namespace lamina
