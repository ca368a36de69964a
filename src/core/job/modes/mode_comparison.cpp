// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/modes/mode_comparison.hpp"

#include <algorithm>
#include <utility>

#include "job/modes/automatic_planning.hpp"
#include "job/modes/mode_choice.hpp"
#include "job/modes/mode_trial.hpp"
#include "job/modes/part_slicing.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/modes/slicing_mode.hpp"

namespace lamina {
namespace {

void requireDistinct(const std::vector<std::string>& modes) {
  if (modes.empty()) throw InvalidConfig("no mode is given; expected at least one to compare");
  for (auto mode = modes.begin(); mode != modes.end(); ++mode) {
    slicingModes().find(*mode);
    if (std::find(modes.begin(), mode, *mode) != mode)
      throw InvalidConfig("mode '" + *mode + "' is given twice; expected each once");
  }
}

/// As `auto` takes it: deposited on the base if there is one, and with the plane that an inclined head needs,
/// unless one is asked for.
SliceJob onMachine(SliceJob job, const BuildSpace& space) {
  job.settings.slicing.mode = kAutoMode;
  if (job.settings.slicing.plane.angle_deg == 0.0) job.settings.slicing.plane = planeOfHead(space);
  return job;
}

/// What `auto` tries; nothing where settings decide that are not compared: a base, or skins.
std::vector<std::string> modesOfAuto(const PlanningRequest& request) {
  const JobSettings& settings = request.job.settings;
  if (!settings.conformal.base.empty()) return {};
  if (settings.slicing.plane.angle_deg != 0.0) return {"inclined"};
  if (settings.automatic.follows_skins) return {};
  return modesInTurn(request.job, request.space);
}

/// The place of the mode that `auto` takes; nothing if one that it tries is not among them.
std::optional<std::size_t> takenByAuto(const std::vector<ComparedMode>& modes,
                                       const std::vector<std::string>& in_turn,
                                       const AutomaticSettings& settings) {
  std::vector<ModeCandidate> tried;
  std::vector<std::size_t> places;
  for (const std::string& mode : in_turn) {
    const auto found = std::find_if(modes.begin(), modes.end(), [&](const ComparedMode& compared) {
      return compared.candidate.mode == mode;
    });
    if (found == modes.end()) return std::nullopt;
    tried.push_back(found->candidate);
    places.push_back(static_cast<std::size_t>(found - modes.begin()));
    if (isLastGoodEnough(tried, settings)) break;
  }
  const std::optional<std::size_t> chosen = chosenMode(tried, settings);
  if (!chosen) return std::nullopt;
  return places[*chosen];
}

}  // namespace

std::vector<std::string> comparableModes(const SliceJob& job) {
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  if (onMachine(job, space).settings.slicing.plane.angle_deg != 0.0) return {"inclined"};
  std::vector<std::string> modes = modesInTurn(job, space);
  modes.emplace_back(nozzleFor(job, space) == Nozzle::Held ? "heightfield" : "curved");
  return modes;
}

ModeComparison compareModes(const SliceJob& job, const std::vector<std::string>& modes, Progress& progress) {
  requireDistinct(modes);
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  const SliceJob placed = onMachine(job, space);
  validate(placed.settings);
  requireToolAxisFor(placed, space);
  const PartOnBed on_bed = partOnBed(readSource(placed, progress), placed, space);
  const PlanningRequest request{placed, space, on_bed.bed_from_part};
  ModeComparison comparison;
  for (const std::string& mode : modes) {
    ModeTrial trial = tryMode(mode, on_bed.source, request, progress);
    ComparedMode& compared = comparison.modes.emplace_back();
    compared.candidate = std::move(trial.candidate);
    if (!trial.planned) continue;
    compared.toolpath = std::move(trial.planned->plan.toolpath);
    compared.unsupported = std::move(trial.planned->support->unsupported);
  }
  comparison.part = on_bed.source.mesh;
  comparison.chosen = takenByAuto(comparison.modes, modesOfAuto(request), job.settings.automatic);
  return comparison;
}

}  // namespace lamina
