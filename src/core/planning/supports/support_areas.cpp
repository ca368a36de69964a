// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/support_areas.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/same_height.hpp"
#include "planning/supports/piecewise.hpp"

namespace lamina {
namespace {

constexpr double kLeastOnBed = 0.25;  // of a layer: a lower bead on the bed has no room for the nozzle
/// Bead widths: where the layers' steps are left out, of what hangs over, which is so much larger, and of
/// what falls, which loses no more than that again.
constexpr double kOverhangDetail = 0.6;
constexpr double kFallingDetail = 0.4;
constexpr int kSweepSteps = 4;
constexpr double kLayerRounding = 1e-6;  // of a layer
constexpr double kTolerance = 0.05;      // bead widths: the outlines of a support need no more

const SharedRegions& nothing() {
  static const SharedRegions empty = std::make_shared<const Regions>();
  return empty;
}

SharedRegions share(Regions regions) {
  return regions.empty() ? nothing() : std::make_shared<const Regions>(std::move(regions));
}

/// What regions pass over on a short way.
Regions swept(const Regions& regions, const Point2& way) {
  std::vector<Polygon> passed;
  for (int i = 0; i <= kSweepSteps; ++i)
    for (Polygon& border : outlines(moved(regions, static_cast<double>(i) / kSweepSteps * way)))
      passed.push_back(std::move(border));
  return unite(passed);
}

std::size_t cornersOf(const Regions& regions) {
  std::size_t count = 0;
  for (const Polygon& border : outlines(regions)) count += border.size();
  return count;
}

/// All of the regions by fewer corners, a little larger; regions of few corners as they are. The edges of
/// layers of a wall that leans are as jagged as its lean is near the limit.
Regions withoutDetail(const Regions& regions, double tolerance_mm) {
  const std::size_t corners = cornersOf(regions);
  if (2 * cornersOf(simplified(regions, tolerance_mm)) > corners) return regions;
  return simplified(grownByPieces(regions, tolerance_mm), tolerance_mm);
}

/// What ends in a layer.
struct ColumnCap {
  double bottom_mm = 0.0;
  double top_mm = 0.0;
  std::size_t full_layers = 0;  ///< below it
  SharedRegions area;
};

class ColumnStack {
 public:
  ColumnStack(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
              const SupportSettings& settings, const WallBeads& walls)
      : stack_(stack), overhangs_(overhangs), settings_(settings), walls_(walls), width_(walls.width_mm) {}

  SupportAreas build(const LayerSpan& counted, Progress& progress);

 private:
  void placeTops(Progress& progress);
  void findBlocked(Progress& progress);
  void drop();
  void keepAway(Progress& progress);
  void joinAndThin(Progress& progress);
  /// On the bed, or on the part too.
  void keepThoseThatStand();
  void reachLedges();
  void endAboveThePart(Progress& progress);
  void dropNarrow(Progress& progress);
  void placeCaps(std::size_t layer);
  LayerSupport sectionsOf(std::size_t layer) const;
  double unsupported(std::size_t layer) const;
  Regions ledgesOf(std::size_t layer) const;

  /// In inclined layers all that it sweeps as it falls by its own height, so that one layer's columns stand
  /// beside those of the next.
  Regions heldUp(std::size_t layer) const {
    const Regions& hangs = overhangs_[layer];
    Regions held = settings_.expand_mm > 0.0 ? offset(hangs, settings_.expand_mm) : hangs;
    held = united(held, ledges_[layer]);
    if (!isLevel()) held = swept(held, stack_.fall() * stack_.bounds[layer].height());
    return withoutDetail(held, kOverhangDetail * width_);
  }
  double narrowest() const { return std::max(width_, settings_.least_width_mm); }
  bool isLevel() const { return !stack_.bed; }
  /// Down from the underside of a layer, or its top, to the top of another.
  Point2 fallBetween(double from_mm, std::size_t to) const {
    return stack_.fall() * (from_mm - stack_.bounds[to].top_mm);
  }
  void widenCovers(Progress& progress);
  /// What of the layer is not within all of the next ones above and below, half a bead narrower all round.
  Regions uncoveredEnds(std::size_t layer) const;

