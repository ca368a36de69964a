// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/runs/bead_run_settings.hpp"

namespace lamina {

/// Offset of a weaving tip from its centre line, as shares of the amplitude.
struct WavePlace {
  double left = 0.0;
  double ahead = 0.0;
};

/// The offset at a phase of the wave [waves].
WavePlace wavePlace(const WeaveSettings& settings, double waves);

/// Phases of the waypoints of half a wave, except the first [waves].
std::vector<double> halfWavePhases(const WeaveSettings& settings, double wavelength_mm);

/// Greatest offsets of the tip ahead of the centre line's point and behind it, as shares of the amplitude.
struct WaveReach {
  double ahead = 0.0;
  double behind = 0.0;
};
WaveReach waveReach(WeaveKind kind);

/// The least distance that the tip moves for each mm of a straight centre line: near 0 if at some phase the
/// tip moves back as fast as the centre line advances.
double leastProgress(const WeaveSettings& settings, double wavelength_mm);

/// The tip's greatest acceleration at a feed, relative to that of a sine wave with the same advance. Zigzags
/// and trapezia count as a sine.
double sharpness(const WeaveSettings& settings, double wavelength_mm);

}  // namespace lamina
