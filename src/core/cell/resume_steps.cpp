// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/resume_steps.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/base/confirmed_place.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr char kPlace[] = "place";

ResumeStep linkStep(const ResumeConditions& found) {
  if (!found.is_executor_there)
    return {"link", ResumeStepState::Waits, found.executor + " gives no sign of life; expected it to run"};
  return {"link", ResumeStepState::Done, found.executor + " is there"};
}

/// A counter of lines proves a place. Where a robot stands does not: somebody may have moved it.
ResumeStep placeStep(const ResumeConditions& found) {
  if (!found.refusals.empty()) return {kPlace, ResumeStepState::Waits, listed(found.refusals, "; ")};
  if (found.place.empty()) return {kPlace, ResumeStepState::Waits, "where the job goes on is not known yet"};
  if (!found.is_by_place) return {kPlace, ResumeStepState::Done, found.place};
  return {kPlace, ResumeStepState::Person, found.place, found.begin_mm};
}

ResumeStep readyStep(const ResumeConditions& found) {
  if (!found.unready.empty()) return {"ready", ResumeStepState::Waits, listed(found.unready, "; ")};
  const std::string heat = found.temperatures.empty() ? "" : "; last reported: " + found.temperatures;
  return {"ready", ResumeStepState::Person, "heat, material, gas and cooling are ready for the bead" + heat};
}

}  // namespace

std::vector<ResumeStep> resumeSteps(const ResumeConditions& found) {
  const std::string way =
      found.is_by_place
          ? "the way to where it begins is free: the tool is lifted, goes there and comes down along its "
            "axis, "
            "and nobody looks for the part itself on that way"
          : "nothing stands between the nozzle and its next lines, and what has oozed from it is taken away";
  return {linkStep(found),
          placeStep(found),
          {"part", ResumeStepState::Person, "the part stands where it stood, firm on the plate"},
          readyStep(found),
          {"way", ResumeStepState::Person, way}};
}

std::vector<std::string> unconfirmed(const std::vector<ResumeStep>& steps,
                                     const ResumeConfirmation& confirmed) {
  std::vector<std::string> sentences;
  for (const ResumeStep& step : steps) {
    if (step.state != ResumeStepState::Person) continue;
    const auto& names = confirmed.steps;
    if (std::find(names.begin(), names.end(), step.name) == names.end()) {
      sentences.push_back("a person has to confirm '" + step.name + "': " + step.text);
    } else if (step.begin_mm && confirmed.begin_mm &&
               !(std::abs(*step.begin_mm - *confirmed.begin_mm) <= kConfirmedPlace)) {
      sentences.push_back("the '" + step.name + "' that was confirmed begins after " +
                          numberText(*confirmed.begin_mm) + " mm of beads, the job now after " +
                          numberText(*step.begin_mm) + " mm; expected the same to " +
                          numberText(kConfirmedPlace) + " mm: look at it, and confirm it anew");
    } else if (step.name == kPlace && confirmed.begin_mm && !step.begin_mm) {
      sentences.push_back(
          "the '" + step.name + "' that was confirmed begins after " + numberText(*confirmed.begin_mm) +
          " mm of beads, and the job now elsewhere: " + step.text + "; look at it, and confirm it anew");
    }
  }
  return sentences;
}

}  // namespace lamina
