// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Counts of layers that lie in parallel planes.
LayerCounts countsOf(const std::vector<Layer>& layers);

/// Plans a part in parallel planes, level or inclined.
PlannedPart planPlanar(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in shells parallel to its lower and upper surface, with level layers between them.
PlannedPart planCurved(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in layers adapted to a wall that leans: the wall alone if one wall without infill is asked
/// for, otherwise walls and infill on the surfaces that its curves span.
PlannedPart planAdapted(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in layers parallel to a base, or as a coat on the part.
PlannedPart planConformal(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in pieces, each in plane layers along a direction of its own.
PlannedPart planMultiDirection(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in layers of equal growth, from the bed through the part.
PlannedPart planVolumetric(SourcePart source, const PlanningRequest& request, Progress& progress);

/// Plans a part in layers that bend to follow its upper side, with the nozzle straight down.
PlannedPart planHeightField(SourcePart source, const PlanningRequest& request, Progress& progress);

}  // namespace lamina
