// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verification/overhang/support.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kRounding = 0.005;  // mm: the decimals of a program
constexpr double kBelow = 0.25;      // of the height: a middle line less far along the tool axis lies beside

Bead largestSection(const std::vector<DepositedBead>& beads) {
  Bead largest;
  for (const DepositedBead& bead : beads) {
    largest.width_mm = std::max(largest.width_mm, bead.section.width_mm);
    largest.height_mm = std::max(largest.height_mm, bead.section.height_mm);
  }
  return largest;
}

/// How far from a place half way down its ray a bead may be that carries it.
double greatestMargin(const Bead& largest, const OverhangSettings& settings, double sideways) {
  const double half_depth = 0.5 * ((settings.reach + 0.5) * largest.height_mm + kRounding);
  return (0.5 - settings.overlap) * largest.width_mm + kRounding + sideways * half_depth;
}

/// Where on the bead, 0 to 1, the plane of the layers sees it nearest to the place.
double nearestOn(const DepositedBead& bead, const Point2& place) {
  const Point2 along = (bead.end - bead.start).head<2>();
  const double squared = along.squaredNorm();
  if (squared == 0.0) return 0.0;
  return std::clamp((place - bead.start.head<2>()).dot(along) / squared, 0.0, 1.0);
}

/// Where a ray along the tool axis is when it has gone so deep.
Point2 atDepth(const LayingPlace& place, double depth) {
  return place.middle.head<2>() - depth / place.tool_axis.z() * place.tool_axis.head<2>();
}

}  // namespace

Support::Support(const std::vector<DepositedBead>& beads, const Eigen::Isometry3d& bed_from_layers,
                 const OverhangSettings& settings, double sideways)
    : beads_(beads),
      settings_(settings),
      up_(bed_from_layers.linear().transpose() * Point3::UnitZ()),
      bed_level_(-bed_from_layers.translation().z()),
      largest_(largestSection(beads)),
      grid_(beads, greatestMargin(largest_, settings, sideways)) {}

bool Support::carries(const LayingPlace& place) const { return bedCarries(place) || beadsCarry(place); }

bool Support::bedCarries(const LayingPlace& place) const {
  // The side of the bead that is nearer to the bed.
  const Point3 across = place.along.cross(Point3::UnitZ());
  const double beside = besideMiddle(place.section) * std::abs(up_.dot(across));
  const double height = up_.dot(place.middle) - bed_level_ - beside - kRounding;
  const double length = settings_.reach * place.section.height_mm / -place.tool_axis.z();
  return height <= std::max(0.0, -up_.dot(place.tool_axis) * length);
}

bool Support::beadsCarry(const LayingPlace& place) const {
  const double least_depth = kBelow * place.section.height_mm;
  const double reach = settings_.reach * place.section.height_mm + kRounding;
  const double beside = besideMiddle(place.section) + kRounding;
  const auto isMet = [&](std::size_t index) {
    if (index >= place.bead) return false;
    const DepositedBead& bead = beads_[index];
    const double half_height = 0.5 * bead.section.height_mm;
    const auto depthAt = [&](double t) {
      return place.middle.z() - (bead.start.z() + t * (bead.end.z() - bead.start.z()));
    };
    // The tool axis leads sideways by how deep it goes, which depends on where it meets a bead that rises.
    const double guess = nearestOn(bead, atDepth(place, depthAt(0.5)));
    const double t = nearestOn(bead, atDepth(place, depthAt(guess)));
    const double depth = depthAt(t);
    if (depth < least_depth || depth - half_height > reach) return false;
    const Point2 met = atDepth(place, depth);
    const Point2 on_bead = (bead.start + t * (bead.end - bead.start)).head<2>();
    const double near = 0.5 * bead.section.width_mm + beside;
    return (met - on_bead).squaredNorm() <= near * near;
  };
  const double deepest = reach + 0.5 * largest_.height_mm;
  return grid_.visitNear(atDepth(place, 0.5 * deepest), place.middle.z() - deepest,
                         place.middle.z() - least_depth, isMet);
}

}  // namespace lamina
