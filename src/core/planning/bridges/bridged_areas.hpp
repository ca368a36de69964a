// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/bridges/bridge_settings.hpp"

namespace lamina {

/// Measures that decide where bridges are.
struct BridgeMeasures {
  BridgeSettings settings;
  double narrowest_mm = 0.4;  ///< narrower unsupported places are supported from their sides
  double thread_pitch_mm = 0.36;
  double fringe_mm = 0.8;  ///< by which hanging areas extend onto the material that holds them
};

/// One bridge.
struct DepositedBridge {
  Regions area;
  std::vector<FillPath> threads;
};

/// An area within walls, divided by what is below it.
struct BridgedAreas {
  std::vector<DepositedBridge> bridges;
  Regions hanging;  ///< unsupported, and not held on both sides
  Regions rest;
  Bridging counts;
};

/// The unsupported part of an area, without places too narrow to sag.
Regions overNothing(const Regions& inside, const Regions& below, double narrowest_mm);

/// Divides an area.
/// @param inside  area within the walls of one layer
/// @param below   material that carries the layer
BridgedAreas bridgedAreas(const Regions& inside, const Regions& below, const BridgeMeasures& measures);

/// Pitch of the threads.
/// @param pitch_mm  distance of neighbouring beads
double threadPitch(const BridgeSettings& settings, double bead_width_mm, double pitch_mm);
/// The bead of a thread.
/// @param bead  nominal bead, which the thread replaces
Bead threadBead(const BridgeSettings& settings, const Bead& bead);

}  // namespace lamina
