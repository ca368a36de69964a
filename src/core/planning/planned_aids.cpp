// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/planned_aids.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "geometry/polygon/region_lists.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "planning/adhesion/brim.hpp"
#include "planning/adhesion/foot_brim.hpp"
#include "planning/adhesion/prime_line.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/skins/skin_areas.hpp"
#include "planning/skirt.hpp"
#include "planning/supports/branch_loops.hpp"
#include "planning/supports/branch_tips.hpp"
#include "planning/supports/layers_below.hpp"
#include "planning/supports/regional_overhangs.hpp"
#include "planning/supports/stacked_material.hpp"
#include "planning/supports/support_areas.hpp"
#include "planning/supports/support_lattice.hpp"
#include "planning/supports/support_tree.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

AidRuns runsOf(std::vector<FillPath> runs, const Bead& bead, double top_mm, RunOrder order) {
  AidRuns aids;
  aids.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
  aids.bead = bead;
  aids.top_mm = top_mm;
  aids.order = order;
  return aids;
}

Regions regionsOf(const LayerSupport& sections) {
  Regions all;
  for (const SupportSection& section : sections)
    for (const SharedRegions& regions : {section.lattice, section.interface})
      all.insert(all.end(), regions->begin(), regions->end());
  return all;
}

void cutOut(LayerSupport& sections, const Regions& taken) {
  for (SupportSection& section : sections)
    for (SharedRegions* const regions : {&section.lattice, &section.interface})
      *regions = std::make_shared<const Regions>(difference(**regions, taken));
}

/// Of which layers the aids are asked for, among those that decide of them.
struct AidWindow {
  LayerSpan asked;
  LatticePlace place;
};

/// Plans what stands beside the part, from its first layer out.
class AidPlanner {
 public:
  AidPlanner(const std::vector<Layer>& layers, const PlanContext& context,
             const SupportRegions& support_regions, const AidWindow& window)
      : layers_(layers),
        context_(context),
        settings_(context.settings),
        support_regions_(support_regions),
        window_(window) {
    first_ = unite(simplify(layers.front().section.contours, settings_.simplification_mm));
  }

  PlannedAids plan(Progress& progress) {
    planned_.layers.resize(layers_.size());
    supports_.layers.resize(layers_.size());
    if (settings_.supports.use) findSupports(progress);
    context_.bed ? addFootBrim() : addBrim();
    if (settings_.supports.use) addSupports(progress);
    if (context_.bed && settings_.supports.use) carryUp(progress);
    if (context_.bed) return std::move(planned_);
    addRaft();
    addSkirt();
    addPrimeLine();
    return std::move(planned_);
  }

 private:
  double layerHeight() const { return window_.place.layer_height_mm; }
  double width() const { return settings_.bead.width_mm; }
  WallBeads walls() const { return {width(), wallThickness(settings_, planWidth({width(), layerHeight()}))}; }

  void findSupports(Progress& progress) {
    const SupportSettings& settings = settings_.supports;
    const StackedMaterial stack =
        stackedMaterial(layers_, settings_.simplification_mm, context_.bed, progress);
    RegionalOverhangs overhangs =
        regionalOverhangs(stack, settings_, support_regions_, layerHeight(), progress);
    overhangs_ = std::move(overhangs.held);
    blocked_mm2_ = overhangs.blocked_mm2;
    if (settings.kind == SupportKind::Lattice)
      supports_ = supportAreas(stack, {overhangs_, window_.asked}, settings, walls(), progress);
    else
      tree_ = growBranches(stack, branchTips(stack, overhangs_, walls(), settings), settings, progress);
  }

  /// Supports stand on a brim's outer side, or on the brim.
  void addBrim() {
    const LayerBounds& bounds = layers_.front().bounds;
    const BrimSettings& settings = settings_.adhesion.brim;
    if (settings.width_mm == 0.0) return;
    const Bead bead = beadOf(PathRole::Brim, settings_, bounds.height()).bead;
    brim_ = makeBrim(first_, settings, planWidth(bead), context_.level_bed);
    if (brim_.runs.empty()) return;
    cutOut(supports_.layers.front(), brim_.area);
    const RunOrder order = settings.ears ? RunOrder::Shortest : RunOrder::AsGiven;
    planned_.layers.front().push_back(runsOf(std::move(brim_.runs), bead, bounds.top_mm, order));
  }

