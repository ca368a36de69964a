// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/bridges/bridge_settings.hpp"

namespace lamina {

/// What decides where bridges are [mm].
struct BridgeMeasures {
  BridgeSettings settings;
  double narrowest_mm = 0.4;  ///< what is narrower is carried by its sides
  double thread_pitch_mm = 0.36;
  double fringe_mm = 0.8;  ///< by which what hangs goes on over what holds it
};

/// One bridge.
struct LaidBridge {
  Regions area;
  std::vector<FillPath> threads;
};

/// An area within walls by what is below it.
struct BridgedAreas {
  std::vector<LaidBridge> bridges;
  Regions hanging;  ///< over nothing, and not held on both sides
  Regions rest;
  Bridging counts;
};

/// What of an area lies over nothing, without places too narrow to sag.
Regions overNothing(const Regions& inside, const Regions& below, double narrowest_mm);

/// @param inside  walls, of one layer
/// @param below   what carries the layer
BridgedAreas bridgedAreas(const Regions& inside, const Regions& below, const BridgeMeasures& measures);

/// Pitch of the threads, and the bead of each.
/// @param pitch_mm  at which beads are laid side by side
double threadPitch(const BridgeSettings& settings, double bead_width_mm, double pitch_mm);
Bead threadBead(const BridgeSettings& settings, const Bead& bead);

}  // namespace lamina
