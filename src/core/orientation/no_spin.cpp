// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/no_spin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kSingular = 1e-6;  // sine of the angle between tool axis and v: below it x is rounding alone

Point3 acrossHeading(double heading_deg) {
  // Quarter turns to the last bit, so that level programs stay as they are.
  const double quarters = heading_deg / 90.0;
  if (quarters == std::floor(quarters)) {
    const auto quarter = ((static_cast<long>(quarters) % 4) + 4) % 4;
    const Point3 across[4] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
    return across[quarter];
  }
  const double heading = toRadians(heading_deg);
  return {-std::sin(heading), std::cos(heading), 0.0};
}

Eigen::Quaterniond frameOf(const Point3& x, const Point3& tool_axis) {
  Eigen::Matrix3d axes;
  axes << x, tool_axis.cross(x), tool_axis;
  // Adding 0 leaves no negative zeros, so that level programs keep their identity.
  return Eigen::Quaterniond(Eigen::Quaterniond(axes).normalized().coeffs() + Eigen::Vector4d::Zero());
}

std::optional<Point3> xWithoutSpin(const Point3& tool_axis, const Point3& across) {
  const Point3 x = tool_axis.cross(across);
  const double sine = x.norm();
  if (sine < kSingular) return std::nullopt;
  return x / sine;
}

/// The nearest direction to x that is perpendicular to the tool axis.
Point3 carried(const Point3& x, const Point3& tool_axis) {
  const Point3 rest = x - x.dot(tool_axis) * tool_axis;
  const double norm = rest.norm();
  return norm < kSingular ? tool_axis.unitOrthogonal() : Point3(rest / norm);
}

[[noreturn]] void refuse(const Point3& tool_axis, double heading_deg) {
  std::ostringstream message;
  message
      << "the tool axis (" << tool_axis.transpose() << ") lies across the nozzle's heading of " << heading_deg
      << " deg, in the horizontal; expected a direction that leaves the nozzle's x a heading: take another "
         "orientation.heading_deg";
  throw InvalidInput(message.str());
}

Eigen::Quaterniond verticalFrame(const Point3& across) {
  const Point3 down = -Point3::UnitZ();
  return frameOf(down.cross(across), down);
}

/// x at every tool axis; nothing if there is none anywhere.
std::vector<Point3> steadyX(const std::vector<Point3>& tool_axes, const Point3& across) {
  std::vector<Point3> all(tool_axes.size());
  std::size_t first = tool_axes.size();
  for (std::size_t i = 0; i < tool_axes.size(); ++i) {
    const std::optional<Point3> x = xWithoutSpin(tool_axes[i], across);
    if (!x && first == tool_axes.size()) continue;
    all[i] = x ? *x : carried(all[i - 1], tool_axes[i]);
    first = std::min(first, i);
  }
  if (first == tool_axes.size()) return {};
  for (std::size_t i = first; i-- > 0;) all[i] = carried(all[i + 1], tool_axes[i]);
  return all;
}

}  // namespace

Eigen::Quaterniond noSpinFrame(const Point3& tool_axis, double heading_deg) {
  const Point3 across = acrossHeading(heading_deg);
  const std::optional<Point3> x = xWithoutSpin(tool_axis, across);
  if (!x) refuse(tool_axis, heading_deg);
  return signedLike(frameOf(*x, tool_axis), verticalFrame(across));
}

std::vector<Eigen::Quaterniond> noSpinFrames(const std::vector<Point3>& tool_axes, double heading_deg) {
  const Point3 across = acrossHeading(heading_deg);
  const std::vector<Point3> x = steadyX(tool_axes, across);
  if (x.empty()) refuse(tool_axes.front(), heading_deg);
  std::vector<Eigen::Quaterniond> frames;
  frames.reserve(tool_axes.size());
  for (std::size_t i = 0; i < tool_axes.size(); ++i)
    frames.push_back(signedLike(frameOf(x[i], tool_axes[i]), i == 0 ? verticalFrame(across) : frames.back()));
  return frames;
}

}  // namespace lamina
