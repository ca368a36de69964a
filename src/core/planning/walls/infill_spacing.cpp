// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/walls/infill_spacing.hpp"

#include <cstdio>
#include <string>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kLeastPitch = 0.5;    // nearer beads lie on each other
constexpr double kWidestSolid = 1.25;  // beads farther apart no longer touch

InfillSpacing atPitch(const char* key, double asked_mm, double pitch_mm) {
  if (asked_mm < kLeastPitch * pitch_mm) {
    char message[160];
    std::snprintf(message, sizeof message,
                  "%s is %.6g mm; must be 0 or at least %.6g mm, half of what a bead fills", key, asked_mm,
                  kLeastPitch * pitch_mm);
    throw InvalidConfig(message);
  }
  if (asked_mm <= kWidestSolid * pitch_mm) return {asked_mm, asked_mm};
  return {asked_mm, pitch_mm};
}

}  // namespace

InfillSpacing infillSpacing(const InfillSettings& settings, double pitch_mm, const LayerPlace& place) {
  const auto outer = static_cast<std::size_t>(settings.outer_layers);
  if (place.index < outer || place.index + outer >= place.count) {
    if (settings.outer_pitch_mm == 0.0) return {pitch_mm, pitch_mm};
    return atPitch("infill.outer_pitch_mm", settings.outer_pitch_mm, pitch_mm);
  }
  if (settings.pitch_mm > 0.0) return atPitch("infill.pitch_mm", settings.pitch_mm, pitch_mm);
  if (settings.density == 0.0) return {0.0, pitch_mm};
  if (isSolid(settings)) return {pitch_mm, pitch_mm};
  return {pitch_mm / settings.density, pitch_mm};
}

}  // namespace lamina
