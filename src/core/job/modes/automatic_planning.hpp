// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "job/modes/part_planning.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina {

/// Slices by the mode that suits the part. What the settings already say decides first: a base to deposit on,
/// an inclined plane, skins to be followed. Otherwise the modes are tried from the simplest on, until one
/// leaves little enough unsupported (`chosenMode`); those that the request knows to be refused are not. A
/// head that cannot tilt gets level layers. The mode, the reason, what was tried and what was refused stand
/// in the summary.
/// @throws InvalidMesh with all reasons if several modes were tried, and all refuse the part (`Unsliceable`
/// if one of them shows what stands in the way; Unreachable if the machine cannot run the layers of one); the
/// error of the mode itself if one was tried; as `PlanFunction`
PlannedPart planAutomatically(const SourcePart& source, const PlanningRequest& request, SliceSummary& summary,
                              Progress& progress);

/// The machine cannot run the layers that `auto` took. The message names the mode.
class ChoiceRefused final : public Unreachable {
 public:
  /// @param summary  of the layers, with what `auto` tried
  ChoiceRefused(const Unreachable& refusal, const SliceSummary& summary);

  /// What is not to be had, that mode too: a further choice need not try it (`PlanningRequest::refused`).
  const std::vector<ModeCandidate>& refused() const { return refused_; }

 private:
  std::vector<ModeCandidate> refused_;
};

/// @throws ChoiceRefused if `auto` chose the layers among modes that it tried; `refusal` otherwise
[[noreturn]] void rethrowForChoice(const Unreachable& refusal, const SliceSummary& summary);

/// The plane across which a head that holds its nozzle inclined prints; level for all others.
PlaneSettings planeOfHead(const BuildSpace& space);

}  // namespace lamina
