// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/motion_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "lamina/base/characters.hpp"
#include "program/gcode/command_words.hpp"

namespace lamina {
namespace {

constexpr std::string_view kCoordinateLetters = "XYZE";

/// The command's letter and number: "G1" of "G01 X5"; empty if it is none, or there is more than one in the
/// line.
std::string codeOf(std::string_view command) {
  if (command.size() < 2 || (command[0] != 'G' && command[0] != 'M') || !isDigit(command[1])) return {};
  std::size_t end = 1;
  while (end < command.size() && isDigit(command[end])) ++end;
  if (end < command.size() && command[end] == '.') return {};
  const bool has_text = command.find_first_of("\"{") != std::string_view::npos;
  if (has_text || command.find_first_of("GMTgmt'", end) != std::string_view::npos) return {};
  return command[0] + std::to_string(std::atoi(std::string(command.substr(1, end - 1)).c_str()));
}

/// The number behind a letter; nothing if the letter is missing or has none.
std::optional<double> wordOf(std::string_view words, char letter) {
  const std::size_t at = words.find(letter);
  return at == std::string_view::npos ? std::nullopt : wordNumber(words.substr(at + 1));
}

template <std::size_t count>
bool isOneOf(const std::string& code, const std::array<std::string_view, count>& codes) {
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Commands that set something to a value of their own.
bool setsAbsolutely(const std::string& code) {
  constexpr std::array<std::string_view, 27> kCodes = {"G17",  "G18",  "G19",  "G20",  "G21",  "G90",  "G91",
                                                       "M5",   "M82",  "M83",  "M104", "M106", "M107", "M109",
                                                       "M116", "M140", "M141", "M190", "M191", "M201", "M203",
                                                       "M204", "M205", "M220", "M221", "M400", "M566"};
  return isOneOf(code, kCodes);
}

}  // namespace

void MotionTracker::locate(const ReportedPosition& position) {
  now_.at = {position.x, position.y, position.z, position.e};
  next_ = now_;
}

bool MotionTracker::needsPosition(std::string_view command) const {
  const std::string code = codeOf(command);
  constexpr std::array<std::string_view, 4> kMotions = {"G0", "G1", "G2", "G3"};
  if (!isOneOf(code, kMotions)) return false;
  return std::any_of(now_.at.begin(), now_.at.end(), [](const auto& at) { return !at; });
}

void MotionTracker::forgetPosition() {
  next_.at = {};
  is_repeatable_ = false;
}

void MotionTracker::expect(std::string_view command) {
  next_ = now_;
  seconds_ = 0.0;
  const std::string code = codeOf(command);
  const std::string_view words = command.substr(std::min(command.size(), command.find_first_of(" XYZEFIJ")));
  is_repeatable_ = setsAbsolutely(code);
  if (code == "G90" || code == "G91") {
    next_.is_relative = code == "G91";
  } else if (code == "M82" || code == "M83") {
    next_.is_filament_relative = code == "M83";
  } else if (code == "G20" || code == "G21") {
    next_.is_metric = code == "G21";
  } else if (code == "G92") {
    place(words);
  } else if (code == "G0" || code == "G1" || code == "G2" || code == "G3") {
    move(words);
    if (code == "G2" || code == "G3") is_repeatable_ = false;
  } else if (!is_repeatable_ && code != "G4") {
    forgetPosition();
    if (code.empty()) next_ = {};
  }
}

void MotionTracker::place(std::string_view words) {
  is_repeatable_ = true;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (const auto value = wordOf(words, kCoordinateLetters[i])) next_.at[i] = *value;
  }
}

void MotionTracker::move(std::string_view words) {
  if (words.find_first_not_of("XYZEFIJRK0123456789.+- ") != std::string_view::npos) return forgetPosition();
  is_repeatable_ = true;
  if (const auto feed = wordOf(words, 'F')) next_.feed_mm_min = *feed;
  for (std::size_t i = 0; i < kCount; ++i) {
    const auto value = wordOf(words, kCoordinateLetters[i]);
    if (!value) continue;
    const std::optional<bool> is_relative = i == kE ? now_.is_filament_relative : now_.is_relative;
    if (is_relative != false) is_repeatable_ = false;
    if (!is_relative || !now_.is_metric) {
      next_.at[i] = std::nullopt;
    } else if (*is_relative) {
      if (next_.at[i]) *next_.at[i] += *value;
    } else {
      next_.at[i] = *value;
    }
  }
  if (next_.feed_mm_min > 0.0) seconds_ = 60.0 * wayFrom(now_, next_) / next_.feed_mm_min;
}

double MotionTracker::wayFrom(const State& start, const State& end) {
  double longest = 0.0;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (start.at[i] && end.at[i]) longest = std::max(longest, std::abs(*end.at[i] - *start.at[i]));
  }
  return 2.0 * longest;  // the diagonal, and the arc over it
}

RunEvidence MotionTracker::evidence(const ReportedPosition& found) const {
  constexpr std::array<double, kCount> kVisible = {0.01, 0.01, 0.01, 0.05};  // filament adds up its rounding
  constexpr double kNear = 0.25;                                             // of the way between both
  const std::array<double, kCount> at = {found.x, found.y, found.z, found.e};
  int ran = 0;
  int did_not = 0;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!now_.at[i] || !next_.at[i]) continue;
    const double way = std::abs(*next_.at[i] - *now_.at[i]);
    if (way < kVisible[i]) continue;
    if (std::abs(at[i] - *next_.at[i]) < kNear * way) {
      ++ran;
    } else if (std::abs(at[i] - *now_.at[i]) < kNear * way) {
      ++did_not;
    } else {
      return RunEvidence::None;
    }
  }
  if (ran > 0 && did_not > 0) return RunEvidence::None;
  if (ran > 0) return RunEvidence::Ran;
  return did_not > 0 ? RunEvidence::DidNotRun : RunEvidence::None;
}

}  // namespace lamina
