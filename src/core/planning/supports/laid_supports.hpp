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

/// Settings for depositing the supports of a stack, and the start.
struct SupportLaying {
  const PlanSettings& settings;
  const PlanSettings& on_bed;    ///< of the first layer
  TravelSettings travel;         ///< within layers
  Point2 from = Point2::Zero();  ///< where the nozzle begins the first layer [mm]
};

/// Deposits the supports of each layer after its other aids and before its islands, lower sections first. To
/// be called once all islands are planned, as only then the places are known from which the nozzle comes and
/// to which it goes on. Runs are ordered by both places. A loop begins where the travels from the run before
/// and to the next run are shortest.
/// @param layers  without supports; joined within, but not to each other
/// @param aids    of each layer; only supports are deposited
void laySupports(std::vector<ToolpathLayer>& layers, const std::vector<LayerAids>& aids,
                 const SupportLaying& laying);

}  // namespace lamina
