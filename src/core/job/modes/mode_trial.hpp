// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "job/modes/part_planning.hpp"
#include "job/modes/skin_modes.hpp"
#include "lamina/job/modes/mode_candidate.hpp"
#include "lamina/verification/overhang/unsupported_surface.hpp"

namespace lamina {

/// A part planned by one mode, and what that gives.
struct ModeTrial {
  ModeCandidate candidate;
  std::optional<PlannedPart> planned;  ///< with its support; nothing if the mode refuses the part
  std::exception_ptr refused_by;       ///< the error that the refusal is the text of
  Mesh in_the_way;                     ///< of an `Unsliceable`: its region
};

/// Whether the machine, and the program for it, may tilt the nozzle.
Nozzle nozzleFor(const SliceJob& job, const BuildSpace& space);

/// The registered modes that `auto` tries until one is good enough, by their turn, where it is the support
/// that decides (`AutoTrial`).
std::vector<std::string> modesInTurn(const SliceJob& job, const BuildSpace& space);

/// Of a part in plane layers as the settings incline them.
UnsupportedSurface unsupportedInPlanes(const Mesh& mesh, const JobSettings& settings);

/// The job by one mode, all modes taking the same overhang.
SliceJob jobBy(const std::string& mode, SliceJob job);

/// Slices by a named mode. A refusal gets the part that its region is shown on.
/// @throws as `PlanFunction`
PlannedPart planShown(SourcePart source, const std::string& mode, const PlanningRequest& request,
                      Progress& progress);

/// Plans a part by a mode, and measures what it leaves unsupported. Refusals stand in the trial.
/// @throws Cancelled; as `unsupportedSurface`
ModeTrial tryMode(const std::string& mode, const SourcePart& source, const PlanningRequest& request,
                  Progress& progress);

}  // namespace lamina
