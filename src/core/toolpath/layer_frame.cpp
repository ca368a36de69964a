// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/layer_frame.hpp"

#include <cmath>
#include <cstdio>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLevel = 1e-9;           // rad: what rounding leaves of a rotation and its inverse
constexpr double kPlaneTolerance = 1e-6;  // mm

double inclination(const Toolpath& toolpath) {
  const Point3 normal = layerNormal(toolpath);
  return std::atan2(normal.head<2>().norm(), normal.z());
}

template <class Change>
void changePaths(Toolpath& toolpath, const Change& change) {
  for (ToolpathLayer& layer : toolpath.layers)
    for (Path& path : layer.paths) change(path);
}

AlongPath<Eigen::Quaterniond> turned(const AlongPath<Eigen::Quaterniond>& orientation,
                                     const Eigen::Quaterniond& rotation) {
  std::vector<Eigen::Quaterniond> values = orientation.values();
  for (Eigen::Quaterniond& value : values) value = (rotation * value).normalized();
  return AlongPath<Eigen::Quaterniond>(std::move(values));
}

}  // namespace

bool isInclined(const Toolpath& toolpath) { return inclination(toolpath) > kLevel; }

bool hasPlaneLayers(const Toolpath& toolpath) {
  const Point3 normal = layerNormal(toolpath);
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points)
          if (std::abs(normal.dot(point) - layer.z_mm) > kPlaneTolerance) return false;
  return true;
}

double inclinationDeg(const Toolpath& toolpath) { return toDegrees(inclination(toolpath)); }

Point3 layerNormal(const Toolpath& toolpath) { return toolpath.part_from_layers * Point3::UnitZ(); }

Toolpath turned(Toolpath toolpath, const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  changePaths(toolpath, [&](Path& path) {
    for (Point3& point : path.points) point = matrix * point;
    path.orientation = turned(path.orientation, rotation);
  });
  toolpath.part_from_layers = (rotation * toolpath.part_from_layers).normalized();
  return toolpath;
}

Toolpath placed(const Toolpath& toolpath, const Eigen::Isometry3d& frame_from_part) {
  Toolpath moved = turned(toolpath, Eigen::Quaterniond(frame_from_part.linear()));
  const Point3 shift = frame_from_part.translation();
  changePaths(moved, [&shift](Path& path) {
    for (Point3& point : path.points) point += shift;
  });
  for (ToolpathLayer& layer : moved.layers) layer.z_mm += layerNormal(moved).dot(shift);
  return moved;
}

Toolpath inLayerFrame(Toolpath toolpath) {
  const Eigen::Quaterniond layers_from_part = toolpath.part_from_layers.conjugate();
  toolpath = turned(std::move(toolpath), layers_from_part);
  toolpath.part_from_layers.setIdentity();
  return toolpath;
}

Toolpath withNozzle(Toolpath toolpath, const Eigen::Quaterniond& part_from_nozzle) {
  changePaths(toolpath, [&](Path& path) { path.orientation = part_from_nozzle; });
  return toolpath;
}

void requireLevelLayers(const Toolpath& toolpath, const std::string& who) {
  if (!isInclined(toolpath)) return;
  char angle[32];
  std::snprintf(angle, sizeof angle, "%.3f", inclinationDeg(toolpath));
  throw InvalidInput(who + ": the layers of '" + toolpath.part_name + "' are inclined by " + angle +
                     " deg; level layers are needed");
}

}  // namespace lamina
