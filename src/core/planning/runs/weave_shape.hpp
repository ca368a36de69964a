// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/runs/bead_run_settings.hpp"

namespace lamina {

/// Where a tip that weaves is off its centre line, as shares of the amplitude.
struct WavePlace {
  double left = 0.0;
  double ahead = 0.0;
};

/// At a phase of the wave [waves].
WavePlace wavePlace(const WeaveSettings& settings, double waves);

/// Phases of half a wave at which waypoints stand, the first left out [waves].
std::vector<double> halfWavePhases(const WeaveSettings& settings, double wavelength_mm);

/// How far the tip goes ahead of its line and back behind it, as shares of the amplitude.
struct WaveReach {
  double ahead = 0.0;
  double behind = 0.0;
};
WaveReach waveReach(WeaveKind kind);

/// The tip's least way for each mm of the line, if that is straight: near 0 where the tip goes back just as
/// fast as the line goes on.
double leastProgress(const WeaveSettings& settings, double wavelength_mm);

/// The tip's greatest acceleration at a feed, as a share of that of a sine at the same feed of its advance.
/// Zigzags and trapezia count as a sine.
double sharpness(const WeaveSettings& settings, double wavelength_mm);

}  // namespace lamina
