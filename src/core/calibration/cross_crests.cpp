// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cross_crests.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kCrestCellMm = 1.0;
constexpr double kClearEnds = 2.0;    // bead widths from the ends of a bead that are left out
constexpr double kWindow = 1.2;       // bead widths on either side of the middle line
constexpr double kLeastHeight = 0.2;  // of the bead, below which a point counts as bed
constexpr double kHighHeight = 0.4;   // of the bead, above which a point counts as bead
constexpr std::size_t kLeastCrestPoints = 8;
constexpr double kSearchMm = 12.0;
constexpr double kSearchTurn = toRadians(5.0);
constexpr double kSearchTurnStep = toRadians(0.5);
constexpr std::size_t kMostSearched = 400;  // points
constexpr std::size_t kLeastSearched = 20;
constexpr double kLeastOnBeads = 0.6;

/// A point seen from a bead.
struct AcrossBead {
  double along_mm = 0.0;
  double across_mm = 0.0;
  double height_mm = 0.0;
  std::size_t point = 0;
};

Point2 directionOf(const CalibrationBead& bead) { return (bead.end - bead.start).normalized(); }

AcrossBead seenFrom(const CalibrationBead& bead, const Point3& at, std::size_t point) {
  const Point2 along = directionOf(bead);
  const Point2 from = at.head<2>() - bead.start;
  return {from.dot(along), along.x() * from.y() - along.y() * from.x(), at.z(), point};
}

/// Heights over the width that each point stands for; empty where the middle line is not seen from both
/// sides.
std::vector<double> crestWeights(const std::vector<AcrossBead>& cell, double middle_mm,
                                 const CrossTarget& target) {
  const double reach = kWindow * target.bead_width_mm;
  const bool is_seen = cell.size() >= kLeastCrestPoints && cell.front().across_mm < middle_mm - 0.8 * reach &&
                       cell.back().across_mm > middle_mm + 0.8 * reach;
  if (!is_seen) return {};
  std::vector<double> weights(cell.size(), 0.0);
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    if (std::abs(cell[i].across_mm - middle_mm) > reach) continue;
    const double height = cell[i].height_mm - kLeastHeight * target.bead_height_mm;
    weights[i] = std::max(0.0, height) * 0.5 * (cell[i + 1].across_mm - cell[i - 1].across_mm);
    sum += weights[i];
  }
  if (!(sum > 0.1 * target.bead_width_mm * target.bead_height_mm)) return {};
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// The crest of the points of one cell; without points if there is none.
Crest crestOf(std::vector<AcrossBead> cell, const CalibrationBead& bead, const CrossTarget& target) {
  std::sort(cell.begin(), cell.end(), [](const AcrossBead& a, const AcrossBead& b) {
    return std::tie(a.across_mm, a.point) < std::tie(b.across_mm, b.point);
  });
  double middle_mm = 0.0;
  std::vector<double> weights;
  for (int i = 0; i < 4; ++i) {
    weights = crestWeights(cell, middle_mm, target);
    if (weights.empty()) return {};
    middle_mm = 0.0;
    for (std::size_t j = 0; j < cell.size(); ++j) middle_mm += weights[j] * cell[j].across_mm;
  }
  const Point2 along = directionOf(bead);
  Crest crest;
  crest.normal = Point2(-along.y(), along.x());
  crest.offset_mm = crest.normal.dot(bead.start);
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (weights[i] == 0.0) continue;
    crest.points.push_back(cell[i].point);
    crest.weights.push_back(weights[i]);
  }
  return crest;
}

/// Distances from the nearest bead on a grid over all that is searched.
class DistanceMap {
 public:
  DistanceMap(const std::vector<CalibrationBead>& beads, double cell_mm) : cell_mm_(cell_mm) {
    Box2 box;
    for (const CalibrationBead& bead : beads) {
      box.include(bead.start);
      box.include(bead.end);
    }
    low_ = box.low - Point2(kSearchMm, kSearchMm);
    const Point2 size = box.high + Point2(kSearchMm, kSearchMm) - low_;
    columns_ = static_cast<int>(std::ceil(size.x() / cell_mm_));
    rows_ = static_cast<int>(std::ceil(size.y() / cell_mm_));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        distance_.push_back(nearest(beads, low_ + cell_mm_ * Point2(column + 0.5, row + 0.5)));
  }

  /// [mm]; far away outside the map.
  double at(const Point2& point) const {
    const Point2 cell = (point - low_) / cell_mm_;
    const bool is_inside = cell.x() >= 0.0 && cell.y() >= 0.0 && cell.x() < columns_ && cell.y() < rows_;
    if (!is_inside) return 1e3;
    return distance_[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(cell.x())];
  }

 private:
  static double nearest(const std::vector<CalibrationBead>& beads, const Point2& point) {
    double least = 1e3;
    for (const CalibrationBead& bead : beads) {
      const Point2 along = bead.end - bead.start;
      const double part = std::clamp((point - bead.start).dot(along) / along.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (point - bead.start - part * along).norm());
    }
    return least;
  }

  double cell_mm_;
  Point2 low_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<double> distance_;
};

/// A high point: where the sensor was, and the point seen from there, along the bed.
struct HighPoint {
  Point2 sensor = Point2::Zero();
  Point2 from_sensor = Point2::Zero();
};

