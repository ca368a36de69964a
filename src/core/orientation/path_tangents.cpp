// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/path_tangents.hpp"

namespace lamina {
namespace {

constexpr double kOpposed = 1e-9;  // of the sum of two directions

/// Unit directions of the motions; those without length take the one before, at the start the one after.
std::vector<Point3> motionDirections(const Path& path) {
  std::vector<Point3> directions(path.motionCount(), Point3::Zero());
  std::size_t first = directions.size();
  for (std::size_t m = 0; m < directions.size(); ++m) {
    const Point3 along = path.points[path.motionEnd(m)] - path.points[m];
    const double length = along.norm();
    if (length > 0.0) directions[m] = along / length;
    if (length > 0.0 && first == directions.size()) first = m;
    if (length == 0.0 && first < m) directions[m] = directions[m - 1];
  }
  if (first == directions.size()) return {};
  for (std::size_t m = 0; m < first; ++m)
    directions[m] = path.is_closed ? directions.back() : directions[first];
  return directions;
}

}  // namespace

std::vector<Point3> pathTangents(const Path& path) {
  const std::vector<Point3> directions = motionDirections(path);
  if (directions.empty()) return {};
  std::vector<Point3> tangents(path.points.size());
  const std::size_t motions = directions.size();
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const bool is_last = !path.is_closed && i == motions;
    const bool is_first = !path.is_closed && i == 0;
    const Point3& out = directions[is_last ? motions - 1 : i];
    const Point3& in = directions[is_first ? 0 : (i + motions - 1) % motions];
    const Point3 sum = in + out;
    tangents[i] = sum.norm() < kOpposed ? out : sum.normalized();
  }
  return tangents;
}

std::vector<double> motionLengths(const Path& path) {
  std::vector<double> lengths(path.motionCount());
  for (std::size_t m = 0; m < lengths.size(); ++m)
    lengths[m] = (path.points[path.motionEnd(m)] - path.points[m]).norm();
  return lengths;
}

}  // namespace lamina
