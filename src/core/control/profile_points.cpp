// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "control/profile_points.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace lamina {
namespace {

constexpr std::ptrdiff_t kNeighbours = 3;  // on each side: a median of seven
constexpr std::size_t kLeastRun = 3;       // points that are no spray
constexpr double kSpraySigmas = 4.0;
constexpr double kSprayLayers = 0.3;
constexpr double kNearOverFar = 0.25;  // of depths of one sensor
constexpr double kNearShare = 0.1;     // of points that may be nearer
constexpr double kSameColumn = 0.25;   // of the way from ray to ray

/// Whether a point is one: drivers send zeros in place of those that they miss.
bool isFinite(const Point3& point) {
  // The difference of anything else to itself is not a number.
  const bool is_finite = (point.x() - point.x()) + (point.y() - point.y()) + (point.z() - point.z()) == 0.0;
  return is_finite && (point.z() != 0.0 || point.x() != 0.0 || point.y() != 0.0);
}

bool isWithin(const Point3& point, const SightSettings& settings) {
  const bool has_far_end = settings.greatest_depth_mm > 0.0;
  if (has_far_end && !(point.z() <= settings.greatest_depth_mm)) return false;
  return !(has_far_end || settings.least_depth_mm > 0.0) || point.z() >= settings.least_depth_mm;
}

/// Whether a value is off the median of itself and its neighbours, as many on both sides, by more than a
/// bound: where half of them are not below it less the bound, and half not above it plus the bound, it is
/// not.
bool isOffMedian(const Point3* point, std::ptrdiff_t side, double bound) {
  const double above = point->z() + bound;
  const double below = point->z() - bound;
  std::ptrdiff_t not_above = 0;
  std::ptrdiff_t not_below = 0;
  for (std::ptrdiff_t k = -side; k <= side; ++k) {
    not_above += point[k].z() <= above ? 1 : 0;
    not_below += point[k].z() >= below ? 1 : 0;
  }
  return not_above <= side || not_below <= side;
}

bool isOffMedian(const std::vector<Point3>& points, std::size_t i, double bound) {
  const std::size_t side = std::min(i, points.size() - 1 - i);
  if (side >= static_cast<std::size_t>(kNeighbours))
    return isOffMedian(&points[i], kNeighbours, bound);  // a loop of fixed length
  return isOffMedian(&points[i], static_cast<std::ptrdiff_t>(side), bound);
}

/// Whether three neighbours of a point agree with it: so nearly all do, and with itself they are more than
/// half of seven.
bool agreesWithThree(const Point3* point, double bound) {
  const double above = point->z() + bound;
  const double below = point->z() - bound;
  const auto is_near = [&](std::ptrdiff_t k) { return point[k].z() <= above && point[k].z() >= below; };
  return is_near(-1) && is_near(1) && is_near(2);
}

/// The first point that is off the median; the number of points if there is none.
std::size_t firstOffMedian(const std::vector<Point3>& points, double bound) {
  constexpr std::size_t kSide = static_cast<std::size_t>(kNeighbours);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_amid = i >= kSide && i + kSide < points.size();
    if (is_amid && agreesWithThree(&points[i], bound)) continue;
    if (isOffMedian(points, i, bound)) return i;
  }
  return points.size();
}

