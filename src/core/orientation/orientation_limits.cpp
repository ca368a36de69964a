// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/orientation_limits.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/space_vectors.hpp"
#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

constexpr double kOpposite = 1e-9;

/// From one direction towards another by at most an angle [rad], the shortest way; between opposite ones the
/// way through straight down, which no lean limit forbids.
Point3 towards(const Point3& from, const Point3& to, double at_most) {
  if (angleBetween(from, to) <= at_most) return to;
  Point3 side = to - to.dot(from) * from;
  if (side.norm() < kOpposite) side = -Point3::UnitZ() + from.z() * from;
  if (side.norm() < kOpposite) side = from.unitOrthogonal();
  return (std::cos(at_most) * from + std::sin(at_most) * side.normalized()).normalized();
}

Point3 between(const Point3& a, const Point3& b) { return towards(a, b, 0.5 * angleBetween(a, b)); }

/// The turn that each motion allows [rad].
std::vector<double> allowances(const std::vector<double>& lengths, double max_deg_per_mm) {
  std::vector<double> allowed;
  allowed.reserve(lengths.size());
  for (const double length : lengths) allowed.push_back(length * max_deg_per_mm * kDegree);
  return allowed;
}

/// Each tool axis as near to the wanted one as the tool axis before allows. A closed path is run round twice,
/// so that its start follows its end.
std::vector<Point3> followed(const std::vector<Point3>& wanted, const std::vector<double>& allowed) {
  std::vector<Point3> tool_axes = wanted;
  const std::size_t count = tool_axes.size();
  const std::size_t steps = allowed.size() == count ? 2 * count : count - 1;
  for (std::size_t step = 0; step < steps; ++step) {
    const std::size_t i = step % count;
    const std::size_t next = (i + 1) % count;
    tool_axes[next] = towards(tool_axes[i], wanted[next], allowed[i]);
  }
  return tool_axes;
}

std::vector<Point3> followedBackwards(std::vector<Point3> wanted, std::vector<double> allowed) {
  // The closing motion of a closed path stays the last one when the points before it are run backwards.
  std::reverse(wanted.begin(), wanted.end());
  const bool is_closed = allowed.size() == wanted.size();
  std::reverse(allowed.begin(), is_closed ? allowed.end() - 1 : allowed.end());
  std::vector<Point3> tool_axes = followed(wanted, allowed);
  std::reverse(tool_axes.begin(), tool_axes.end());
  return tool_axes;
}

std::size_t leastChanged(const std::vector<Point3>& wanted, const std::vector<Point3>& tool_axes) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < tool_axes.size(); ++i)
    if (angleBetween(wanted[i], tool_axes[i]) < angleBetween(wanted[best], tool_axes[best]) - 1e-9) best = i;
  return best;
}

/// Follows the wanted tool axes round from the start so that the start is reached again within what is
/// allowed.
void followRound(std::vector<Point3>& tool_axes, const std::vector<double>& allowed, std::size_t start) {
  constexpr double kRounding = 1e-12;
  const std::size_t count = tool_axes.size();
  const Point3 home = tool_axes[start];
  double rest = 0.0;
  for (const double allowance : allowed) rest += allowance;
  for (std::size_t step = 0; step + 1 < count; ++step) {
    const std::size_t i = (start + step) % count;
    const std::size_t next = (i + 1) % count;
    rest -= allowed[i];
    const Point3 reachable = towards(home, tool_axes[next], std::min(rest, M_PI));
    const Point3 near = towards(tool_axes[i], reachable, allowed[i]);
    // Homewards is always within reach, if nothing else is.
    tool_axes[next] =
        angleBetween(near, home) <= rest + kRounding ? near : towards(tool_axes[i], home, allowed[i]);
  }
}

}  // namespace

double angleDeg(const Point3& a, const Point3& b) { return angleBetween(a, b) / kDegree; }

double leanDeg(const Point3& tool_axis) {
  return std::atan2(tool_axis.head<2>().norm(), -tool_axis.z()) / kDegree;
}

Point3 withLeanLimit(const Point3& tool_axis, double max_deg) {
  if (leanDeg(tool_axis) <= max_deg) return tool_axis;
  const double sideways = tool_axis.head<2>().norm();
  const Point2 heading = sideways > 0.0 ? Point2(tool_axis.head<2>() / sideways) : Point2::UnitX();
  const double lean = max_deg * kDegree;
  return {std::sin(lean) * heading.x(), std::sin(lean) * heading.y(), -std::cos(lean)};
}

std::vector<Point3> withTurnLimit(const std::vector<Point3>& wanted, const std::vector<double>& lengths,
                                  double max_deg_per_mm) {
  if (wanted.size() < 2) return wanted;
  const std::vector<double> allowed = allowances(lengths, max_deg_per_mm);
  // Halfway between following at twice the speed from either side, a sudden turn is made at just the speed
  // allowed, half before its place and half after it.
  const std::vector<double> doubled = allowances(lengths, 2.0 * max_deg_per_mm);
  std::vector<Point3> tool_axes = followed(wanted, doubled);
  const std::vector<Point3> backwards = followedBackwards(wanted, doubled);
  for (std::size_t i = 0; i < tool_axes.size(); ++i) tool_axes[i] = between(tool_axes[i], backwards[i]);
  if (allowed.size() < wanted.size()) return followed(tool_axes, allowed);
  followRound(tool_axes, allowed, leastChanged(wanted, tool_axes));
  return tool_axes;
}

}  // namespace lamina
