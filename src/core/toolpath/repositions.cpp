// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/repositions.hpp"

#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

/// Runs that end and start this near to each other join [mm].
constexpr double kJoined = 1e-6;

bool isWall(const Path& path) { return kindOf(path.role) == RoleKind::Wall; }

void count(Repositions& repositions, const Path& from, const Path& to) {
  if ((to.firstPoint() - from.lastPoint()).norm() <= kJoined) return;
  ++(isWall(from) && !isWall(to) ? repositions.to_fill : repositions.in_layer);
}

}  // namespace

Repositions countRepositions(const Toolpath& toolpath) {
  Repositions repositions;
  const Path* from = nullptr;
  for (const ToolpathLayer& layer : toolpath.layers) {
    bool is_first = true;
    for (const Path& path : layer.paths) {
      if (!isPartOfPart(path)) continue;
      if (from != nullptr && !is_first) count(repositions, *from, path);
      if (from != nullptr && is_first && (path.firstPoint() - from->lastPoint()).norm() > kJoined)
        ++repositions.to_layer;
      from = &path;
      is_first = false;
    }
  }
  return repositions;
}

}  // namespace lamina
