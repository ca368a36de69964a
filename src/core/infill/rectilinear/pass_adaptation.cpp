// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/pass_adaptation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "geometry/polygon/plane_vectors.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Points of the outlines, with the fewest more in between so that none is farther than `step` from the next.
std::vector<Point2> densified(const std::vector<Polygon>& outlines, double step) {
  std::vector<Point2> points;
  for (const Polygon& outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& from = outline[i];
      const Point2 along = outline[i + 1 < outline.size() ? i + 1 : 0] - from;
      const int parts = std::max(1, static_cast<int>(std::ceil(along.norm() / step)));
      for (int k = 0; k < parts; ++k) points.emplace_back(from + along * k / parts);
    }
  std::sort(points.begin(), points.end(),
            [](const Point2& a, const Point2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  return points;
}

/// How far a line through `point` goes along a unit vector until it meets an edge; negative behind the point.
/// Nothing if it does not.
std::optional<double> wayToEdge(const Point2& point, const Point2& along, const Point2& a, const Point2& b) {
  const Point2 across = leftOf(along);
  const double from = (a - point).dot(across);
  const double to = (b - point).dot(across);
  if ((from < 0.0) == (to < 0.0)) return std::nullopt;
  return (a - point).dot(along) + from / (from - to) * (b - a).dot(along);
}

Point2 middleOf(const Polyline& pass) { return 0.5 * (pass.front() + pass.back()); }

}  // namespace

PerimeterApproach::PerimeterApproach(const std::vector<Polygon>& perimeter, double distance_mm,
                                     const HybridSettings& settings)
    : settings_(settings),
      spacing_(distance_mm),
      points_(densified(perimeter, settings.perimeter_step * distance_mm)),
      inwards_(outlines(offset(unite(perimeter), -settings.approach * distance_mm, Join::Round))) {}

const Point2& PerimeterApproach::nearest(const Point2& point) const {
  const auto right = std::lower_bound(points_.begin(), points_.end(), point.x(),
                                      [](const Point2& p, double x) { return p.x() < x; });
  double best = std::numeric_limits<double>::infinity();
  const Point2* found = &points_.front();
  const auto look = [&](const Point2& candidate) {
    const double squared = (candidate - point).squaredNorm();
    if (squared >= best) return;
    best = squared;
    found = &candidate;
  };
  for (auto at = right; at != points_.end() && std::pow(at->x() - point.x(), 2) < best; ++at) look(*at);
  for (auto at = right; at != points_.begin() && std::pow((at - 1)->x() - point.x(), 2) < best; --at)
    look(*(at - 1));
  return *found;
}

double PerimeterApproach::distance(const Point2& point) const {
  return points_.empty() ? std::numeric_limits<double>::infinity() : (nearest(point) - point).norm();
}

Point2 PerimeterApproach::movedTowardsNearest(const Point2& point, const Point2& outward) const {
  if (points_.empty()) return point;
  const double approach = settings_.approach * spacing_;
  const Point2 to_nearest = nearest(point) - point;
  const double along = to_nearest.dot(outward);
  const double squared = approach * approach - (to_nearest - along * outward).squaredNorm();
  if (squared < 0.0) return point;
  return point + (along - std::sqrt(squared)) * outward;
}

Point2 PerimeterApproach::clipped(const Point2& point, const Point2& outward) const {
  std::vector<double> crossings;
  for (const Polygon& outline : inwards_)
    for (std::size_t i = 0; i < outline.size(); ++i)
      if (const auto way = wayToEdge(point, outward, outline[i], outline[i + 1 < outline.size() ? i + 1 : 0]))
        crossings.push_back(*way);
  std::sort(crossings.begin(), crossings.end());
  const auto ahead = std::lower_bound(crossings.begin(), crossings.end(), 0.0);
  const bool is_inside = (crossings.end() - ahead) % 2 != 0;
  if (is_inside) return point + *ahead * outward;
  return ahead == crossings.begin() ? point : Point2(point + *(ahead - 1) * outward);
}

Point2 PerimeterApproach::approached(const Point2& point, const Point2& outward, int iterations) const {
  if (settings_.longitudinal == LongitudinalAdaptation::Clipped) return clipped(point, outward);
  Point2 moved = point;
  for (int i = 0; i < iterations; ++i) moved = movedTowardsNearest(moved, outward);
  return moved;
}

void adaptLongitudinally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter) {
  for (GridSection& section : sections)
    for (Polyline& pass : section.passes) {
      if (pass.size() < 2 && perimeter.settings().longitudinal == LongitudinalAdaptation::TwoPass) continue;
      const Point2 left = perimeter.approached(pass.front(), {-1.0, 0.0});
      const Point2 right = perimeter.approached(pass.back(), {1.0, 0.0});
      if (left.x() < right.x()) pass = {left, right};
    }
}

namespace {

class TransversalAdapter {
 public:
  explicit TransversalAdapter(const PerimeterApproach& perimeter) : perimeter_(perimeter) {}

  /// @param passes  the outermost one last
  /// @return one point more, if that is what is needed
  std::optional<Point2> adapt(std::vector<Polyline>& passes, const Point2& outward) const {
    const double spacing = perimeter_.spacing();
    const double distance = perimeter_.distance(middleOf(passes.back()));
    const bool is_point = passes.back().size() < 2;
    if (is_point || distance < perimeter_.settings().delete_below * spacing) {
      if (passes.size() < 2) return std::nullopt;
      passes.pop_back();
      passes.push_back(curveBeside(passes.back(), outward));
      return std::nullopt;
    }
    if (distance > perimeter_.settings().add_above * spacing) {
      passes.push_back(curveBeside(passes.back(), outward));
      return std::nullopt;
    }
    return perimeter_.approached(middleOf(passes.back()), outward);
  }

 private:
  /// The pass moved square to itself until it lies along the perimeter, short of both ends of the pass.
  Polyline curveBeside(const Polyline& pass, const Point2& outward) const {
    const HybridSettings& settings = perimeter_.settings();
    const double length = (pass.back() - pass.front()).norm();
    const double margin = std::min(settings.end_margin * perimeter_.spacing(), 0.25 * length);
    Polyline curve;
    for (int i = 0; i < settings.curve_points; ++i) {
      const double at = margin + (length - 2.0 * margin) * i / (settings.curve_points - 1);
      const Point2 on_pass(pass.front().x() + at, pass.front().y());
      const Point2 moved = perimeter_.approached(on_pass, outward);
      // A point that would go back has the perimeter beside it and not ahead.
      if ((moved - on_pass).dot(outward) > 0.0) curve.push_back(moved);
    }
    return curve.empty() ? pass : curve;
  }

  const PerimeterApproach& perimeter_;
};

}  // namespace

void adaptTransversally(std::vector<GridSection>& sections, const PerimeterApproach& perimeter) {
  const TransversalAdapter adapter(perimeter);
  for (GridSection& section : sections) {
    if (section.is_bordered_above) section.above = adapter.adapt(section.passes, {0.0, 1.0});
    if (!section.is_bordered_below) continue;
    std::reverse(section.passes.begin(), section.passes.end());
    section.below = adapter.adapt(section.passes, {0.0, -1.0});
    std::reverse(section.passes.begin(), section.passes.end());
  }
}

}  // namespace lamina
