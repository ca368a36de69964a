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

/// A part planned by one mode, and the result of measuring it.
struct ModeTrial {
  ModeCandidate candidate;
  std::optional<PlannedPart> planned;  ///< with its support; nothing if the mode refuses the part
  std::exception_ptr refused_by;       ///< error whose message is the candidate's refusal
  Mesh in_the_way;                     ///< region of the error if it is an Unsliceable
};

/// Whether the machine, and the program for it, may tilt the nozzle.
Nozzle nozzleFor(const SliceJob& job, const BuildSpace& space);

/// Names of the registered modes that `auto` tries one after the other until one is good enough, sorted by
/// the turn in their `AutoTrial`; for parts whose mode the unsupported surface decides.
std::vector<std::string> modesInTurn(const SliceJob& job, const BuildSpace& space);

/// Unsupported surface of a part in plane layers, inclined as the settings say.
UnsupportedSurface unsupportedInPlanes(const Mesh& mesh, const JobSettings& settings);

/// The job with the mode replaced, and the overhang that all modes are compared at.
SliceJob jobBy(const std::string& mode, SliceJob job);

/// Adds notes to the plan on what the job has left out for its mode.
void addNotesOf(const SliceJob& job, PlannedPart& planned);

/// Slices by a named mode. An Unsliceable is rethrown with the mesh of the part, on which the region is
/// shown.
/// @throws as `PlanFunction`
PlannedPart planShown(SourcePart source, const std::string& mode, const PlanningRequest& request,
                      Progress& progress);

/// Plans a part by a mode and measures the surface left unsupported. If the mode refuses the part, the trial
/// holds the error.
/// @throws Cancelled; as `unsupportedSurface`
ModeTrial tryMode(const std::string& mode, const SourcePart& source, const PlanningRequest& request,
                  Progress& progress);

}  // namespace lamina
