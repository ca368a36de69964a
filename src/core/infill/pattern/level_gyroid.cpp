// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/level_gyroid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/pattern/gyroid_graphs.hpp"

namespace lamina {
namespace {

constexpr double kPeriod = 2.0 * M_PI;
constexpr double kStraight = 0.1;  ///< curvature in phases that counts as little
constexpr double kBulge = 0.98;    ///< of the chord error
constexpr int kSamples = 128;      ///< of a period, far finer than the chords

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

constexpr double kBeyond = 1e-3;  ///< periods

/// How far the points of a graph from one to another lie from the line through two others.
double farthestFrom(const Polyline& graph, std::size_t from, std::size_t to, const Polyline& ends) {
  const Point2 along = (ends[to] - ends[from]).normalized();
  double farthest = 0.0;
  for (std::size_t i = from; i <= to; ++i)
    farthest = std::max(farthest, std::abs(cross(along, graph[i] - ends[from])));
  return farthest;
}

/// The points of a period moved aside by up to a distance, away from the centre of curvature: chords between
/// them cross the graph, and may be longer by half than those between its own points.
Polyline bulged(const Polyline& period, double distance) {
  const std::size_t count = period.size() - 1;
  const Point2 forward(kPeriod, 0.0);
  Polyline moved;
  moved.reserve(period.size());
  for (std::size_t i = 0; i <= count; ++i) {
    const Point2 before = i > 0 ? period[i - 1] : Point2(period[count - 1] - forward);
    const Point2 after = i < count ? period[i + 1] : Point2(period[1] + forward);
    const Point2 along = 0.5 * (after - before);
    const Point2 bend = after - 2.0 * period[i] + before;
    const double curvature = cross(along, bend) / std::pow(along.squaredNorm(), 1.5);
    const double share = curvature / (std::abs(curvature) + kStraight);
    moved.push_back(period[i] - share * distance * leftOf(along).normalized());
  }
  return moved;
}

/// Chords as long as the error allows on both sides, one after the other.
Polyline chordsOf(const Polyline& period, double chord_error) {
  const Polyline ends = bulged(period, kBulge * chord_error);
  Polyline chords{ends.front()};
  for (std::size_t from = 0, to = 1; from + 1 < period.size(); from = to++) {
    while (to + 1 < period.size() && farthestFrom(period, from, to + 1, ends) <= chord_error) ++to;
    chords.push_back(ends[to]);
  }
  return chords;
}

/// One period of a graph: points (t, v), the last of them the first, a period farther.
Polyline periodOf(const GyroidGraphs& graphs, int branch, double chord_error) {
  Polyline fine;
  for (int s = 0; s <= kSamples; ++s) {
    const double t = kPeriod * s / kSamples;
    fine.emplace_back(t, graphs.at(t, branch));
  }
  fine.back().y() = fine.front().y();
  return chordsOf(fine, chord_error);
}

/// The box in phases (t, v): its corners in order.
Polygon graphBox(const GyroidSection& section, const Box2& box, bool is_over_x) {
  Polygon corners;
  for (const Point2& corner :
       {box.low, Point2(box.high.x(), box.low.y()), box.high, Point2(box.low.x(), box.high.y())}) {
    const Point3 phases = section.phases(corner);
    corners.emplace_back(is_over_x ? phases.x() : phases.y(), is_over_x ? phases.y() : phases.x());
  }
  return corners;
}

/// From where to where a convex outline reaches along t between two values of v; high below low if it is not
/// there.
Interval reachBetween(const Polygon& outline, double low_v, double high_v) {
  Interval reach;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const Point2 along = outline[i] - outline[j];
    const double at_low = (low_v - outline[j].y()) / along.y();
    const double at_high = (high_v - outline[j].y()) / along.y();
    const bool is_level = std::abs(along.y()) < 1e-9;
    if (is_level && (outline[j].y() < low_v || outline[j].y() > high_v)) continue;
    const double from = is_level ? 0.0 : std::clamp(std::min(at_low, at_high), 0.0, 1.0);
    const double to = is_level ? 1.0 : std::clamp(std::max(at_low, at_high), 0.0, 1.0);
    if (!is_level && std::max(at_low, at_high) < 0.0) continue;
    if (!is_level && std::min(at_low, at_high) > 1.0) continue;
    for (const double at : {from, to}) {
      const double t = outline[j].x() + at * along.x();
      reach = {std::min(reach.low, t), std::max(reach.high, t)};
    }
  }
  return reach;
}

}  // namespace

PatternCurves levelGyroidCurves(const GyroidSection& section, const Box2& box, double chord_error_mm) {
  const GyroidGraphs graphs(section.phases(Point2::Zero()).z());
  const bool is_over_x = graphs.isOverX();
  const Polygon wanted = graphBox(section, box, is_over_x);
  const Box2 around = boundingBox({wanted});
  PatternCurves curves;
  for (const int branch : {-1, 1}) {
    const Polyline period = periodOf(graphs, branch, chord_error_mm * section.phasesPerMillimetre());
    const Box2 span = boundingBox({period});
    const double last_v = std::ceil((around.high.y() - span.low.y()) / kPeriod);
    for (double v = std::floor((around.low.y() - span.high.y()) / kPeriod); v <= last_v; ++v) {
      const Interval reach = reachBetween(wanted, span.low.y() + v * kPeriod, span.high.y() + v * kPeriod);
      if (reach.low > reach.high) continue;
      Polyline curve;
      // Beyond the box on either side, so that both ends are outside.
      const double first_t = std::floor(reach.low / kPeriod - kBeyond);
      const double last_t = std::floor(reach.high / kPeriod + kBeyond);
      for (double t = first_t; t <= last_t; ++t)
        for (std::size_t i = t == first_t ? 0 : 1; i < period.size(); ++i) {
          const Point2 at = period[i] + kPeriod * Point2(t, v);
          curve.push_back(section.atPhases(is_over_x ? at : Point2(at.y(), at.x())));
        }
      curves.open.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace lamina
