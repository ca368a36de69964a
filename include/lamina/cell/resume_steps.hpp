// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace lamina {

/// Whether what a step of a resume needs is there.
enum class ResumeStepState : std::uint8_t {
  Waits = 0,   ///< not yet
  Done = 1,    ///< proven by the machine
  Person = 2,  ///< a person has to look, and confirm it
};

/// What is to be re-established before a job that was cut off is resumed.
struct ResumeStep {
  std::string name;  ///< by which it is confirmed
  ResumeStepState state = ResumeStepState::Waits;
  std::string text;  ///< what is known, and what is expected
  /// Of a place where a machine stands: length of beads after which the job begins [mm].
  std::optional<double> begin_mm = {};
};

/// What is known of a job that was cut off.
struct ResumeConditions {
  bool is_executor_there = false;
  std::string executor;               ///< its name, for people
  std::vector<std::string> refusals;  ///< why the job cannot be resumed
  std::vector<std::string> unready;   ///< steps of the start-up that are not satisfied, each with the reason
  bool is_by_place = false;           ///< where it goes on depends on where the machine stands
  std::string place;                  ///< where it goes on, in words
  std::optional<double> begin_mm = {};  ///< of a place where the machine stands, as in `ResumeStep`
  std::string temperatures;             ///< as the machine reported them last; empty if it did not
};

/// The steps in the order in which they are to be looked at: link, place, part, heat and process, way.
std::vector<ResumeStep> resumeSteps(const ResumeConditions& found);

/// What a person has confirmed of a resume.
struct ResumeConfirmation {
  std::vector<std::string> steps;  ///< names
  /// `begin_mm` of the place that was confirmed; nothing if that is not stated.
  std::optional<double> begin_mm = {};
};

/// What stands against resuming for the steps that a person has to confirm and has not, a sentence each.
/// Steps that are waited for are not among them. A place that begins more than 0.5 mm from the one that was
/// confirmed is not confirmed.
std::vector<std::string> unconfirmed(const std::vector<ResumeStep>& steps,
                                     const ResumeConfirmation& confirmed);

}  // namespace lamina