  const StackedMaterial& stack_;
  const std::vector<Regions>& overhangs_;
  const SupportSettings& settings_;
  WallBeads walls_;
  double width_;
  std::vector<Regions> ledges_;                  ///< of each layer; none in inclined ones
  std::vector<Regions> held_;                    ///< of each layer, what columns hold up
  std::size_t count_ = 0;                        ///< of layers from the bed that may have support
  std::vector<std::vector<std::size_t>> joins_;  ///< for each, layers whose columns have it as last full one
  std::vector<std::vector<ColumnCap>> caps_;
  std::vector<SharedRegions> blocked_;  ///< by the part and the gap at its side
  std::vector<SharedRegions> falling_;  ///< what columns fall through, up to the part
  std::vector<SharedRegions> columns_;  ///< of full height; in steps: beside the part, joined, standing, wide
  std::vector<SharedRegions> whole_;    ///< with caps
  std::vector<SharedRegions> covers_;   ///< of interfaces: the whole ones, half a bead wider
};

/// Without what would come up under a layer between the column and what it holds up.
Regions ColumnStack::ledgesOf(std::size_t layer) const {
  const std::optional<ColumnTop> top = columnTopBelow(stack_.bounds, layer, settings_.top_gap_mm);
  if (!isLevel() || !top || top->full_layers == 0) return {};
  const std::size_t last = top->full_layers - 1;
  Regions ledges =
      ledgesIn(overhangs_[layer], *stack_.material[layer], *stack_.material[last], walls_, settings_);
  for (std::size_t k = last + 1; k < layer && !ledges.empty(); ++k)
    ledges = differenceByPieces(ledges, within(*stack_.material[k], boxOf(ledges), 1.0));
  return ledges;
}

void ColumnStack::placeTops(Progress& progress) {
  ledges_.resize(stack_.size());
  held_.resize(stack_.size());
  const auto hold = [&](std::size_t j) {
    if (overhangs_[j].empty()) return;
    ledges_[j] = ledgesOf(j);
    held_[j] = heldUp(j);
  };
  parallelFor(stack_.size(), hold, progress, "supports");
  joins_.resize(stack_.size());
  caps_.resize(stack_.size());
  for (std::size_t j = 0; j < stack_.size(); ++j) {
    if (overhangs_[j].empty()) continue;
    const std::optional<ColumnTop> top = columnTopBelow(stack_.bounds, j, settings_.top_gap_mm);
    if (!top) continue;
    if (top->full_layers > 0) joins_[top->full_layers - 1].push_back(j);
    count_ = std::max(count_, top->full_layers);
    for (const ColumnTop::Cap& cap : top->caps) {
      const Point2 fall = stack_.fall() * (stack_.bounds[j].bottom_mm - cap.top_mm);
      caps_[cap.layer].push_back({cap.bottom_mm, cap.top_mm, top->full_layers, share(moved(held_[j], fall))});
      count_ = std::max(count_, cap.layer + 1);
    }
  }
}

/// Near what falls.
void ColumnStack::findBlocked(Progress& progress) {
  blocked_.assign(count_, nothing());
  const auto isShared = [&](std::size_t k) {
    return k + 1 < count_ && isLevel() && stack_.material[k] == stack_.material[k + 1] &&
           falling_[k] == falling_[k + 1] && caps_[k].empty() && caps_[k + 1].empty();
  };
  const double gap = settings_.side_gap_mm;
  const double reach = 3.0 * gap + settings_.join_mm + width_;
  const auto find = [&](std::size_t k) {
    if (isShared(k)) return;
    Box2 box = boxOf(*falling_[k]);
    for (const ColumnCap& cap : caps_[k]) {
      const Box2 own = boxOf(*cap.area);
      if (!own.isEmpty()) box.include(own.low), box.include(own.high);
    }
    const Regions near = within(*stack_.material[k], box, reach);
    blocked_[k] = share(united(offset(simplified(near, kTolerance * width_), gap), stack_.bedIn(k)));
  };
  parallelFor(count_, find, progress, "supports");
  for (std::size_t k = count_; k-- > 0;)
    if (isShared(k)) blocked_[k] = blocked_[k + 1];
}

/// What falls past a wall that leans reaches the gap beside it only farther down: it is stopped by the part,
/// and left out where it comes too near.
void ColumnStack::drop() {
  falling_.assign(count_, nothing());
  for (std::size_t k = count_; k-- > 0;) {
    const bool is_top = k + 1 == count_;
    if (!is_top && joins_[k].empty() && isLevel() && stack_.material[k] == stack_.material[k + 1]) {
      falling_[k] = falling_[k + 1];
      continue;
    }
    Regions area = is_top ? Regions{} : moved(*falling_[k + 1], fallBetween(stack_.bounds[k + 1].top_mm, k));
    for (const std::size_t j : joins_[k])
      area = united(area, moved(held_[j], fallBetween(stack_.bounds[j].bottom_mm, k)));
    if (area.empty()) continue;
    const Regions stops = united(within(*stack_.material[k], boxOf(area), 1.0), stack_.bedIn(k));
    falling_[k] = share(simplified(differenceByPieces(area, stops), kFallingDetail * width_));
  }
}

void ColumnStack::keepAway(Progress& progress) {
  columns_.assign(count_, nothing());
  const auto isShared = [&](std::size_t k) {
    return k + 1 < count_ && falling_[k] == falling_[k + 1] && blocked_[k] == blocked_[k + 1];
  };
  const auto cut = [&](std::size_t k) {
    for (ColumnCap& cap : caps_[k]) cap.area = share(differenceByPieces(*cap.area, *blocked_[k]));
    if (!isShared(k)) columns_[k] = share(differenceByPieces(*falling_[k], *blocked_[k]));
  };
  parallelFor(count_, cut, progress, "supports");
  for (std::size_t k = count_; k-- > 0;)
    if (isShared(k)) columns_[k] = columns_[k + 1];
}

/// Slivers go first, so that less has to grow.
void ColumnStack::joinAndThin(Progress& progress) {
  const auto isShared = [&](std::size_t k) {
    return k + 1 < count_ && columns_[k] == columns_[k + 1] && blocked_[k] == blocked_[k + 1];
  };
  std::vector<SharedRegions> joined(count_, nothing());
  const auto join_layer = [&](std::size_t k) {
    if (isShared(k) || columns_[k]->empty()) return;
    const double thin = 0.5 * narrowest();
    const double reach = 0.5 * settings_.join_mm;
    const Regions thick = offset(simplified(*columns_[k], kFallingDetail * width_), -thin);
    if (thick.empty()) return;
    const NeighbouringRegions parts = neighbouring(thick, settings_.join_mm + narrowest());
    Regions closed = grownByPieces(parts.alone, thin);
    if (!parts.near.empty()) {
      Regions together = offset(grownByPieces(parts.near, thin + reach), -reach);
      std::move(together.begin(), together.end(), std::back_inserter(closed));
    }
    joined[k] = share(differenceByPieces(closed, *blocked_[k]));
  };
  parallelFor(count_, join_layer, progress, "supports");
  for (std::size_t k = count_; k-- > 0;)
    if (isShared(k)) joined[k] = joined[k + 1];
  columns_ = std::move(joined);
}

void ColumnStack::keepThoseThatStand() {
  const bool on_part = settings_.foot == SupportFoot::Everywhere;
  if (on_part && isLevel()) return;
  std::vector<SharedRegions> kept = columns_;
  // The first inclined layer meets the bed along a line; what falls past it would need layers before it.
  if (!isLevel() && count_ > 0) kept[0] = nothing();
  for (std::size_t k = 1; k < count_; ++k) {
    const bool is_over_columns = isLevel() && blocked_[k] == blocked_[k - 1];
    if (is_over_columns && kept[k - 1] == columns_[k - 1]) continue;
    if (is_over_columns && columns_[k] == columns_[k - 1]) {
      kept[k] = kept[k - 1];
      continue;
    }
    const Point2 rise = -fallBetween(stack_.bounds[k].top_mm, k - 1);
    const Regions foot = united(*kept[k - 1], on_part ? *blocked_[k - 1] : stack_.bedIn(k - 1));
    kept[k] = share(intersection(*columns_[k], moved(foot, rise)));
  }
  columns_ = std::move(kept);
}

/// Below ledges columns come nearer to the part than the gap at its side, each layer by no more than the one
/// below carries.
void ColumnStack::reachLedges() {
  const double gap = ledgeGap(settings_);
  const double step = ledgeStep(walls_);
  const auto reach =
      static_cast<std::size_t>(std::ceil((settings_.side_gap_mm - gap) / step - kLayerRounding));
  std::vector<Regions> near(count_);
  for (std::size_t j = 0; j < stack_.size(); ++j) {
    if (ledges_[j].empty()) continue;
    const std::size_t tops = columnTopBelow(stack_.bounds, j, settings_.top_gap_mm)->full_layers;
    for (std::size_t k = tops - std::min(tops, reach); k < tops; ++k) near[k] = united(near[k], ledges_[j]);
  }
  for (std::size_t k = 1; k < count_; ++k) {
    if (near[k].empty()) continue;
    const Box2 box = boxOf(near[k]);
    const Regions carried = grownByPieces(within(*columns_[k - 1], box, 3.0 * step), step);
    Regions nearer = intersection(intersection(near[k], *falling_[k]), carried);
    if (nearer.empty()) continue;
    const Regions part = grownByPieces(within(*stack_.material[k], box, 3.0 * gap), gap);
    nearer = differenceByPieces(nearer, part);
    if (!nearer.empty()) columns_[k] = share(united(*columns_[k], nearer));
  }
}

void ColumnStack::endAboveThePart(Progress& progress) {
  std::vector<SharedRegions> ended = columns_;
  const auto end_layer = [&](std::size_t k) {
    const double least = stack_.bounds[k].bottom_mm - settings_.bottom_gap_mm + kSameHeight;
    for (std::size_t i = k; i-- > 0 && stack_.bounds[i].top_mm > least && !ended[k]->empty();)
      if (stack_.material[i] != stack_.material[k] && !stack_.material[i]->empty())
        ended[k] = share(differenceByPieces(
            *ended[k], moved(*stack_.material[i], -fallBetween(stack_.bounds[k].top_mm, i))));
  };
  parallelFor(count_, end_layer, progress, "supports");
  columns_ = std::move(ended);
}

void ColumnStack::dropNarrow(Progress& progress) {
  std::vector<SharedRegions> wide(count_, nothing());
  const auto isShared = [&](std::size_t k) { return k + 1 < count_ && columns_[k] == columns_[k + 1]; };
  const auto drop_in = [&](std::size_t k) {
    if (!isShared(k)) wide[k] = share(withoutNarrowPieces(*columns_[k], narrowest()));
  };
  parallelFor(count_, drop_in, progress, "supports");
  for (std::size_t k = count_; k-- > 0;)
    if (isShared(k)) wide[k] = wide[k + 1];
  columns_ = std::move(wide);
  whole_ = columns_;
  const auto place_caps = [&](std::size_t k) { placeCaps(k); };
  parallelFor(count_, place_caps, progress, "supports");
}

void ColumnStack::placeCaps(std::size_t layer) {
  std::vector<ColumnCap>& caps = caps_[layer];
  std::stable_sort(caps.begin(), caps.end(),
                   [](const ColumnCap& a, const ColumnCap& b) { return a.top_mm > b.top_mm; });
  for (ColumnCap& cap : caps) {
    Regions area = *cap.area;
    if (cap.full_layers > 0) {
      const std::size_t foot = cap.full_layers - 1;
      const Point2 rise = -stack_.fall() * (cap.top_mm - stack_.bounds[foot].top_mm);
      area = intersection(area, moved(*columns_[foot], rise));
    }
    const Regions with_cap = withoutNarrow(united(*whole_[layer], area), narrowest());
    cap.area = share(difference(with_cap, *whole_[layer]));
    if (!cap.area->empty()) whole_[layer] = share(with_cap);
  }
}

/// Of the whole layer; bed that shows covers too.
void ColumnStack::widenCovers(Progress& progress) {
  covers_.assign(count_, nothing());
  const auto isShared = [&](std::size_t k) {
    return k + 1 < count_ && isLevel() && whole_[k] == whole_[k + 1];
  };
  const auto widen = [&](std::size_t k) {
    if (!isShared(k)) covers_[k] = share(grownByPieces(united(*whole_[k], stack_.bedIn(k)), 0.5 * width_));
  };
  parallelFor(count_, widen, progress, "supports");
  for (std::size_t k = count_; k-- > 0;)
    if (isShared(k)) covers_[k] = covers_[k + 1];
}

/// Narrower by half a bead, to a cover wider by that: what is left is what is a bead wide and not covered,
/// and outlines that follow each other do not meet.
Regions ColumnStack::uncoveredEnds(std::size_t layer) const {
  std::optional<Regions> narrower;
  Regions uncovered;
  for (const int step : {1, -1})
    for (int m = 1; m <= settings_.interface_layers; ++m) {
      const auto at = static_cast<std::ptrdiff_t>(layer) + static_cast<std::ptrdiff_t>(m) * step;
      if (at < 0) break;
      const auto next = static_cast<std::size_t>(at);
      if (next < count_ && isLevel() && whole_[next] == whole_[layer]) continue;
      if (!narrower) narrower = offset(*columns_[layer], -0.5 * width_);
      if (next >= count_) return *narrower;
      const Point2 rise = stack_.fall() * (stack_.bounds[next].top_mm - stack_.bounds[layer].top_mm);
      uncovered = united(uncovered, differenceByPieces(*narrower, moved(*covers_[next], rise)));
    }
  return uncovered;
}

LayerSupport ColumnStack::sectionsOf(std::size_t layer) const {
  LayerSupport sections;
  const bool has_interfaces = settings_.interface_layers > 0;
  for (const ColumnCap& cap : caps_[layer]) {
    if (cap.area->empty()) continue;
    sections.push_back({cap.bottom_mm, cap.top_mm, has_interfaces ? nothing() : cap.area,
                        has_interfaces ? cap.area : nothing()});
  }
  std::reverse(sections.begin(), sections.end());
  const SharedRegions& full = columns_[layer];
  if (full->empty()) return sections;
  const LayerBounds& bounds = stack_.bounds[layer];
  SupportSection section{bounds.bottom_mm, bounds.top_mm, full, nothing()};
  if (has_interfaces) {
    const Regions uncovered = uncoveredEnds(layer);
    if (!uncovered.empty()) {
      const Regions ends = grownByPieces(uncovered, 0.5 * width_);
      section.interface = share(intersection(ends, *full));
      section.lattice = share(differenceByPieces(*full, ends));
    }
  }
  sections.push_back(std::move(section));
  return sections;
}

/// What hangs over in a layer without a support that comes as near as the gap at its side.
double ColumnStack::unsupported(std::size_t layer) const {
  if (overhangs_[layer].empty()) return 0.0;
  const std::optional<ColumnTop> top = columnTopBelow(stack_.bounds, layer, settings_.top_gap_mm);
  if (!top) return area(overhangs_[layer]);
  const std::size_t last = top->caps.empty() ? top->full_layers - 1 : top->caps.back().layer;
  const Point2 rise = -fallBetween(stack_.bounds[layer].bottom_mm, last);
  const double reach = settings_.side_gap_mm + kTolerance * width_;
  const Regions beside = within(moved(*whole_[last], rise), boxOf(overhangs_[layer]), 3.0 * reach);
  return area(differenceByPieces(overhangs_[layer], grownByPieces(beside, reach)));
}

SupportAreas ColumnStack::build(const LayerSpan& counted, Progress& progress) {
  SupportAreas areas;
  areas.layers.resize(stack_.size());
  placeTops(progress);
  drop();
  findBlocked(progress);
  keepAway(progress);
  joinAndThin(progress);
  keepThoseThatStand();
  reachLedges();
  if (settings_.foot == SupportFoot::Everywhere) endAboveThePart(progress);
  dropNarrow(progress);
  if (settings_.interface_layers > 0) widenCovers(progress);
  std::vector<double> unsupported_mm2(stack_.size(), 0.0);
  const auto finish = [&](std::size_t i) {
    if (i < count_) areas.layers[i] = sectionsOf(i);
    unsupported_mm2[i] = unsupported(i);
  };
  parallelFor(stack_.size(), finish, progress, "supports");
  SupportTotals& totals = areas.totals;
  for (std::size_t k = counted.begin; k < counted.end; ++k) {
    totals.overhang_mm2 += area(overhangs_[k]);
    totals.unsupported_mm2 += unsupported_mm2[k];
  }
  const std::size_t begin = std::min(counted.begin, count_);
  for (std::size_t k = begin; k < std::min(counted.end, count_); ++k)
    if (k == begin || whole_[k] != whole_[k - 1])
      totals.area_mm2 = std::max(totals.area_mm2, area(*whole_[k]));
  return areas;
}

}  // namespace

std::optional<ColumnTop> columnTopBelow(const std::vector<LayerBounds>& bounds, std::size_t layer,
                                        double gap_mm) {
  const double end = bounds[layer].bottom_mm - gap_mm;
  std::size_t k = layer;
  while (k > 0 && bounds[k - 1].bottom_mm >= end - kSameHeight) --k;
  if (k == 0) return std::nullopt;
  --k;
  const double rest = end - bounds[k].bottom_mm;
  const double height = bounds[k].height();
  ColumnTop top;
  if (rest >= height - kSameHeight) {
    top.full_layers = k + 1;
  } else if (k == 0 || rest >= 0.5 * height - kSameHeight) {
    if (k == 0 && rest < kLeastOnBed * height) return std::nullopt;
    top.full_layers = k;
    top.caps = {{k, bounds[k].bottom_mm, end}};
  } else {
    const double middle = 0.5 * (bounds[k - 1].bottom_mm + end);
    top.full_layers = k - 1;
    top.caps = {{k - 1, bounds[k - 1].bottom_mm, middle}, {k, middle, end}};
  }
  return top;
}

SupportAreas supportAreas(const StackedMaterial& stack, const CountedOverhangs& overhangs,
                          const SupportSettings& settings, const WallBeads& walls, Progress& progress) {
  return ColumnStack(stack, overhangs.areas, settings, walls).build(overhangs.counted, progress);
}

}  // namespace lamina
