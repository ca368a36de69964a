// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <memory>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/volumetric_layers.hpp"
#include "slicing/volumetric/arrival_field.hpp"
#include "slicing/volumetric/growth_lattice.hpp"
#include "slicing/volumetric/growth_measures.hpp"
#include "slicing/volumetric/head_lean.hpp"

namespace lamina {

/// Cells, and when growth reaches them.
struct GrownCells final : HeadRoom::Growth {
  GrownCells(std::shared_ptr<const CellGraph> graph, ArrivalField arrival)
      : cells(std::move(graph)), field(std::move(arrival)) {}

  double at(const Point3& place) const override {
    const std::uint32_t node = cells->nodeAt(place);
    return node == CellGraph::kNone ? std::numeric_limits<double>::infinity() : field.growth_mm[node];
  }

  std::shared_ptr<const CellGraph> cells;
  ArrivalField field;
};

/// A part's growth by one overhang used, and how that suits the surface and the head.
struct GrownPart {
  const Mesh& mesh;
  const VolumetricRequest& request;
  double bed_mm;
  double overhang_rad;  ///< used
  GrowthGauge gauge;
  std::shared_ptr<const GrownCells> grown;
  std::shared_ptr<const GrowthLattice> lattice;
  HangingSurface hanging;
  std::shared_ptr<const HeadRoom> room;
  std::shared_ptr<const HeadLean> lean;  ///< nothing without a head
  double fitted = 0.0;                   ///< share of the fitted growth in it, within [0, 1]
  std::string fit_loss;  ///< why the next larger share of the fit was not taken; empty if all was

  const CellGraph& cells() const { return *grown->cells; }
  const ArrivalField& field() const { return grown->field; }
  double unsupportedPercent() const { return 100.0 * hanging.grown_mm2 / hanging.surface_mm2; }
  /// Of the volume: where the head is not clear by any lean.
  double shut() const { return lean ? lean->shut() : 0.0; }
};

/// What of a part no growth leads to.
struct Pendant {
  double volume_mm3 = 0.0;
  double whole_mm3 = 0.0;  ///< of the part
  Point3 lowest = Point3::Constant(std::numeric_limits<double>::infinity());

  double percent() const { return 100.0 * volume_mm3 / whole_mm3; }
};

Pendant pendantOf(const GrownPart& part);

/// What the growth of a part by one overhang fails to print well.
struct GrowthLoss {
  double unsupported_mm2 = 0.0;
  double pendant_mm3 = 0.0;
};

/// Whether less overhang, by which growth leads to less of the part, is better: some surface is supported
/// instead, and no more volume is lost than a layer over it.
bool supportsMore(const GrowthLoss& next, const GrowthLoss& best, double layer_height_mm);

/// Grows a part, and fits its growth to `VolumetricSettings::target`. The fit is taken whole, or else by a
/// half or a quarter with the growth as it arrives: the largest share by which no more than 0.1 % of the
/// surface is left unsupported in addition, growth has no more minima, no more than 0.5 % of the volume is
/// beyond the bounds of thickness, or no more than without, and the head is clear in as much of the volume,
/// or 99 %.
///
/// It grows by the overhang that `overhang_used_deg` states. If it states none, by 20 deg less than the
/// material takes, and then in steps of 2.5 deg: more where the head has no room between fronts that meet, so
/// that they meet at a wider angle, as long as that makes room, thickness allows it and no more is left
/// unsupported than is taken; less where much is left unsupported, as long as there is less of it, the head
/// has room, and no more volume is lost to pendants than a layer over the surface that is supported instead.
/// @throws Unsliceable if it does not stand on the bed; Cancelled
GrownPart grownPart(const Mesh& mesh, const VolumetricRequest& request, Progress& progress);

}  // namespace lamina
