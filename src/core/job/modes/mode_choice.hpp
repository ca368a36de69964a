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

/// Index of the mode that `auto` takes; nothing if all candidates are refused. It is the first one that
/// leaves little enough unsupported and takes at most `longest_time` times as long as the quickest candidate
/// so far; candidates after it need not be tried. If there is no such candidate, only those count that take
/// at most `longest_time` times as long as the quickest of all. Among them, those that leave as little
/// unsupported as the best, within `alike_percent`, are compared by the number of steps, then by time, then
/// by order. Refused candidates never count.
/// @param candidates  the simplest first
std::optional<std::size_t> chosenMode(const std::vector<ModeCandidate>& candidates,
                                      const AutomaticSettings& settings);

/// Whether the last candidate is good enough compared with the earlier ones: no further mode has to be tried.
bool isLastGoodEnough(const std::vector<ModeCandidate>& candidates, const AutomaticSettings& settings);

/// Whether a candidate can never be chosen, whatever else is tried: it is refused, or another candidate is no
/// worse in unsupported surface, steps and time, and is preferred between equals.
/// @param candidates  none was tried after one that is good enough
bool isOutdone(const std::vector<ModeCandidate>& candidates, std::size_t which);

/// Why the candidate with index `chosen` was chosen, with the numbers: a sentence without full stop.
std::string reasonFor(const std::vector<ModeCandidate>& candidates, std::size_t chosen,
                      const AutomaticSettings& settings);

/// Whether the part can be sliced by the mode, but the machine cannot run the layers.
bool isRefusedByMachine(const ModeCandidate& candidate);

/// For each mode whose layers the machine cannot run, what it would give and why it cannot be run, to be
/// added to the reason; empty if there is none.
std::string machineRefusals(const std::vector<ModeCandidate>& candidates);

/// What the candidate with index `which` would give, or why it was passed over: a sentence without full stop.
std::string noteOn(const std::vector<ModeCandidate>& candidates, std::size_t which,
                   const AutomaticSettings& settings);

}  // namespace lamina
