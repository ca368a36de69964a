// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/build_aids.hpp"

namespace lamina {

/// Whether the runs hold up the part.
bool isSupport(const AidRuns& aids);

/// By what the supports of a stack are laid.
struct SupportLaying {
  const PlanSettings& settings;
  const PlanSettings& on_bed;    ///< of the first layer
  TravelSettings travel;         ///< within layers
  Point2 from = Point2::Zero();  ///< where the nozzle begins the first layer [mm]
};

/// Lays the supports of each layer before its islands and behind its other aids, those of lower sections
/// first. Only once all islands are planned is known from where the nozzle comes and where it goes on: runs
/// are ordered by both, and loops begin where the way from the run before to the next one is shortest.
/// @param layers  without supports; joined within, but not to each other
/// @param aids    of each layer; only supports are laid
void laySupports(std::vector<ToolpathLayer>& layers, const std::vector<LayerAids>& aids,
                 const SupportLaying& laying);

}  // namespace lamina