  /// On the bed beside inclined layers, where no support stands then.
  void addFootBrim() {
    const BrimSettings& settings = settings_.adhesion.brim;
    if (settings.width_mm == 0.0) return;
    const double width_mm = beadOf(PathRole::Brim, settings_, layerHeight()).bead.width_mm;
    std::vector<FootBrim> brims = footBrim(layers_, *context_.bed, settings, width_mm);
    for (std::size_t i = window_.asked.begin; i < window_.asked.end; ++i) {
      if (brims[i].runs.empty()) continue;
      cutOut(supports_.layers[i], brims[i].area);
      const LayerBounds& bounds = layers_[i].bounds;
      planned_.layers[i].push_back(
          runsOf(std::move(brims[i].runs), {width_mm, bounds.height()}, bounds.top_mm, RunOrder::Shortest));
    }
  }

  void addSupports(Progress& progress) {
    std::vector<LayerAids> supports;
    if (settings_.supports.kind == SupportKind::Lattice) {
      LatticePlace place = window_.place;
      place.variants = support_regions_.variants;
      supports = supportLattice(supports_.layers, settings_, place, progress);
      for (std::size_t i = 0; i < supports.size(); ++i)
        if (i < window_.asked.begin || i >= window_.asked.end) supports[i].clear();
      planned_.supports = supports_.totals;
      for (const LayerSupport& layer : supports_.layers) support_areas_.push_back(regionsOf(layer));
    } else {
      BranchLoops loops = branchLoops(tree_, brim_.area, settings_, progress);
      planned_.supports = branchTotals(overhangs_, tree_, loops, settings_.supports);
      supports = std::move(loops.layers);
      support_areas_ = std::move(loops.areas);
    }
    planned_.supports.blocked_mm2 = blocked_mm2_;
    addVolumes(planned_.supports, supports);
    for (std::size_t i = 0; i < supports.size(); ++i)
      std::move(supports[i].begin(), supports[i].end(), std::back_inserter(planned_.layers[i]));
  }

  /// A layer lies on what ends at most the gap above supports below it.
  void carryUp(Progress& progress) {
    const Point2 up = context_.bed->up.head<2>() / context_.bed->up.z();
    planned_.carrying.resize(layers_.size());
    const auto carry = [&](std::size_t i) {
      const LayerBounds& bounds = layers_[i].bounds;
      const double least_mm = bounds.bottom_mm - settings_.supports.top_gap_mm - bounds.height();
      for (std::size_t k = i; k-- > 0 && layers_[k].bounds.top_mm > least_mm;)
        appendTo(planned_.carrying[i],
                 moved(support_areas_[k], up * (bounds.top_mm - layers_[k].bounds.top_mm)));
    };
    parallelFor(layers_.size(), carry, progress, "supports");
  }

  Regions onFirstLayer() const {
    Regions all = first_;
    if (!support_areas_.empty()) appendTo(all, support_areas_.front());
    appendTo(all, brim_.area);
    return all;
  }

  void addRaft() {
    const RaftSettings& settings = settings_.adhesion.raft;
    if (settings.layers == 0) return;
    raft_area_ = raftArea(onFirstLayer(), settings);
    const double part_mm = layers_.front().bounds.bottom_mm;
    planned_.raft = makeRaft(raft_area_, settings_, part_mm, layerHeight());
    planned_.raft_mm = part_mm - planned_.raft.front().bounds.bottom_mm;
  }

  /// What the skirt goes round: all of the first layer, and what is above it in other layers that have a
  /// skirt.
  Regions withinSkirt() const {
    Regions all = onFirstLayer();
    appendTo(all, raft_area_);
    const auto count = static_cast<std::size_t>(settings_.skirt.layers);
    for (std::size_t i = 1; i + planned_.raft.size() < count && i < layers_.size(); ++i) {
      for (const Polygon& contour : layers_[i].section.contours) all.push_back({contour, {}});
      if (!support_areas_.empty()) appendTo(all, support_areas_[i]);
    }
    return all;
  }

