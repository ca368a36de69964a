// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/automatic_planning.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "job/modes/mode_choice.hpp"
#include "job/modes/mode_trial.hpp"
#include "job/modes/skin_modes.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/slicing/unsliceable.hpp"

namespace lamina {
namespace {

std::string percentText(double percent) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f %%", percent);
  return text;
}

/// Modes tried one after the other, and what came of them. Only plans that may still be taken are kept.
class ModeTrials {
 public:
  ModeTrials(const SourcePart& source, const PlanningRequest& request) : source_(source), request_(request) {}

  void attempt(const std::string& mode, Progress& progress) {
    ModeTrial trial = known(mode);
    if (trial.candidate.refusal.empty()) trial = tryMode(mode, source_, request_, progress);
    candidates_.push_back(std::move(trial.candidate));
    if (trial.refused_by) refused_by_ = trial.refused_by;
    if (!trial.in_the_way.triangles.empty()) in_the_way_ = std::move(trial.in_the_way);
    if (trial.planned) trial.planned->support.reset();
    planned_.push_back(std::move(trial.planned));
    for (std::size_t i = 0; i < planned_.size(); ++i)
      if (isOutdone(candidates_, i)) planned_[i].reset();
  }

  bool isGoodEnough() const { return isLastGoodEnough(candidates_, settings()); }
  bool isLastTaken() const { return candidates_.back().refusal.empty(); }
  const std::vector<ModeCandidate>& candidates() const { return candidates_; }
  std::optional<std::size_t> chosen() const { return chosenMode(candidates_, settings()); }
  PlannedPart take(std::size_t place) { return std::move(*planned_[place]); }
  std::string reason(std::size_t place) const { return reasonFor(candidates_, place, settings()); }

  /// Of one mode its own error; of several all reasons, and the region of the last that shows one.
  [[noreturn]] void refuse() const {
    if (candidates_.size() == 1) std::rethrow_exception(refused_by_);
    const bool is_for_machine = std::any_of(candidates_.begin(), candidates_.end(), isRefusedByMachine);
    std::string message =
        is_for_machine ? "no slicing mode suits part and machine" : "no slicing mode takes the part";
    for (const ModeCandidate& candidate : candidates_)
      message += "; not " + candidate.mode + ": " + candidate.refusal;
    if (is_for_machine) throw Unreachable(message);
    if (in_the_way_.triangles.empty()) throw InvalidMesh(message);
    throw Unsliceable(message, in_the_way_).withPart(source_.mesh);
  }

  /// On all that were tried but one.
  std::vector<std::string> notesBeside(std::size_t place) const {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (i != place) notes.push_back(noteOn(candidates_, i, settings()));
    return notes;
  }

 private:
  /// What an earlier choice found; without refusal if it found none.
  ModeTrial known(const std::string& mode) const {
    ModeTrial trial;
    for (const ModeCandidate& candidate : request_.refused)
      if (candidate.mode == mode) trial.candidate = candidate;
    trial.refused_by = std::make_exception_ptr(Unreachable(trial.candidate.refusal));
    return trial;
  }

  const AutomaticSettings& settings() const { return request_.job.settings.automatic; }

  const SourcePart& source_;
  const PlanningRequest& request_;
  std::vector<ModeCandidate> candidates_;
  std::vector<std::optional<PlannedPart>> planned_;
  std::exception_ptr refused_by_;
  Mesh in_the_way_;
};

PlannedPart taken(ModeTrials& trials, std::size_t place, const std::string& reason, SliceSummary& summary) {
  PlannedPart planned = trials.take(place);
  summary.mode = trials.candidates()[place].mode;
  summary.mode_reason = reason + machineRefusals(trials.candidates());
  summary.candidates = trials.candidates();
  for (std::string& note : trials.notesBeside(place)) planned.notes.push_back(std::move(note));
  return planned;
}

/// Where nothing is to choose, an error stays what it is.
PlannedPart planNamed(const std::string& mode, const SourcePart& source, const PlanningRequest& request,
                      SliceSummary& summary, Progress& progress) {
  const SliceJob job = jobBy(mode, request.job);
  validate(job.settings);
  summary.mode = mode;
  PlannedPart planned = planShown(source, mode, {job, request.space, request.bed_from_part}, progress);
  addNotesOf(job, planned);
  return planned;
}

std::string noteOnHeld(const PlanningRequest& request) {
  return "modes that tilt the nozzle were not tried: " + request.space.name + " holds it as it is";
}

PlannedPart planBySupport(ModeTrials& trials, const PlanningRequest& request, SliceSummary& summary,
                          Progress& progress) {
  for (const std::string& mode : modesInTurn(request.job, request.space)) {
    trials.attempt(mode, progress);
    if (trials.isGoodEnough()) break;
  }
  const std::optional<std::size_t> chosen = trials.chosen();
  if (!chosen) trials.refuse();
  PlannedPart planned = taken(trials, *chosen, trials.reason(*chosen), summary);
  const bool is_held = nozzleFor(request.job, request.space) == Nozzle::Held;
  if (is_held && !trials.isGoodEnough()) planned.notes.push_back(noteOnHeld(request));
  return planned;
}

}  // namespace

PlannedPart planAutomatically(const SourcePart& source, const PlanningRequest& request, SliceSummary& summary,
                              Progress& progress) {
  const JobSettings& settings = request.job.settings;
  if (!settings.conformal.base.empty()) {
    summary.mode_reason = "conformal.base is set";
    return planNamed("conformal", source, request, summary, progress);
  }
  if (settings.slicing.plane.angle_deg != 0.0) {
    PlannedPart planned = planNamed("inclined", source, request, summary, progress);
    summary.mode_reason = "the plane of the layers is inclined; " +
                          percentText(unsupportedInPlanes(source.mesh, settings).percent()) +
                          " of the surface stay unsupported";
    return planned;
  }
  ModeTrials trials(source, request);
  if (settings.automatic.follows_skins)
    for (const ModeChoice& choice :
         modesForSkins(source.mesh, settings, nozzleFor(request.job, request.space))) {
      trials.attempt(choice.mode, progress);
      if (trials.isLastTaken()) return taken(trials, trials.candidates().size() - 1, choice.reason, summary);
    }
  return planBySupport(trials, request, summary, progress);
}

ChoiceRefused::ChoiceRefused(const Unreachable& refusal, const SliceSummary& summary)
    : Unreachable(std::string(refusal.what()) + "; auto took slicing.mode=" + summary.mode) {
  for (ModeCandidate candidate : summary.candidates) {
    if (candidate.mode == summary.mode) candidate.refusal = refusal.what();
    if (!candidate.refusal.empty()) refused_.push_back(std::move(candidate));
  }
}

void rethrowForChoice(const Unreachable& refusal, const SliceSummary& summary) {
  if (summary.candidates.empty()) throw refusal;
  throw ChoiceRefused(refusal, summary);
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
