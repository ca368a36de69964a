// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_gauge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

double thicknessOfLevelUnderside(double overhang_rad) {
  return std::exp((0.5 * M_PI - overhang_rad) * std::tan(overhang_rad));
}

}  // namespace

GrowthGauge::GrowthGauge(const GrowthLimits& limits)
    : overhang_(limits.overhang_rad),
      tan_overhang_(std::tan(limits.overhang_rad)),
      cos_overhang_(std::cos(limits.overhang_rad)),
      greatest_lean_(limits.overhang_rad + limits.max_tilt_rad),
      thickest_lean_(std::numeric_limits<double>::infinity()),
      thickest_tilt_(limits.max_tilt_rad) {
  if (tan_overhang_ > 0.0) thickest_lean_ = overhang_ + std::log(limits.max_thickness) / tan_overhang_;
  if (thickest_lean_ < greatest_lean_) thickest_tilt_ = thickest_lean_ - overhang_;
  const double thickness = std::exp(thickest_tilt_ * tan_overhang_);
  beyond_ = Point2(std::sin(thickest_tilt_), std::cos(thickest_tilt_)) / thickness;
}

double GrowthGauge::cost(const Point3& way) const {
  const double across = way.head<2>().norm();
  if (across <= tan_overhang_ * way.z()) return way.z();
  const double lean = std::atan2(across, way.z());
  if (lean > greatest_lean_) return std::numeric_limits<double>::infinity();
  if (lean >= thickest_lean_) return beyond_.x() * across + beyond_.y() * way.z();
  return way.norm() * cos_overhang_ * std::exp(-(lean - overhang_) * tan_overhang_);
}

Point3 GrowthGauge::gradient(const Point3& way) const {
  const double across = way.head<2>().norm();
  if (across <= tan_overhang_ * way.z()) return Point3::UnitZ();
  const double tilt = std::clamp(std::atan2(across, way.z()) - overhang_, 0.0, thickest_tilt_);
  const double inverse_thickness = std::exp(-tilt * tan_overhang_);
  Point3 gradient;
  gradient << way.head<2>() * (std::sin(tilt) * inverse_thickness / across),
      std::cos(tilt) * inverse_thickness;
  return gradient;
}

double overhangWithin(double overhang_rad, double max_thickness) {
  if (thicknessOfLevelUnderside(overhang_rad) <= max_thickness) return overhang_rad;
  double low = 0.0;
  double high = overhang_rad;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (thicknessOfLevelUnderside(middle) <= max_thickness ? low : high) = middle;
  }
  return low;
}

}  // namespace lamina