  void addSkirt() {
    if (settings_.skirt.count == 0) return;
    std::vector<FillPath> runs;
    for (Polygon& loop : makeSkirt(withinSkirt(), settings_))
      runs.push_back({std::move(loop), true, PathRole::Skirt, Deposit::Bead, {}});
    if (!runs.empty()) skirt_ = {{runs.front().points, {}}};
    const std::size_t count =
        std::min(static_cast<std::size_t>(settings_.skirt.layers), planned_.raft.size() + layers_.size());
    for (std::size_t i = 0; i < count; ++i) {
      LayerAids& aids = aidsOf(i);
      const LayerBounds bounds = withoutGap(i);
      aids.insert(aids.begin(), runsOf(runs, {width(), bounds.height()}, bounds.top_mm, RunOrder::AsGiven));
    }
  }

  /// Of a layer that stands on the one before, where the part stands a gap above its raft.
  LayerBounds withoutGap(std::size_t index) const {
    LayerBounds bounds = boundsOf(index);
    if (planned_.raft.empty() || index < planned_.raft.size()) return bounds;
    const double gap_mm = layers_.front().bounds.bottom_mm - planned_.raft.back().bounds.top_mm;
    bounds.bottom_mm -= gap_mm;
    bounds.top_mm -= gap_mm;
    return bounds;
  }

  void addPrimeLine() {
    const PrimeSettings& settings = settings_.adhesion.prime;
    if (settings.line == PrimeLine::None) return;
    if (!context_.level_bed)
      throw InvalidConfig("prime.line is set for a plan without a bed; expected 'none'");
    Regions occupied = onFirstLayer();
    appendTo(occupied, raft_area_);
    appendTo(occupied, offset(skirt_, 0.5 * width()));
    LayerAids& aids = aidsOf(0);
    // The skirt lies round the raft, which lies below the part.
    occupied = unite(outlines(occupied));
    aids.insert(aids.begin(), makePrimeLine(settings, boundsOf(0), *context_.level_bed, occupied));
  }

  /// From the bed up, those of a raft counted.
  LayerAids& aidsOf(std::size_t index) {
    const std::size_t below = planned_.raft.size();
    return index < below ? planned_.raft[index].aids : planned_.layers[index - below];
  }
  const LayerBounds& boundsOf(std::size_t index) const {
    const std::size_t below = planned_.raft.size();
    return index < below ? planned_.raft[index].bounds : layers_[index - below].bounds;
  }

  const std::vector<Layer>& layers_;
  const PlanContext& context_;
  const PlanSettings& settings_;
  const SupportRegions& support_regions_;
  const AidWindow& window_;
  Regions first_;  ///< layer of the part
  std::vector<Regions> overhangs_;
  double blocked_mm2_ = 0.0;
  SupportAreas supports_;               ///< of a lattice
  SupportTree tree_;                    ///< or a tree
  std::vector<Regions> support_areas_;  ///< of each layer, of both; none without supports
  Brim brim_;
  Regions raft_area_;
  Regions skirt_;  ///< within its outermost loop
  PlannedAids planned_;
};

/// How many layers a column crosses at most, from what it holds up down to the bed, with its interfaces, and
/// a brim.
std::size_t greatestReach(const std::vector<Layer>& layers, const BedPlane& bed,
                          const PlanSettings& settings) {
  const SupportSettings& supports = settings.supports;
  double highest_mm = 0.0;
  double least_mm = std::numeric_limits<double>::infinity();
  for (const Layer& layer : layers) {
    least_mm = std::min(least_mm, layer.bounds.height());
    for (const Polygon& contour : layer.section.contours)
      for (const Point2& point : contour)
        highest_mm = std::max(highest_mm, bed.heightOf({point.x(), point.y(), layer.bounds.top_mm}));
  }
  const double way_mm = highest_mm * bed.up.z() + supports.top_gap_mm + supports.bottom_gap_mm;
  const auto of_columns =
      static_cast<std::size_t>(std::ceil(way_mm / least_mm) + supports.interface_layers) + 2;
  return std::max(of_columns, countBrimLayersBelow(layers, bed, settings.adhesion.brim));
}

