// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/slicing/automatic_planning.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/slicing/mode_choice.hpp"
#include "job/slicing/skin_modes.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/robot_files.hpp"
#include "lamina/slicing/planar/layer_plane.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/verification/overhang/unsupported_surface.hpp"

namespace lamina {
namespace {

/// From the simplest to print.
constexpr const char* kTiltingModes[] = {"multi_direction", "adapted", "volumetric"};

Nozzle nozzleOf(const PlanningRequest& request) {
  const bool is_held = programRunner(request.job.output) == ProgramRunner::RapidRobot &&
                       request.job.settings.program.rapid.variant != RapidVariant::Powder5Axes;
  return canTurnToolAxis(request.space) && !is_held ? Nozzle::Tilting : Nozzle::Held;
}

SupportQuestion questionOf(const JobSettings& settings) {
  return {settings.automatic.max_overhang_deg, settings.slicing.first_layer_height_mm};
}

UnsupportedSurface unsupportedInPlanes(const Mesh& mesh, const JobSettings& settings) {
  return unsupportedSurface(mesh, partFromLayers(settings.slicing.plane) * Point3::UnitZ(),
                            questionOf(settings));
}

std::string percentText(double percent) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f %%", percent);
  return text;
}

/// The job by one mode, all modes taking the same overhang.
SliceJob jobBy(const std::string& mode, SliceJob job) {
  JobSettings& settings = job.settings;
  settings.slicing.mode = mode;
  settings.directions.max_overhang_deg = settings.automatic.max_overhang_deg;
  settings.volumetric.max_overhang_deg = settings.automatic.max_overhang_deg;
  return job;
}

LayerSupport measuredSupport(const Mesh& mesh, const PlannedPart& planned, const SliceJob& job) {
  const bool is_plane = hasPlaneLayers(job.settings.slicing.mode);
  const UnsupportedSurface surface =
      is_plane ? unsupportedInPlanes(mesh, job.settings)
               : unsupportedSurface(mesh, planned.plan.toolpath, questionOf(job.settings));
  return {surface.surface_mm2, surface.unsupported_mm2, is_plane ? std::size_t{1} : planned.counts.layers};
}

/// Modes tried one after the other, and what came of them.
class ModeTrials {
 public:
  ModeTrials(const SourcePart& source, const PlanningRequest& request) : source_(source), request_(request) {}

  void attempt(const std::string& mode, Progress& progress) {
    ModeCandidate candidate;
    candidate.mode = mode;
    std::optional<PlannedPart> planned;
    try {
      planned = plan(candidate, progress);
    } catch (const InvalidInput& refusal) {
      candidate.refusal = refusal.what();
    }
    candidates_.push_back(std::move(candidate));
    planned_.push_back(std::move(planned));
  }

  bool isGoodEnough() const { return isLastGoodEnough(candidates_, settings()); }
  bool isLastTaken() const { return candidates_.back().refusal.empty(); }
  const std::vector<ModeCandidate>& candidates() const { return candidates_; }
  std::optional<std::size_t> chosen() const { return chosenMode(candidates_, settings()); }
  PlannedPart take(std::size_t place) { return std::move(*planned_[place]); }
  std::string reason(std::size_t place) const { return reasonFor(candidates_, place, settings()); }

  /// On all that were tried but one.
  std::vector<std::string> notesBeside(std::size_t place) const {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (i != place) notes.push_back(noteOn(candidates_, i, settings()));
    return notes;
  }

 private:
  const AutomaticSettings& settings() const { return request_.job.settings.automatic; }

  PlannedPart plan(ModeCandidate& candidate, Progress& progress) const {
    const SliceJob job = jobBy(candidate.mode, request_.job);
    validate(job.settings);
    PlannedPart planned =
        planShown(source_, candidate.mode, {job, request_.space, request_.bed_from_part}, progress);
    if (totals(planned.plan.toolpath).deposition_runs == 0)
      throw InvalidInput("no bead is deposited in any of its " + std::to_string(planned.counts.layers) +
                         " layers; expected at least one");
    const LayerSupport support =
        planned.support ? *planned.support : measuredSupport(source_.mesh, planned, job);
    candidate.unsupported_percent =
        support.surface_mm2 > 0.0 ? 100.0 * support.unsupported_mm2 / support.surface_mm2 : 0.0;
    candidate.steps = support.steps;
    candidate.layers = planned.counts.layers;
    candidate.time_s = estimateTime(planned.plan.toolpath, job.settings.motion).total_s;
    return planned;
  }

