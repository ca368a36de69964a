// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "planning/layer_planner.hpp"
#include "planning/tools/tool_beads.hpp"
#include "planning/walls/infill_spacing.hpp"

namespace lamina {

/// The runs of a solid fill, in the order in which they are deposited.
struct SolidRuns {
  std::vector<FillPath> in_turn;    ///< deposited first, in this order
  std::vector<FillPath> any_order;  ///< deposited afterwards, ordered for short travels
};

/// The fill of one layer within its walls: how its areas meet the walls, with which beads, and along which
/// runs. Of earlier deposition it knows only what the requests state.
class LayerFill {
 public:
  /// @param context    must outlive this
  /// @param index      of the layer, from 0
  /// @param height_mm  of its beads
  LayerFill(const PlanContext& context, std::size_t index, double height_mm);

  const LayerBeads& beads() const { return beads_; }
  /// Distance of neighbouring walls [mm].
  double pitch() const { return beads_.walls.pitch_mm; }
  bool isSolid() const { return lamina::isSolid(infill_); }
  /// Whether the density is 0.
  bool isNone() const { return infill_.spacing_mm == 0.0; }
  /// Whether the strategy fits its lines between the walls.
  bool isFitted() const;
  bool depositsDrops() const;
  /// Whether beads fill the layer; false for a vase.
  bool isFilledByBeads() const;

  /// How the infill meets the walls. A sparse one runs into them rather than ending at them.
  WallContact contact() const;
  /// Distance by which the infill reaches into the walls [mm].
  double overlap() const;
  /// Whether a solid infill is fitted apart from the walls: its beads differ in width from those of the
  /// walls.
  bool isFittedAlone() const;
  /// The area that the infill's lines cover. Without walls the area is offset by half the difference between
  /// the infill's pitch and the pitch that its beads fill: otherwise the part would grow or shrink.
  Regions area(const Regions& inside) const;

  /// The request of the layer's infill, without island, start and branches.
  InfillRequest request() const;
  /// The same with the pitch of another role, for infill in place of that role.
  InfillRequest requestAs(PathRole role, InfillRequest request) const;
  /// The same, for skins.
  /// @param turn_deg  rotation relative to the skins of the first layer
  InfillRequest skinRequest(InfillRequest request, double turn_deg) const;

  /// The runs of the infill in an area, smoothed.
  std::vector<FillPath> infill(const Regions& area, const InfillRequest& request) const;
  /// The runs of a solid fill up to the border of an area.
  SolidRuns solid(const Regions& area, PathRole role, InfillRequest request,
                  const InfillStrategy& strategy) const;

 private:
  const PlanContext& context_;
  std::size_t index_;
  LayerBeads beads_;
  InfillSpacing infill_;
};

}  // namespace lamina