std::vector<Point3> withoutSpray(std::vector<Point3> points, double bound) {
  const std::size_t first = firstOffMedian(points, bound);
  if (first == points.size()) return points;
  std::vector<Point3> kept(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  kept.reserve(points.size());
  for (std::size_t i = first; i < points.size();) {
    if (!isOffMedian(points, i, bound)) {
      kept.push_back(points[i++]);
      continue;
    }
    std::size_t end = i + 1;
    while (end < points.size() && isOffMedian(points, end, bound) &&
           std::abs(points[end].z() - points[end - 1].z()) <= bound)
      ++end;
    const auto from = points.begin();
    if (end - i >= kLeastRun)
      kept.insert(kept.end(), from + static_cast<std::ptrdiff_t>(i), from + static_cast<std::ptrdiff_t>(end));
    i = end;
  }
  return kept;
}

/// The depth beyond which points say which ray they are of; none where the depths are from elsewhere than the
/// origin. Few points that are nearer, or behind, are of some other light.
std::optional<double> leastDepthOfRays(const std::vector<Point3>& points) {
  double greatest = 0.0;
  for (const Point3& point : points) greatest = std::max(greatest, point.z());
  const double least = kNearOverFar * greatest;
  const auto near = std::count_if(points.begin(), points.end(),
                                  [least](const Point3& point) { return !(point.z() > least); });
  if (static_cast<double>(near) > kNearShare * static_cast<double>(points.size())) return std::nullopt;
  return least;
}

/// How far apart the directions of two points are, times both of their depths: 0 of one ray.
double apart(const Point3& a, const Point3& b) { return std::abs(a.x() * b.z() - b.x() * a.z()); }

/// How far apart the directions of points of one ray are at most.
double widthOfColumn(const std::vector<Point3>& points, double least_depth) {
  const auto is_far = [least_depth](const Point3& point) { return point.z() > least_depth; };
  const auto first = std::find_if(points.begin(), points.end(), is_far);
  const auto last = std::find_if(points.rbegin(), points.rend(), is_far);
  const auto steps = std::distance(first, last.base()) - 1;
  if (steps <= 0) return 0.0;
  return kSameColumn * apart(*first, *last) / (first->z() * last->z() * static_cast<double>(steps));
}

/// Points along one ray follow one another. Rays go out from the origin where nearly all points lie far from
/// it, as against the depth that they cover; else, depths being from elsewhere, no two points are of one ray.
std::vector<std::size_t> columnsOf(const std::vector<Point3>& points) {
  const std::optional<double> least_depth = leastDepthOfRays(points);
  const double width = least_depth ? widthOfColumn(points, *least_depth) : 0.0;
  std::vector<std::size_t> columns(points.size() + 1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_same = width > 0.0 && i > 0 && points[i - 1].z() > *least_depth &&
                         points[i].z() > *least_depth &&
                         apart(points[i - 1], points[i]) < width * points[i - 1].z() * points[i].z();
    columns[count] = i;
    count += is_same ? 0 : 1;
  }
  columns[count] = points.size();
  columns.resize(count + 1);
  return columns;
}

}  // namespace

SoundPoints soundPoints(const std::vector<Point3>& points, double layer_mm, const SightSettings& settings) {
  SoundPoints sound;
  PointCounts& counts = sound.counts;
  const std::size_t trim = std::min(static_cast<std::size_t>(settings.trim_points), points.size());
  const std::size_t end = points.size() - std::min(trim, points.size() - trim);
  counts.received = points.size();
  counts.trimmed = trim + (points.size() - end);
  const auto at = [&](std::size_t i) { return points.begin() + static_cast<std::ptrdiff_t>(i); };
  std::size_t valid = trim;
  while (valid < end && isFinite(points[valid]) && isWithin(points[valid], settings)) ++valid;
  sound.points.reserve(end - trim);
  sound.points.assign(at(trim), at(valid));
  for (std::size_t i = valid; i < end; ++i) {
    if (!isFinite(points[i]))
      ++counts.not_finite;
    else if (!isWithin(points[i], settings))
      ++counts.outside_window;
    else
      sound.points.push_back(points[i]);
  }
  const std::size_t before = sound.points.size();
  const double bound = std::max(kSpraySigmas * settings.sigma_mm, kSprayLayers * layer_mm);
  sound.points = withoutSpray(std::move(sound.points), bound);
  counts.spray = before - sound.points.size();
  sound.columns = columnsOf(sound.points);
  return sound;
}

}  // namespace lamina
