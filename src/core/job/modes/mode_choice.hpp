// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/job/modes/automatic_settings.hpp"
#include "lamina/job/modes/mode_candidate.hpp"

namespace lamina {

/// The first that leaves little enough unsupported, and takes at most `longest_time` times as long as the
/// quickest of those up to it: what comes later changes nothing, so that it need not be tried. If there is
/// none, of those that take at most `longest_time` times as long as the quickest of all, the one with the
/// fewest steps of those that leave as little as the best, or alike; of several of these the quickest, then
/// the first. Refused ones count for nothing.
/// @param candidates  the simplest first
/// @return its place; nothing if all are refused
std::optional<std::size_t> chosenMode(const std::vector<ModeCandidate>& candidates,
                                      const AutomaticSettings& settings);

/// Whether the last candidate is good enough beside those before it, so that no further one has to be tried.
bool isLastGoodEnough(const std::vector<ModeCandidate>& candidates, const AutomaticSettings& settings);

/// Whether one of them is never chosen, whatever else is tried: it is refused, or another, preferred where
/// both are alike, leaves no more unsupported in no more steps and no more time.
/// @param candidates  none of them tried behind one that is good enough
bool isOutdone(const std::vector<ModeCandidate>& candidates, std::size_t which);

/// Why one of them was chosen, with the numbers: a sentence without full stop.
std::string reasonFor(const std::vector<ModeCandidate>& candidates, std::size_t chosen,
                      const AutomaticSettings& settings);

/// Whether a mode takes the part, but the machine cannot run its layers.
bool isRefusedByMachine(const ModeCandidate& candidate);

/// What each mode would give whose layers the machine cannot run, and why it cannot, to be added to the
/// reason; empty if there is none.
std::string machineRefusals(const std::vector<ModeCandidate>& candidates);

/// What one of them would give, or why it was passed over: a sentence without full stop.
std::string noteOn(const std::vector<ModeCandidate>& candidates, std::size_t which,
                   const AutomaticSettings& settings);

}  // namespace lamina
