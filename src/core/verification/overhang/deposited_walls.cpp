// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/deposited_walls.hpp"

#include <cstdint>

#include "lamina/base/error.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {
namespace {

void addMotions(DepositedWalls& walls, const Path& path, double width_mm) {
  const auto first = static_cast<std::uint32_t>(walls.motions.vertices.size());
  walls.motions.vertices.insert(walls.motions.vertices.end(), path.points.begin(), path.points.end());
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    const auto from = static_cast<std::uint32_t>(first + m);
    const auto to = static_cast<std::uint32_t>(first + end);
    walls.motions.triangles.push_back({from, to, to});
    walls.growth.push_back({upAt(path, end), {width_mm, path.bead.at(end).height_mm}});
  }
}

}  // namespace

DepositedWalls depositedWalls(const Toolpath& toolpath, double width_mm) {
  const auto collect = [&](auto isWanted) {
    DepositedWalls walls;
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
      for (const Path& path : toolpath.layers[l].paths)
        if (isWanted(path.role)) addMotions(walls, path, width_mm);
      if (l == 0) walls.in_first_layer = walls.growth.size();
    }
    return walls;
  };
  DepositedWalls walls = collect([](PathRole role) { return role == PathRole::OuterWall; });
  if (walls.growth.empty())
    walls = collect(
        [](PathRole role) { return kindOf(role) == RoleKind::Wall || kindOf(role) == RoleKind::Infill; });
  if (walls.growth.empty()) throw InvalidInput("the toolpath deposits nothing; expected at least one bead");
  return walls;
}

}  // namespace lamina
