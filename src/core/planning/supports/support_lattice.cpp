// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/support_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "infill/rectilinear/zigzag.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/supports/piecewise.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

constexpr double kMostlyOn = 0.5;     // of an interface on the one below
constexpr double kWithinRim = 1e-3;   // mm: the outermost lines from the border that they follow
constexpr double kStub = 2.25;        // pitches, two bead widths: a shorter line of a lattice is a needle
constexpr double kRimLines = 1.5;     // from the rim of an interface to its middle: narrower ones are all rim
constexpr double kLongestJoin = 3.5;  // distances of lines, along the border from one run to another

using SharedRuns = std::shared_ptr<const std::vector<FillPath>>;

/// Lines of one role.
struct LatticeLines {
  PathRole role = PathRole::Support;
  double spacing_mm = 0.0;
  double pitch_mm = 0.0;  ///< plan width of a bead
  double angle_rad = 0.0;
  int walls = 0;
  const Regions* below = nullptr;  ///< interfaces of the layer below; null for none
  Point2 away = Point2::Zero();  ///< by which the areas were moved towards the origin, where the lines begin
};

/// The least way by which an area may be moved so that its lines are those of another place.
Point2 phaseOf(const LatticeLines& lines) {
  if (lines.away.isZero()) return Point2::Zero();
  const Point2 across(-std::sin(lines.angle_rad), std::cos(lines.angle_rad));
  return std::remainder(lines.away.dot(across), lines.spacing_mm) * across;
}

/// A join is deposited where a retracted travel would lead along the same border.
std::vector<FillPath> joinedRuns(const Regions& centred, const InfillRequest& request) {
  return joinedRasterRuns(centred, request, kLongestJoin * request.spacing_mm);
}

/// Along the lines that there are without moving anything towards the origin.
std::vector<FillPath> rasterAtPlace(const Regions& centred, const InfillRequest& request,
                                    const Point2& phase) {
  if (phase.isZero()) return joinedRuns(centred, request);
  std::vector<FillPath> runs = joinedRuns(moved(centred, phase), request);
  for (FillPath& run : runs)
    for (Point2& point : run.points) point -= phase;
  return runs;
}

void addLoops(const Regions& centre_lines, PathRole role, std::vector<FillPath>& runs) {
  for (Polygon& loop : outlines(centre_lines))
    runs.push_back({std::move(loop), true, role, Deposit::Bead, {}});
}

bool isWithoutRoom(const Regions& regions, double radius_mm) {
  for (const Region& region : regions)
    if (surelyHasRoom(region, radius_mm)) return false;
  return offset(regions, -radius_mm).empty();
}

/// Lines might miss a column that is narrower than their distance, and the rim of an interface that follows a
/// ledge, where walls lie: they are loops.
bool isForLoops(const Regions& centred, const LatticeLines& lines) {
  const bool is_interface = lines.role == PathRole::SupportInterface;
  const double room_mm =
      is_interface ? kRimLines * lines.spacing_mm : 0.5 * (lines.spacing_mm - lines.pitch_mm);
  return lines.walls == 0 && isWithoutRoom(centred, room_mm);
}

/// As many lines as the distance asks for at least, the first and the last along the borders that they face:
/// what is deposited on an interface finds a bead along all of its rim.
std::vector<FillPath> rasterFromRimToRim(const Regions& centred, InfillRequest request) {
  const Point2 across(-std::sin(request.angle_rad), std::cos(request.angle_rad));
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Region& region : centred)
    for (const Point2& point : region.outer) {
      low = std::min(low, across.dot(point));
      high = std::max(high, across.dot(point));
    }
  const double way = high - low - 2.0 * kWithinRim;
  if (!(way > 0.0)) return {};
  request.spacing_mm = way / std::ceil(way / request.spacing_mm);
  const Point2 away = (low + kWithinRim) * across;
  std::vector<FillPath> runs = joinedRuns(moved(centred, -away), request);
  for (FillPath& run : runs)
    for (Point2& point : run.points) point += away;
  return runs;
}

/// Whether a loop along its rim would lie on an interface: over a lattice it would hang from line to line.
bool liesOnInterface(const Region& column, const Regions* below) {
  return below != nullptr && area(intersection({column}, *below)) > kMostlyOn * area({column});
}

