// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// What a transform did.
struct RewriteReport {
  std::string slicer;           ///< as the comments report; empty if they do not
  std::size_t lines = 0;        ///< of the source
  std::size_t layers = 0;       ///< reported by the comments
  std::size_t motions = 0;      ///< of the part, rewritten
  std::size_t depositions = 0;  ///< of these, those that deposit the part
  std::size_t arcs = 0;         ///< of these, those made chords of
  std::size_t deferred = 0;     ///< motions left out because not all coordinates were known yet
  std::size_t homings_annulled = 0;
  std::size_t aids_dropped = 0;   ///< motions of skirt, brim, raft, support and priming tower left out
  double layer_height_mm = 0.0;   ///< 0 if neither set nor reported
  Point3 shift = Point3::Zero();  ///< after the map [mm]
  /// Of the deposition ends no higher than a layer above the lowest: what the part stands on. An edge only,
  /// if the mesh was not tilted before it was sliced.
  Box3 footprint;
  Box3 part;                              ///< of the deposition ends over the bed [mm]
  double tool_axis_off_normal_deg = 0.0;  ///< angle between the nozzle and the normal of the layers
  Box3 nozzle;                            ///< of all places the nozzle goes to in the part, over the bed [mm]
};

/// Whether the part is more than ten times as wide as what touches the bed, in x or y: so it comes out if the
/// mesh was not tilted by the opposite angle before it was sliced. Not reported in the listing's mode.
bool standsOnEdge(const RewriteReport& report);

/// How far the nozzle may be held from the layers' normal: far below what a head is built to.
inline constexpr double kToolAxisToleranceDeg = 0.01;

/// Whether the nozzle is held otherwise than along the layers' normal.
bool isToolAxisOffNormal(const RewriteReport& report);

}  // namespace lamina
