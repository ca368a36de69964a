// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/planner.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/plan_consistency.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/adhesion/foot_brim.hpp"
#include "planning/compensation/first_layer.hpp"
#include "planning/layer_planner.hpp"
#include "planning/left_open.hpp"
#include "planning/order/layer_chain.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/order/standing.hpp"
#include "planning/order/starts_in_air.hpp"
#include "planning/planned_aids.hpp"
#include "planning/skins/roof_branches.hpp"
#include "planning/skins/stack_covers.hpp"
#include "planning/supports/laid_supports.hpp"
#include "planning/supports/layers_below.hpp"
#include "planning/tools/tool_beads.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/space_travel.hpp"
#include "planning/travel/travel.hpp"
#include "planning/travel/wipes.hpp"
#include "planning/walls/rising_wall.hpp"

namespace lamina {
namespace {

/// Whether a fill lays the rim of the part itself, in runs that go on along it. Threads would cut them.
bool laysRim(const PlanContext& context) {
  return context.settings.walls.count == 0 && context.strategy.deposit == Deposit::Bead &&
         context.strategy.contact == WallContact::Beside;
}

PlanContext contextFor(const std::vector<Layer>& layers, const PlanSettings& settings) {
  PlanContext context;
  context.settings = settings;
  context.layer_count = layers.size();
  context.strategy = infillStrategy(settings.infill.strategy);
  context.skin_strategy = infillStrategy(settings.skins.strategy);
  SettingsSchema schema;
  describe(schema, context.settings);
  schema.validate();
  requireConsistent(settings);
  if (settings.travel.hop == Hopping::Never) context.settings.travel.hop_mm = 0.0;
  if (laysRim(context)) context.settings.bridges.is_used = false;
  if (context.strategy.deposit == Deposit::Bead)
    for (const Layer& layer : layers) {
      requireSensiblePitch(settings.bead, layer.bounds.height());
      requireSensibleWidths(settings, layer.bounds.height());
    }
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

/// Of layers whose sides are seen, where the planner does not know what lies above and below them.
PlanContext skinContext(PlanContext context) {
  if (isSolid(context.settings.infill)) return context;
  context.strategy = context.skin_strategy;
  context.settings.infill.strategy = context.settings.skins.strategy;
  context.settings.infill.density = 1.0;
  context.settings.infill.pitch_mm = 0.0;
  return context;
}

/// Of the first layer.
PlanContext bedContext(PlanContext context) {
  context.settings = onBed(std::move(context.settings));
  return context;
}

/// The next layer is above every skin of this one.
TravelSettings betweenLayers(TravelSettings settings) {
  if (settings.hop == Hopping::OverSkin) settings.hop_mm = 0.0;
  return settings;
}

/// Layers are planned apart from each other; only here does each learn where the nozzle comes from.
void joinLayers(std::vector<ToolpathLayer>& layers, const TravelMaker& travel_between) {
  const Path* previous = nullptr;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    std::vector<Path>& paths = layers[i].paths;
    if (paths.empty()) continue;
    if (previous != nullptr) {
      std::optional<Path> travel = travel_between(*previous, paths.front(), i);
      if (travel) travel->process.is_retracted |= previous->tool != paths.front().tool;
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
    plan.bridging += each.bridging;
    plan.left_open += each.left_open;
    plan.toolpath.layers.push_back(std::move(each.layer));
  }
  return plan;
}

/// What is known of a stack before its layers are planned apart from each other.
struct StackCover {
  std::vector<LayerCover> covers;               ///< none without skins, bridges and overhanging walls
  std::vector<std::vector<Polyline>> branches;  ///< none for a fill that does not grow
  std::vector<InfillGroup> groups;              ///< none where each layer has an infill of its own
};

/// @return null where nothing is known of what covers the layer
const LayerCover* coverAt(const StackCover& stack, std::size_t index) {
  return stack.covers.empty() || !stack.covers[index].material ? nullptr : &stack.covers[index];
}

/// A variant and what it is planned by.
struct VariantPlan {
  const std::vector<Regions>& areas;
  PlanContext context;
  PlanContext on_bed;  ///< of the first layer
  StackCover stack;
};

LayerVariant variantAt(const VariantPlan& plan, std::size_t index) {
  LayerVariant variant;
  variant.context = index == 0 ? &plan.on_bed : &plan.context;
  variant.cover = coverAt(plan.stack, index);
  if (index > 0) variant.cover_below = coverAt(plan.stack, index - 1);
  if (!plan.stack.branches.empty()) variant.branches = &plan.stack.branches[index];
  variant.area = &plan.areas[index];
  return variant;
}

/// With room for the travel to the layer and no more: all layers are held at once.
void takeRoomNeeded(std::vector<Path>& paths) {
  std::vector<Path> exact;
  exact.reserve(paths.size() + 1);
  std::move(paths.begin(), paths.end(), std::back_inserter(exact));
  paths = std::move(exact);
}

/// What the layers of a plan are planned from.
struct StackPlan {
  StackCover stack;
  PlannedAids aids;
  std::vector<VariantPlan> variants;
};

/// Gives back what a layer is planned from once all that look at it are planned: it, and the one above. The
/// toolpath, which grows meanwhile, takes its place in memory.
class StackRelease {
 public:
  /// @param layers  null if they are needed further
  StackRelease(StackPlan& plan, std::vector<Layer>* layers, std::size_t count)
      : plan_(plan), layers_(layers), left_(count) {
    for (std::atomic<int>& each : left_) each = 2;
    if (!left_.empty()) left_.back() = 1;
  }
  /// From any thread, once for each layer.
  void layerIsPlanned(std::size_t index) {
    if (!plan_.stack.branches.empty()) plan_.stack.branches[index] = std::vector<Polyline>();
    if (!plan_.stack.groups.empty()) plan_.stack.groups[index] = InfillGroup();
    drop(index);
    if (index > 0) drop(index - 1);
  }

 private:
  void drop(std::size_t index) {
    if (--left_[index] > 0) return;
    if (!plan_.stack.covers.empty()) plan_.stack.covers[index] = LayerCover();
    if (layers_ != nullptr) (*layers_)[index].section = Section();
  }

  StackPlan& plan_;
  std::vector<Layer>* layers_;
  std::vector<std::atomic<int>> left_;  ///< layers that are yet to look at it
};

StackedLayer stackedAt(const std::vector<Layer>& layers, const StackPlan& plan, std::size_t index) {
  StackedLayer stacked;
  stacked.layer = &layers[index];
  if (index > 0) stacked.below = &layers[index - 1];
  stacked.cover = coverAt(plan.stack, index);
  if (index > 0) stacked.cover_below = coverAt(plan.stack, index - 1);
  if (!plan.stack.branches.empty()) stacked.branches = &plan.stack.branches[index];
  if (!plan.stack.groups.empty()) stacked.group = &plan.stack.groups[index];
  if (!plan.aids.layers.empty()) stacked.aids = &plan.aids.layers[index];
  if (!plan.aids.carrying.empty()) stacked.supports = &plan.aids.carrying[index];
  for (const VariantPlan& variant : plan.variants)
    if (!variant.areas[index].empty()) stacked.variants.push_back(variantAt(variant, index));
  return stacked;
}

/// Whether layers are planned where they are, of beads that stay in their layer.
bool laysWithinLayers(const PlanContext& context) {
  return !context.lift && !isVase(context) && context.strategy.deposit == Deposit::Bead &&
         context.strategy.link == LayerLink::Travel;
}

/// Skins are for walls with an infill that stays in its layer, be it sparse or solid lines between them.
bool takesCovers(const PlanContext& context) {
  const PlanSettings& settings = context.settings;
  const bool takes_skins = hasSkins(settings.skins) &&
                           (!isSolid(settings.infill) || context.strategy.contact == WallContact::Fitted);
  return (takes_skins || settings.ironing.is_used || settings.bridges.is_used || settings.overhangs.is_used ||
          settings.infill.every_layers > 1) &&
         laysWithinLayers(context);
}

StackCover stackCover(const std::vector<Layer>& layers, const PlanContext& context, Progress& progress) {
  if (!takesCovers(context)) return {};
  const StackPlace place = context.bed ? StackPlace::AlongBelt : StackPlace::NearOrigin;
  StackCover stack;
  stack.covers = stackCovers(layers, context.settings, place, progress);
  if (isSolid(context.settings.infill)) return stack;
  std::vector<double> heights_mm;
  heights_mm.reserve(layers.size());
  for (const Layer& layer : layers) heights_mm.push_back(layer.bounds.height());
  stack.groups = infillGroups(stack.covers, heights_mm, context.settings, place, progress);
  if (context.strategy.growth != FillGrowth::FromAbove) return stack;
  stack.branches = branchesUnderSkins(stack.covers, heights_mm, context.settings, place, progress);
  return stack;
}

std::vector<Polyline> moved(std::vector<Polyline> lines, const Point2& by) {
  for (Polyline& line : lines)
    for (Point2& point : line) point += by;
  return lines;
}

/// Only fills of beads, each within its layer, can lie beside each other.
void requireBeadsInLayers(const PlanContext& context) {
  if (context.strategy.deposit == Deposit::Bead && context.strategy.link == LayerLink::Travel) return;
  throw InvalidConfig("infill.strategy is '" + context.settings.infill.strategy +
                      "' in a part of which regions have settings of their own; expected one that lays beads "
                      "within each layer");
}

/// What is refilled is measured as all of a layer is deposited at one flow.
void requireFlowFor(VoidRefill refill, double flow_of_region, double flow) {
  if (refill == VoidRefill::None || flow_of_region == flow) return;
  throw InvalidConfig("bead.flow is " + numberText(flow_of_region) + " in a region and " + numberText(flow) +
                      " elsewhere, with voids.refill 'beads'; expected the same, or voids.refill 'none'");
}

/// Walls go on from region to region, of one width.
void requireSameNozzle(const ToolSettings& of_region, const ToolSettings& of_part) {
  const double share =
      nozzleShare({toolFor(PathRole::OuterWall, of_region), toolFor(PathRole::OuterWall, of_part)}, of_part);
  if (share == 1.0) return;
  throw InvalidConfig("tool.walls is " + std::to_string(of_region.walls) + " in a region and " +
                      std::to_string(of_part.walls) + " elsewhere, whose nozzle_mm is " +
                      numberText(1.0 / share) + " times as wide; expected tools of the same nozzle_mm");
}

/// The groups of layers of one region end within those of another.
void requireInfillInEachLayer(const InfillSettings& infill) {
  if (infill.every_layers == 1) return;
  throw InvalidConfig("infill.every_layers is " + std::to_string(infill.every_layers) +
                      " in a part of which regions have settings of their own; expected 1");
}

std::vector<VariantPlan> variantPlans(const std::vector<Layer>& layers,
                                      const std::vector<PlanVariant>& variants, const PlanContext& plan,
                                      Progress& progress) {
  std::vector<VariantPlan> plans;
  if (!variants.empty()) requireBeadsInLayers(plan);
  if (!variants.empty()) requireInfillInEachLayer(plan.settings.infill);
  for (const PlanVariant& variant : variants) {
    PlanContext context = contextFor(layers, variant.settings);
    requireBeadsInLayers(context);
    requireFlowFor(plan.settings.voids.refill, context.settings.bead.flow, plan.settings.bead.flow);
    requireInfillInEachLayer(context.settings.infill);
    requireSameNozzle(context.settings.tools, plan.settings.tools);
    StackCover stack = stackCover(layers, context, progress);
    PlanContext on_bed = bedContext(context);
    plans.push_back({variant.areas, std::move(context), std::move(on_bed), std::move(stack)});
  }
  return plans;
}

/// Of a layer without part, that of its supports.
Point2 distanceOf(const StackedLayer& stacked) {
  Layer layer{stacked.layer->bounds, {}};
  if (!stacked.layer->section.contours.empty() || stacked.aids == nullptr)
    return distanceFromOrigin(*stacked.layer);
  for (const AidRuns& aids : *stacked.aids)
    for (const FillPath& run : *aids.runs) layer.section.contours.push_back(run.points);
  return distanceFromOrigin(layer);
}

/// An inclined layer far out on a belt is planned near the origin.
PlannedLayer planAnywhere(const StackedLayer& stacked, std::size_t index, const PlanContext& context) {
  const Point2 away = context.bed ? distanceOf(stacked) : Point2(Point2::Zero());
  if (away.isZero()) return planLayer(stacked, index, context);
  const Layer layer = moved(*stacked.layer, -away);
  const Layer below = stacked.below != nullptr ? moved(*stacked.below, -away) : Layer{};
  PlanContext near = context;
  near.anchor -= away;
  near.part_from_layers.translate(Point3(away.x(), away.y(), 0.0));
  near.bed->level_mm -= near.bed->up.head<2>().dot(away);
  const LayerCover cover = stacked.cover != nullptr ? moved(*stacked.cover, -away) : LayerCover{};
  const LayerCover cover_below =
      stacked.cover_below != nullptr ? moved(*stacked.cover_below, -away) : LayerCover{};
  const std::vector<Polyline> branches =
      stacked.branches != nullptr ? moved(*stacked.branches, -away) : std::vector<Polyline>{};
  const InfillGroup group = stacked.group != nullptr ? moved(*stacked.group, -away) : InfillGroup{};
  const LayerAids aids = stacked.aids != nullptr ? moved(*stacked.aids, -away) : LayerAids{};
  const Regions supports = stacked.supports != nullptr ? moved(*stacked.supports, -away) : Regions{};
  PlannedLayer planned = planLayer(
      {&layer, stacked.below != nullptr ? &below : nullptr, stacked.cover != nullptr ? &cover : nullptr,
       stacked.cover_below != nullptr ? &cover_below : nullptr,
       stacked.branches != nullptr ? &branches : nullptr, stacked.group != nullptr ? &group : nullptr,
       stacked.aids != nullptr ? &aids : nullptr, stacked.supports != nullptr ? &supports : nullptr},
      index, near);
  for (Path& path : planned.layer.paths)
    for (Point3& point : path.points) point.head<2>() += away;
  return planned;
}

PlannedLayer planMeasured(const StackedLayer& stacked, std::size_t index, const PlanContext& context) {
  PlannedLayer planned = planAnywhere(stacked, index, context);
  planned.left_open = leftOpenIn(stacked, planned.layer, index, context);
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

/// Below the layers of the part, whose coordinates stay.
void putOnRaft(Plan& plan, const PlannedAids& aids, const PlanContext& context, Progress& progress) {
  std::vector<ToolpathLayer> raft(aids.raft.size());
  const auto plan_layer = [&](std::size_t i) {
    const Layer layer{aids.raft[i].bounds, {}};
    StackedLayer stacked;
    stacked.layer = &layer;
    stacked.aids = &aids.raft[i].aids;
    raft[i] = planLayer(stacked, i, context).layer;
  };
  parallelFor(raft.size(), plan_layer, progress, "plan");
  plan.raft_mm = aids.raft_mm;
  std::vector<ToolpathLayer>& layers = plan.toolpath.layers;
  layers.insert(layers.begin(), std::make_move_iterator(raft.begin()), std::make_move_iterator(raft.end()));
}

/// @throws InvalidConfig if there is to be a prime tower over layers that are not level
void requireTower(const PlanContext& context) {
  const std::vector<double>& purge_mm3 = context.settings.tools.purge_mm3;
  if (purge_mm3.empty() || (!context.bed && !context.lift)) return;
  throw InvalidConfig("tools.purge_mm3 is " + numberText(purge_mm3.front()) + " mm3 for " +
                      std::string(context.bed ? "inclined" : "curved") +
                      " layers; expected none: a prime tower stands on level ones");
}

/// Settings and marks of regions of a part; none if null.
struct PlanRegions {
  const std::vector<PlanVariant>* variants = nullptr;
  const SupportMarks* marks = nullptr;
  const std::vector<Regions>* seams = nullptr;
  std::vector<Layer>* spent = nullptr;   ///< the layers, of which no section is needed once it is planned
  std::optional<PlannedAids> aids = {};  ///< if they are planned already
  std::vector<LayerCover> covers = {};   ///< of lifted layers (`LayerLifting::covers`)
};

bool usesTools(const PlanContext& context, const PlanRegions& regions) {
  const auto uses = [](const PlanVariant& variant) { return usesTools(variant.settings); };
  return usesTools(context.settings) ||
         (regions.variants != nullptr &&
          std::any_of(regions.variants->begin(), regions.variants->end(), uses));
}

/// Lays layers tool by tool.
void arrangeByTools(std::vector<ToolpathLayer>& layers, const PlanContext& context,
                    const TravelMaker& travel) {
  requireTower(context);
  arrangeTools(layers, context.settings, travel);
}

/// A vase rises from its own base.
bool standsOnSupports(const PlanSettings& settings) {
  return settings.supports.use && infillStrategy(settings.infill.strategy).link != LayerLink::Rising;
}

/// What is planned of all layers together, with what is known of it taken out of the regions.
StackPlan stackPlan(const std::vector<Layer>& layers, const PlanContext& of_settings, PlanRegions& regions,
                    Progress& progress) {
  StackPlan plan;
  plan.stack = of_settings.lift ? StackCover{std::move(regions.covers), {}, {}}
                                : stackCover(layers, of_settings, progress);
  plan.aids = regions.aids ? std::move(*regions.aids)
                           : planAids(layers, of_settings, {regions.variants, regions.marks}, progress);
  if (regions.variants != nullptr)
    plan.variants = variantPlans(layers, *regions.variants, wallContext(of_settings), progress);
  return plan;
}

Plan planInContext(const std::vector<Layer>& layers, const PlanContext& of_settings, Progress& progress,
                   PlanRegions regions = {}) {
  const PlanContext context = wallContext(of_settings);
  StackPlan of_stack = stackPlan(layers, of_settings, regions, progress);
  const std::size_t base_layers = baseLayers(context);
  const PlanContext base = baseContext(context);
  const std::vector<bool>& is_skin = of_settings.is_skin;
  const PlanContext skin = is_skin.empty() ? PlanContext{} : skinContext(context);
  const auto contextAt = [&](std::size_t i) -> const PlanContext& {
    if (i < base_layers) return base;
    return i < is_skin.size() && is_skin[i] ? skin : context;
  };
  const PlanContext on_bed = bedContext(layers.empty() ? context : contextAt(0));
  std::vector<PlannedLayer> planned(layers.size());
  // Chains are laid within the sections when all layers are planned.
  const bool is_chained = context.strategy.link == LayerLink::Chained;
  StackRelease release(of_stack, is_chained ? nullptr : regions.spent, layers.size());
  parallelFor(
      layers.size(),
      [&](std::size_t i) {
        StackedLayer stacked = stackedAt(layers, of_stack, i);
        if (regions.seams != nullptr && i < regions.seams->size()) stacked.seams = &(*regions.seams)[i];
        planned[i] = planMeasured(stacked, i, i == 0 ? on_bed : contextAt(i));
        if (i == 0) scaleFlow(planned[i].layer, context.settings.first_layer.flow);
        if (context.lift) liftLayer(planned[i], i, context.lift);
        takeRoomNeeded(planned[i].layer.paths);
        release.layerIsPlanned(i);
      },
      progress, "plan");
  Plan plan = inOne(std::move(planned));
  plan.supports = of_stack.aids.supports;
  std::vector<ToolpathLayer>& paths = plan.toolpath.layers;
  const TravelSettings travel_settings = betweenLayers(of_settings.settings.travel);
  laySupports(paths, std::exchange(of_stack.aids.layers, {}),
              {of_settings.settings, on_bed.settings, travel_settings, context.anchor});
  const TravelMaker travel = context.lift ? spaceTravels(paths, travel_settings, of_settings.standing_mm)
                                          : levelTravels(travel_settings);
  const std::vector<Layer> nowhere;
  if (is_chained)
    chainLayers(paths, context.lift ? nowhere : layers, of_settings.settings, chainAnchor(paths, context),
                travel);
  if (isVase(context)) raiseWall(paths, base_layers, travel_settings);
  putOnRaft(plan, of_stack.aids, context, progress);
  if (usesTools(of_settings, regions)) arrangeByTools(paths, of_settings, travel);
  joinLayers(paths, travel);
  giveTravelsTools(paths);
  if (context.bed) {
    const CarriedLayers carried{layers, of_stack.aids.carrying, *context.bed,
                                of_settings.settings.bead.width_mm};
    const StartsInAir starts = startsInAir(carried, paths);
    plan.anchored.in_air = countOf(starts);
    if (of_settings.settings.anchoring.strategy == Anchoring::SupportedStart)
      requireStanding({carried, paths, starts}, of_settings.part_from_layers);
  }
  addWipes(paths, travel_settings);
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
              const Box2& bed, Progress& progress) {
  return planPart(part_name, layers, settings, VariedBed{bed, {}}, progress);
}

Plan planPart(const std::string& part_name, std::vector<Layer> layers, const PlanSettings& settings,
              const VariedBed& varied, Progress& progress) {
  PlanContext context = contextFor(layers, settings);
  context.level_bed = varied.bed;
  Plan plan =
      planInContext(layers, context, progress, {&varied.variants, varied.marks, varied.seams, &layers});
  plan.toolpath.part_name = part_name;
  return plan;
}

Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerIncline& incline, Progress& progress) {
  std::size_t below = countBrimLayersBelow(layers, incline.bed, settings.adhesion.brim);
  if (standsOnSupports(settings))
    below = std::max(below, countLayersBelow(layers, incline.bed, settings.supports));
  std::vector<Layer> stack = withLayersBelow(layers, below);
  PlanContext context = contextFor(stack, settings);
  context.bed = incline.bed;
  context.part_from_layers = incline.part_from_layers;
  PlanRegions regions;
  regions.aids = planAids(stack, context, {}, progress);
  dropEmptyBelow(stack, *regions.aids);
  context.layer_count = stack.size();
  Plan plan = planInContext(stack, context, progress, std::move(regions));
  plan.toolpath.part_name = part_name;
  return plan;
}

Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerLifting& lifting, Progress& progress) {
  PlanContext context = contextFor(layers, settings);
  if (isVase(context))
    throw InvalidConfig("infill.strategy is '" + settings.infill.strategy +
                        "', which rises from one level layer to the next; curved layers need another");
  context.settings.skirt.count = 0;
  context.settings.bridges.is_used = context.settings.overhangs.is_used = false;
  context.settings.ironing.is_used = false;
  context.lift = lifting.lift;
  context.is_skin = lifting.is_skin;
  context.standing_mm = lifting.standing_mm;
  PlanRegions regions;
  if (takesSkins(settings)) regions.covers = lifting.covers;
  Plan plan = planInContext(layers, context, progress, std::move(regions));
  plan.toolpath.part_name = part_name;
  return plan;
}

Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress) {
  return planPart(part_name, layers, settings, progress).toolpath;
}

}  // namespace lamina