/// Within a loop round it.
void addWithinRim(const Regions& centred, const LatticeLines& lines, const InfillRequest& request,
                  std::vector<FillPath>& runs) {
  addLoops(centred, lines.role, runs);
  for (const Region& within : offset(centred, -lines.pitch_mm))
    for (FillPath& run : rasterFromRimToRim({within}, request)) {
      run.role = lines.role;
      runs.push_back(std::move(run));
    }
}

/// A needle that stands by itself breaks off; only a column that has nothing else keeps it.
std::vector<FillPath> withoutStubs(std::vector<FillPath> runs, const LatticeLines& lines) {
  const auto is_stub = [&lines](const FillPath& run) { return length(run.points) < kStub * lines.pitch_mm; };
  if (lines.role != PathRole::Support || std::all_of(runs.begin(), runs.end(), is_stub)) return runs;
  runs.erase(std::remove_if(runs.begin(), runs.end(), is_stub), runs.end());
  return runs;
}

/// With their loops round them, outermost first.
SharedRuns linesIn(const Regions& area, const LatticeLines& lines) {
  std::vector<FillPath> runs;
  Regions inside = area;
  for (int wall = 0; wall < lines.walls && !inside.empty(); ++wall) {
    addLoops(offset(inside, -0.5 * lines.pitch_mm), lines.role, runs);
    inside = offset(inside, -lines.pitch_mm);
  }
  InfillRequest request;
  request.pitch_mm = lines.pitch_mm;
  request.spacing_mm = lines.spacing_mm;
  request.angle_rad = lines.angle_rad;
  for (const Region& column : inside) {
    Regions centred = offset({column}, -0.5 * lines.pitch_mm);
    if (isForLoops(centred, lines)) {
      for (; !centred.empty(); centred = offset(centred, -lines.spacing_mm))
        addLoops(centred, lines.role, runs);
      continue;
    }
    if (lines.walls == 0 && liesOnInterface(column, lines.below)) {
      addWithinRim(centred, lines, request, runs);
      continue;
    }
    for (FillPath& run : withoutStubs(rasterAtPlace(centred, request, phaseOf(lines)), lines)) {
      run.role = lines.role;
      runs.push_back(std::move(run));
    }
  }
  return std::make_shared<const std::vector<FillPath>>(std::move(runs));
}

/// Whether the lines of both are laid in the same way.
bool layAlike(const SupportSettings& a, const SupportSettings& b) {
  const auto lines = [](const SupportSettings& supports) {
    return std::tie(supports.density, supports.interface_density, supports.raster_angle_deg, supports.walls);
  };
  return lines(a) == lines(b);
}

/// Regions with lines of their own, those that have any.
std::vector<const PlanVariant*> variantsOfLines(const PlanSettings& settings, const LatticePlace& place) {
  std::vector<const PlanVariant*> own;
  if (place.variants == nullptr) return own;
  for (const PlanVariant& variant : *place.variants)
    if (!layAlike(variant.settings.supports, settings.supports)) own.push_back(&variant);
  return own;
}

class LatticePlanner {
 public:
  LatticePlanner(const PlanSettings& settings, const LatticePlace& place)
      : settings_(settings),
        height_mm_(place.layer_height_mm),
        away_(place.away),
        variants_(variantsOfLines(settings, place)) {}

  /// Whether any region with lines of its own reaches into a layer.
  bool isVaried(std::size_t layer) const {
    return std::any_of(variants_.begin(), variants_.end(), [layer](const PlanVariant* variant) {
      return layer < variant->areas.size() && !variant->areas[layer].empty();
    });
  }

  /// @param below  sections of the layer below
  LayerAids plan(const LayerSupport& sections, const LayerSupport& below, std::size_t layer) const {
    Regions interfaces;
    for (const SupportSection& section : below)
      interfaces.insert(interfaces.end(), section.interface->begin(), section.interface->end());
    LayerAids aids;
    for (const SupportSection& section : sections) {
      addIn(section, section.lattice, PathRole::Support, {layer, nullptr}, aids);
      addIn(section, section.interface, PathRole::SupportInterface,
            {layer, interfaces.empty() ? nullptr : &interfaces}, aids);
    }
    return aids;
  }

 private:
  struct SectionPlace {
    std::size_t layer = 0;
    const Regions* below = nullptr;  ///< interfaces of the layer below; null for none
  };

