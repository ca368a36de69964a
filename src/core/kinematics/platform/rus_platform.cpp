// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/platform/rus_platform.hpp"

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"

namespace lamina {
namespace {

constexpr double kThird = 2.0 * M_PI / 3.0;

Point3 atAngle(double angle, double radius) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

/// Corner of a hexagon beside the middle of its short edge.
Point3 corner(double middle, double side, double long_mm, double short_mm) {
  const double radius = hexagonRadius(long_mm, short_mm);
  return atAngle(middle + side * std::asin(0.5 * short_mm / radius), radius);
}

RusLeg platformLegOf(const HuntDimensions& dimensions, std::size_t index) {
  const std::size_t pair = index / 2;
  const double middle = kThird * static_cast<double>(pair);
  const double side = index % 2 == 0 ? -1.0 : 1.0;
  RusLeg leg;
  leg.motor = corner(middle, side, dimensions.static_long_mm, dimensions.static_short_mm);
  leg.rest = atAngle(middle + side * kThird, 1.0);
  leg.axis = leg.rest.cross(Point3::UnitZ());
  leg.ball = corner(middle, side, dimensions.mobile_long_mm, dimensions.mobile_short_mm);
  leg.crank_mm = dimensions.crank_mm;
  leg.coupler_mm = dimensions.coupler_mm;
  leg.branch = CrankBranch::Ahead;
  leg.low = dimensions.crank_low;
  leg.high = dimensions.crank_high;
  leg.greatest_lean = dimensions.greatest_lean;
  leg.greatest_swing = dimensions.greatest_swing;
  return leg;
}

void requirePositive(double length_mm, const char* what) {
  if (!(length_mm > 0.0))
    throw InvalidConfig(std::string(what) + " of the platform is " + numberText(length_mm) +
                        " mm; must be positive");
}

}  // namespace

double hexagonRadius(double long_mm, double short_mm) {
  return std::sqrt((long_mm * long_mm + long_mm * short_mm + short_mm * short_mm) / 3.0);
}

RusPlatform huntPlatform(const HuntDimensions& dimensions) {
  requirePositive(dimensions.static_long_mm, "long edge of the base");
  requirePositive(dimensions.static_short_mm, "short edge of the base");
  requirePositive(dimensions.mobile_long_mm, "long edge of the mobile part");
  requirePositive(dimensions.mobile_short_mm, "short edge of the mobile part");
  requirePositive(dimensions.crank_mm, "crank");
  requirePositive(dimensions.coupler_mm, "coupler");
  RusPlatform platform;
  for (std::size_t i = 0; i < kLegs; ++i) platform.legs[i] = platformLegOf(dimensions, i);
  platform.home.translation().z() = -dimensions.home_drop_mm;
  const auto cranks = crankAnglesIfReached(platform, platform.home);
  if (!cranks)
    throw InvalidConfig("the legs of the platform do not reach its home " +
                        numberText(dimensions.home_drop_mm) + " mm below the base");
  for (std::size_t i = 0; i < kLegs; ++i) {
    RusLeg& leg = platform.legs[i];
    leg.socket = (leg.elbow((*cranks)[static_cast<Eigen::Index>(i)]) - platform.home * leg.ball).normalized();
  }
  return platform;
}

}  // namespace lamina
