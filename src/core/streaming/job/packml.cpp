// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/job/packml.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace lamina {
namespace {

using State = PackmlState;

constexpr std::array<std::pair<State, State>, 18> kArrows = {{
    {State::Idle, State::Starting},
    {State::Starting, State::Execute},
    {State::Execute, State::Holding},
    {State::Holding, State::Held},
    {State::Held, State::Unholding},
    {State::Unholding, State::Execute},
    {State::Execute, State::Suspending},
    {State::Suspending, State::Suspended},
    {State::Suspended, State::Unsuspending},
    {State::Unsuspending, State::Execute},
    {State::Execute, State::Completing},
    {State::Completing, State::Complete},
    {State::Complete, State::Resetting},
    {State::Stopping, State::Stopped},
    {State::Stopped, State::Resetting},
    {State::Resetting, State::Idle},
    {State::Aborting, State::Aborted},
    {State::Aborted, State::Clearing},
}};

bool canStop(State state) {
  constexpr std::array<State, 5> kCannot = {State::Stopping, State::Stopped, State::Aborting, State::Aborted,
                                            State::Clearing};
  return std::find(kCannot.begin(), kCannot.end(), state) == kCannot.end();
}

}  // namespace

const char* toString(PackmlState state) {
  constexpr std::array<const char*, 17> kNames = {
      "Idle",       "Starting",  "Execute",    "Holding",   "Held",        "Unholding",
      "Suspending", "Suspended", "Completing", "Complete",  "Stopping",    "Stopped",
      "Aborting",   "Aborted",   "Clearing",   "Resetting", "Unsuspending"};
  const auto index = static_cast<std::size_t>(state);
  return index < kNames.size() ? kNames[index] : "Unknown";
}

bool isLegalTransition(PackmlState from, PackmlState to) {
  if (to == State::Aborting) return from != State::Aborting && from != State::Aborted;
  if (to == State::Stopping) return canStop(from);
  if (from == State::Clearing) return to == State::Stopped;
  return std::find(kArrows.begin(), kArrows.end(), std::make_pair(from, to)) != kArrows.end();
}

bool isFinal(PackmlState state) {
  return state == State::Complete || state == State::Stopped || state == State::Aborted;
}

}  // namespace lamina
