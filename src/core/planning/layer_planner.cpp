// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/layer_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/polygon/inside.hpp"
#include "geometry/polygon/region_lists.hpp"
#include "infill/drops/drop_fill.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/layer_error.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/voids/beads/refill.hpp"
#include "planning/bridges/hollow_below.hpp"
#include "planning/bridges/layer_below.hpp"
#include "planning/bridges/lines_below.hpp"
#include "planning/deposited_runs.hpp"
#include "planning/layer_fill.hpp"
#include "planning/modifiers/island_pieces.hpp"
#include "planning/modifiers/run_clipping.hpp"
#include "planning/order/anchored_run.hpp"
#include "planning/order/bed_side.hpp"
#include "planning/order/ordering.hpp"
#include "planning/order/start_count.hpp"
#include "planning/order/support_test.hpp"
#include "planning/overhangs/overhanging_path.hpp"
#include "planning/role_feed.hpp"
#include "planning/run_path.hpp"
#include "planning/seams/seam.hpp"
#include "planning/skins/ironing.hpp"
#include "planning/skins/skin_areas.hpp"
#include "planning/supports/laid_supports.hpp"
#include "planning/tools/tool_order.hpp"
#include "planning/travel/layer_travels.hpp"
#include "planning/walls/walls.hpp"

