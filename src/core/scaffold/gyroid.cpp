// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/gyroid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "scaffold/convex_clip.hpp"

namespace lamina {
namespace {

/// Length of the curves in a square of one period, mean over all heights of cut: by quadrature.
constexpr double kLengthOfCell = 2.4586;
constexpr int kSegments = 64;  ///< of a curve along a period

/// The curves of a cut as graphs. Solved for one coordinate, the equation reads a cos v + b sin v + c = 0,
/// and v = atan2(b, a) +- acos(-c / sqrt(a² + b²)). For v = y this holds at every x where |sin z| <= |cos z|;
/// at other heights for v = x at every y.
class Graphs {
 public:
  explicit Graphs(double z) : sin_z_(std::sin(z)), cos_z_(std::cos(z)) {}

  bool isOverX() const { return std::abs(sin_z_) <= std::abs(cos_z_); }

  /// @param branch  -1 or 1
  double at(double t, int branch) const {
    // The angle does not jump where the coefficient that keeps its sign is held positive.
    const double sign = std::copysign(1.0, isOverX() ? cos_z_ : sin_z_);
    const double a = sign * (isOverX() ? std::sin(t) : sin_z_);
    const double b = sign * (isOverX() ? cos_z_ : std::cos(t));
    const double c = sign * (isOverX() ? sin_z_ * std::cos(t) : cos_z_ * std::sin(t));
    const double ratio = std::clamp(-c / std::hypot(a, b), -1.0, 1.0);
    return std::atan2(b, a) + branch * std::acos(ratio);
  }

 private:
  double sin_z_, cos_z_;
};

}  // namespace

double gyroidPeriod(double length_per_area) { return kLengthOfCell / length_per_area; }

std::vector<Polyline> gyroidLines(const GyroidSlice& slice, const Polygon& outline) {
  const double unit = slice.period_mm / (2.0 * M_PI);
  const Eigen::Rotation2Dd turn(slice.angle_rad);
  double radius = 0.0;
  for (const Point2& corner : outline) radius = std::max(radius, corner.norm());
  const Graphs graphs(slice.z_mm / unit);
  const int periods = static_cast<int>(std::ceil(radius / slice.period_mm)) + 1;
  std::vector<Polyline> lines;
  for (int shift = -periods; shift <= periods; ++shift)
    for (const int branch : {-1, 1}) {
      Polyline graph;
      for (int s = -periods * kSegments; s <= periods * kSegments; ++s) {
        const double t = 2.0 * M_PI * s / kSegments;
        const double v = graphs.at(t, branch) + 2.0 * M_PI * shift;
        graph.push_back(turn * (unit * (graphs.isOverX() ? Point2(t, v) : Point2(v, t))));
      }
      std::vector<Polyline> inside = clippedToConvex(graph, outline);
      if (lines.size() % 2 != 0) {
        std::reverse(inside.begin(), inside.end());
        for (Polyline& line : inside) std::reverse(line.begin(), line.end());
      }
      std::move(inside.begin(), inside.end(), std::back_inserter(lines));
    }
  return lines;
}

}  // namespace lamina
