// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaffold/sinusoidal.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "scaffold/layer_assembly.hpp"

namespace lamina {
namespace {

constexpr double kParallelFill = M_PI / 4.0;
constexpr double kMirroredFill = 0.98;

void requireConsistent(const ScaffoldSettings& settings) {
  if (2.0 * settings.amplitude_mm > settings.length_mm)
    throw InvalidConfig("scaffold.amplitude_mm is " + std::to_string(settings.amplitude_mm) +
                        " mm; must be at most half of scaffold.length_mm, " +
                        std::to_string(0.5 * settings.length_mm) + " mm");
  if (settings.arrangement == FilamentArrangement::Mirrored && settings.wave != ScaffoldWave::Sine)
    throw InvalidConfig("scaffold.arrangement is mirrored; scaffold.wave must then be sine");
}

bool isMirrored(const ScaffoldSettings& settings) {
  return settings.arrangement == FilamentArrangement::Mirrored;
}

/// Offset of a filament from its middle line, over the amplitude.
double waveAt(const ScaffoldSettings& settings, std::size_t layer, double phase) {
  const bool is_sine =
      settings.wave == ScaffoldWave::Sine || (settings.wave == ScaffoldWave::SineCosine && layer % 2 != 0);
  return is_sine ? std::sin(phase) : std::cos(phase);
}

/// Quarter turns of a layer.
std::size_t turnsOf(const ScaffoldSettings& settings, std::size_t layer) {
  return settings.wave == ScaffoldWave::SineCosine ? layer / 2 : layer;
}

Polyline filament(const ScaffoldSettings& settings, std::size_t layer, int index) {
  const double side = settings.length_mm;
  const double amplitude = settings.amplitude_mm;
  const double sign = isMirrored(settings) && index % 2 != 0 ? -1.0 : 1.0;
  const double middle = amplitude + index * (side - 2.0 * amplitude) / (settings.filaments - 1);
  const int segments = std::max(1, settings.cycles * settings.cycle_segments);
  const Eigen::Rotation2Dd turn(0.5 * M_PI * static_cast<double>(turnsOf(settings, layer) % 4));
  Polyline line;
  for (int s = 0; s <= segments; ++s) {
    const double along = static_cast<double>(s) / segments;
    const double wave = waveAt(settings, layer, 2.0 * M_PI * settings.cycles * along);
    line.push_back(turn * Point2(side * (along - 0.5), middle + sign * amplitude * wave - 0.5 * side));
  }
  return line;
}

}  // namespace

Toolpath sinusoidalScaffold(const ScaffoldSettings& settings) {
  requireConsistent(settings);
  const double kind_fill = isMirrored(settings) ? kMirroredFill : kParallelFill;
  const Point2 corner(settings.corner_x_mm, settings.corner_y_mm);
  LayerAssembly assembly(settings, corner + Point2::Constant(0.5 * settings.length_mm),
                         settings.bead_fill > 0.0 ? settings.bead_fill : kind_fill);
  const std::vector<double> tops = layerTops(settings);
  for (std::size_t layer = 0; layer < tops.size(); ++layer) {
    std::vector<ScaffoldRun> runs;
    for (int i = 0; i < settings.filaments; ++i) {
      Polyline line = filament(settings, layer, i);
      // To and fro, so that travels are short.
      if (i % 2 != 0) std::reverse(line.begin(), line.end());
      runs.push_back({std::move(line)});
    }
    assembly.add(tops[layer], runs);
  }
  return assembly.finish("sinusoidal");
}

}  // namespace lamina
