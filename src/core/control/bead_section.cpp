// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/bead_section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "control/profile_points.hpp"
#include "control/run_stretches.hpp"

namespace lamina {
namespace {

constexpr std::size_t kLeastPoints = 5;
constexpr double kCrownReach = 1.0 / 6.0;  // of the width, to each side
constexpr double kLeastReach = 0.3;        // of the width, to each side
constexpr double kHighest = -0.5;          // layers below the crown: what is higher is no bead
// Valleys between beads are as narrow as spray: what is off is bounded instead.
constexpr double kAllIsSound = std::numeric_limits<double>::infinity();

using Sights = std::vector<std::optional<CellSight>>;

/// How far the contour of a stadium lies below its top.
double plannedDepth(double across_mm, const Bead& bead) {
  const double round = 0.5 * std::min(bead.height_mm, bead.width_mm);
  const double beyond = std::clamp(std::abs(across_mm) - (0.5 * bead.width_mm - round), 0.0, round);
  return round - std::sqrt(round * round - beyond * beyond);
}

/// Mean depth of the points on the crown; none without any.
std::optional<double> crownDepth(const std::vector<ContourPoint>& contour, const Bead& bead) {
  double sum = 0.0;
  double count = 0.0;
  for (const ContourPoint& point : contour) {
    if (std::abs(point.across_mm) > kCrownReach * bead.width_mm) continue;
    sum += point.below_mm;
    count += 1.0;
  }
  return count > 0.0 ? std::optional<double>(sum / count) : std::nullopt;
}

/// The points of a profile as one cell has them.
class CellContour {
 public:
  CellContour(const LayerCells& cells, std::size_t cell)
      : middle_(cells.middle[cell]),
        growth_(cells.growth[cell]),
        left_(growth_.cross(cells.tangent[cell]).normalized()),
        half_width_mm_(0.5 * cells.width_mm[cell]) {}

  /// Adds a point.
  /// @return whether it lies within the width of the bead
  bool add(const Point3& point) {
    const Eigen::Vector3d from_middle = point - middle_;
    const double across_mm = from_middle.dot(left_);
    if (!(std::abs(across_mm) <= half_width_mm_)) return false;
    points_.push_back({across_mm, -from_middle.dot(growth_)});
    return true;
  }
  void reserve(std::size_t points) { points_.reserve(points); }
  const std::vector<ContourPoint>& points() const { return points_; }

 private:
  Point3 middle_;
  Eigen::Vector3d growth_;
  Eigen::Vector3d left_;
  double half_width_mm_;
  std::vector<ContourPoint> points_;
};

bool isOnCrown(const std::optional<CellSight>& sight, std::size_t layer) {
  return sight && sight->layer == layer && sight->across_share <= kCrownReach;
}

/// Whether a point lies on another bead of the layer.
bool isOfOtherRun(const std::optional<CellSight>& sight, const LayerCells& cells, std::size_t run) {
  return sight && sight->layer == cells.layer && runOf(cells, sight->cell) != run;
}

/// The contour about a point on the crown of a cell, to both sides.
CellContour contourAbout(std::size_t crown, const std::vector<Point3>& points, const Sights& sights,
                         const LayerCells& cells) {
  const std::size_t cell = sights[crown]->cell;
  const std::size_t run = runOf(cells, cell);
  CellContour contour(cells, cell);
  contour.reserve(points.size());
  for (std::size_t i = crown; i < points.size(); ++i)
    if (isOfOtherRun(sights[i], cells, run) || !contour.add(points[i])) break;
  for (std::size_t i = crown; i-- > 0;)
    if (isOfOtherRun(sights[i], cells, run) || !contour.add(points[i])) break;
  return contour;
}

}  // namespace

std::optional<double> sectionDeficit(const std::vector<ContourPoint>& contour, const Bead& bead) {
  const double area = crossSection(bead);
  const auto crown = crownDepth(contour, bead);
  if (contour.size() < kLeastPoints || !crown || !(area > 0.0)) return std::nullopt;
  const auto [least, greatest] = std::minmax_element(
      contour.begin(), contour.end(),
      [](const ContourPoint& a, const ContourPoint& b) { return a.across_mm < b.across_mm; });
  const double reach = kLeastReach * bead.width_mm;
  if (least->across_mm > -reach || greatest->across_mm < reach) return std::nullopt;
  double lack_mm = 0.0;
  for (const ContourPoint& point : contour) {
    const double depth = std::clamp(point.below_mm - *crown, kHighest * bead.height_mm, bead.height_mm);
    lack_mm += depth - plannedDepth(point.across_mm, bead);
  }
  const double spacing = (greatest->across_mm - least->across_mm) / static_cast<double>(contour.size() - 1);
  return lack_mm * spacing / area;
}

std::vector<SectionReading> readSections(const SensorProfile& profile, const CellAtlas& atlas,
                                         const SightSettings& settings) {
  std::vector<SectionReading> sections;
  const std::vector<std::size_t> layers = atlas.layers();
  if (layers.empty()) return sections;
  const std::shared_ptr<const LayerCells> cells = atlas.cellsOf(layers.back());
  std::vector<Point3> points = soundPoints(profile.points, kAllIsSound, settings).points;
  for (Point3& point : points) point = profile.toolpath_from_sensor * point;
  const Sights sights = atlas.newestAt(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!isOnCrown(sights[i], cells->layer)) continue;
    const std::size_t cell = sights[i]->cell;
    const CellContour contour = contourAbout(i, points, sights, *cells);
    const auto deficit = sectionDeficit(contour.points(), {cells->width_mm[cell], cells->height_mm[cell]});
    if (deficit) sections.push_back({cells->layer, cell, *deficit});
    // The rest of this crown shows the same section.
    while (i + 1 < points.size() && isOnCrown(sights[i + 1], cells->layer) &&
           runOf(*cells, sights[i + 1]->cell) == runOf(*cells, cell))
      ++i;
  }
  return sections;
}

void seeSections(HeightLoop& loop, const SensorProfile& profile, const CellAtlas& atlas,
                 const SightSettings& settings) {
  if (!loop.readsSections()) return;
  for (const SectionReading& section : readSections(profile, atlas, settings))
    if (section.layer == loop.cells().layer) loop.seeDeficit(section.cell, section.deficit);
}

}  // namespace lamina
