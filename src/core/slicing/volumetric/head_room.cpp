// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/head_room.hpp"
#include "lamina/geometry/shortest_rotation.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kHullSpacingMm = 4.0;
constexpr double kPatchMm = HeadRoom::kAroundMm - 1e-6;  // rounding moves points
constexpr double kTipMm = 3.0;                           // not looked at
constexpr double kFarthestMm = 120.0;
constexpr double kBedMm = 0.05;  // bed is farther in by so much

void addRing(double along, double radius, std::vector<Point3>& hull) {
  const int count = std::max(6, static_cast<int>(std::ceil(2.0 * M_PI * radius / kHullSpacingMm)));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count;
    hull.emplace_back(radius * std::cos(angle), radius * std::sin(angle), along);
  }
}

/// The face towards the bed, and the side.
void addStage(const HeadStage& stage, std::vector<Point3>& hull) {
  const double from = std::max(kTipMm, stage.from_mm);
  const double to = std::min(kFarthestMm, stage.to_mm);
  for (double radius = kHullSpacingMm; radius < stage.radius_mm; radius += kHullSpacingMm)
    addRing(from, radius, hull);
  for (double along = from; along <= to; along += kHullSpacingMm) addRing(along, stage.radius_mm, hull);
}

}  // namespace

HeadRoom::HeadRoom(std::shared_ptr<const Growth> growth, const std::vector<HeadStage>& stages, double bed_mm)
    : growth_(std::move(growth)), stages_(stages), bed_mm_(bed_mm) {
  std::vector<Point3> hull;
  for (const HeadStage& stage : stages_) addStage(stage, hull);
  if (!hull.empty()) addPatches(std::move(hull), hull_);
}

double HeadRoom::Growth::leastAround(const Point3& /*place*/) const {
  return -std::numeric_limits<double>::infinity();
}

/// Halves of what is too large for one.
void HeadRoom::addPatches(std::vector<Point3> points, std::vector<Patch>& patches) {
  Box3 box;
  for (const Point3& point : points) box.include(point);
  const Point3 middle = 0.5 * (box.low + box.high);
  const auto isNear = [&](const Point3& point) { return (point - middle).norm() <= kPatchMm; };
  if (std::all_of(points.begin(), points.end(), isNear)) {
    patches.push_back({middle, std::move(points)});
    return;
  }
  Eigen::Index axis = 0;
  box.size().maxCoeff(&axis);
  const auto half = std::stable_partition(points.begin(), points.end(),
                                          [&](const Point3& point) { return point[axis] < middle[axis]; });
  addPatches({points.begin(), half}, patches);
  addPatches({half, points.end()}, patches);
}

bool HeadRoom::isClear(const Point3& tip, const Point3& axis, double growth_mm) const {
  const double flat = std::sqrt(std::max(0.0, 1.0 - axis.z() * axis.z()));
  for (const HeadStage& stage : stages_) {
    const double along =
        axis.z() > 0.0 ? std::max(kTipMm, stage.from_mm) : std::min(kFarthestMm, stage.to_mm);
    if (tip.z() + along * axis.z() - stage.radius_mm * flat < bed_mm_ - kBedMm) return false;
  }
  const Eigen::Quaterniond turn = shortestRotation(Point3::UnitZ(), axis);
  const Eigen::Matrix3d frame = turn.toRotationMatrix();
  const auto isFilled = [&](const Point3& point) { return growth_->at(tip + frame * point) < growth_mm; };
  return std::none_of(hull_.begin(), hull_.end(), [&](const Patch& patch) {
    if (growth_->leastAround(tip + frame * patch.middle) >= growth_mm) return false;
    return std::any_of(patch.points.begin(), patch.points.end(), isFilled);
  });
}

}  // namespace lamina
