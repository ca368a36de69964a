// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "lamina/base/registry.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/fill_settings.hpp"
#include "lamina/infill/line_link.hpp"

namespace lamina {

/// In which order the lines of a solid zigzag are deposited.
enum class LineAdvance {
  Shortest,  ///< in the order of the shortest travels
  /// Each line has earlier lines on one side only; no line is deposited between two earlier lines.
  OneSense,
};

/// Input of an infill strategy besides the regions.
struct InfillRequest {
  /// Distance of the centre lines of neighbouring lines; equal to the pitch if the fill is solid.
  double spacing_mm = 0.4;
  double pitch_mm = 0.4;          ///< plan width that a bead of nominal cross-section fills
  double angle_rad = 0.0;         ///< direction of the raster, from x counter-clockwise
  double turn_rad = 0.0;          ///< part of `angle_rad` that rotates this layer relative to the first layer
  Point2 start = Point2::Zero();  ///< position from which the nozzle comes
  /// Index of the layer, from 0; for random seeds, and for fills that change from layer to layer.
  std::size_t layer = 0;
  std::size_t island = 0;  ///< index within the layer, from 0: for random seeds
  /// Pose of the regions' plane z = 0 in the part [mm], for patterns in space. Layers that were laid out flat
  /// keep the height and the directions of their plan.
  Eigen::Isometry3d part_from_plan = Eigen::Isometry3d::Identity();
  LineLinks links;
  LineAdvance advance = LineAdvance::Shortest;
  /// Branches in this layer of a fill that grows from the layers above (`FillGrowth`); null if they are not
  /// known.
  const std::vector<Polyline>* branches = nullptr;
  FillSettings settings;  ///< settings of all strategies
};

/// Whether the fill is solid: the spacing of the lines is the pitch.
bool isSolid(const InfillRequest& request);

/// Greatest length of links along the border between lines that end side by side, in steps between
/// neighbouring lines; negative if they may not be linked. Always 3 for a solid fill, as a longer link would
/// deposit a bead where none is wanted.
double longestLink(const InfillRequest& request, double step_mm);

/// Height of the layer [mm], along its normal from the part's origin.
double heightOf(const InfillRequest& request);

/// Fills regions with beads or drops: the distance from the border to a centre line is half a pitch for a
/// bead of nominal width, otherwise half the bead's width. No regions give no runs. The same regions give the
/// same runs.
using FillFunction =
    std::function<std::vector<FillPath>(const Regions& regions, const InfillRequest& request)>;

/// Who decides on the order in which the runs of a fill are deposited.
enum class RunOrder {
  Shortest,  ///< the planner, for short travels
  AsGiven,   ///< the strategy
};

/// How the fill of a layer is connected with that of the next one.
enum class LayerLink {
  Travel,   ///< by a travel
  Chained,  ///< the closed run of a layer is opened where the run below ended, and joined to the run below
  Rising,   ///< the loops of all layers become one that rises steadily
};

/// Whether the fill of a layer depends on what lies above it.
enum class FillGrowth {
  Alone,      ///< it does not
  FromAbove,  ///< it does: branches below the skins above
};

/// Whether the ends of a fill overlap the walls around it.
enum class WallContact {
  Overlapping,  ///< they do, by `infill.wall_overlap`
  Fitted,       ///< a sparse fill overlaps; a solid fill is as wide as the area within the walls
  Beside,       ///< they do not
};

/// How the beads of a solid fill lie in its area.
enum class SolidFit {
  Fitted,   ///< up to the border, with their widths fitted to the room there
  InCells,  ///< in equal cells; areas in which no cell fits stay open
};

/// An infill strategy, with the properties that the planner needs to know.
struct InfillStrategy {
  FillFunction fill;
  RunOrder order = RunOrder::Shortest;
  LayerLink link = LayerLink::Travel;
  WallContact contact = WallContact::Beside;
  /// Drops fill the whole section, without walls and skirt, as these are beads.
  Deposit deposit = Deposit::Bead;
  /// Share of the volume of a sparse fill that is deposited twice where its lines cross, divided by the
  /// density.
  double crossing = 0.0;
  FillGrowth growth = FillGrowth::Alone;
  /// Directions of the fill's lines relative to `infill.angle_deg` [deg] if they are the same in all layers;
  /// empty for a fill that is rotated by the request.
  std::vector<double> fixed_lines_deg = {};
  /// The strictest `InfillRequest::advance` that its solid fill can keep.
  LineAdvance advance = LineAdvance::Shortest;
  SolidFit solid = SolidFit::Fitted;
};

/// All strategies by name, those of plug-ins included. A plug-in adds one by `infillStrategies().add("name",
/// {...})`.
Registry<InfillStrategy>& infillStrategies();

/// The strategy of that name.
/// @throws InvalidConfig if there is none, naming the existing strategies
InfillStrategy infillStrategy(const std::string& name);

/// Whether the strategy of that name deposits drops: its toolpaths have no beads within the part.
/// @throws InvalidConfig if there is none
bool depositsDrops(const std::string& strategy);

/// Names of all strategies, in alphabetical order.
std::vector<std::string> infillStrategyNames();

}  // namespace lamina
