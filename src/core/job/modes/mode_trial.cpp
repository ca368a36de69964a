// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/mode_trial.hpp"

#include <algorithm>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

SupportCriteria criteriaOf(const JobSettings& settings) {
  return {settings.automatic.max_overhang_deg, settings.slicing.first_layer_height_mm};
}

SupportMeasures measuredSupport(const Mesh& mesh, const PlannedPart& planned, const JobSettings& settings,
                                Progress& progress) {
  const bool is_plane = hasPlaneLayers(settings.slicing.mode);
  UnsupportedSurface surface =
      is_plane ? unsupportedInPlanes(mesh, settings)
               : unsupportedSurface(mesh, planned.plan.toolpath, criteriaOf(settings), progress);
  return {surface.unsupported_mm2, is_plane ? std::size_t{1} : planned.counts.layers,
          std::move(surface.region)};
}

PlannedPart plannedBy(const SliceJob& job, const SourcePart& source, const PlanningRequest& request,
                      Progress& progress) {
  validate(job.settings);
  PlannedPart planned =
      planShown(source, job.settings.slicing.mode, {job, request.space, request.bed_from_part}, progress);
  if (totals(planned.plan.toolpath).deposition_runs == 0)
    throw InvalidInput("no bead is deposited in any of its " + std::to_string(planned.counts.layers) +
                       " layers; expected at least one");
  addNotesOf(job, planned);
  return planned;
}

}  // namespace

Nozzle nozzleFor(const SliceJob& job, const BuildSpace& space) {
  const bool is_held = programRunner(job.output) == ProgramRunner::RapidRobot &&
                       job.settings.program.rapid.variant != RapidVariant::Powder5Axes;
  return canTurnToolAxis(space) && !is_held ? Nozzle::Tilting : Nozzle::Held;
}

std::vector<std::string> modesInTurn(const SliceJob& job, const BuildSpace& space) {
  const bool is_held = nozzleFor(job, space) == Nozzle::Held;
  std::vector<std::pair<int, std::string>> in_turn;
  for (const std::string& name : slicingModes().names()) {
    const SlicingMode mode = slicingModes().find(name);
    if (mode.auto_trial == AutoTrial::None || (is_held && mode.auto_trial == AutoTrial::TiltingHead))
      continue;
    in_turn.emplace_back(mode.auto_turn, name);
  }
  std::sort(in_turn.begin(), in_turn.end());
  std::vector<std::string> modes;
  modes.reserve(in_turn.size());
  for (auto& [turn, name] : in_turn) modes.push_back(std::move(name));
  return modes;
}

UnsupportedSurface unsupportedInPlanes(const Mesh& mesh, const JobSettings& settings) {
  return unsupportedSurface(mesh, partFromLayers(settings.slicing.plane) * Point3::UnitZ(),
                            criteriaOf(settings));
}

void addNotesOf(const SliceJob& job, PlannedPart& planned) {
  const std::vector<std::string>& left_out = job.settings.giving_way.notes;
  planned.notes.insert(planned.notes.end(), left_out.begin(), left_out.end());
}

SliceJob jobBy(const std::string& mode, SliceJob job) {
  JobSettings& settings = job.settings;
  settings.slicing.mode = mode;
  settings.directions.max_overhang_deg = settings.automatic.max_overhang_deg;
  settings.volumetric.max_overhang_deg = settings.automatic.max_overhang_deg;
  // The part has been read, and is as large as shrinkage makes it, for all modes.
  settings.giving_way.keys.erase("compensation.shrink_xy");
  settings.giving_way.keys.erase("compensation.shrink_z");
  settings.giving_way.notes.clear();
  settings = withoutLeftOut(std::move(settings));
  return job;
}

PlannedPart planShown(SourcePart source, const std::string& mode, const PlanningRequest& request,
                      Progress& progress) {
  const SlicingMode by = slicingModes().find(mode);
  if (by.shape == LayerShape::Plane) return by.plan(std::move(source), request, progress);
  const Mesh part = source.mesh;
  try {
    return by.plan(std::move(source), request, progress);
  } catch (Unsliceable& refusal) {
    throw std::move(refusal).withPart(part);
  }
}

ModeTrial tryMode(const std::string& mode, const SourcePart& source, const PlanningRequest& request,
                  Progress& progress) {
  ModeTrial trial;
  trial.candidate.mode = mode;
  const SliceJob job = jobBy(mode, request.job);
  try {
    trial.planned = plannedBy(job, source, request, progress);
  } catch (const InvalidInput& refusal) {
    trial.candidate.refusal = refusal.what();
    trial.refused_by = std::current_exception();
    if (const auto* const shown = dynamic_cast<const Unsliceable*>(&refusal))
      trial.in_the_way = shown->region();
    return trial;
  }
  PlannedPart& planned = *trial.planned;
  if (!planned.support) planned.support = measuredSupport(source.mesh, planned, job.settings, progress);
  const SupportMeasures& support = *planned.support;
  const double surface_mm2 = surfaceArea(source.mesh);
  if (surface_mm2 > 0.0) trial.candidate.unsupported_percent = 100.0 * support.unsupported_mm2 / surface_mm2;
  trial.candidate.steps = support.steps;
  trial.candidate.layers = planned.counts.layers;
  trial.candidate.time_s = estimateTime(planned.plan.toolpath, job.settings.motion).total_s;
  return trial;
}

}  // namespace lamina
