// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/volumetric_layers.hpp"
#include "slicing/volumetric/arrival_field.hpp"
#include "slicing/volumetric/growth_lattice.hpp"
#include "slicing/volumetric/growth_measures.hpp"
#include "slicing/volumetric/head_lean.hpp"

namespace lamina {

/// The cells of a part, and the growth at which each is reached.
class GrownCells final : public HeadRoom::Growth {
 public:
  GrownCells(std::shared_ptr<const CellGraph> graph, ArrivalField arrival);

  double at(const Point3& place) const override {
    const std::uint32_t node = cells->nodeAt(place);
    return node == CellGraph::kNone ? std::numeric_limits<double>::infinity() : field.growth_mm[node];
  }

  double leastAround(const Point3& place) const override;

  std::shared_ptr<const CellGraph> cells;
  ArrivalField field;

 private:
  std::size_t blockOf(const std::array<int, 3>& block) const;
  void spreadAlong(std::size_t axis);

  VoxelFrame blocks_;          ///< of several cells, with a margin round the part
  std::vector<double> least_;  ///< least growth in and around each block
};

/// Growth of a part for one overhang used, and how well it supports the surface and suits the head.
struct GrownPart {
  const Mesh& mesh;
  const VolumetricRequest& request;
  double bed_mm;
  double overhang_rad;  ///< overhang that growth uses on purpose
  GrowthGauge gauge;
  std::shared_ptr<const GrownCells> grown;
  std::shared_ptr<const GrowthLattice> lattice;
  HangingSurface hanging;
  std::shared_ptr<const HeadRoom> room;
  std::shared_ptr<const HeadLean> lean;  ///< nothing if no head is given
  double fitted = 0.0;                   ///< share of the fitted growth in the growth, within [0, 1]
  std::string fit_loss;  ///< why the next larger share of the fit was not taken; empty if the whole fit was

  const CellGraph& cells() const { return *grown->cells; }
  const ArrivalField& field() const { return grown->field; }
  double unsupportedPercent() const { return 100.0 * hanging.grown_mm2 / hanging.surface_mm2; }
  /// Share of the volume in which the head cannot avoid a collision by any lean.
  double shut() const { return lean ? lean->shut() : 0.0; }
};

/// The part of the volume that no growth reaches.
struct Pendant {
  double volume_mm3 = 0.0;
  double whole_mm3 = 0.0;  ///< volume of the whole part
  Point3 lowest = Point3::Constant(std::numeric_limits<double>::infinity());

  double percent() const { return 100.0 * volume_mm3 / whole_mm3; }
};

Pendant pendantOf(const GrownPart& part);

/// What cannot be printed well if a part grows by one overhang.
struct GrowthLoss {
  double unsupported_mm2 = 0.0;
  double pendant_mm3 = 0.0;
};

/// Whether `next`, with less overhang used and so perhaps more pendant volume, is better than `best`: it
/// leaves less surface unsupported, and the additional pendant volume is at most one layer over the surface
/// that is supported instead.
bool supportsMore(const GrowthLoss& next, const GrowthLoss& best, double layer_height_mm);

/// Grows a part, and fits its growth to `VolumetricSettings::target`. The share of the fitted growth is the
/// largest of 1, 1/2, 1/4 and 0 with which
/// - at most 0.1 % of the surface is left unsupported in addition,
/// - growth has no additional minima,
/// - at most 0.5 % of the volume is beyond the bounds of thickness, or no more than without the fit,
/// - the head is clear in 99 % of the volume, or in as much as without the fit.
///
/// The part grows with the overhang that `overhang_used_deg` states. If that is not set, growth starts with
/// 20 deg less than the material allows and is varied in steps of 2.5 deg. More overhang is used if the head
/// has no room between fronts that meet, as fronts then meet at a wider angle: as long as this makes room,
/// thickness allows it, and no more surface is left unsupported than is allowed. Less overhang is used if
/// much surface is left unsupported: as long as this surface shrinks, the head has room, and the additional
/// pendant volume is at most one layer over the surface that is supported instead.
/// @throws Unsliceable if the part does not stand on the bed; Cancelled
GrownPart grownPart(const Mesh& mesh, const VolumetricRequest& request, Progress& progress);

}  // namespace lamina
