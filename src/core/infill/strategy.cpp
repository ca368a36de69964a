// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/strategy.hpp"

#include <cmath>
#include <map>

#include "infill/contour/contour.hpp"
#include "infill/contour/perimeters.hpp"
#include "infill/contour/spiral.hpp"
#include "infill/contour/vase.hpp"
#include "infill/drops/drops_contour.hpp"
#include "infill/drops/drops_dense.hpp"
#include "infill/drops/drops_raster.hpp"
#include "infill/hilbert/hilbert.hpp"
#include "infill/hilbert/hilbert_quadtree.hpp"
#include "infill/rectilinear/hybrid.hpp"
#include "infill/rectilinear/zigzag.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// Contours wind one way, by which a program's reader reports borders from holes: they must not be turned
/// round.
InfillStrategy drops(const FillFunction& fill) {
  return {fill, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside, Deposit::Drops};
}

const std::map<std::string, InfillStrategy>& strategies() {
  static const std::map<std::string, InfillStrategy> by_name = {
      {"contour", {contour, RunOrder::Shortest, LayerLink::Chained, WallContact::Beside}},
      {"drops_contour", drops(dropsContour)},
      {"drops_dense", drops(dropsDense)},
      {"drops_raster", drops(dropsRaster)},
      {"hilbert", {hilbert, RunOrder::Shortest, LayerLink::Travel, WallContact::Overlapping}},
      {"hilbert_quadtree", {hilbertQuadtree, RunOrder::Shortest, LayerLink::Chained, WallContact::Beside}},
      {"hybrid", {hybrid, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"perimeters", {perimeters, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"spiral", {spiral, RunOrder::AsGiven, LayerLink::Travel, WallContact::Beside}},
      {"vase", {vase, RunOrder::AsGiven, LayerLink::Rising, WallContact::Beside}},
      {"zigzag", {zigzag, RunOrder::Shortest, LayerLink::Travel, WallContact::Fitted}},
  };
  return by_name;
}

}  // namespace

bool isSolid(const InfillRequest& request) {
  constexpr double kRounding = 1e-6;
  return std::abs(request.spacing_mm - request.pitch_mm) < kRounding * request.pitch_mm;
}

InfillStrategy infillStrategy(const std::string& name) {
  const auto found = strategies().find(name);
  if (found != strategies().end()) return found->second;
  throw InvalidConfig("infill.strategy is '" + name + "'; must be one of " +
                      listed(infillStrategyNames(), " | "));
}

std::vector<std::string> infillStrategyNames() {
  std::vector<std::string> names;
  for (const auto& entry : strategies()) names.push_back(entry.first);
  return names;
}

}  // namespace lamina
