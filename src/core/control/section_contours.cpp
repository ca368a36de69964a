// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/section_contours.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "control/profile_points.hpp"

namespace lamina {
namespace {

// Valleys between beads are as narrow as spray: what is off is bounded instead.
constexpr double kAllIsSound = std::numeric_limits<double>::infinity();

/// The base of a plane layer.
struct LayerBase {
  Eigen::Vector3d normal;
  double top_mm;
  double height_mm;

  /// Where the light to a point below the base passes it, lifted to the planned top; nothing of other points.
  std::optional<Point3> passedBy(const Point3& point, const Eigen::Isometry3d& toolpath_from_sensor) const {
    const double base_mm = top_mm - height_mm;
    const double depth = base_mm - normal.dot(point);
    if (!(depth > 0.0)) return std::nullopt;
    // Depths that are not from where the light comes from have their origin in the midst of the range.
    const Point3& origin = toolpath_from_sensor.translation();
    const bool is_source = normal.dot(origin) > top_mm;
    const Eigen::Vector3d back =
        is_source ? Eigen::Vector3d(origin - point) : Eigen::Vector3d(-toolpath_from_sensor.linear().col(2));
    const double rise = normal.dot(back);
    if (!(rise > 0.0)) return std::nullopt;
    return point + back * (depth / rise) + height_mm * normal;
  }
};

}  // namespace

void SectionContours::begin() {
  cells_.reset();
  contours_.clear();
  touched_.clear();
}

void SectionContours::see(const SensorProfile& profile, const CellAtlas& atlas,
                          const SightSettings& settings) {
  const std::vector<std::size_t> layers = atlas.layers();
  if (layers.empty()) return;
  const std::size_t layer = layers.back();
  cells_ = atlas.cellsOf(layer);
  contours_.resize(cells_->size());
  if (cells_->size() == 0) return;
  const LayerBase base{cells_->growth[0], cells_->growth[0].dot(cells_->middle[0]), cells_->height_mm[0]};
  const bool is_plane = atlas.isPlane(layer);
  std::vector<Point3> points = soundPoints(profile.points, kAllIsSound, settings).points;
  for (Point3& point : points) point = profile.toolpath_from_sensor * point;
  const std::vector<std::optional<CellSight>> sights = atlas.newestAt(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (sights[i] && sights[i]->layer == layer) {
      add(sights[i]->cell, sights[i]->across_mm, sights[i]->error_mm);
      continue;
    }
    const auto passed = is_plane ? base.passedBy(points[i], profile.toolpath_from_sensor) : std::nullopt;
    const auto sight = passed ? atlas.newestAt(*passed) : std::nullopt;
    if (sight && sight->layer == layer) add(sight->cell, sight->across_mm, cells_->height_mm[sight->cell]);
  }
}

void SectionContours::add(std::size_t cell, double across_mm, double below_mm) {
  const Bead bead = beadOf(cell);
  const double share = across_mm / bead.width_mm + 0.5;
  if (!(share >= 0.0 && share <= 1.0)) return;
  const auto number = static_cast<std::size_t>(share * static_cast<double>(kStrips));
  Strip& strip = contours_[cell][std::min(number, kStrips - 1)];
  const auto points = static_cast<float>(++strip.points);
  strip.across_mm += (static_cast<float>(across_mm) - strip.across_mm) / points;
  strip.lower_mm += (static_cast<float>(below_mm - plannedDepth(across_mm, bead)) - strip.lower_mm) / points;
  if (touched_.empty() || touched_.back() != cell) touched_.push_back(cell);
}

std::vector<ContourPoint> SectionContours::contourOf(std::size_t cell) const {
  std::vector<ContourPoint> contour;
  contour.reserve(kStrips);
  for (const Strip& strip : contours_[cell]) {
    if (strip.points == 0) continue;
    const auto across = static_cast<double>(strip.across_mm);
    contour.push_back({across, static_cast<double>(strip.lower_mm) + plannedDepth(across, beadOf(cell))});
  }
  return contour;
}

std::vector<SectionReading> SectionContours::take() {
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  std::vector<SectionReading> readings;
  readings.reserve(touched_.size());
  for (const std::size_t cell : touched_)
    if (const auto deficit = sectionDeficit(contourOf(cell), beadOf(cell)))
      readings.push_back({cell, *deficit});
  touched_.clear();
  return readings;
}

}  // namespace lamina
