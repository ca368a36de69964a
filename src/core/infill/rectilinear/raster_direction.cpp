// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/raster_direction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/polygon/plane_vectors.hpp"
#include "infill/rectilinear/section_order.hpp"
#include "infill/rectilinear/zigzag.hpp"

namespace lamina {
namespace {

constexpr int kCoarseAngles = 12;
constexpr int kRefinements = 4;
/// A direction must be better by this part, so that rounding chooses none.
constexpr double kLeastDirectionGain = 1e-9;

/// Edges as vectors that point up, or right, by their direction.
std::vector<Point2> edgesByDirection(const Regions& regions) {
  std::vector<Point2> edges;
  for (const Polygon& outline : outlines(regions))
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2 edge = outline[i + 1 < outline.size() ? i + 1 : 0] - outline[i];
      if (edge.x() == 0.0 && edge.y() == 0.0) continue;
      const bool is_turned = edge.y() < 0.0 || (edge.y() == 0.0 && edge.x() < 0.0);
      edges.emplace_back(is_turned ? Point2(-edge) : edge);
    }
  std::sort(edges.begin(), edges.end(), [](const Point2& a, const Point2& b) {
    return std::atan2(a.y(), a.x()) < std::atan2(b.y(), b.x());
  });
  return edges;
}

/// Way to the first run and between them. Those of a solid raster are in order, others are deposited by their
/// nearest ends.
double travelTo(const std::vector<FillPath>& runs, const InfillRequest& request) {
  if (runs.empty()) return 0.0;
  std::vector<BoustrophedonCell> ends;
  ends.reserve(runs.size());
  for (const FillPath& run : runs) {
    const std::array<Point2, 2> line = {run.points.front(), lastPoint(run)};
    ends.push_back({line, line, 1});
  }
  const SectionTour tour = isSolid(request) ? tourAsGiven(ends) : tourByEnds(ends, request.start);
  const Point2 first = entryPoint(ends[tour.front().section], tour.front().entry);
  return (first - request.start).norm() + travelLength(ends, tour);
}

class DirectionSearch {
 public:
  DirectionSearch(const Regions& regions, const InfillRequest& request, const FillFunction& fill)
      : regions_(regions), request_(request), fill_(fill) {}

  std::vector<FillPath> search() && {
    const double given = request_.angle_rad;
    tryAngle(angleOfFewestTurns(regions_, given));
    for (int i = 0; i < kCoarseAngles; ++i) tryAngle(given + M_PI * i / kCoarseAngles);
    double step = 0.5 * M_PI / kCoarseAngles;
    for (int i = 0; i < kRefinements; ++i, step *= 0.5) {
      const double middle = best_angle_;
      tryAngle(middle - step);
      tryAngle(middle + step);
    }
    return std::move(best_);
  }

 private:
  void tryAngle(double angle) {
    InfillRequest turned = request_;
    turned.angle_rad = angle;
    std::vector<FillPath> runs = fill_(regions_, turned);
    const double travel = std::round(travelTo(runs, request_) / request_.spacing_mm);
    const double extent = extentAcross(regions_, angle);
    const bool is_better = travel < best_travel_ ||
                           (travel == best_travel_ && extent < best_extent_ * (1.0 - kLeastDirectionGain));
    if (!is_better) return;
    best_ = std::move(runs);
    best_angle_ = angle;
    best_travel_ = travel;
    best_extent_ = extent;
  }

  const Regions& regions_;
  const InfillRequest& request_;
  const FillFunction& fill_;
  std::vector<FillPath> best_;
  double best_angle_ = 0.0;
  double best_travel_ = std::numeric_limits<double>::infinity();  ///< in whole spacings
  double best_extent_ = 0.0;
};

}  // namespace

double extentAcross(const Regions& regions, double angle_rad) {
  const Point2 across(-std::sin(angle_rad), std::cos(angle_rad));
  double sum = 0.0;
  for (const Point2& edge : edgesByDirection(regions)) sum += std::abs(edge.dot(across));
  return 0.5 * sum;
}

double angleOfFewestTurns(const Regions& regions, double angle_rad) {
  const std::vector<Point2> edges = edgesByDirection(regions);
  double least = extentAcross(regions, angle_rad) * (1.0 - kLeastDirectionGain);
  double best = angle_rad;
  // Edges left of the direction count one way, those right of it the other.
  Point2 balance = Point2::Zero();
  for (const Point2& edge : edges) balance += edge;
  for (const Point2& edge : edges) {
    balance -= 2.0 * edge;
    const double extent = 0.5 * std::abs(cross(edge, balance)) / edge.norm();
    if (extent >= least) continue;
    least = extent * (1.0 - kLeastDirectionGain);
    best = std::atan2(edge.y(), edge.x());
  }
  return best;
}

std::vector<FillPath> inBestDirection(const Regions& regions, const InfillRequest& request,
                                      const FillFunction& fill) {
  switch (request.settings.raster.direction) {
    case RasterDirection::FewestTurns: {
      InfillRequest turned = request;
      turned.angle_rad = angleOfFewestTurns(regions, request.angle_rad);
      return fill(regions, turned);
    }
    case RasterDirection::LeastTravel:
      return DirectionSearch(regions, request, fill).search();
    default:
      return fill(regions, request);
  }
}

}  // namespace lamina