namespace lamina {
namespace {

bool isAnchored(const PlanContext& context) {
  return context.bed && context.settings.anchoring.strategy != Anchoring::None;
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
        stacked_(stacked),
        settings_(context.settings),
        index_(index),
        nozzle_(anchorOf(*stacked.layer, context)),
        seam_(settings_.seam, nozzle_, index, stacked.seams),
        travels_(settings_.travel, settings_.bead.width_mm),
        top_(stacked.layer->bounds.top_mm),
        cover_(stacked.cover),
        cover_below_(stacked.cover_below),
        branches_(stacked.branches),
        group_(stacked.group),
        aids_(stacked.aids),
        below_(*stacked.layer, stacked.cover, context.bed, context.settings, index),
        fill_(context, index, stacked.layer->bounds.height()),
        pitch_(fill_.pitch()) {
    const Layer& layer = *stacked.layer;
    if (isAnchored(context))
      support_test_.emplace(layer, BelowLayer{stacked.below, stacked.supports}, *context.bed,
                            Bead{settings_.bead.width_mm, layer.bounds.height()});
    result_.z_mm = layer.bounds.top_mm;
    result_.height_mm = layer.bounds.height();
  }

  /// Once only.
  PlannedLayer plan(const std::vector<Polygon>& contours) {
    const Regions material =
        cover_ != nullptr ? *cover_->material : unite(simplify(contours, settings_.simplification_mm));
    setMaterial(material);
    if (aids_ != nullptr)
      for (const AidRuns& aids : *aids_)
        if (!isSupport(aids)) addAids(aids);
    if (fill_.depositsDrops()) requireFewDrops(material, settings_.fill.drops);
    std::vector<Polygon> islands;
    for (const Region& island : material) islands.push_back(seam_.placed(island.outer));
    for (const OrderedRun& next : orderRuns(endsOf(islands), nozzle_)) {
      const Region& island = material[next.run];
      island_ = next.run;
      is_in_island_ = true;
      const std::size_t before = result_.paths.size();
      const double unprinted = addIsland(island);
      unprinted_mm2_ += result_.paths.size() > before ? unprinted : area({island});
    }
    is_in_island_ = false;
    if (settings_.voids.refill == VoidRefill::Beads && fill_.isFilledByBeads()) refillVoids(material);
    iron();
    return {std::move(result_), unprinted_mm2_, refilling_, starts_, moved_starts_, 0.0, bridging_};
  }

  /// What is being planned, for messages.
  std::string place() const {
    return is_in_island_ ? islandPlace(index_, top_, island_) : layerPlace(index_, top_);
  }

 private:
  bool takesSkins() const {
    return cover_ != nullptr && hasSkins(settings_.skins) && (!fill_.isSolid() || fill_.isFitted());
  }

  /// @param spans  whether something of the island lies over a gap
  bool needsSkins(bool spans) const {
    return (takesSkins() && !cover_->isCovered()) || (spans && !fill_.isSolid());
  }

  /// @param material  of the layer; must outlive this
  void setMaterial(const Regions& material) {
    material_ = &material;
    travels_.setMaterial(material);
  }

  /// @return area [mm²] that gets no bead
  double addIsland(const Region& island) {
    if (fill_.depositsDrops()) {
      addInfill({island});
      return 0.0;
    }
    if (!stacked_.variants.empty()) {
      const LayerVariant rest{&context_, cover_, cover_below_, branches_, nullptr};
      const std::vector<IslandPiece> pieces = piecesOf(island, rest, stacked_.variants);
      if (pieces.size() > 1) return addPieces(island, pieces);
      if (pieces.front().plan != &rest) {
        double unprinted_mm2 = 0.0;
        planBy(*pieces.front().plan,
               [&](LayerPlanner& planner) { unprinted_mm2 = planner.addIsland(island); });
        return unprinted_mm2;
      }
    }
    const bool spans = below_.leavesGaps({island});
    bool has_skins = needsSkins(spans);
    Walls walls = makeWalls({island}, settings_, pitch_, has_skins ? WallContact::Beside : fill_.contact());
    if (takesSkins() && !has_skins && !fill_.isSolid() &&
        hasSmall(walls.infill, settings_.skins.least_infill_mm2)) {
      has_skins = true;
      walls = makeWalls({island}, settings_, pitch_, WallContact::Beside);
    }
    addWalls(walls);
    if (spans) walls.infill = addBridges(below_.bridged(walls.infill, pitch_));
    if (has_skins && bridgesInfill() && fill_.isNone()) walls.infill = addBridgesOverHollow(walls.infill);
    const std::size_t before = result_.paths.size();
    if (has_skins)
      addSkinsAndInfill(walls.infill);
    else
      addInfillAlone(walls.infill, std::move(walls.narrow_infill));
    return walls.unprinted_mm2 + (fill_.isSolid() ? areaMissed(walls.infill, result_.paths, before) : 0.0);
  }

  /// Lays what spans a gap within walls, and what hangs over one.
  /// @return what is left to fill
  Regions addBridges(BridgedAreas areas) {
    bridging_ += areas.counts;
    for (DepositedBridge& bridge : areas.bridges) addFills(std::move(bridge.threads), bridge.area);
    const std::size_t before = result_.paths.size();
    addSkin(areas.hanging, PathRole::BottomSkin);
    markUnsupportedSince(result_.paths, before,
                         settings_.feed.skin_mm_s * settings_.overhangs.feed_factors.back());
    return std::move(areas.rest);
  }

  /// Whether what would be no more than a dot is left open: a part that is open inside is none the weaker,
  /// but for branches that grow from dots.
  bool leavesDots() const {
    return settings_.walls.count > 0 && !fill_.isSolid() && branches_ == nullptr &&
           settings_.voids.refill == VoidRefill::None;
  }

  bool bridgesInfill() const {
    return settings_.bridges.is_used && settings_.bridges.is_over_infill && cover_below_ != nullptr &&
           index_ > 0;
  }

  /// Without infill the lowest skin spans from wall to wall.
  Regions addBridgesOverHollow(const Regions& inside) {
    const HollowBelow below = hollowBelow(inside, *cover_, *cover_below_, skinMeasures(settings_, pitch_));
    if (below.room.empty()) return inside;
    std::vector<Polygon> rest = outlines(addBridges(below_.bridgedOver(below.carrying, below.room, pitch_)));
    for (Polygon& outline : outlines(below.hollow)) rest.push_back(std::move(outline));
    return unite(rest);
  }

  void addWalls(Walls& walls) {
    for (std::size_t i = 0, count = walls.walls.size(); i < count; ++i) {
      const std::size_t k = settings_.walls.order == WallOrder::OutsideIn ? i : count - 1 - i;
      addWall(walls.walls[k].centre_lines, k == 0 ? PathRole::OuterWall : PathRole::InnerWall);
      addFills(std::move(walls.walls[k].thin), {});
    }
  }

  /// An island in several pieces: as many walls as the piece with the fewest has go all round; the others
  /// lie in their pieces. Where the plan itself has none, what holds for whole layers is that of the pieces.
  /// @return area [mm²] that gets no bead
  double addPieces(const Region& island, const std::vector<IslandPiece>& pieces) {
    const auto is_planned_here = [this](const IslandPiece& each) { return each.plan->context == &context_; };
    if (std::none_of(pieces.begin(), pieces.end(), is_planned_here)) {
      double unprinted_mm2 = 0.0;
      planBy(*pieces.front().plan,
             [&](LayerPlanner& planner) { unprinted_mm2 = planner.addPieces(island, pieces); });
      return unprinted_mm2;
    }
    PlanSettings fewest = settings_;
    fewest.walls.count = leastWalls(pieces);
    Walls walls = makeWalls({island}, fewest, pitch_, WallContact::Beside);
    const auto addCommonWalls = [&] {
      const std::size_t before = result_.paths.size();
      addWalls(walls);
      result_.paths = depositedByPieces(std::move(result_.paths), before, pieces, {&settings_, index_});
    };
    if (settings_.walls.order == WallOrder::OutsideIn) addCommonWalls();
    for (const IslandPiece& piece : pieces)
      planBy(*piece.plan, [&](LayerPlanner& planner) {
        planner.addInnerWalls(island, piece.area, static_cast<std::size_t>(fewest.walls.count));
      });
    if (settings_.walls.order == WallOrder::InsideOut) addCommonWalls();
    for (const IslandPiece& piece : pieces)
      planBy(*piece.plan, [&](LayerPlanner& planner) { planner.fillPiece(island, piece.area); });
    return walls.unprinted_mm2;
  }

  /// Goes on by another plan of the layer from where the nozzle is.
  template <class Step>
  void planBy(const LayerVariant& plan, const Step& step) {
    StackedLayer stacked = stacked_;
    stacked.cover = plan.cover;
    stacked.cover_below = plan.cover_below;
    stacked.branches = plan.branches;
    stacked.aids = nullptr;
    stacked.variants.clear();
    planWith(stacked, plan, step);
  }

  template <class Step>
  void planWith(const StackedLayer& stacked, const LayerVariant& plan, const Step& step) {
    LayerPlanner planner(stacked, index_, *plan.context);
    if (material_ != nullptr) planner.setMaterial(*material_);
    planner.nozzle_ = nozzle_;
    planner.island_ = island_;
    planner.travels_.setSeen(travels_.seen());
    step(planner);
    takeOver(planner, plan);
  }

  /// What another planner deposited, and found.
  void takeOver(LayerPlanner& planner, const LayerVariant& plan) {
    starts_ += planner.starts_;
    bridging_ += planner.bridging_;
    appendTo(sparse_, planner.sparse_);
    do_sparse_overlap_ = do_sparse_overlap_ || planner.do_sparse_overlap_;
    if (plan.context == &context_)
      appendTo(seen_, planner.seen_);
    else if (!planner.seen_.empty())
      seen_by_.push_back({&plan, std::move(planner.seen_)});
    std::move(planner.seen_by_.begin(), planner.seen_by_.end(), std::back_inserter(seen_by_));
    std::vector<Path>& paths = planner.result_.paths;
    if (paths.empty()) return;
    if (!result_.paths.empty()) addTravelTo(paths.front().firstPoint(), TravelOver::Anything);
    std::move(paths.begin(), paths.end(), std::back_inserter(result_.paths));
    nozzle_ = planner.nozzle_;
    travels_.setSeen(planner.travels_.seen());
  }

  /// Walls beyond the first so many, where they run through the piece.
  void addInnerWalls(const Region& island, const Regions& piece, std::size_t first) {
    if (static_cast<std::size_t>(settings_.walls.count) <= first) return;
    Walls walls = makeWalls({island}, settings_, pitch_, fill_.contact());
    std::vector<FillPath> whole;
    for (std::size_t k = first; k < walls.walls.size(); ++k) {
      for (FillPath& thin : walls.walls[k].thin) whole.push_back(std::move(thin));
      const PathRole role = k == 0 ? PathRole::OuterWall : PathRole::InnerWall;
      for (Polygon& loop : outlines(walls.walls[k].centre_lines))
        whole.push_back({std::move(loop), true, role, Deposit::Bead, {}});
    }
    addFills(clipped(whole, piece), {});
  }

  /// Skins and infill, up to the walls of the island and to the border of the piece.
  void fillPiece(const Region& island, const Regions& piece) {
    const bool spans = below_.leavesGaps({island});
    const bool has_skins = needsSkins(spans);
    const double overlap_mm = has_skins ? 0.0 : fill_.overlap();
    Walls walls = makeWalls({island}, settings_, pitch_, has_skins ? WallContact::Beside : fill_.contact());
    Regions inside = intersection(walls.infill, overlap_mm > 0.0 ? offset(piece, overlap_mm) : piece);
    if (spans) inside = addBridges(below_.bridged(inside, pitch_));
    if (inside.empty()) return;
    do_sparse_overlap_ = overlap_mm > 0.0;
    if (has_skins) return addSkinsAndInfill(inside);
    addInfillAlone(inside, clipped(walls.narrow_infill, piece));
  }

  /// Inside walls.
  /// @param narrow  runs where the infill has no room
  void addInfillAlone(const Regions& inside, std::vector<FillPath> narrow) {
    const Regions open = fillNarrowGaps(inside, inside, fill_.overlap());
    const std::size_t before = result_.paths.size();
    if (!fill_.isNone()) addInfill(fill_.area(open));
    keepSeen(inside);
    starts_ += startsOf(open, fillsSince(result_.paths, before), pitch_);
    addFills(std::move(narrow), {});
    if (!fill_.isSolid()) appendTo(sparse_, inside);
  }

  /// Lays beads in narrow gaps between walls, where a sparse fill would lay nothing.
  /// @return the rest of what is sparse
  Regions fillNarrowGaps(const Regions& inside, Regions sparse, double overlap_mm) {
    if (fill_.isSolid() || fill_.isNone() || !fill_.isFitted()) return sparse;
    FittedArea parts = withoutNarrowGaps(inside, std::move(sparse), overlap_mm, settings_, pitch_);
    addFills(std::move(parts.narrow), {});
    return std::move(parts.wide);
  }

  /// Bottom skins first and top skins last, so that nothing is deposited over what is seen. A solid infill
  /// gets their roles and stays what it is.
  /// @param inside  walls
  void addSkinsAndInfill(const Regions& inside) {
    SkinAreas areas = skinAreas(inside, *cover_, skinMeasures(settings_, pitch_));
    if (!areas.sparse.empty()) areas.sparse = fillNarrowGaps(inside, std::move(areas.sparse), 0.0);
    const std::size_t before = result_.paths.size();
    const auto lay = [&](const Regions& area, PathRole role) {
      if (!fill_.isSolid()) return addSkin(area, role);
      addSolid(area, role, fill_.requestAs(role, infillRequest()), context_.strategy);
    };
    areas.skin = withoutLowest(std::move(areas.skin), inside);
    lay(areas.bottom_skin, PathRole::BottomSkin);
    lay(areas.skin, PathRole::Skin);
    addSkin(areas.thickening, PathRole::InnerWall);
    if (fill_.isSolid())
      lay(areas.sparse, PathRole::Infill);
    else if (!fill_.isNone() && !areas.sparse.empty())
      addInfill(fill_.area(fill_.overlap() > 0.0 ? offset(areas.sparse, fill_.overlap()) : areas.sparse));
    travels_.addSeen(areas.top_skin);
    lay(areas.top_skin, PathRole::TopSkin);
    if (settings_.ironing.is_used) appendTo(seen_, areas.top_skin);
    starts_ += startsOf(inside, fillsSince(result_.paths, before), pitch_);
    if (!fill_.isSolid()) appendTo(sparse_, areas.sparse);
  }

  /// The other skins; lays the lowest over a sparse infill across its lines, if that is asked for.
  Regions withoutLowest(Regions skin, const Regions& inside) {
    if (!bridgesInfill() || fill_.isNone() || fill_.isSolid()) return skin;
    const SkinAreas areas_below = skinAreas(inside, *cover_below_, skinMeasures(settings_, pitch_));
    const Regions lowest = intersection(skin, areas_below.sparse);
    if (lowest.empty()) return skin;
    const std::size_t before = result_.paths.size();
    const double across_deg =
        acrossLines(linesOf(context_.strategy, settings_.infill, groupOf(settings_.infill, index_ - 1)));
    addSkin(lowest, PathRole::Skin, std::fmod(across_deg - settings_.skins.angle_deg, 360.0));
    markUnsupportedSince(result_.paths, before, settings_.feed.bridge_mm_s);
    return difference(skin, lowest);
  }

  void addSkin(const Regions& area, PathRole role) {
    addSkin(area, role, 90.0 * static_cast<double>(index_ % 4));
  }

  /// @param turn_deg  against the first layer's skins
  void addSkin(const Regions& area, PathRole role, double turn_deg) {
    addSolid(area, role, fill_.skinRequest(infillRequest(), turn_deg), context_.skin_strategy);
  }

  /// Up to the border of the area.
  void addSolid(const Regions& area, PathRole role, InfillRequest request, const InfillStrategy& strategy) {
    SolidRuns runs = fill_.solid(area, role, std::move(request), strategy);
    const InsideTest inside(area);
    for (const FillPath& run : runs.in_turn) addFill(run, inside);
    addFills(std::move(runs.any_order), area);
  }

  /// A solid infill that is seen is ironed as a skin is.
  void keepSeen(const Regions& inside) {
    if (!settings_.ironing.is_used || cover_ == nullptr || !fill_.isSolid()) return;
    appendTo(seen_, skinAreas(inside, *cover_, skinMeasures(settings_, pitch_)).top_skin);
  }

  /// What is seen, across its lines, once the layer is deposited.
  void iron() {
    ironSeen(std::exchange(seen_, {}));
    for (const IslandPiece& seen : std::exchange(seen_by_, {}))
      planBy(*seen.plan, [&](LayerPlanner& planner) { planner.ironSeen(seen.area); });
  }

  void ironSeen(const Regions& seen) {
    if (seen.empty()) return;
    const double turn_deg = settings_.skins.angle_deg + 90.0 * static_cast<double>(index_ % 4 + 1);
    addFills(ironingLines(seen, settings_.ironing, toRadians(turn_deg)), seen);
  }

  void addWall(const Regions& centre_lines, PathRole role) {
    std::vector<Polygon> loops = outlines(centre_lines);
    for (Polygon& loop : loops) loop = seam_.placed(std::move(loop));
    for (const OrderedRun& next : orderRuns(endsOf(loops), nozzle_))
      addLoop(seam_.approached(std::move(loops[next.run]), nozzle_), role);
  }

  /// That of a group of layers is deposited in the last of them, as in one high layer.
  void addInfill(const Regions& area) {
    if (fill_.isFittedAlone()) return addSolid(area, PathRole::Infill, infillRequest(), context_.strategy);
    if (group_ == nullptr || fill_.isSolid()) return layInfill(area);
    const GroupedInfill parts = groupedInfill(area, *group_, settings_.bead.width_mm);
    layInfill(parts.alone);
    if (parts.together.empty()) return;
    const Layer high{{top_ - group_->height_mm, top_}, {}};
    StackedLayer stacked;
    stacked.layer = &high;
    stacked.below = stacked_.below;
    stacked.branches = branches_;
    planWith(stacked, {&context_}, [&](LayerPlanner& planner) { planner.layInfill(parts.together); });
  }

  void layInfill(const Regions& area) {
    addFills(fill_.infill(area, infillRequest()), area, context_.strategy.order);
  }

  /// @param area  over which travels need not be retracted
  void addFills(std::vector<FillPath> runs, const Regions& area, RunOrder order = RunOrder::Shortest) {
    if (leavesDots()) runs = withoutDots(std::move(runs), settings_.bead.width_mm);
    const InsideTest inside(area);
    for (const FillPath& run : inOrder(std::move(runs), order, nozzle_)) addFill(run, inside);
  }

  /// What a sparse infill leaves open stays so.
  void refillVoids(const Regions& material) {
    if (do_sparse_overlap_) sparse_ = unite(outlines(sparse_));
    const RefillSettings settings{settings_.voids.least_area};
    const Regions solid = fill_.isSolid() && sparse_.empty() ? material : difference(material, sparse_);
    const std::size_t before = result_.paths.size();
    addFills(refill(findVoids(solid, withoutFlow(result_, settings_.bead.flow), {}), settings), material);
    refilling_ = refillingSince(result_.paths, before);
  }

  InfillRequest infillRequest() const {
    InfillRequest request = fill_.request();
    request.start = nozzle_;
    request.island = island_;
    request.part_from_plan = context_.part_from_layers * Eigen::Translation3d(0.0, 0.0, top_);
    request.branches = branches_;
    return request;
  }

  void addFill(const FillPath& fill, const InsideTest& area) {
    const bool stays_inside = area.staysInside(nozzle_, fill.points.front());
    addRun(fill, stays_inside ? TravelOver::Infill : TravelOver::Anything);
  }

  void addLoop(Polygon loop, PathRole role) {
    addRun({std::move(loop), true, role, Deposit::Bead, {}}, TravelOver::Anything);
  }

  /// They need no anchor on the part.
  void addAids(const AidRuns& aids) {
    const Regions nowhere;
    const InsideTest area(aids.area ? *aids.area : nowhere);
    for (const FillPath& run : inOrder(*aids.runs, aids.order, nozzle_)) {
      const bool is_inside = aids.area && area.staysInside(nozzle_, run.points.front());
      Path path = pathAlong(run, aids.bead, aids.top_mm, feedIn(settings_.feed, run.role, index_));
      path.tool = aids.tool;
      layPath(std::move(path), is_inside ? TravelOver::Infill : TravelOver::Anything);
    }
  }

  void addRun(const FillPath& run, TravelOver over) {
    if (!support_test_) return layRun(run, over);
    std::vector<FillPath> parts =
        anchored(run, [this](const Point2& point) { return support_test_->carries(point); });
    if (!support_test_->carries(parts.front().points.front()))
      parts.front() = begunAtBeads(std::move(parts.front()), result_.paths);
    const bool is_moved = parts.front().points.front() != run.points.front();
    if (is_moved) ++moved_starts_;
    for (const FillPath& part : parts) layRun(part, is_moved ? TravelOver::Anything : over);
  }

  void layRun(const FillPath& run, TravelOver over) {
    const RoleBead& usual = fill_.beads().of(run.role);
    Path path = below_.carried(pathAlong(run, beadsAlong(run, settings_, usual.bead, usual.pitch_mm), top_,
                                         feedIn(settings_.feed, run.role, index_)));
    layPath(withFlow(std::move(path), settings_.bead.flow), over);
  }

  void layPath(Path path, TravelOver over) {
    path.tool = toolOf(path, settings_.tools);
    if (!result_.paths.empty()) addTravelTo(path.firstPoint(), over);
    nozzle_ = path.lastPoint().head<2>();
    result_.paths.push_back(std::move(path));
  }

  void addTravelTo(const Point3& point, TravelOver over) {
    std::optional<Path> travel = travels_.between(result_.paths.back().lastPoint(), point, over);
    if (travel) result_.paths.push_back(std::move(*travel));
  }

  const PlanContext& context_;
  StackedLayer stacked_;
  const PlanSettings& settings_;
  std::size_t index_;
  std::size_t island_ = 0;
  bool is_in_island_ = false;
  Point2 nozzle_;
  Seam seam_;
  LayerTravels travels_;
  const Regions* material_ = nullptr;
  double top_;
  const LayerCover* cover_;                ///< null without skins, bridges and overhanging walls
  const LayerCover* cover_below_;          ///< of the layer below
  const std::vector<Polyline>* branches_;  ///< null for a fill that does not grow
  const InfillGroup* group_;               ///< null where each layer has an infill of its own
  const LayerAids* aids_;                  ///< null without
  LayerBelow below_;
  LayerFill fill_;
  double pitch_;                             ///< between neighbouring walls [mm]
  std::optional<SupportTest> support_test_;  ///< of runs that are to be anchored
  std::size_t moved_starts_ = 0;
  double unprinted_mm2_ = 0.0;
  Refilling refilling_;
  Bridging bridging_;
  FillStarts starts_;
  Regions sparse_;                    ///< what the infill of all islands does not fill
  bool do_sparse_overlap_ = false;    ///< each other, where pieces reach over their borders
  Regions seen_;                      ///< what is to be ironed
  std::vector<IslandPiece> seen_by_;  ///< the same, by other plans
  ToolpathLayer result_;
};

}  // namespace

PlannedLayer planLayer(const StackedLayer& stacked, std::size_t index, const PlanContext& context) {
  LayerPlanner planner(stacked, index, context);
  try {
    return planner.plan(stacked.layer->section.contours);
  } catch (...) {
    rethrowAt(planner.place());
  }
}

}  // namespace lamina
