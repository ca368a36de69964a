// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "job/modes/part_planning.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Slices by the mode that suits the part. Settings decide first: a base to deposit on, an inclined plane, or
/// skins to be followed. Otherwise modes are tried, the simplest first, until one leaves little enough
/// unsupported (`chosenMode`). Modes that the request lists as refused are not tried. A head that cannot tilt
/// gets level layers. The summary states the mode, the reason, and what was tried and refused.
/// @throws InvalidMesh with all reasons if several modes were tried and all refuse the part: Unsliceable if
///   one of them has a region to show, Unreachable if the machine cannot run the layers of one
/// @throws the error of the mode itself if only one was tried; as `PlanFunction`
PlannedPart planAutomatically(const SourcePart& source, const PlanningRequest& request, SliceSummary& summary,
                              Progress& progress);

/// Thrown if the machine cannot run the layers of the mode that `auto` chose. The message names the mode.
class ChoiceRefused final : public Unreachable {
 public:
  /// @param summary  of the layers, with what `auto` tried
  ChoiceRefused(const Unreachable& refusal, const SliceSummary& summary);

  /// Modes that were refused, the chosen one included, so that a further choice need not try them
  /// (`PlanningRequest::refused`).
  const std::vector<ModeCandidate>& refused() const { return refused_; }

 private:
  std::vector<ModeCandidate> refused_;
};

/// Throws `refusal` again, as ChoiceRefused if `auto` chose the layers among several modes that it tried.
[[noreturn]] void rethrowForChoice(const Unreachable& refusal, const SliceSummary& summary);

/// The plane across which a head with a nozzle fixed at an inclination prints; the level plane for all other
/// heads.
PlaneSettings planeOfHead(const BuildSpace& space);

}  // namespace lamina
