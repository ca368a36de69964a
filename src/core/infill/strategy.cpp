// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/strategy.hpp"

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "infill/contour/contour.hpp"
#include "infill/contour/perimeters.hpp"
#include "infill/contour/spiral.hpp"
#include "infill/contour/vase.hpp"
#include "infill/drops/drops_contour.hpp"
#include "infill/drops/drops_dense.hpp"
#include "infill/drops/drops_raster.hpp"
#include "infill/hilbert/hilbert.hpp"
#include "infill/hilbert/hilbert_quadtree.hpp"
#include "infill/lightning/lightning.hpp"
#include "infill/pattern/crossing_lines.hpp"
#include "infill/pattern/gyroid.hpp"
#include "infill/pattern/honeycomb.hpp"
#include "infill/rectilinear/hybrid.hpp"
#include "infill/rectilinear/zigzag.hpp"

namespace lamina {
namespace {

/// Contours wind one way, by which a program's reader distinguishes borders from holes: they must not be
/// turned round.
InfillStrategy drops(const FillFunction& fill) {
  return {fill, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside, Deposit::Drops};
}

/// Solid ones are zigzags.
InfillStrategy pattern(const FillFunction& fill, std::vector<double> lines_deg, double crossing = 0.0) {
  return {fill,          RunOrder::Shortest, LayerLink::Travel, WallContact::Fitted,
          Deposit::Bead, crossing,           FillGrowth::Alone, std::move(lines_deg)};
}

InfillStrategy cells(const FillFunction& fill, LayerLink link, WallContact contact) {
  InfillStrategy strategy{fill, RunOrder::Shortest, link, contact};
  strategy.solid = SolidFit::InCells;
  return strategy;
}

InfillStrategy zigzags() {
  InfillStrategy strategy{zigzag, RunOrder::Shortest, LayerLink::Travel, WallContact::Fitted};
  strategy.advance = LineAdvance::OneSense;
  return strategy;
}

std::map<std::string, InfillStrategy> builtInStrategies() {
  const std::vector<double> two_ways = {0.0, 90.0};
  const std::vector<double> three_ways = {0.0, 60.0, 120.0};
  return {
      {"contour", {contour, RunOrder::Shortest, LayerLink::Chained, WallContact::Beside}},
      {"cubic", pattern(cubicFill, three_ways, 1.0 / 3.0)},
      {"drops_contour", drops(dropsContour)},
      {"drops_dense", drops(dropsDense)},
      {"drops_raster", drops(dropsRaster)},
      {"grid", pattern(gridFill, two_ways, 0.25)},
      {"gyroid", pattern(gyroid, two_ways)},
      {"hilbert", cells(hilbert, LayerLink::Travel, WallContact::Overlapping)},
      {"hilbert_quadtree", cells(hilbertQuadtree, LayerLink::Chained, WallContact::Beside)},
      {"honeycomb", pattern(honeycomb, three_ways)},
      {"hybrid", {hybrid, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"lightning",
       {lightning, RunOrder::Shortest, LayerLink::Travel, WallContact::Fitted, Deposit::Bead, 0.0,
        FillGrowth::FromAbove}},
      {"perimeters", {perimeters, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"spiral", {spiral, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"triangles", pattern(trianglesFill, three_ways, 0.25)},
      {"vase", {vase, RunOrder::AsGiven, LayerLink::Rising, WallContact::Beside}},
      {"zigzag", zigzags()},
  };
}

}  // namespace

bool isSolid(const InfillRequest& request) {
  constexpr double kRounding = 1e-6;
  return std::abs(request.spacing_mm - request.pitch_mm) < kRounding * request.pitch_mm;
}

double longestLink(const InfillRequest& request, double step_mm) {
  constexpr double kLongestLink = 3.0;
  if (isSolid(request)) return kLongestLink;
  switch (request.links.link) {
    case LineLink::None:
      return -1.0;
    case LineLink::UpTo:
      return request.links.longest_mm / step_mm;
    case LineLink::Border:
      break;
  }
  return kLongestLink;
}

double heightOf(const InfillRequest& request) {
  return request.part_from_plan.linear().col(2).dot(request.part_from_plan.translation());
}

Registry<InfillStrategy>& infillStrategies() {
  static Registry<InfillStrategy> registry("infill.strategy", builtInStrategies());
  return registry;
}

InfillStrategy infillStrategy(const std::string& name) { return infillStrategies().find(name); }

bool depositsDrops(const std::string& strategy) { return infillStrategy(strategy).deposit == Deposit::Drops; }

std::vector<std::string> infillStrategyNames() { return infillStrategies().names(); }

}  // namespace lamina
