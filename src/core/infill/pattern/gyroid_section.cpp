// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/gyroid_section.hpp"

#include <array>
#include <cmath>
#include <complex>

namespace lamina {
namespace {

/// After so many steps rounding has grown to about 1e-14.
constexpr std::size_t kStepsByRotation = 64;

constexpr double kLevel = 1e-12;

using Phase = std::complex<double>;  // cosine and sine

std::array<Phase, 3> unitPhases(const Point3& angles) {
  return {std::polar(1.0, angles.x()), std::polar(1.0, angles.y()), std::polar(1.0, angles.z())};
}

double gyroidOf(const std::array<Phase, 3>& at) {
  return at[0].imag() * at[1].real() + at[1].imag() * at[2].real() + at[2].imag() * at[0].real();
}

Phase product(const Phase& a, const Phase& b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

}  // namespace

GyroidSection::GyroidSection(const Eigen::Isometry3d& part_from_plan, double cell_mm, double angle_rad) {
  const double per_mm = 2.0 * M_PI / cell_mm;
  const Eigen::Matrix3d unturned = per_mm * Eigen::AngleAxisd(-angle_rad, Point3::UnitZ()).toRotationMatrix();
  along_ = (unturned * part_from_plan.linear()).leftCols<2>();
  origin_ = unturned * part_from_plan.translation();
}

double GyroidSection::value(const Point2& point) const { return gyroidOf(unitPhases(phases(point))); }

bool GyroidSection::isLevel() const { return along_.row(2).isZero(kLevel * phasesPerMillimetre()); }

Point2 GyroidSection::atPhases(const Point2& phases) const {
  // A rotation, but for the scale: its inverse is its transpose.
  return along_.topRows<2>().transpose() * (phases - origin_.head<2>()) / along_.col(0).squaredNorm();
}

SectionValue GyroidSection::valueAndSlope(const Point2& point) const {
  const std::array<Phase, 3> at = unitPhases(phases(point));
  const auto& [x, y, z] = at;
  const Point2 gradient = along_.transpose() * Point3(x.real() * y.real() - z.imag() * x.imag(),
                                                      y.real() * z.real() - x.imag() * y.imag(),
                                                      z.real() * x.real() - y.imag() * z.imag());
  return {gyroidOf(at), gradient};
}

std::vector<double> GyroidSection::row(const Point2& from, double step_mm, std::size_t count) const {
  std::vector<double> values(count);
  const std::array<Phase, 3> step = unitPhases(step_mm * along_.col(0));
  std::array<Phase, 3> at{};
  for (std::size_t i = 0; i < count; ++i) {
    if (i % kStepsByRotation == 0)
      at = unitPhases(phases(from + Point2(static_cast<double>(i) * step_mm, 0.0)));
    values[i] = gyroidOf(at);
    for (std::size_t k = 0; k < at.size(); ++k) at[k] = product(at[k], step[k]);
  }
  return values;
}

}  // namespace lamina
