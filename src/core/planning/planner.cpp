// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polygon/inside.hpp"
#include "infill/contour/corner_smoothing.hpp"
#include "infill/drops/drop_fill.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/error_place.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/plan_consistency.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/failing_layer.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/refill.hpp"
#include "planning/order/anchored_run.hpp"
#include "planning/order/layer_chain.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/order/ordering.hpp"
#include "planning/order/support_test.hpp"
#include "planning/seams/seam.hpp"
#include "planning/seams/start_count.hpp"
#include "planning/travel/space_travel.hpp"
#include "planning/travel/travel.hpp"
#include "planning/walls/infill_spacing.hpp"
#include "planning/walls/rising_wall.hpp"
#include "planning/walls/walls.hpp"
#include "run_path.hpp"
#include "skirt.hpp"

namespace lamina {
namespace {

bool laysBeads(const Path& path) { return path.role != PathRole::Travel && path.deposit == Deposit::Bead; }

/// Whether the first path of a layer goes on where the layer before ended.
bool continues(const ToolpathLayer& layer, const ToolpathLayer* before) {
  return before != nullptr && !before->paths.empty() && laysBeads(before->paths.back()) &&
         before->paths.back().lastPoint() == layer.paths.front().firstPoint();
}

std::size_t startsInAir(const ToolpathLayer& layer, bool continues, const SupportTest& support_test) {
  std::size_t count = 0;
  bool is_laying = continues;
  for (const Path& path : layer.paths) {
    const bool is_start = laysBeads(path) && !is_laying;
    if (is_start && !support_test.carries(path.firstPoint().head<2>())) ++count;
    is_laying = laysBeads(path);
  }
  return count;
}

/// How many runs of beads begin with neither bed nor the layer before below them. A run that goes on where
/// the one before ended does not begin.
/// @param layers    as sliced
/// @param toolpath  their plan, in the same frame
std::size_t countStartsInAir(const std::vector<Layer>& layers, const std::vector<ToolpathLayer>& toolpath,
                             const BedPlane& bed, double bead_width_mm) {
  std::vector<std::size_t> counts(layers.size(), 0);
  const auto count = [&](std::size_t i) {
    if (toolpath[i].paths.empty()) return;
    const SupportTest support_test(layers[i], i > 0 ? &layers[i - 1] : nullptr, bed,
                                   {bead_width_mm, layers[i].bounds.height()});
    counts[i] =
        startsInAir(toolpath[i], continues(toolpath[i], i > 0 ? &toolpath[i - 1] : nullptr), support_test);
  };
  NoProgress nobody;
  parallelFor(layers.size(), count, nobody, "plan");
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// What all layers of a plan share.
struct PlanContext {
  PlanSettings settings;
  InfillStrategy strategy;
  std::size_t layer_count = 0;
  Point2 anchor = Point2::Zero();  ///< of aligned seams; where each layer's ordering starts [mm]
  std::optional<BedPlane> bed;     ///< below inclined layers
  LayerLift lift;                  ///< of layers planned in a plan; none of those planned where they are
};

/// A layer and the one it is laid on, if there is one.
struct StackedLayer {
  const Layer* layer = nullptr;
  const Layer* below = nullptr;
};

/// The paths of one layer.
struct PlannedLayer {
  ToolpathLayer layer;
  double unprinted_mm2 = 0.0;  ///< of what gets no bead or drop
  Refilling refilling;
  FillStarts starts;
  std::size_t moved_starts = 0;  ///< see `AnchoredStarts`
  double left_out_mm3 = 0.0;     ///< see `LiftedLayer`
};

constexpr double kEquallyNear = 1e-6;  // mm: rounding of rotations

/// The point of a layer's contours that is nearest to the bed; of several within 1e-6 mm the first along x,
/// then along y. None of an empty layer.
std::optional<Point2> bedSide(const Layer& layer, const BedPlane& bed) {
  const auto height = [&](const Point2& point) {
    return bed.heightOf({point.x(), point.y(), layer.bounds.top_mm});
  };
  double lowest = std::numeric_limits<double>::infinity();
  for (const Polygon& contour : layer.section.contours)
    for (const Point2& point : contour) lowest = std::min(lowest, height(point));
  std::optional<Point2> side;
  for (const Polygon& contour : layer.section.contours)
    for (const Point2& point : contour)
      if (height(point) <= lowest + kEquallyNear &&
          (!side || std::make_pair(point.x(), point.y()) < std::make_pair(side->x(), side->y())))
        side = point;
  return side;
}

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

bool isAnchored(const PlanContext& context) {
  return context.bed && context.settings.anchoring.strategy == Anchoring::SupportedStart;
}

/// Where the nozzle begins: an inclined layer at the bed.
Point2 anchorOf(const Layer& layer, const PlanContext& context) {
  if (!isAnchored(context)) return context.anchor;
  return bedSide(layer, *context.bed).value_or(context.anchor);
}

class LayerPlanner {
 public:
  LayerPlanner(const StackedLayer& stacked, std::size_t index, const PlanContext& context)
      : context_(context),
        settings_(context.settings),
        index_(index),
        nozzle_(anchorOf(*stacked.layer, context)),
        seam_(settings_.seam, nozzle_, index),
        top_(stacked.layer->bounds.top_mm) {
    const Layer& layer = *stacked.layer;
    if (isAnchored(context))
      support_test_.emplace(layer, stacked.below, *context.bed,
                            Bead{settings_.bead.width_mm, layer.bounds.height()});
    result_.z_mm = layer.bounds.top_mm;
    result_.height_mm = layer.bounds.height();
    bead_ = {settings_.bead.width_mm, result_.height_mm};
    pitch_ = settings_.bead.pitch_mm > 0.0 ? settings_.bead.pitch_mm : planWidth(bead_);
    infill_ = infillSpacing(settings_.infill, pitch_, {index, context.layer_count});
  }

  /// Once only.
  PlannedLayer plan(const std::vector<Polygon>& contours) {
    const Regions material = unite(simplify(contours, settings_.simplification_mm));
    if (index_ == 0 && !laysDrops() && !context_.bed)
      for (Polygon& loop : makeSkirt(material, settings_)) addLoop(std::move(loop), PathRole::Skirt);
    if (laysDrops()) requireFewDrops(material, settings_.fill.drops);
    std::vector<RunEnds> islands;
    for (const Region& island : material) {
      const Polygon outline = seam_.placed(island.outer);
      islands.push_back({outline.front(), outline.front()});
    }
    for (const OrderedRun& next : orderRuns(islands, nozzle_)) {
      const Region& island = material[next.run];
      island_ = next.run;
      is_in_island_ = true;
      const std::size_t before = result_.paths.size();
      const double unprinted = addIsland(island);
      unprinted_mm2_ += result_.paths.size() > before ? unprinted : area({island});
    }
    is_in_island_ = false;
    if (settings_.voids.refill == VoidRefill::Beads && isFilledByBeads()) refillVoids(material);
    return {std::move(result_), unprinted_mm2_, refilling_, starts_, moved_starts_, 0.0};
  }

  /// What is being planned, for messages.
  std::string place() const {
    return layerPlace(index_, top_) + (is_in_island_ ? ", island " + std::to_string(island_) : "");
  }

 private:
  bool laysDrops() const { return context_.strategy.deposit == Deposit::Drops; }
  /// A vase is hollow.
  bool isFilledByBeads() const { return !laysDrops() && context_.strategy.link != LayerLink::Rising; }

  /// A sparse fill runs into the walls rather than ending at them.
  WallContact contact() const {
    const WallContact contact = context_.strategy.contact;
    return contact == WallContact::Fitted && !isSolid(infill_) ? WallContact::Overlapping : contact;
  }

  /// @return area [mm²] that gets no bead
  double addIsland(const Region& island) {
    if (laysDrops()) {
      addInfill({island});
      return 0.0;
    }
    Walls walls = makeWalls({island}, settings_, pitch_, contact());
    const std::size_t count = walls.walls.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = settings_.walls.order == WallOrder::OutsideIn ? i : count - 1 - i;
      addWall(walls.walls[k].centre_lines, k == 0 ? PathRole::OuterWall : PathRole::InnerWall);
      addShortest(std::move(walls.walls[k].thin), {});
    }
    const std::size_t before = result_.paths.size();
    if (infill_.spacing_mm > 0.0) addInfill(infillArea(walls.infill));
    starts_ += startsOf(walls.infill, fillsSince(before), pitch_);
    addShortest(std::move(walls.narrow_infill), {});
    if (!isSolid(infill_)) sparse_.insert(sparse_.end(), walls.infill.begin(), walls.infill.end());
    return walls.unprinted_mm2 + (isSolid(infill_) ? areaMissed(walls.infill, before) : 0.0);
  }

  /// Area [mm²] of those regions into which none of the paths goes that were deposited since there were so
  /// many.
  double areaMissed(const Regions& regions, std::size_t before) const {
    if (regions.size() == 1 && result_.paths.size() > before) return 0.0;
    double missed = 0.0;
    for (const Region& region : regions) {
      const std::vector<Polygon> borders = outlines({region});
      const auto goesInside = [&](const Path& path) {
        return path.role != PathRole::Travel &&
               std::any_of(path.points.begin(), path.points.end(),
                           [&](const Point3& point) { return contains(borders, point.head<2>()); });
      };
      if (std::none_of(result_.paths.begin() + static_cast<std::ptrdiff_t>(before), result_.paths.end(),
                       goesInside))
        missed += area({region});
    }
    return missed;
  }

  /// Ends of the runs of infill deposited since there were so many paths.
  std::vector<RunEnds> fillsSince(std::size_t before) const {
    std::vector<RunEnds> ends;
    for (std::size_t i = before; i < result_.paths.size(); ++i) {
      const Path& path = result_.paths[i];
      if (path.role == PathRole::Infill || path.role == PathRole::GapFill)
        ends.push_back({path.firstPoint().head<2>(), path.lastPoint().head<2>()});
    }
    return ends;
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

  /// Without walls the outermost lines lie as for beads that fill their pitch: the part would grow or shrink.
  Regions infillArea(const Regions& inside) const {
    const double beyond = infill_.pitch_mm - pitch_;
    if (settings_.walls.count > 0 || beyond == 0.0) return inside;
    return offset(inside, 0.5 * beyond);
  }

  void addInfill(const Regions& area) {
    if (area.empty()) return;
    const SmoothingSettings& smoothing = settings_.fill.smoothing;
    std::vector<FillPath> fills = context_.strategy.fill(area, infillRequest());
    for (FillPath& fill : fills) {
      fill = simplified(smoothed(std::move(fill), smoothing), smoothing.tolerance_mm);
      for (double& width : fill.width_mm) width *= pitch_ / infill_.pitch_mm;
    }
    if (context_.strategy.order == RunOrder::AsGiven) {
      for (const FillPath& fill : fills) addFill(fill, area);
      return;
    }
    addShortest(std::move(fills), area);
  }

  /// @param area  over which travels need not be retracted
  void addShortest(std::vector<FillPath> runs, const Regions& area) {
    std::vector<RunEnds> ends;
    ends.reserve(runs.size());
    for (const FillPath& run : runs) ends.push_back({run.points.front(), lastPoint(run)});
    for (const OrderedRun& next : orderRuns(ends, nozzle_))
      addFill(next.is_reversed ? reversed(std::move(runs[next.run])) : runs[next.run], area);
  }

  /// What a sparse infill leaves open stays so.
  void refillVoids(const Regions& material) {
    RefillSettings settings;
    settings.least_area = settings_.voids.least_area;
    const Regions solid = isSolid(infill_) ? material : difference(material, sparse_);
    const std::size_t before = result_.paths.size();
    addShortest(refill(findVoids(solid, result_, {}), settings), material);
    for (std::size_t i = before; i < result_.paths.size(); ++i) {
      const Path& path = result_.paths[i];
      if (path.role == PathRole::Travel) continue;
      ++refilling_.runs;
      refilling_.deposited_mm3 += depositedVolume(path);
    }
  }

  InfillRequest infillRequest() const {
    const InfillSettings& infill = settings_.infill;
    InfillRequest request;
    request.pitch_mm = infill_.pitch_mm;
    request.spacing_mm = infill_.spacing_mm;
    const double turn = infill.alternation_deg * static_cast<double>(index_);
    request.angle_rad = std::fmod(infill.angle_deg + turn, 360.0) * M_PI / 180.0;
    request.turn_rad = std::fmod(turn, 360.0) * M_PI / 180.0;
    request.start = nozzle_;
    request.layer = index_;
    request.island = island_;
    request.settings = settings_.fill;
    return request;
  }

  void addFill(const FillPath& fill, const Regions& area) {
    const bool is_inside = staysInside(area, nozzle_, fill.points.front());
    addRun(fill, is_inside ? TravelOver::Infill : TravelOver::Anything);
  }

  void addLoop(Polygon loop, PathRole role) {
    addRun({std::move(loop), true, role, Deposit::Bead, {}}, TravelOver::Anything);
  }

  void addRun(const FillPath& run, TravelOver over) {
    if (!support_test_) return layRun(run, over);
    const std::vector<FillPath> parts =
        anchored(run, [this](const Point2& point) { return support_test_->carries(point); });
    const bool is_moved = parts.front().points.front() != run.points.front();
    if (is_moved) ++moved_starts_;
    for (const FillPath& part : parts) layRun(part, is_moved ? TravelOver::Anything : over);
  }

  void layRun(const FillPath& run, TravelOver over) {
    const double feed = feedOf(run.role, settings_.feed);
    Path path = pathAlong(run, beadOf(run), top_,
                          index_ == 0 ? std::min(feed, settings_.feed.first_layer_mm_s) : feed);
    if (!result_.paths.empty()) addTravelTo(path.firstPoint(), over);
    nozzle_ = path.lastPoint().head<2>();
    result_.paths.push_back(std::move(path));
  }

  AlongPath<Bead> beadOf(const FillPath& run) const {
    if (run.deposit == Deposit::Drops) return Bead{settings_.fill.drops.diameter_mm, result_.height_mm};
    if (run.width_mm.empty()) return bead_;
    return beadsOf(run.width_mm, crossSection(bead_) / pitch_, result_.height_mm);
  }

  void addTravelTo(const Point3& point, TravelOver over) {
    std::optional<Path> travel = makeTravel(result_.paths.back().lastPoint(), point, settings_.travel, over);
    if (travel) result_.paths.push_back(std::move(*travel));
  }

  const PlanContext& context_;
  const PlanSettings& settings_;
  std::size_t index_;
  std::size_t island_ = 0;
  bool is_in_island_ = false;
  Point2 nozzle_;
  Seam seam_;
  double top_;
  std::optional<SupportTest> support_test_;  ///< of runs that are to be anchored
  std::size_t moved_starts_ = 0;
  Bead bead_;           ///< nominal
  double pitch_ = 0.0;  ///< between neighbouring beads [mm]
  InfillSpacing infill_;
  double unprinted_mm2_ = 0.0;
  Refilling refilling_;
  FillStarts starts_;
  Regions sparse_;  ///< what the infill of all islands does not fill
  ToolpathLayer result_;
};

/// The paths of one layer, in order and joined by travels. Depends on nothing but its arguments, so that
/// layers can be planned side by side. An inclined layer is begun at the bed, and its runs are anchored on
/// the layer before.
/// @param index  of the layer, from 0: turns the infill, and 0 has the skirt
PlannedLayer planLayer(const StackedLayer& stacked, std::size_t index, const PlanContext& context) {
  LayerPlanner planner(stacked, index, context);
  try {
    return planner.plan(stacked.layer->section.contours);
  } catch (...) {
    rethrowAt(planner.place());
  }
}

PlanContext contextFor(const std::vector<Layer>& layers, const PlanSettings& settings) {
  PlanContext context;
  context.settings = settings;
  context.layer_count = layers.size();
  context.strategy = infillStrategy(settings.infill.strategy);
  SettingsSchema schema;
  describe(schema, context.settings);
  schema.validate();
  requireConsistent(settings);
  if (context.strategy.deposit == Deposit::Bead)
    for (const Layer& layer : layers) requireSensiblePitch(settings.bead, layer.bounds.height());
  for (const Layer& layer : layers) {
    const Box2 box = boundingBox(layer.section.contours);
    if (box.isEmpty()) continue;
    context.anchor = box.low;
    break;
  }
  return context;
}

bool isVase(const PlanContext& context) { return context.strategy.link == LayerLink::Rising; }

std::size_t baseLayers(const PlanContext& context) {
  return isVase(context) ? static_cast<std::size_t>(context.settings.fill.vase.base_layers) : 0;
}

/// Of layers without base: a vase is its own wall.
PlanContext wallContext(PlanContext context) {
  if (!isVase(context)) return context;
  context.settings.walls.count = 0;
  context.settings.infill.density = 1.0;
  return context;
}

/// Of base layers: solid inside one wall.
PlanContext baseContext(PlanContext context) {
  context.strategy = infillStrategy(context.settings.fill.vase.base_strategy);
  context.settings.walls.count = 1;
  context.settings.infill.density = 1.0;
  return context;
}

/// Layers are planned apart from each other; only here does each learn where the nozzle comes from.
void joinLayers(std::vector<ToolpathLayer>& layers, const TravelMaker& travel_between) {
  const Path* previous = nullptr;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    std::vector<Path>& paths = layers[i].paths;
    if (paths.empty()) continue;
    if (previous != nullptr) {
      std::optional<Path> travel = travel_between(*previous, paths.front(), i);
      if (travel) paths.insert(paths.begin(), std::move(*travel));
    }
    previous = &paths.back();
  }
}

/// Where a chain of layers starts. On lifted ones the planner's anchor is a place of the plan.
Point3 chainAnchor(const std::vector<ToolpathLayer>& layers, const PlanContext& context) {
  if (context.lift)
    for (const ToolpathLayer& layer : layers)
      if (!layer.paths.empty()) return layer.paths.front().firstPoint();
  return {context.anchor.x(), context.anchor.y(), layers.empty() ? 0.0 : layers.front().z_mm};
}

Plan inOne(std::vector<PlannedLayer> planned) {
  Plan plan;
  plan.toolpath.layers.reserve(planned.size());
  for (PlannedLayer& each : planned) {
    plan.unprinted_mm3 += each.unprinted_mm2 * each.layer.height_mm + each.left_out_mm3;
    plan.refilling.runs += each.refilling.runs;
    plan.refilling.deposited_mm3 += each.refilling.deposited_mm3;
    plan.starts += each.starts;
    plan.anchored.moved += each.moved_starts;
    plan.toolpath.layers.push_back(std::move(each.layer));
  }
  return plan;
}

StackedLayer stackedAt(const std::vector<Layer>& layers, std::size_t index) {
  return {&layers[index], index > 0 ? &layers[index - 1] : nullptr};
}

/// An inclined layer far out on a belt is planned near the origin.
PlannedLayer planAnywhere(const StackedLayer& stacked, std::size_t index, const PlanContext& context) {
  const Point2 away = context.bed ? distanceFromOrigin(*stacked.layer) : Point2(Point2::Zero());
  if (away.isZero()) return planLayer(stacked, index, context);
  const Layer layer = moved(*stacked.layer, -away);
  const Layer below = stacked.below != nullptr ? moved(*stacked.below, -away) : Layer{};
  PlanContext near = context;
  near.anchor -= away;
  near.bed->level_mm -= near.bed->up.head<2>().dot(away);
  PlannedLayer planned = planLayer({&layer, stacked.below != nullptr ? &below : nullptr}, index, near);
  for (Path& path : planned.layer.paths)
    for (Point3& point : path.points) point.head<2>() += away;
  return planned;
}

/// Brings a layer that was planned in a plan to where it is deposited.
void liftLayer(PlannedLayer& planned, std::size_t index, const LayerLift& lift) {
  const double top_mm = planned.layer.z_mm;
  try {
    LiftedLayer lifted = lift(index, std::move(planned.layer));
    planned.layer = std::move(lifted.layer);
    planned.left_out_mm3 = lifted.left_out_mm3;
  } catch (...) {
    rethrowAt(layerPlace(index, top_mm));
  }
}

Plan planInContext(const std::vector<Layer>& layers, const PlanContext& of_settings, Progress& progress) {
  const PlanContext context = wallContext(of_settings);
  const std::size_t base_layers = baseLayers(context);
  const PlanContext base = baseContext(context);
  std::vector<PlannedLayer> planned(layers.size());
  parallelFor(
      layers.size(),
      [&](std::size_t i) {
        planned[i] = planAnywhere(stackedAt(layers, i), i, i < base_layers ? base : context);
        if (context.lift) liftLayer(planned[i], i, context.lift);
      },
      progress, "plan");
  Plan plan = inOne(std::move(planned));
  std::vector<ToolpathLayer>& paths = plan.toolpath.layers;
  const TravelSettings& travel_settings = of_settings.settings.travel;
  const TravelMaker travel =
      context.lift ? spaceTravels(paths, travel_settings) : levelTravels(travel_settings);
  if (context.strategy.link == LayerLink::Chained)
    chainLayers(paths, of_settings.settings, chainAnchor(paths, context), travel);
  if (isVase(context)) raiseWall(paths, base_layers, travel_settings);
  joinLayers(paths, travel);
  if (context.bed)
    plan.anchored.in_air = countStartsInAir(layers, paths, *context.bed, of_settings.settings.bead.width_mm);
  return plan;
}

}  // namespace

Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              Progress& progress) {
  Plan plan = planInContext(layers, contextFor(layers, settings), progress);
  plan.toolpath.part_name = part_name;
  return plan;
}

Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const BedPlane& bed, Progress& progress) {
  PlanContext context = contextFor(layers, settings);
  context.bed = bed;
  Plan plan = planInContext(layers, context, progress);
  plan.toolpath.part_name = part_name;
  return plan;
}

Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerLift& lift, Progress& progress) {
  PlanContext context = contextFor(layers, settings);
  if (isVase(context))
    throw InvalidConfig("infill.strategy is '" + settings.infill.strategy +
                        "', which rises from one level layer to the next; curved layers need another");
  context.settings.skirt.count = 0;
  context.lift = lift;
  Plan plan = planInContext(layers, context, progress);
  plan.toolpath.part_name = part_name;
  return plan;
}

Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress) {
  return planPart(part_name, layers, settings, progress).toolpath;
}

}  // namespace lamina
