// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/given_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "geometry/spatial/nearest_points.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"

namespace lamina {
namespace {

constexpr std::size_t kNear = 8;
constexpr double kReachSpacings = 3.0;
constexpr double kReachCells = 2.0;
constexpr double kLeastMean = 0.1;  // length of a mean of unit directions below which it says nothing
constexpr std::size_t kSpacings = 2000;
constexpr std::size_t kNodesAtOnce = 4096;

std::vector<Point3> placesOf(const std::vector<DirectionSample>& samples) {
  std::vector<Point3> places;
  places.reserve(samples.size());
  for (const DirectionSample& sample : samples) places.push_back(sample.place);
  return places;
}

std::string spot(const Point3& place) {
  return numberText(place.x()) + ", " + numberText(place.y()) + ", " + numberText(place.z()) + " mm";
}

/// Median distance from a sample to the nearest other one; infinite if there is none.
double spacingOf(const NearestPoints& places) {
  const std::size_t count = places.points().size();
  if (count < 2) return std::numeric_limits<double>::infinity();
  std::vector<double> spacings;
  const std::size_t step = (count + kSpacings - 1) / kSpacings;
  spacings.reserve(count / step + 1);
  for (std::size_t i = 0; i < count; i += step)
    spacings.push_back(std::sqrt(places.nearest(places.points()[i], 2).back().squared));
  const auto middle = spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2);
  std::nth_element(spacings.begin(), middle, spacings.end());
  return *middle;
}

/// Of a sample at a distance, with one at `end_mm` that weighs nothing; infinite without.
double weightOf(double distance_mm, double end_mm) {
  const double weight = 1.0 / distance_mm - 1.0 / end_mm;
  return weight * weight;
}

class GivenDirections {
 public:
  GivenDirections(const std::vector<DirectionSample>& samples, double cell_mm)
      : samples_(samples),
        places_(placesOf(samples)),
        reach_mm_(std::max(kReachSpacings * spacingOf(places_), kReachCells * cell_mm)) {}

  Point3 at(const Point3& place) const {
    const std::vector<NearPoint> near = places_.nearest(place, kNear + 1);
    const double nearest_mm = std::sqrt(near.front().squared);
    if (nearest_mm > reach_mm_)
      throw InvalidInput("the part at " + spot(place) + " is " + numberText(nearest_mm) +
                         " mm from the nearest given direction; expected at most " + numberText(reach_mm_) +
                         " mm, as they lie apart from each other: volumetric.target_file has to reach the "
                         "whole part, in the coordinates of its mesh");
    const Point3 mean = meanOf(near);
    if (mean.norm() < kLeastMean)
      throw InvalidInput("the given directions about " + spot(place) + " have a mean of length " +
                         numberText(mean.norm()) + "; expected at least " + numberText(kLeastMean) +
                         " of 1: they have to point towards later layers");
    return mean.normalized();
  }

 private:
  Point3 meanOf(const std::vector<NearPoint>& near) const {
    const double end_mm =
        near.size() > kNear ? std::sqrt(near.back().squared) : std::numeric_limits<double>::infinity();
    Point3 sum = Point3::Zero();
    double whole = 0.0;
    for (const NearPoint& point : near) {
      const Point3& direction = samples_[point.index].direction;
      if (point.squared <= 0.0) return direction;
      const double weight = weightOf(std::sqrt(point.squared), end_mm);
      sum += weight * direction;
      whole += weight;
    }
    // All are equally far.
    if (whole <= 0.0) {
      for (const NearPoint& point : near) sum += samples_[point.index].direction;
      whole = static_cast<double>(near.size());
    }
    return sum / whole;
  }

  const std::vector<DirectionSample>& samples_;
  NearestPoints places_;
  double reach_mm_;
};

}  // namespace

std::vector<Point3> directionsAtNodes(const CellGraph& cells, const std::vector<DirectionSample>& samples,
                                      Progress& progress) {
  if (samples.empty()) throw InvalidInput("0 directions are given; expected one at least");
  const GivenDirections given(samples, cells.frame().voxel_mm);
  std::vector<Point3> directions(cells.nodeCount(), Point3::Zero());
  const std::size_t count = directions.size();
  const auto find = [&](std::size_t block) {
    for (std::size_t i = block * kNodesAtOnce; i < std::min(count, (block + 1) * kNodesAtOnce); ++i)
      directions[i] = given.at(cells.middle(static_cast<std::uint32_t>(i)));
  };
  parallelFor((count + kNodesAtOnce - 1) / kNodesAtOnce, find, progress, "fit");
  return directions;
}

}  // namespace lamina
