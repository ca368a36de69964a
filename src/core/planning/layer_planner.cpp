// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/layer_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/inside.hpp"
#include "lamina/geometry/offset.hpp"
#include "lamina/geometry/simplify.hpp"
#include "planning/ordering.hpp"
#include "planning/seam.hpp"
#include "planning/skirt.hpp"
#include "planning/travel.hpp"
#include "planning/walls.hpp"

namespace lamina {
namespace {

double feedOf(PathRole role, const FeedSettings& feed) {
  switch (role) {
    case PathRole::OuterWall:
      return feed.outer_wall_mm_s;
    case PathRole::InnerWall:
      return feed.inner_wall_mm_s;
    case PathRole::Skirt:
      return feed.skirt_mm_s;
    default:
      return feed.infill_mm_s;
  }
}

class LayerPlanner {
 public:
  LayerPlanner(const Layer& layer, std::size_t index, const PlanContext& context)
      : context_(context),
        settings_(context.settings),
        index_(index),
        seam_(settings_.seam, context.anchor, index),
        nozzle_(context.anchor),
        top_(layer.slab.top_mm) {
    result_.z_mm = layer.slab.top_mm;
    result_.height_mm = layer.slab.height();
  }

  ToolpathLayer plan(const std::vector<Polygon>& contours) && {
    const Regions material = unite(simplify(contours, settings_.simplification_mm));
    if (index_ == 0)
      for (Polygon& loop : makeSkirt(material, settings_)) addLoop(std::move(loop), PathRole::Skirt);
    std::vector<RunEnds> islands;
    for (const Region& island : material) {
      const Polygon outline = seam_.placed(island.outer);
      islands.push_back({outline.front(), outline.front()});
    }
    for (const OrderedRun& next : orderRuns(islands, nozzle_)) addIsland(material[next.run]);
    return std::move(result_);
  }

 private:
  void addIsland(const Region& island) {
    Walls walls = makeWalls({island}, settings_);
    const std::size_t count = walls.centre_lines.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = settings_.walls.order == WallOrder::OutsideIn ? i : count - 1 - i;
      addWall(walls.centre_lines[k], k == 0 ? PathRole::OuterWall : PathRole::InnerWall);
    }
    addInfill(walls.infill);
  }

  void addWall(const Regions& centre_lines, PathRole role) {
    std::vector<Polygon> loops = outlines(centre_lines);
    std::vector<RunEnds> ends;
    ends.reserve(loops.size());
    for (Polygon& loop : loops) {
      loop = seam_.placed(std::move(loop));
      ends.push_back({loop.front(), loop.front()});
    }
    for (const OrderedRun& next : orderRuns(ends, nozzle_))
      addLoop(seam_.approached(std::move(loops[next.run]), nozzle_), role);
  }

  void addInfill(const Regions& area) {
    if (area.empty()) return;
    const InfillSettings& infill = settings_.infill;
    InfillRequest request;
    request.bead_width_mm = settings_.bead.width_mm;
    request.spacing_mm = settings_.bead.width_mm * (1.0 - settings_.bead.overlap) / infill.density;
    request.angle_rad =
        std::fmod(infill.angle_deg + infill.alternation_deg * static_cast<double>(index_), 360.0) * M_PI /
        180.0;
    std::vector<FillPath> fills = context_.fill(area, request);
    std::vector<RunEnds> ends;
    ends.reserve(fills.size());
    for (const FillPath& fill : fills)
      ends.push_back({fill.points.front(), fill.is_closed ? fill.points.front() : fill.points.back()});
    for (const OrderedRun& next : orderRuns(ends, nozzle_)) {
      FillPath& fill = fills[next.run];
      if (next.is_reversed) std::reverse(fill.points.begin(), fill.points.end());
      const bool is_inside = staysInside(area, nozzle_, fill.points.front());
      addRun(fill, PathRole::Infill, is_inside ? TravelOver::Infill : TravelOver::Anything);
    }
  }

  void addLoop(Polygon loop, PathRole role) { addRun({std::move(loop), true}, role, TravelOver::Anything); }

  void addRun(const FillPath& run, PathRole role, TravelOver over) {
    Path path;
    path.role = role;
    path.is_closed = run.is_closed;
    path.points.reserve(run.points.size());
    for (const Point2& point : run.points) path.points.emplace_back(point.x(), point.y(), top_);
    path.bead = Bead{settings_.bead.width_mm, result_.height_mm};
    const double feed = feedOf(role, settings_.feed);
    path.feed_mm_s = index_ == 0 ? std::min(feed, settings_.feed.first_layer_mm_s) : feed;
    if (!result_.paths.empty()) addTravelTo(path.firstPoint(), over);
    nozzle_ = path.lastPoint().head<2>();
    result_.paths.push_back(std::move(path));
  }

  void addTravelTo(const Point3& point, TravelOver over) {
    std::optional<Path> travel = makeTravel(result_.paths.back().lastPoint(), point, settings_.travel, over);
    if (travel) result_.paths.push_back(std::move(*travel));
  }

  const PlanContext& context_;
  const PlanSettings& settings_;
  std::size_t index_;
  Seam seam_;
  Point2 nozzle_;
  double top_;
  ToolpathLayer result_;
};

}  // namespace

ToolpathLayer planLayer(const Layer& layer, std::size_t index, const PlanContext& context) {
  return LayerPlanner(layer, index, context).plan(layer.section.contours);
}

}  // namespace lamina
