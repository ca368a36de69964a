// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/slicing/mode_comparison.hpp"

#include <algorithm>
#include <utility>

#include "job/slicing/automatic_planning.hpp"
#include "job/slicing/mode_choice.hpp"
#include "job/slicing/mode_trial.hpp"
#include "job/slicing/part_slicing.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/part/placement.hpp"

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

/// With the plane that an inclined head needs, unless one is asked for.
SliceJob onMachine(SliceJob job, const BuildSpace& space) {
  if (job.settings.slicing.plane.angle_deg == 0.0) job.settings.slicing.plane = planeOfHead(space);
  return job;
}

}  // namespace

std::vector<std::string> comparableModes(const SliceJob& job) {
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  if (onMachine(job, space).settings.slicing.plane.angle_deg != 0.0) return {"inclined"};
  if (nozzleFor(job, space) == Nozzle::Held) return {"planar", "heightfield"};
  std::vector<std::string> modes = tiltingModes();
  modes.insert(modes.begin(), "planar");
  modes.emplace_back("curved");
  return modes;
}

ModeComparison compareModes(const SliceJob& job, const std::vector<std::string>& modes, Progress& progress) {
  requireDistinct(modes);
  validate(job.settings);
  const BuildSpace space = buildSpaceOf(job.settings.machine);
  const SliceJob placed = onMachine(job, space);
  const SourcePart source = readSource(placed, progress);
  const PlanningRequest request{placed, space,
                                placePart(boundingBox(source.mesh), space, placed.settings.placement)};
  ModeComparison comparison;
  std::vector<ModeCandidate> candidates;
  for (const std::string& mode : modes) {
    ModeTrial trial = tryMode(mode, source, request, progress);
    candidates.push_back(trial.candidate);
    ComparedMode& compared = comparison.modes.emplace_back();
    compared.candidate = std::move(trial.candidate);
    if (!trial.planned) continue;
    compared.toolpath = std::move(trial.planned->plan.toolpath);
    compared.unsupported = std::move(trial.planned->support->unsupported);
  }
  comparison.part = source.mesh;
  comparison.chosen = chosenMode(candidates, job.settings.automatic);
  return comparison;
}

}  // namespace lamina
