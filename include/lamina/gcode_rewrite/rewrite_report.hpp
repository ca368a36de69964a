// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Result of a transformation.
struct RewriteReport {
  std::string slicer;                ///< name, as the comments state it; empty if they do not
  std::size_t lines = 0;             ///< number of lines of the source
  std::size_t layers = 0;            ///< number of layers that the comments state
  std::size_t motions = 0;           ///< number of motions of the part, which were rewritten
  std::size_t depositions = 0;       ///< number of those motions that deposit the part
  std::size_t arcs = 0;              ///< number of those motions that were arcs and became chords
  std::size_t deferred = 0;          ///< number of motions left out because a coordinate was not known yet
  std::size_t homings_annulled = 0;  ///< number of G28 that became comments
  /// Number of motions of skirt, brim, raft, support and priming tower left out.
  std::size_t aids_dropped = 0;
  double layer_height_mm = 0.0;  ///< layer height of the settings or of the comments; 0 if neither states one
  Point3 shift = Point3::Zero();  ///< shift after the map [mm]
  /// Box of the surface on which the part stands: bounding box of the ends of deposition at most a layer
  /// height above the lowest end [mm]. If the mesh was not tilted before it was sliced, the part stands on an
  /// edge, and this box is narrow.
  Box3 footprint;
  /// How far the lowest bead of the part's first layer begins above the bed; 0 in the mode `Listing`. Above
  /// that gap the first layer, and all layers on it, are deposited in mid-air.
  double first_layer_gap_mm = 0.0;
  Box3 part;                              ///< box of the ends of deposition, over the bed [mm]
  double tool_axis_off_normal_deg = 0.0;  ///< angle between the nozzle and the normal of the layers
  Box3 nozzle;  ///< box of all positions of the nozzle in the part, over the bed [mm]
};

/// Whether the part is more than ten times as wide as its footprint, in x or in y. This is the case if the
/// mesh was not tilted by the opposite angle before it was sliced. Always false in the mode `Listing`, which
/// finds no footprint.
bool standsOnEdge(const RewriteReport& report);

/// Whether nothing holds the first layer: it begins above the bed by more than two layer heights, about the
/// width of a bead. This is also so for a part that is round or level where its layers begin.
bool beginsInAir(const RewriteReport& report);

/// A note for the user on a first layer that begins in mid-air; empty if it does not.
std::string noticeOnFirstLayer(const RewriteReport& report);

/// Greatest angle between tool axis and normal of the layers that is neglected [deg]; heads are built far
/// less accurately.
inline constexpr double kToolAxisToleranceDeg = 0.01;

/// Whether the tool axis is not along the normal of the layers.
bool isToolAxisOffNormal(const RewriteReport& report);

}  // namespace lamina
