// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/tool_point.hpp"

namespace lamina {

Toolpath withToolPoint(Toolpath toolpath, const Point3& point_mm) {
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths)
      for (std::size_t i = 0; i < path.points.size(); ++i)
        path.points[i] -= path.orientation.at(i) * point_mm;
  return toolpath;
}

}  // namespace lamina
