// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/no_spin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kSingular = 1e-6;  // sine of the angle between jet and v: beneath it x is rounding alone

Point3 acrossHeading(double heading_deg) {
  // Quarter turns to the last bit, so that level programs stay as they are.
  const double quarters = heading_deg / 90.0;
  if (quarters == std::floor(quarters)) {
    const auto quarter = ((static_cast<long>(quarters) % 4) + 4) % 4;
    const Point3 across[4] = {{0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {1, 0, 0}};
    return across[quarter];
  }
  const double heading = heading_deg * M_PI / 180.0;
  return {-std::sin(heading), std::cos(heading), 0.0};
}

Eigen::Quaterniond frameOf(const Point3& x, const Point3& jet) {
  Eigen::Matrix3d axes;
  axes << x, jet.cross(x), jet;
  // Adding 0 leaves no negative zeros, so that level programs keep their identity.
  return Eigen::Quaterniond(Eigen::Quaterniond(axes).normalized().coeffs() + Eigen::Vector4d::Zero());
}

std::optional<Point3> xWithoutSpin(const Point3& jet, const Point3& across) {
  const Point3 x = jet.cross(across);
  const double sine = x.norm();
  if (sine < kSingular) return std::nullopt;
  return x / sine;
}

/// The nearest direction to x that is perpendicular to the jet.
Point3 carried(const Point3& x, const Point3& jet) {
  const Point3 rest = x - x.dot(jet) * jet;
  const double norm = rest.norm();
  return norm < kSingular ? jet.unitOrthogonal() : Point3(rest / norm);
}

[[noreturn]] void refuse(const Point3& jet, double heading_deg) {
  std::ostringstream message;
  message
      << "the jet (" << jet.transpose() << ") lies across the nozzle's heading of " << heading_deg
      << " deg, in the horizontal; expected a direction that leaves the nozzle's x a heading: take another "
         "orientation.heading_deg";
  throw InvalidInput(message.str());
}

Eigen::Quaterniond verticalFrame(const Point3& across) {
  const Point3 down = -Point3::UnitZ();
  return frameOf(down.cross(across), down);
}

/// x at every jet; nothing if there is none anywhere.
std::vector<Point3> steadyX(const std::vector<Point3>& jets, const Point3& across) {
  std::vector<Point3> all(jets.size());
  std::size_t first = jets.size();
  for (std::size_t i = 0; i < jets.size(); ++i) {
    const std::optional<Point3> x = xWithoutSpin(jets[i], across);
    if (!x && first == jets.size()) continue;
    all[i] = x ? *x : carried(all[i - 1], jets[i]);
    first = std::min(first, i);
  }
  if (first == jets.size()) return {};
  for (std::size_t i = first; i-- > 0;) all[i] = carried(all[i + 1], jets[i]);
  return all;
}

}  // namespace

Eigen::Quaterniond noSpinFrame(const Point3& jet, double heading_deg) {
  const Point3 across = acrossHeading(heading_deg);
  const std::optional<Point3> x = xWithoutSpin(jet, across);
  if (!x) refuse(jet, heading_deg);
  return signedLike(frameOf(*x, jet), verticalFrame(across));
}

std::vector<Eigen::Quaterniond> noSpinFrames(const std::vector<Point3>& jets, double heading_deg) {
  const Point3 across = acrossHeading(heading_deg);
  const std::vector<Point3> x = steadyX(jets, across);
  if (x.empty()) refuse(jets.front(), heading_deg);
  std::vector<Eigen::Quaterniond> frames;
  frames.reserve(jets.size());
  for (std::size_t i = 0; i < jets.size(); ++i)
    frames.push_back(signedLike(frameOf(x[i], jets[i]), i == 0 ? verticalFrame(across) : frames.back()));
  return frames;
}

}  // namespace lamina
