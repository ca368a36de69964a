// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/expected_position.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lamina {
namespace {

constexpr double kInch = 25.4;  // mm
// Above the step of any machine, and the rounding of reports.
constexpr double kPlaceTolerance = 0.1;  // mm

std::string millimetres(double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3f mm", value);
  return text.data();
}

/// Commands that leave places and coordinates alone.
bool isHarmless(const GrblWord& word) {
  constexpr std::string_view kOtherLetters = "FIJKLNPRSTABCUVWXYZ";
  const int tenfold = word.tenfold();
  if (word.letter == 'M')
    return tenfold <= 50 || tenfold == 70 || tenfold == 80 || tenfold == 90 || tenfold == 300 ||
           tenfold == 560;
  return kOtherLetters.find(word.letter) != std::string_view::npos;
}

}  // namespace

ExpectedPosition::ExpectedPosition(std::string_view modes) {
  constexpr std::string_view kStart = "[GC:";
  if (modes.substr(0, kStart.size()) != kStart) return;
  modes.remove_prefix(kStart.size());
  is_followed_ = true;
  follow(modes.substr(0, modes.find(']')));
}

void ExpectedPosition::giveUp() {
  is_followed_ = false;
  forget();
}

/// @return whether the command is one that sets how words are read
bool ExpectedPosition::setMode(int tenfold) {
  constexpr int kLastMotion = 30;
  constexpr int kFirstWork = 540;
  constexpr int kLastWork = 590;
  if (tenfold <= kLastMotion && tenfold % 10 == 0) {
    moves_ = true;
  } else if (tenfold == 200 || tenfold == 210) {
    unit_mm_ = tenfold == 200 ? kInch : 1.0;
  } else if (tenfold == 800) {
    moves_ = false;
  } else if (tenfold == 900 || tenfold == 910) {
    is_absolute_ = tenfold == 900;
  } else if (tenfold >= kFirstWork && tenfold <= kLastWork && tenfold % 10 == 0) {
    if (tenfold != work_system_) forget();
    work_system_ = tenfold;
  } else {
    constexpr std::array<int, 11> kNoMatter = {40, 170, 180, 190, 400, 500, 610, 911, 930, 940, 980};
    return std::find(kNoMatter.begin(), kNoMatter.end(), tenfold) != kNoMatter.end();
  }
  return true;
}

void ExpectedPosition::onCommand(int tenfold, Line& line) {
  constexpr std::array<int, 7> kGoesElsewhere = {100, 280, 300, 431, 490, 530, 921};
  if (setMode(tenfold)) return;
  if (tenfold >= 382 && tenfold <= 385) {
    moves_ = false;  // a probe ends where it touches
    forget();
  } else if (tenfold == 920) {
    line.moves_along_words = false;
    line.sets_words = true;
  } else if (tenfold == 281 || tenfold == 301) {
    line.moves_along_words = false;  // remembers where the machine is
  } else if (std::find(kGoesElsewhere.begin(), kGoesElsewhere.end(), tenfold) != kGoesElsewhere.end()) {
    line.moves_along_words = false;
    forget();
  } else {
    giveUp();
  }
}

void ExpectedPosition::onMotion(const GrblWords& words, const Line& line) {
  if (!line.sets_words && !(line.moves_along_words && moves_)) return;
  for (const GrblWord& word : words) {
    if (word.letter < 'X' || word.letter > 'Z') continue;
    std::optional<double>& axis = axes_[static_cast<std::size_t>(word.letter - 'X')];
    const double value = unit_mm_ * word.value;
    if (line.sets_words || is_absolute_) {
      axis = value;
    } else if (axis) {
      *axis += value;
    }
  }
}

void ExpectedPosition::follow(std::string_view command) {
  if (!is_followed_) return;
  const auto words = GrblWords::of(command);
  if (!words) return giveUp();
  Line line;
  bool ends_program = false;
  for (const GrblWord& word : *words) {
    if (word.letter == 'G') {
      onCommand(word.tenfold(), line);
    } else if (!isHarmless(word)) {
      return giveUp();
    }
    ends_program = ends_program || (word.letter == 'M' && (word.tenfold() == 20 || word.tenfold() == 300));
  }
  if (!is_followed_) return;
  onMotion(*words, line);
  if (!ends_program) return;
  constexpr int kFirstSystem = 540;  // to which the end of a program goes back
  if (work_system_ != kFirstSystem) forget();
  work_system_ = kFirstSystem;
  is_absolute_ = true;
}

std::optional<double> ExpectedPosition::distanceFrom(const GrblAxes& work) const {
  std::optional<double> largest;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    if (axes_[i]) largest = std::max(largest.value_or(0.0), std::abs(*axes_[i] - work[i]));
  return largest;
}

std::string ExpectedPosition::contradictionBy(const GrblAxes& work) const {
  constexpr std::string_view kNames = "XYZ";
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!axes_[i] || std::abs(*axes_[i] - work[i]) <= kPlaceTolerance) continue;
    return std::string(1, kNames[i]) + " is " + millimetres(work[i]) + "; expected " + millimetres(*axes_[i]);
  }
  return {};
}

}  // namespace lamina
