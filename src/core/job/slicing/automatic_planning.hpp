// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "job/slicing/part_planning.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Slices by the mode that suits the part. What the settings already say decides first: a base to be laid on,
/// an inclined plane, skins to be followed. Otherwise the modes are tried from the simplest on, until one
/// leaves little enough unsupported (`chosenMode`). A head that cannot tilt gets level layers. The mode, the
/// reason, what was tried and what was refused stand in the summary.
/// @throws InvalidMesh with all reasons if several modes were tried, and all refuse the part (`Unsliceable`
/// if one of them shows what stands in the way); the error of the mode itself if one was tried; as
/// `PlanFunction`
PlannedPart planAutomatically(const SourcePart& source, const PlanningRequest& request, SliceSummary& summary,
                              Progress& progress);

/// Why the machine cannot run a part. Where `auto` took layers that are not plane, and does not know that
/// level ones refuse the part, it names these: they tilt nothing.
Unreachable withLevelLayersNamed(const Unreachable& refusal, const SliceSummary& summary);

/// The plane across which a head that holds its nozzle inclined prints; level for all others.
PlaneSettings planeOfHead(const BuildSpace& space);

}  // namespace lamina
