// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/slicing_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Tolerances of lifted paths.
struct LiftSettings {
  double position_tolerance_mm = 0.005;  ///< greatest distance of the tip from the layer between waypoints
  /// Greatest angle between nozzle and normal; only for `ToolAxis::Normal`.
  double normal_tolerance_deg = 0.1;
  double height_tolerance = 0.05;         ///< greatest relative change of the layer's height along a motion
  double widest_bead = 2.0;               ///< greatest width of a bead, in planned widths
  ToolAxis tool_axis = ToolAxis::Normal;  ///< Down leaves the nozzle upright
};

/// Adds the keys lifting.*; the tool axis has no key.
void describe(SettingsSchema& schema, LiftSettings& settings);

/// Lifts a planned layer onto its charts.
///
/// Runs that deposit follow the surface of the layer's nozzle tips. They get waypoints where they cross edges
/// of triangles, unless the tolerances hold without them; planned waypoints stay. The tool axis is opposite
/// to the normal; the nozzle's frame is `nozzleDown()`, rotated to this axis by the least angle. Each bead is
/// as high as the layer. The volume of a bead is that of the planned bead, scaled to the middle surface of
/// the layer:
///
/// volume = plan area of the bead * area ratio of the triangle * height of the layer
///
/// The same holds for drops. Where tips converge, in a layer whose radius of curvature is about its height, a
/// motion may be too short for its volume. The volume is then spread over neighbouring motions, within a
/// bead's width. Material that would still need a wider bead than allowed is left out, and so are runs that
/// are too short as a whole.
///
/// Travels that are not retracted and stay over one chart follow the layer, with their inner waypoints raised
/// above it by four times the position tolerance. For other travels see `makeSpaceTravel`.
///
/// Motions that lie on no chart are left out, up to a length of five bead widths in a run. They occur where a
/// bead crosses the gap between two charts divided by a fold.
///
/// @param planned  paths in the plan; may not leave the charts by more than `ChartLookup::kSnap`
/// @param highest_mm  z of the highest nozzle tip of this layer and the layers before it [part frame]
/// @return layer height and z as planned; the paths join as the planned ones do. Lifted and left-out volume
///   add up to the planned volume.
/// @throws InvalidInput naming the place, if a longer piece of a run, or a drop, lies on no chart
LiftedLayer liftOnto(const std::vector<LayerChart>& charts, ToolpathLayer planned,
                     const LiftSettings& settings, const TravelSettings& travel, double highest_mm);

/// Lifts each layer onto its charts by `liftOnto`. Layers without charts are level and stay as planned.
/// @param layers  charts of each layer; must outlive the result
/// @param highest_mm  value of `liftOnto` for each layer
/// @throws InvalidInput if `highest_mm` has another size than `layers`; the result throws as `liftOnto`
LayerLift chartLift(const std::vector<std::vector<LayerChart>>& layers, std::vector<double> highest_mm,
                    const LiftSettings& settings, const TravelSettings& travel);

}  // namespace lamina
