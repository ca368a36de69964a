// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "lamina/calibration/feeder_fit.hpp"
#include "view_points.hpp"

namespace lamina {
namespace {

constexpr double kReachShare = 0.45;  // of the distance of beads, on either side of one
constexpr double kBedShare = 0.7;     // of that reach, beyond which there is bed
constexpr std::size_t kLeastSectionPoints = 8;

/// A height at a place across a bead.
struct HeightAcross {
  double across_mm = 0.0;
  double height_mm = 0.0;
};

/// Median height of the outermost points.
double bedBeside(const std::vector<HeightAcross>& cell, double reach_mm) {
  std::vector<double> heights;
  for (const HeightAcross& point : cell)
    if (std::abs(point.across_mm) > kBedShare * reach_mm) heights.push_back(point.height_mm);
  if (heights.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
  std::nth_element(heights.begin(), middle, heights.end());
  return *middle;
}

/// Area over the bed; no number if the cell is not seen across its whole width.
double areaOf(std::vector<HeightAcross> cell, double reach_mm) {
  std::sort(cell.begin(), cell.end(), [](const HeightAcross& a, const HeightAcross& b) {
    return a.across_mm < b.across_mm || (a.across_mm == b.across_mm && a.height_mm < b.height_mm);
  });
  const double bed = bedBeside(cell, reach_mm);
  const bool is_seen = cell.size() >= kLeastSectionPoints && cell.front().across_mm < -kBedShare * reach_mm &&
                       cell.back().across_mm > kBedShare * reach_mm;
  if (!is_seen) return std::numeric_limits<double>::quiet_NaN();
  double area = 0.0;
  for (std::size_t i = 1; i < cell.size(); ++i)
    area += (0.5 * (cell[i].height_mm + cell[i - 1].height_mm) - bed) *
            (cell[i].across_mm - cell[i - 1].across_mm);
  return area;
}

BeadCrossSections sectionsOf(const CalibrationBead& bead, const std::vector<Point3>& points,
                             double reach_mm) {
  const Point2 along = (bead.end - bead.start).normalized();
  const double length = (bead.end - bead.start).norm();
  std::map<int, std::vector<HeightAcross>> cells;
  for (const Point3& point : points) {
    const Point2 from = point.head<2>() - bead.start;
    const double across = along.x() * from.y() - along.y() * from.x();
    const double place = from.dot(along);
    if (std::abs(across) <= reach_mm && place >= 0.0 && place < length)
      cells[static_cast<int>(place / kCrossSectionLengthMm)].push_back({across, point.z()});
  }
  BeadCrossSections sections;
  for (auto& [cell, heights] : cells) {
    const double area = areaOf(std::move(heights), reach_mm);
    if (!std::isfinite(area)) continue;
    sections.along_mm.push_back((cell + 0.5) * kCrossSectionLengthMm);
    sections.area_mm2.push_back(area);
  }
  return sections;
}

}  // namespace

std::vector<BeadCrossSections> beadSections(const SensorRecording& scan,
                                            const Eigen::Isometry3d& nozzle_from_sensor, double time_offset_s,
                                            const FeederSteps& steps) {
  const std::vector<Point3> points = viewPoints(scan, time_offset_s).onBed(nozzle_from_sensor);
  const double gap_mm = (steps.beads.back().end - steps.beads.front().start).norm();
  std::vector<BeadCrossSections> sections;
  for (const CalibrationBead& bead : steps.beads)
    sections.push_back(sectionsOf(bead, points, kReachShare * gap_mm));
  return sections;
}

}  // namespace lamina
