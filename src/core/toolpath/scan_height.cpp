// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/scan_height.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kSameHeight = 1e-3;  // mm: programs and messages round finer

}  // namespace

double scanHeight(const ToolpathLayer& layer, double clearance_mm) {
  if (!(layer.height_mm > 0.0)) return layer.z_mm + clearance_mm;
  const double layers = std::ceil(clearance_mm / layer.height_mm - 0.5 - 1e-9) + 0.5;
  return layer.z_mm + layers * layer.height_mm;
}

bool isScanned(const ToolpathLayer& layer, double clearance_mm, const Point3& normal) {
  const double height = scanHeight(layer, clearance_mm);
  return std::any_of(layer.paths.begin(), layer.paths.end(), [&](const Path& path) {
    return path.role == PathRole::Travel &&
           std::any_of(path.points.begin(), path.points.end(), [&](const Point3& point) {
             return std::abs(normal.dot(point) - height) < kSameHeight;
           });
  });
}

}  // namespace lamina
