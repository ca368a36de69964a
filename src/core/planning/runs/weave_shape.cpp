// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/weave_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr double kEightAhead = 0.5;             // of the amplitude, by which an eight goes ahead and back
constexpr double kEightSharpness = 17.0 / 8.0;  // greatest of (sin² + 4 sin² 2x)^0.5
constexpr std::size_t kMostInHalf = 64;         // points of half a wave
constexpr std::size_t kLookedAt = 720;          // places of a wave

/// First and second derivatives of the tip's place by the advance times the wave's turn, in the unit of the
/// amplitude; the advance itself left out.
struct WaveMotion {
  double left = 0.0;
  double ahead = 0.0;
  double left_bend = 0.0;
  double ahead_bend = 0.0;
};

WaveMotion waveMotion(WeaveKind kind, double turn) {
  WaveMotion motion{std::cos(turn), 0.0, -std::sin(turn), 0.0};
  if (kind == WeaveKind::Circle) motion.ahead = std::sin(turn), motion.ahead_bend = std::cos(turn);
  if (kind == WeaveKind::Eight) {
    motion.ahead = 2.0 * kEightAhead * std::cos(2.0 * turn);
    motion.ahead_bend = -4.0 * kEightAhead * std::sin(2.0 * turn);
  }
  return motion;
}

double placeTurn(std::size_t place) {
  return 2.0 * M_PI * static_cast<double>(place) / static_cast<double>(kLookedAt);
}

/// Greatest curvature of the tip's way, in that of a sine's crest.
double greatestBend(WeaveKind kind, double steepness) {
  double greatest = 0.0;
  for (std::size_t place = 0; place < kLookedAt; ++place) {
    const WaveMotion motion = waveMotion(kind, placeTurn(place));
    const double ahead = 1.0 + steepness * motion.ahead;
    const double left = steepness * motion.left;
    const double speed = std::hypot(ahead, left);
    const double across = std::abs(ahead * motion.left_bend - left * motion.ahead_bend);
    greatest = std::max(greatest, across / (speed * speed * speed));
  }
  return greatest;
}

/// Of the tip for each mm of advance, were it a sine that passes its line.
double steepnessOf(const WeaveSettings& settings, double wavelength_mm) {
  return 2.0 * M_PI * settings.amplitude_mm / wavelength_mm;
}

}  // namespace

WavePlace wavePlace(const WeaveSettings& settings, double waves) {
  const double phase = waves - std::floor(waves);
  const double turn = 2.0 * M_PI * phase;
  if (settings.kind == WeaveKind::Sine) return {std::sin(turn), 0.0};
  if (settings.kind == WeaveKind::Circle) return {std::sin(turn), 1.0 - std::cos(turn)};
  if (settings.kind == WeaveKind::Eight) return {std::sin(turn), kEightAhead * std::sin(2.0 * turn)};
  // The slope of a zigzag, or a steeper one that is cut off at both sides.
  const double flat = settings.kind == WeaveKind::Trapezium ? settings.flat_share : 0.0;
  const double triangle = phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
  return {std::clamp(triangle / (1.0 - 2.0 * flat), -1.0, 1.0), 0.0};
}

std::vector<double> halfWavePhases(const WeaveSettings& settings, double wavelength_mm) {
  if (settings.kind == WeaveKind::Zigzag) return {0.25, 0.5};
  if (settings.kind == WeaveKind::Trapezium)
    return {0.25 - 0.5 * settings.flat_share, 0.25 + 0.5 * settings.flat_share, 0.5};
  // A chord of length d is off a curve of curvature k by k d² / 8; with the advance for the parameter the
  // second derivative takes the place of the curvature.
  const double turn = 2.0 * M_PI / wavelength_mm;
  const double bend =
      settings.amplitude_mm * turn * turn * (settings.kind == WeaveKind::Eight ? kEightSharpness : 1.0);
  const double step_mm = std::sqrt(8.0 * settings.tolerance_mm / bend);
  const auto quarters = static_cast<std::size_t>(std::ceil(0.25 * wavelength_mm / step_mm));
  const std::size_t count = 2 * std::clamp<std::size_t>(quarters, 1, kMostInHalf / 2);
  std::vector<double> phases;
  phases.reserve(count);
  for (std::size_t i = 1; i <= count; ++i)
    phases.push_back(0.5 * static_cast<double>(i) / static_cast<double>(count));
  return phases;
}

WaveReach waveReach(WeaveKind kind) {
  if (kind == WeaveKind::Circle) return {2.0, 0.0};
  if (kind == WeaveKind::Eight) return {kEightAhead, kEightAhead};
  return {};
}

double leastProgress(const WeaveSettings& settings, double wavelength_mm) {
  if (settings.kind != WeaveKind::Circle && settings.kind != WeaveKind::Eight) return 1.0;
  const double steepness = steepnessOf(settings, wavelength_mm);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t place = 0; place < kLookedAt; ++place) {
    const WaveMotion motion = waveMotion(settings.kind, placeTurn(place));
    least = std::min(least, std::hypot(1.0 + steepness * motion.ahead, steepness * motion.left));
  }
  return least;
}

double sharpness(const WeaveSettings& settings, double wavelength_mm) {
  if (settings.kind != WeaveKind::Circle && settings.kind != WeaveKind::Eight) return 1.0;
  if (settings.feed == WeaveFeed::Tip)
    return greatestBend(settings.kind, steepnessOf(settings, wavelength_mm));
  return settings.kind == WeaveKind::Eight ? kEightSharpness : 1.0;
}

}  // namespace lamina
