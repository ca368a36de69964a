// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/voids/part_placing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/job/part/placement.hpp"
#include "planning/order/near_origin.hpp"
#include "toolpath/deposited_segment.hpp"

namespace lamina {
namespace {

constexpr double kRoundPlace = 0.5;  // mm: slicers put the middle of parts on multiples of it
constexpr double kNearRound = 0.2;   // mm
/// Nearer places are the same [mm].
constexpr double kSamePlace = 1e-3;
/// Sides of boxes are tried one by one where they distinguish places so far [mm].
constexpr double kSidesDiffer = 0.05;
/// Placements are compared on so many layers.
constexpr std::size_t kComparedLayers = 6;

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Of all beads but skirts, each motion weighed by its volume.
Point2 centroidOf(const ToolpathLayer& layer) {
  double sum = 0.0;
  Point2 moment = Point2::Zero();
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      const Point2 a = path.points[m].head<2>();
      const Point2 b = path.points[end].head<2>();
      const double volume = (b - a).norm() * crossSection(path.bead.at(end));
      sum += volume;
      moment += 0.5 * volume * (a + b);
    }
  }
  return sum > 0.0 ? Point2(moment / sum) : Point2(Point2::Zero());
}

Point2 centroidOf(const Regions& regions) {
  double sum = 0.0;
  Point2 moment = Point2::Zero();
  for (const Polygon& outline : outlines(regions))
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      const double cross = outline[j].x() * outline[i].y() - outline[j].y() * outline[i].x();
      sum += 0.5 * cross;
      moment += cross / 6.0 * (outline[i] + outline[j]);
    }
  return sum > 0.0 ? Point2(moment / sum) : Point2(Point2::Zero());
}

/// Places along one axis that layers indicate, by their low sides, their middles, their high sides.
struct AxisPlaces {
  std::vector<double> low;
  std::vector<double> middle;
  std::vector<double> high;

  void add(double deposited_low, double deposited_high, double cut_low, double cut_high) {
    low.push_back(deposited_low - cut_low);
    high.push_back(deposited_high - cut_high);
    middle.push_back(0.5 * (low.back() + high.back()));
  }

  std::vector<double> places() const {
    const double by_low = median(low);
    const double by_high = median(high);
    if (std::abs(by_low - by_high) < kSidesDiffer) return {median(middle)};
    return {median(middle), by_low, by_high};
  }
};

/// Every place of the lists, without those that are there already.
class Candidates {
 public:
  /// @param centre  of the part's box
  explicit Candidates(const Point2& centre) : centre_(centre) {}

  void add(const Point2& place) {
    const bool is_known = std::any_of(places_.begin(), places_.end(), [&](const Point2& known) {
      return (known - place).norm() < kSamePlace;
    });
    if (!is_known) places_.push_back(place);
  }

  /// The place, after that near it where the middle of the part is round.
  void addRounded(const Point2& place) {
    const Point2 round = ((centre_ + place) / kRoundPlace).array().round() * kRoundPlace;
    if ((round - centre_ - place).norm() <= kNearRound) add(round - centre_);
    add(place);
  }

  const std::vector<Point2>& places() const { return places_; }

 private:
  Point2 centre_;
  std::vector<Point2> places_;
};

class Placing {
 public:
  Placing(const Toolpath& program, const std::vector<Regions>& contours, const VoidMapSettings& map)
      : program_(program), contours_(contours), map_(map) {}

  void addStated(Candidates& candidates) const {
    AxisPlaces x;
    AxisPlaces y;
    AxisPlaces centroid;  // x as low, y as high
    for (std::size_t i = 0; i < contours_.size(); ++i) {
      const Box2 deposited = depositedBox(program_.layers[i]);
      const Box2 cut = boundingBox(outlines(contours_[i]));
      if (deposited.isEmpty() || cut.isEmpty()) continue;
      x.add(deposited.low.x(), deposited.high.x(), cut.low.x(), cut.high.x());
      y.add(deposited.low.y(), deposited.high.y(), cut.low.y(), cut.high.y());
      const Point2 between = centroidOf(program_.layers[i]) - centroidOf(contours_[i]);
      centroid.low.push_back(between.x());
      centroid.high.push_back(between.y());
    }
    if (x.low.empty()) return;
    for (const double at_x : x.places())
      for (const double at_y : y.places()) candidates.addRounded({at_x, at_y});
    if (x.places().size() + y.places().size() > 2)
      candidates.addRounded({median(centroid.low), median(centroid.high)});
  }

  Point2 best(const std::vector<Point2>& places) const {
    std::vector<double> faults(places.size());
    NoProgress nobody;
    parallelFor(
        faults.size(), [&](std::size_t i) { faults[i] = fault(places[i]); }, nobody, "place");
    return places[static_cast<std::size_t>(std::min_element(faults.begin(), faults.end()) - faults.begin())];
  }

 private:
  /// Area that is uncovered or overfilled.
  double fault(const Point2& offset) const {
    double sum = 0.0;
    const std::size_t step = 1 + (contours_.size() - 1) / kComparedLayers;
    for (std::size_t i = 0; i < contours_.size(); i += step) {
      const LayerVoids voids = findVoids(moved(contours_[i], offset), program_.layers[i], map_);
      sum += voids.uncovered_mm2 + voids.overfill_mm2;
    }
    return sum;
  }

  const Toolpath& program_;
  const std::vector<Regions>& contours_;
  const VoidMapSettings& map_;
};

}  // namespace

Point2 findPlace(const Toolpath& program, const std::vector<Regions>& contours, const Box3& box,
                 const VoidJob& job) {
  if (contours.empty()) return Point2::Zero();
  Candidates candidates(box.centre().head<2>());
  const Placing placing(program, contours, job.map);
  placing.addStated(candidates);
  const Point2 bed = boundingBox(buildSpaceOf(job.settings.machine)).centre().head<2>();
  candidates.add(placePart(box, bed, job.settings.placement).translation().head<2>());
  candidates.add(Point2::Zero());
  return placing.best(candidates.places());
}

Box2 depositedBox(const ToolpathLayer& layer) {
  Box2 box;
  for (const Path& path : layer.paths) {
    if (!isPartOfPart(path)) continue;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      const double reach = 0.5 * path.bead.at(i).width_mm;
      box.include(path.points[i].head<2>() - Point2(reach, reach));
      box.include(path.points[i].head<2>() + Point2(reach, reach));
    }
  }
  return box;
}

}  // namespace lamina