  /// Region by region, each with its own lines.
  void addIn(const SupportSection& section, const SharedRegions& area, PathRole role,
             const SectionPlace& place, LayerAids& aids) const {
    const auto lay = [&](const SharedRegions& piece, const SupportSettings& supports) {
      LatticeLines lines = linesOf(role, supports);
      if (role == PathRole::SupportInterface) lines.below = place.below;
      add(section, piece, lines, aids);
    };
    if (!isVaried(place.layer)) return lay(area, settings_.supports);
    Regions rest = *area;
    for (const PlanVariant* const variant : variants_) {
      if (place.layer >= variant->areas.size()) continue;
      const Regions& own = variant->areas[place.layer];
      const Regions common = intersection(rest, own);
      if (common.empty()) continue;
      rest = difference(rest, own);
      lay(std::make_shared<const Regions>(common), variant->settings.supports);
    }
    lay(std::make_shared<const Regions>(std::move(rest)), settings_.supports);
  }

  void add(const SupportSection& section, const SharedRegions& area, LatticeLines lines,
           LayerAids& aids) const {
    if (area->empty()) return;
    AidRuns group;
    group.bead = beadOf(lines.role, settings_, section.top_mm - section.bottom_mm).bead;
    lines.pitch_mm = planWidth(group.bead);
    group.top_mm = section.top_mm;
    const SupportSettings& supports = settings_.supports;
    const int tool = lines.role == PathRole::Support ? supports.tool : supports.interface_tool;
    group.tool = static_cast<std::uint32_t>(std::max(0, tool));
    group.area = area;
    group.runs = linesIn(*area, lines);
    if (!group.runs->empty()) aids.push_back(std::move(group));
  }

  /// For beads whose width is to come.
  LatticeLines linesOf(PathRole role, const SupportSettings& supports) const {
    const bool is_lattice = role == PathRole::Support;
    LatticeLines lines;
    lines.role = role;
    lines.spacing_mm = planWidth(beadOf(role, settings_, height_mm_).bead) /
                       (is_lattice ? supports.density : supports.interface_density);
    lines.angle_rad = toRadians(supports.raster_angle_deg + (is_lattice ? 0.0 : 90.0));
    lines.walls = supports.walls;
    lines.away = away_;
    return lines;
  }

  const PlanSettings& settings_;
  double height_mm_;  ///< of the layers that lines are spaced for
  Point2 away_;
  std::vector<const PlanVariant*> variants_;
};

/// Whether the areas of a layer are those of the one below it.
bool areAlike(const LayerSupport& a, const LayerSupport& b) {
  const auto height = [](const SupportSection& section) { return section.top_mm - section.bottom_mm; };
  return a.size() == 1 && b.size() == 1 && a[0].lattice == b[0].lattice && a[0].interface == b[0].interface &&
         std::abs(height(a[0]) - height(b[0])) < 1e-9;
}

}  // namespace

std::vector<LayerAids> supportLattice(const std::vector<LayerSupport>& areas, const PlanSettings& settings,
                                      const LatticePlace& place, Progress& progress) {
  const LatticePlanner planner(settings, place);
  std::vector<LayerAids> aids(areas.size());
  // The lowest of interfaces on each other is deposited in another way.
  const auto isShared = [&](std::size_t i) {
    return i > 0 && !planner.isVaried(i) && !planner.isVaried(i - 1) && areAlike(areas[i], areas[i - 1]) &&
           (areas[i][0].interface->empty() || (i > 1 && areAlike(areas[i - 1], areas[i - 2])));
  };
  const auto plan_layer = [&](std::size_t i) {
    if (!isShared(i)) aids[i] = planner.plan(areas[i], i > 0 ? areas[i - 1] : LayerSupport{}, i);
  };
  parallelFor(areas.size(), plan_layer, progress, "supports");
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (!isShared(i)) continue;
    aids[i] = aids[i - 1];
    for (AidRuns& group : aids[i]) group.top_mm = areas[i][0].top_mm;
  }
  return aids;
}

void addVolumes(SupportTotals& totals, const std::vector<LayerAids>& supports) {
  for (const LayerAids& layer : supports)
    for (const AidRuns& group : layer) {
      const bool is_interface = group.runs->front().role == PathRole::SupportInterface;
      (is_interface ? totals.interface_mm3 : totals.support_mm3) += depositedVolume(group);
    }
}

}  // namespace lamina