std::vector<HighPoint> highPoints(const CrossTarget& target, const ViewPoints& view,
                                  const Eigen::Isometry3d& nozzle_from_sensor) {
  std::vector<std::size_t> high;
  for (std::size_t i = 0; i < view.points.size(); ++i)
    if (view.onBed(view.points[i], nozzle_from_sensor).z() > kHighHeight * target.bead_height_mm)
      high.push_back(i);
  std::vector<HighPoint> points;
  for (const std::size_t i : evenlyChosen(high, kMostSearched)) {
    const SeenPoint& seen = view.points[i];
    const Point3 sensor = view.bed_from_nozzle[seen.profile] * nozzle_from_sensor.translation();
    points.push_back({sensor.head<2>(), (view.onBed(seen, nozzle_from_sensor) - sensor).head<2>()});
  }
  return points;
}

/// A shift along the bed and a turn about its normal.
struct Placement {
  Point2 shift = Point2::Zero();
  double turn = 0.0;
};

double costOf(const std::vector<Point2>& turned, const Point2& shift, const DistanceMap& map,
              double most_mm) {
  double cost = 0.0;
  for (const Point2& point : turned) cost += std::min(map.at(point + shift), most_mm);
  return cost;
}

std::vector<Point2> turnedBy(double turn, const std::vector<HighPoint>& points) {
  std::vector<Point2> turned;
  turned.reserve(points.size());
  for (const HighPoint& point : points)
    turned.push_back(point.sensor + Eigen::Rotation2Dd(turn) * point.from_sensor);
  return turned;
}

Placement bestPlacement(const std::vector<HighPoint>& points, const DistanceMap& map, double width_mm) {
  Placement best;
  double least = std::numeric_limits<double>::infinity();
  const double step_mm = 0.5 * width_mm;
  const int shifts = static_cast<int>(std::ceil(kSearchMm / step_mm));
  const int turns = static_cast<int>(std::lround(kSearchTurn / kSearchTurnStep));
  for (int turn = -turns; turn <= turns; ++turn) {
    const std::vector<Point2> turned = turnedBy(turn * kSearchTurnStep, points);
    for (int i = -shifts; i <= shifts; ++i)
      for (int j = -shifts; j <= shifts; ++j) {
        const Point2 shift = step_mm * Point2(i, j);
        const double cost = costOf(turned, shift, map, 2.0 * width_mm);
        if (cost < least) best = {shift, turn * kSearchTurnStep};
        least = std::min(least, cost);
      }
  }
  return best;
}

}  // namespace

double crestDistance(const Crest& crest, const ViewPoints& view,
                     const Eigen::Isometry3d& nozzle_from_sensor) {
  double across = -crest.offset_mm;
  for (std::size_t i = 0; i < crest.points.size(); ++i)
    across += crest.weights[i] *
              crest.normal.dot(view.onBed(view.points[crest.points[i]], nozzle_from_sensor).head<2>());
  return across;
}

std::vector<Crest> crestsOf(const CrossTarget& target, const ViewPoints& view,
                            const Eigen::Isometry3d& nozzle_from_sensor) {
  const double reach = 2.0 * kWindow * target.bead_width_mm;
  const double ends = kClearEnds * target.bead_width_mm;
  std::map<std::tuple<std::size_t, int, int>, std::vector<AcrossBead>> cells;  // by bead, pass and place
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    const int pass = view.pass[view.points[i].profile];
    if (pass < 0) continue;
    const Point3 at = view.onBed(view.points[i], nozzle_from_sensor);
    for (std::size_t bead = 0; bead < target.beads.size(); ++bead) {
      const AcrossBead seen = seenFrom(target.beads[bead], at, i);
      const double length = (target.beads[bead].end - target.beads[bead].start).norm();
      if (std::abs(seen.across_mm) > reach || seen.along_mm < ends || seen.along_mm > length - ends) continue;
      cells[{bead, pass, static_cast<int>(seen.along_mm / kCrestCellMm)}].push_back(seen);
    }
  }
  std::vector<Crest> crests;
  for (auto& [key, cell] : cells) {
    Crest crest = crestOf(std::move(cell), target.beads[std::get<0>(key)], target);
    if (!crest.points.empty()) crests.push_back(std::move(crest));
  }
  return crests;
}

Eigen::Isometry3d placedOverCross(const CrossTarget& target, const ViewPoints& view,
                                  const Eigen::Isometry3d& nozzle_from_sensor) {
  const std::vector<HighPoint> points = highPoints(target, view, nozzle_from_sensor);
  if (points.size() < kLeastSearched)
    throw InvalidInput(std::to_string(points.size()) + " points lie higher than " +
                       numberText(kHighHeight * target.bead_height_mm) +
                       " mm over the bed; expected beads of a cross");
  const DistanceMap map(target.beads, 0.25 * target.bead_width_mm);
  const Placement best = bestPlacement(points, map, target.bead_width_mm);
  std::size_t on_beads = 0;
  for (const Point2& point : turnedBy(best.turn, points))
    if (map.at(point + best.shift) < target.bead_width_mm) ++on_beads;
  const double share = static_cast<double>(on_beads) / static_cast<double>(points.size());
  if (share < kLeastOnBeads)
    throw InvalidInput(
        "the cross is not found: " + std::to_string(std::lround(100.0 * share)) +
        " % of what is higher than the bed fits its beads; expected 60 %, the sensor within 12 mm "
        "and 5 deg of where it is thought to be");
  const Eigen::Matrix3d turn = view.bed_from_nozzle.front().linear();
  const Eigen::Matrix3d about = Eigen::AngleAxisd(best.turn, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Isometry3d corrected = nozzle_from_sensor;
  corrected.linear() = turn.transpose() * about * turn * nozzle_from_sensor.linear();
  corrected.translation() += turn.transpose() * Point3(best.shift.x(), best.shift.y(), 0.0);
  return corrected;
}

}  // namespace lamina