/// @throws InvalidInput if there are any
void requireNoRegions(const SupportRegions& regions) {
  if ((regions.variants == nullptr || regions.variants->empty()) && regions.marks == nullptr) return;
  throw InvalidInput(
      "layers far out on a belt have regions with supports of their own; expected none: supports are planned "
      "stretch by stretch there");
}

/// Stretch by stretch near the origin, each with the layers beside it that decide of it.
PlannedAids aidsAlongBelt(const std::vector<Layer>& layers, const PlanContext& context,
                          const SupportRegions& support_regions, Progress& progress) {
  requireNoRegions(support_regions);
  PlannedAids all;
  all.layers.resize(layers.size());
  const std::size_t reach = greatestReach(layers, *context.bed, context.settings);
  for (const StackStretch& stretch : stretchesAlongBelt(layers)) {
    const std::size_t begin = stretch.begin - std::min(stretch.begin, reach);
    const std::size_t end = std::min(layers.size(), stretch.end + reach);
    std::vector<Layer> near;
    for (std::size_t i = begin; i < end; ++i) near.push_back(moved(layers[i], -stretch.away));
    PlanContext there = context;
    there.bed->level_mm -= there.bed->up.head<2>().dot(stretch.away);
    const AidWindow window = {{stretch.begin - begin, stretch.end - begin},
                              {heightAmid(layers), stretch.away}};
    PlannedAids planned = AidPlanner(near, there, {}, window).plan(progress);
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
      all.layers[i] = moved(std::move(planned.layers[i - begin]), stretch.away);
    all.supports = sumOf(all.supports, planned.supports);
    if (planned.carrying.empty()) continue;
    all.carrying.resize(layers.size());
    for (std::size_t i = stretch.begin; i < stretch.end; ++i)
      all.carrying[i] = moved(std::move(planned.carrying[i - begin]), stretch.away);
  }
  return all;
}

}  // namespace

void dropEmptyBelow(std::vector<Layer>& layers, PlannedAids& aids) {
  std::ptrdiff_t count = 0;
  for (std::size_t i = 0; i < layers.size() && layers[i].section.contours.empty(); ++i) {
    if (i < aids.layers.size() && !aids.layers[i].empty()) break;
    ++count;
  }
  layers.erase(layers.begin(), layers.begin() + count);
  if (!aids.layers.empty()) aids.layers.erase(aids.layers.begin(), aids.layers.begin() + count);
  if (!aids.carrying.empty()) aids.carrying.erase(aids.carrying.begin(), aids.carrying.begin() + count);
}

SupportTotals sumOf(const SupportTotals& a, const SupportTotals& b) {
  SupportTotals sum;
  sum.overhang_mm2 = a.overhang_mm2 + b.overhang_mm2;
  sum.unsupported_mm2 = a.unsupported_mm2 + b.unsupported_mm2;
  sum.blocked_mm2 = a.blocked_mm2 + b.blocked_mm2;
  sum.area_mm2 = std::max(a.area_mm2, b.area_mm2);
  sum.support_mm3 = a.support_mm3 + b.support_mm3;
  sum.interface_mm3 = a.interface_mm3 + b.interface_mm3;
  sum.dropped_branches = a.dropped_branches + b.dropped_branches;
  return sum;
}

PlannedAids planAids(const std::vector<Layer>& layers, const PlanContext& context,
                     const SupportRegions& support_regions, Progress& progress) {
  const PlanSettings& settings = context.settings;
  if (context.lift || context.strategy.deposit == Deposit::Drops || layers.empty()) return {};
  const bool lies_on_bed = context.bed ? settings.adhesion.brim.width_mm > 0.0
                                       : settings.skirt.count > 0 || isUsed(settings.adhesion);
  if (!settings.supports.use && !lies_on_bed) return {};
  const auto isFarOut = [](const StackStretch& stretch) { return !stretch.away.isZero(); };
  const std::vector<StackStretch> stretches = stretchesAlongBelt(layers);
  if (context.bed && std::any_of(stretches.begin(), stretches.end(), isFarOut))
    return aidsAlongBelt(layers, context, support_regions, progress);
  const AidWindow window = {{0, layers.size()}, {heightAmid(layers), Point2::Zero()}};
  return AidPlanner(layers, context, support_regions, window).plan(progress);
}

}  // namespace lamina
