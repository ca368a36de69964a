// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/walls/adapted_walls.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/shortest_rotation.hpp"
#include "planning/seams/seam.hpp"
#include "planning/travel/travel.hpp"
#include "planning/walls/curve_inset.hpp"

namespace lamina {
namespace {

Polygon planOf(const AdaptedCurve& curve) {
  Polygon plan;
  plan.reserve(curve.points.size());
  for (const Point3& point : curve.points) plan.emplace_back(point.head<2>());
  return plan;
}

template <class Change>
void changeAll(AdaptedCurve& curve, const Change& change) {
  change(curve.points);
  change(curve.axis);
  change(curve.height_mm);
}

/// The curve from its seam, or from its nearer end.
AdaptedCurve approached(AdaptedCurve curve, Seam& seam, const std::optional<Point3>& nozzle) {
  if (!curve.is_closed) {
    const bool is_backwards = nozzle && (curve.points.back() - *nozzle).squaredNorm() <
                                            (curve.points.front() - *nozzle).squaredNorm();
    if (is_backwards) changeAll(curve, [](auto& values) { std::reverse(values.begin(), values.end()); });
    return curve;
  }
  const Polygon plan = planOf(curve);
  Polygon placed = seam.placed(plan);
  if (nozzle) placed = seam.approached(std::move(placed), nozzle->head<2>());
  const Point2 start = placed.front();
  const auto nearest = std::min_element(plan.begin(), plan.end(),
                                        [&start](const Point2& a, const Point2& b) {
                                          return (a - start).squaredNorm() < (b - start).squaredNorm();
                                        }) -
                       plan.begin();
  changeAll(curve,
            [nearest](auto& values) { std::rotate(values.begin(), values.begin() + nearest, values.end()); });
  return curve;
}

Eigen::Quaterniond againstAxis(const Point3& axis) {
  return (shortestRotation(Point3::UnitZ(), axis) * nozzleDown()).normalized();
}

Path pathAlong(AdaptedCurve curve, double width_mm, double feed_mm_s) {
  std::vector<Eigen::Quaterniond> orientations;
  std::vector<Bead> beads;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    orientations.push_back(againstAxis(curve.axis[i]));
    beads.push_back({width_mm, curve.height_mm[i]});
  }
  Path path;
  path.role = PathRole::OuterWall;
  path.is_closed = curve.is_closed;
  path.points = std::move(curve.points);
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(orientations));
  path.bead = AlongPath<Bead>(std::move(beads));
  path.feed_mm_s = feed_mm_s;
  return path;
}

Point2 anchorOf(const AdaptedLayers& layers) {
  Box2 box;
  for (const AdaptedLayer& layer : layers.layers) {
    for (const AdaptedCurve& curve : layer.curves)
      for (const Point3& point : curve.points) box.include(point.head<2>());
    if (!box.isEmpty()) return box.low;
  }
  return Point2::Zero();
}

/// Beads of a layer's curves, inside the wall.
AdaptedLayer insetLayer(const AdaptedLayer& layer, double distance_mm, InsetWay way) {
  AdaptedLayer inset;
  for (const AdaptedCurve& curve : layer.curves)
    for (AdaptedCurve& piece : insetCurve(curve, distance_mm, way)) inset.curves.push_back(std::move(piece));
  return inset;
}

/// @param nozzle  where it is, if it is anywhere yet
ToolpathLayer plannedLayer(const AdaptedLayer& layer, const PlanSettings& settings, double feed_mm_s,
                           Seam& seam, std::optional<Point3> nozzle) {
  ToolpathLayer planned;
  planned.z_mm = -std::numeric_limits<double>::infinity();
  for (const AdaptedCurve& curve : layer.curves) {
    for (const Point3& point : curve.points) planned.z_mm = std::max(planned.z_mm, point.z());
    for (const double height : curve.height_mm) planned.height_mm = std::max(planned.height_mm, height);
    Path path = pathAlong(approached(curve, seam, nozzle), settings.bead.width_mm, feed_mm_s);
    if (nozzle) {
      std::optional<Path> travel = makeTravel(*nozzle, path.firstPoint(), settings.travel);
      if (travel) planned.paths.push_back(std::move(*travel));
    }
    nozzle = path.lastPoint();
    planned.paths.push_back(std::move(path));
  }
  return planned;
}

}  // namespace

std::vector<ToolpathLayer> adaptedWalls(const AdaptedLayers& layers, const PlanSettings& settings) {
  const double distance_mm = settings.adapted.contour_offset * settings.bead.width_mm;
  const FeedSettings& feed = settings.feed;
  const Point2 anchor = anchorOf(layers);
  std::optional<Point3> nozzle;
  std::vector<ToolpathLayer> planned;
  for (std::size_t k = 0; k < layers.layers.size(); ++k) {
    // The bed is level: across a wall that leans inwards, the lowest layer would sink into it.
    const AdaptedLayer inset =
        insetLayer(layers.layers[k], distance_mm, k == 0 ? InsetWay::Level : InsetWay::AcrossWall);
    if (inset.curves.empty()) continue;
    Seam seam(settings.seam, anchor, k);
    const double feed_mm_s =
        k == 0 ? std::min(feed.outer_wall_mm_s, feed.first_layer_mm_s) : feed.outer_wall_mm_s;
    planned.push_back(plannedLayer(inset, settings, feed_mm_s, seam, nozzle));
    nozzle = planned.back().paths.back().lastPoint();
  }
  if (planned.empty() && !layers.layers.empty())
    throw InvalidInput("no wall is thick enough for a bead " + numberText(distance_mm) +
                       " mm inside its surface on either side; expected a smaller bead.width_mm or "
                       "walls.contour_offset");
  return planned;
}

}  // namespace lamina
