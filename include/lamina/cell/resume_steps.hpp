// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
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
};

/// What is known of a job that was cut off.
struct ResumeConditions {
  bool is_executor_there = false;
  std::string executor;               ///< its name, for people
  std::vector<std::string> refusals;  ///< why the job cannot be resumed
  std::vector<std::string> unready;   ///< steps of the start-up that are not satisfied, each with the reason
  bool is_by_place = false;           ///< where it goes on depends on where the machine stands
  std::string place;                  ///< where it goes on, in words
  std::string temperatures;           ///< as the machine reported them last; empty if it did not
};

/// The steps in the order in which they are to be looked at: link, place, part, heat and process, way.
std::vector<ResumeStep> resumeSteps(const ResumeConditions& found);

/// What stands against resuming for the steps that a person has to confirm and has not, a sentence each.
/// Steps that are waited for are not among them.
std::vector<std::string> unconfirmed(const std::vector<ResumeStep>& steps,
                                     const std::vector<std::string>& confirmed);

}  // namespace lamina
