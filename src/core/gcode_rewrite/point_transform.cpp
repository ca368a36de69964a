// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_rewrite/point_transform.hpp"

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr int kDeepest = 12;  // 4096 chords of one motion

struct Division {
  const PointTransform& transform;
  double tolerance_mm;
  std::vector<Point3>& points;

  Point3 mapped(const Point3& point) const { return transform.coordinates(transform.overBed(point)); }

  bool isStraight(const Point3& from, const Point3& to) const {
    const Point3 first = mapped(from);
    const Point3 last = mapped(to);
    for (const double part : {0.25, 0.5, 0.75})
      if ((mapped(from + part * (to - from)) - (first + part * (last - first))).norm() > tolerance_mm)
        return false;
    return true;
  }

  void divide(const Point3& from, const Point3& to, int depth) {
    if (isStraight(from, to)) {
      points.push_back(to);
      return;
    }
    if (depth == kDeepest)
      throw InvalidInput(
          "the map bends a motion so sharply that 4096 chords do not follow it; expected a smooth one");
    const Point3 middle = 0.5 * (from + to);
    divide(from, middle, depth + 1);
    divide(middle, to, depth + 1);
  }
};

}  // namespace

std::vector<Point3> divided(const Point3& start, const std::vector<Point3>& ends,
                            const PointTransform& transform, double tolerance_mm) {
  std::vector<Point3> points;
  Division division{transform, tolerance_mm, points};
  Point3 from = start;
  for (const Point3& end : ends) {
    division.divide(from, end, 0);
    from = end;
  }
  return points;
}

}  // namespace lamina
