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
  Shortest,  ///< for short travels
  OneSense,  ///< each after its neighbours on one side, so that none is deposited between two earlier ones
};

/// What a fill strategy is asked for.
struct InfillRequest {
  double spacing_mm = 0.4;  ///< between neighbouring lines, centre to centre; the pitch if the fill is solid
  double pitch_mm = 0.4;    ///< plan width that a bead of nominal cross-section fills
  double angle_rad = 0.0;   ///< of the raster, from x counter-clockwise
  double turn_rad = 0.0;    ///< part of that angle by which this layer is turned against the first one
  Point2 start = Point2::Zero();  ///< where the nozzle comes from
  std::size_t layer = 0;          ///< index, from 0: for seeds and for what changes from layer to layer
  std::size_t island = 0;         ///< index within the layer, from 0: for seeds
  /// Where the plane z = 0 of the regions lies in the part [mm]: for patterns in space. Layers laid out flat
  /// keep the height and the directions of their plan.
  Eigen::Isometry3d part_from_plan = Eigen::Isometry3d::Identity();
  LineLinks links;
  LineAdvance advance = LineAdvance::Shortest;
  /// Of this layer, where the fill grows from the layers above (`FillGrowth`); null where they are not known.
  const std::vector<Polyline>* branches = nullptr;
  FillSettings settings;  ///< what single strategies ask for besides
};

/// Whether neighbouring lines lie side by side at the pitch.
bool isSolid(const InfillRequest& request);

/// How far lines that end beside each other may be joined along the border, in steps between neighbouring
/// lines; negative if they may not. Always 3 for a solid fill: a longer link would lay a bead where none was
/// asked for.
double longestLink(const InfillRequest& request, double step_mm);

/// Height of the layer [mm], along its normal from the part's origin.
double heightOf(const InfillRequest& request);

/// Covers regions with beads, or drops: centre lines keep half a pitch from the border if their beads have
/// the nominal width, else half the width of the bead. No region gives no path. The same regions give the
/// same paths.
using FillFunction =
    std::function<std::vector<FillPath>(const Regions& regions, const InfillRequest& request)>;

/// Who decides in which order the runs of a fill are deposited.
enum class RunOrder {
  Shortest,  ///< the planner, for short travels
  AsGiven,   ///< the strategy
};

/// How the fills of one layer and the next hang together.
enum class LayerLink {
  Travel,
  Chained,  ///< the closed run of a layer is opened where that of the layer below ended, and joined to it
  Rising,   ///< the loops of all layers become one that rises all the time
};

/// Whether the fill of a layer depends on what lies above it.
enum class FillGrowth {
  Alone,
  FromAbove,  ///< branches under the skins above
};

/// Whether the ends of a fill run into the walls around it.
enum class WallContact {
  Overlapping,  ///< by `infill.wall_overlap`
  Fitted,       ///< overlapping if sparse; a solid fill is as wide as its place
  Beside,
};

/// A way to fill, and what the planner has to know about it.
struct InfillStrategy {
  FillFunction fill;
  RunOrder order = RunOrder::Shortest;
  LayerLink link = LayerLink::Travel;
  WallContact contact = WallContact::Beside;
  Deposit deposit = Deposit::Bead;  ///< drops cover the whole section: walls and skirt are of beads
  /// Share of the volume of a sparse fill that is deposited twice where its lines cross: this times the
  /// density.
  double crossing = 0.0;
  FillGrowth growth = FillGrowth::Alone;
  /// Directions of its lines against `infill.angle_deg` [deg] if they are the same in all layers; empty for a
  /// fill that turns with the request.
  std::vector<double> fixed_lines_deg = {};
  /// The strictest `InfillRequest::advance` that its solid fill keeps to.
  LineAdvance advance = LineAdvance::Shortest;
};

/// All strategies, those of plug-ins too. Whoever adds one calls `infillStrategies().add("name", {...})`.
Registry<InfillStrategy>& infillStrategies();

/// The strategy of that name.
/// @throws InvalidConfig if there is none, naming those there are
InfillStrategy infillStrategy(const std::string& name);

/// Whether the strategy of that name lays drops: its toolpaths have no beads within the part.
/// @throws InvalidConfig if there is none
bool laysDrops(const std::string& strategy);

/// Names of all strategies, in alphabetical order.
std::vector<std::string> infillStrategyNames();

}  // namespace lamina