  const SourcePart& source_;
  const PlanningRequest& request_;
  std::vector<ModeCandidate> candidates_;
  std::vector<std::optional<PlannedPart>> planned_;
};

PlannedPart taken(ModeTrials& trials, std::size_t place, const std::string& reason, SliceSummary& summary) {
  PlannedPart planned = trials.take(place);
  summary.mode = trials.candidates()[place].mode;
  summary.mode_reason = reason;
  summary.candidates = trials.candidates();
  for (std::string& note : trials.notesBeside(place)) planned.notes.push_back(std::move(note));
  return planned;
}

/// Where nothing is to choose, an error stays what it is.
PlannedPart planNamed(const std::string& mode, const std::string& reason, const SourcePart& source,
                      const PlanningRequest& request, SliceSummary& summary, Progress& progress) {
  const SliceJob job = jobBy(mode, request.job);
  validate(job.settings);
  summary.mode = mode;
  summary.mode_reason = reason;
  return planShown(source, mode, {job, request.space, request.bed_from_part}, progress);
}

std::string noteOnHeld(const PlanningRequest& request) {
  return "modes that tilt the nozzle were not tried: " + request.space.name + " holds it as it is";
}

PlannedPart planBySupport(ModeTrials& trials, const PlanningRequest& request, SliceSummary& summary,
                          Progress& progress) {
  trials.attempt("planar", progress);
  const bool may_tilt = nozzleOf(request) == Nozzle::Tilting;
  if (may_tilt)
    for (const char* const mode : kTiltingModes) {
      if (trials.isGoodEnough()) break;
      trials.attempt(mode, progress);
    }
  const std::optional<std::size_t> chosen = trials.chosen();
  if (!chosen) {
    std::string refusals;
    for (const ModeCandidate& candidate : trials.candidates())
      refusals += "; not " + candidate.mode + ": " + candidate.refusal;
    throw InvalidMesh("no slicing mode takes the part" + refusals);
  }
  PlannedPart planned = taken(trials, *chosen, trials.reason(*chosen), summary);
  if (!may_tilt && !trials.isGoodEnough()) planned.notes.push_back(noteOnHeld(request));
  return planned;
}

}  // namespace

PlannedPart planShown(SourcePart source, const std::string& mode, const PlanningRequest& request,
                      Progress& progress) {
  const SlicingMode by = slicingModes().find(mode);
  if (by.shape == LayerShape::Plane) return by.plan(std::move(source), request, progress);
  const Mesh part = source.mesh;
  try {
    return by.plan(std::move(source), request, progress);
  } catch (Unsliceable& refusal) {
    throw std::move(refusal).on(part);
  }
}

PlannedPart planAutomatically(const SourcePart& source, const PlanningRequest& request, SliceSummary& summary,
                              Progress& progress) {
  const JobSettings& settings = request.job.settings;
  if (!settings.conformal.base.empty())
    return planNamed("conformal", "conformal.base is set", source, request, summary, progress);
  if (settings.slicing.plane.angle_deg != 0.0) {
    PlannedPart planned = planNamed("inclined", "", source, request, summary, progress);
    summary.mode_reason = "the plane of the layers is inclined; " +
                          percentText(unsupportedInPlanes(source.mesh, settings).percent()) +
                          " of the surface stay unsupported";
    return planned;
  }
  ModeTrials trials(source, request);
  if (settings.automatic.follows_skins)
    for (const ModeChoice& choice : modesForSkins(source.mesh, settings, nozzleOf(request))) {
      trials.attempt(choice.mode, progress);
      if (trials.isLastTaken()) return taken(trials, trials.candidates().size() - 1, choice.reason, summary);
    }
  return planBySupport(trials, request, summary, progress);
}

PlaneSettings planeOfHead(const BuildSpace& space) {
  constexpr double kUprightDeg = 0.01;
  constexpr double kPerDegree = 1e6;  // what a machine is described to
  const auto rounded = [](double angle) { return std::round(angle * kPerDegree) / kPerDegree + 0.0; };
  PlaneSettings plane;
  const Point3 axis = toolAxis(space);
  const double angle_deg = toDegrees(std::atan2(axis.head<2>().norm(), -axis.z()));
  if (angle_deg <= kUprightDeg || canTurnToolAxis(space)) return plane;
  plane.angle_deg = rounded(angle_deg);
  plane.axis_heading_deg = rounded(toDegrees(std::atan2(-axis.x(), axis.y())));
  return plane;
}

}  // namespace lamina
