// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/modes/mode_choice.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <tuple>

namespace lamina {
namespace {

/// Of printing, beside the first of them.
double longestTime(const std::vector<ModeCandidate>& candidates, std::size_t count,
                   const AutomaticSettings& settings) {
  double quickest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i)
    if (candidates[i].refusal.empty()) quickest = std::min(quickest, candidates[i].time_s);
  return settings.longest_time * quickest;
}

bool isGood(const ModeCandidate& candidate, const AutomaticSettings& settings) {
  return candidate.unsupported_percent <= settings.good_unsupported_percent;
}

/// Beside those before it: what is tried later takes nothing from it.
bool isGoodEnough(const std::vector<ModeCandidate>& candidates, std::size_t place,
                  const AutomaticSettings& settings) {
  const ModeCandidate& candidate = candidates[place];
  return candidate.refusal.empty() && isGood(candidate, settings) &&
         candidate.time_s <= longestTime(candidates, place + 1, settings);
}

/// Places of those that are not refused and do not take too long.
std::vector<std::size_t> eligible(const std::vector<ModeCandidate>& candidates,
                                  const AutomaticSettings& settings) {
  const double longest_s = longestTime(candidates, candidates.size(), settings);
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (candidates[i].refusal.empty() && candidates[i].time_s <= longest_s) places.push_back(i);
  return places;
}

std::string numbersOf(const ModeCandidate& candidate) {
  char text[160];
  std::snprintf(text, sizeof text, "%.2f %% of the surface unsupported in %zu step%s, %zu layers, %.1f min",
                candidate.unsupported_percent, candidate.steps, candidate.steps == 1 ? "" : "s",
                candidate.layers, candidate.time_s / 60.0);
  return text;
}

std::string wouldLeave(const ModeCandidate& candidate) {
  std::string numbers = "would leave " + numbersOf(candidate);
  if (!isRefusedByMachine(candidate)) return numbers;
  return numbers + ", but the machine cannot run it: " + candidate.refusal;
}

std::string limitText(double percent) {
  char text[48];
  std::snprintf(text, sizeof text, "%.4g %%", percent);
  return text;
}

/// " of those that take at most ..." if that leaves one out of the first of them; empty otherwise.
std::string limitOfTime(const std::vector<ModeCandidate>& candidates, std::size_t count,
                        const AutomaticSettings& settings) {
  const double longest_s = longestTime(candidates, count, settings);
  const bool leaves_one_out =
      std::any_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(count),
                  [&](const ModeCandidate& each) { return each.refusal.empty() && each.time_s > longest_s; });
  if (!leaves_one_out) return "";
  char text[96];
  std::snprintf(text, sizeof text, " of those that take at most %.1f min (auto.longest_time)",
                longest_s / 60.0);
  return text;
}

std::string limitOfMachine(const std::vector<ModeCandidate>& candidates) {
  const bool leaves_one_out = std::any_of(candidates.begin(), candidates.end(), isRefusedByMachine);
  return leaves_one_out ? " that the machine can run" : "";
}

}  // namespace

std::optional<std::size_t> chosenMode(const std::vector<ModeCandidate>& candidates,
                                      const AutomaticSettings& settings) {
  for (std::size_t place = 0; place < candidates.size(); ++place)
    if (isGoodEnough(candidates, place, settings)) return place;
  const std::vector<std::size_t> places = eligible(candidates, settings);
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t place : places) least = std::min(least, candidates[place].unsupported_percent);
  std::optional<std::size_t> best;
  const auto rank = [&](std::size_t place) {
    return std::tuple(candidates[place].steps, candidates[place].time_s, place);
  };
  for (const std::size_t place : places)
    if (candidates[place].unsupported_percent <= least + settings.alike_percent)
      if (!best || rank(place) < rank(*best)) best = place;
  return best;
}

bool isLastGoodEnough(const std::vector<ModeCandidate>& candidates, const AutomaticSettings& settings) {
  return !candidates.empty() && isGoodEnough(candidates, candidates.size() - 1, settings);
}

bool isOutdone(const std::vector<ModeCandidate>& candidates, std::size_t which) {
  const ModeCandidate& one = candidates[which];
  if (!one.refusal.empty()) return true;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const ModeCandidate& other = candidates[i];
    if (i == which || !other.refusal.empty()) continue;
    const bool is_first = std::tuple(other.steps, other.time_s, i) < std::tuple(one.steps, one.time_s, which);
    if (is_first && other.time_s <= one.time_s && other.unsupported_percent <= one.unsupported_percent)
      return true;
  }
  return false;
}

std::string reasonFor(const std::vector<ModeCandidate>& candidates, std::size_t chosen,
                      const AutomaticSettings& settings) {
  const ModeCandidate& taken = candidates[chosen];
  std::string reason = "it leaves " + numbersOf(taken) + ", ";
  if (isGood(taken, settings))
    reason += "the simplest" + limitOfTime(candidates, chosen + 1, settings) + " with at most " +
              limitText(settings.good_unsupported_percent);
  else
    reason += "in the fewest steps of those that leave about the least; none" + limitOfMachine(candidates) +
              limitOfTime(candidates, candidates.size(), settings) + " leaves at most " +
              limitText(settings.good_unsupported_percent);
  if (chosen > 0 && candidates.front().refusal.empty())
    reason += "; " + candidates.front().mode + " " + wouldLeave(candidates.front());
  return reason;
}

bool isRefusedByMachine(const ModeCandidate& candidate) {
  return !candidate.refusal.empty() && candidate.layers > 0;
}

std::string machineRefusals(const std::vector<ModeCandidate>& candidates) {
  std::string text;
  for (const ModeCandidate& candidate : candidates)
    if (isRefusedByMachine(candidate)) text += "; " + candidate.mode + " " + wouldLeave(candidate);
  return text;
}

std::string noteOn(const std::vector<ModeCandidate>& candidates, std::size_t which,
                   const AutomaticSettings& settings) {
  const ModeCandidate& candidate = candidates[which];
  if (isRefusedByMachine(candidate)) return "not " + candidate.mode + ": it " + wouldLeave(candidate);
  if (!candidate.refusal.empty()) return "not " + candidate.mode + ": " + candidate.refusal;
  std::string note = "not " + candidate.mode + ": it " + wouldLeave(candidate);
  const double longest_s = longestTime(candidates, candidates.size(), settings);
  if (candidate.time_s <= longest_s) return note;
  char text[96];
  std::snprintf(text, sizeof text, "; it may take %.1f min (auto.longest_time)", longest_s / 60.0);
  return note + text;
}

}  // namespace lamina
