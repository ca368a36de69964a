// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/listed_paths.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/waypoint_text.hpp"

namespace lamina {
namespace {

constexpr double kSlowest = 1e-3;  // mm/s: what the decimals of a program resolve
constexpr double kFastest = 1e5;   // mm/s

}  // namespace

std::vector<ListedPath> listedPaths(const Toolpath& toolpath) {
  std::vector<ListedPath> paths;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p)
      paths.push_back({&toolpath.layers[l].paths[p], l, p});
  if (paths.empty())
    throw InvalidInput("the toolpath of '" + toolpath.part_name +
                       "' has no path; a program needs at least one motion");
  return paths;
}

void refuseWaypoint(const ListedPath& at, std::size_t waypoint, const std::string& what) {
  throw InvalidInput("toolpath " + toText({at.layer, at.index, waypoint}) + ": " + what);
}

void requireWritableFeeds(const ListedPath& at) {
  const AlongPath<double>& feed = at.path->feed_mm_s;
  for (std::size_t i = 0; i < feed.values().size(); ++i)
    if (!(feed.at(i) >= kSlowest && feed.at(i) < kFastest))
      refuseWaypoint(at, i, "feed is " + numberText(feed.at(i)) + " mm/s; must be 0.001 mm/s at least");
}

}  // namespace lamina
