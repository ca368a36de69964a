// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Counts of layers that lie in parallel planes.
LayerCounts countsOf(const std::vector<Layer>& layers);

/// By parallel planes, level or inclined.
PlannedPart planPlanar(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By shells of the lower and upper surface, and level layers between them.
PlannedPart planCurved(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers adapted to a wall that leans: the wall alone if one wall without infill is asked for, otherwise
/// walls and infill on the surfaces that its curves span.
PlannedPart planAdapted(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers on a base, or a coat on the part.
PlannedPart planConformal(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By pieces along directions of their own, each in plane layers.
PlannedPart planMultiDirection(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers of equal growth from the bed through the part.
PlannedPart planVolumetric(SourcePart source, const PlanningRequest& request, Progress& progress);

/// By layers that bend to follow the part's upper side, the nozzle straight down.
PlannedPart planHeightField(SourcePart source, const PlanningRequest& request, Progress& progress);

}  // namespace lamina
