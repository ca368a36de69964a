// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/resume/program_state.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "program/gcode/command_words.hpp"

namespace lamina {
namespace {

constexpr std::array<char, 3> kAxisLetters = {'X', 'Y', 'Z'};

/// The number of a command with that letter, "M106" or "M106 S1"; nothing for others.
std::optional<int> codeOf(const std::string& command, char letter) {
  if (command.size() < 2 || command[0] != letter || std::isdigit(static_cast<unsigned char>(command[1])) == 0)
    return std::nullopt;
  return std::atoi(command.c_str() + 1);
}

/// Acceleration, jerk, flow, pressure advance, levelling and the like: what is set once and stays.
bool isSetting(int code) {
  constexpr std::array<int, 20> kSettings = {92,  106, 107, 201, 202, 203, 204, 205, 207, 208,
                                             209, 221, 301, 304, 420, 566, 572, 592, 593, 900};
  return std::find(kSettings.begin(), kSettings.end(), code) != kSettings.end();
}

/// Questions, messages, waiting, and commands to the motors.
bool leavesNothingBehind(int code) {
  constexpr std::array<int, 17> kCodes = {17,  18,  27,  31,  73,  75,  84,  105, 110,
                                          113, 114, 115, 117, 118, 155, 300, 400};
  return std::find(kCodes.begin(), kCodes.end(), code) != kCodes.end();
}

/// The letters of a command's words: those that set different things stay beside each other.
std::string lettersOf(const std::string& command) {
  std::string letters;
  for (std::size_t i = 1; i < command.size(); ++i) {
    const auto before = static_cast<unsigned char>(command[i - 1]);
    const bool begins_word = before == ' ' || before == '.' || std::isdigit(before) != 0;
    if (begins_word && std::isalpha(static_cast<unsigned char>(command[i])) != 0) letters += command[i];
  }
  return letters;
}

}  // namespace

ProgramState::ProgramState()
    : reader_({}, {[this](const GcodeMotion& motion) { onMotion(motion); }, {}, {}, {}}) {}

void ProgramState::onMotion(const GcodeMotion& motion) {
  pushed_mm_ += motion.extrusion_mm;
  const double before = reached_mm_;
  reached_mm_ = std::max(reached_mm_, pushed_mm_);
  retracted_mm = reached_mm_ - pushed_mm_;
  position = motion.end;
  if (motion.start == motion.end || reached_mm_ <= before) return;
  if (!has_deposited) lowest = highest = motion.start;
  has_deposited = true;
  lowest = lowest.cwiseMin(motion.start).cwiseMin(motion.end);
  highest = highest.cwiseMax(motion.start).cwiseMax(motion.end);
  deposited_length_mm += (motion.end - motion.start).norm();
}

void ProgramState::run(const std::string& command) {
  const GcodeLine& line = parser_.parse(command, ++line_);
  if (line.is_other)
    runOther(command);
  else
    runWords(line);
  reader_.read(command + "\n");
}

void ProgramState::runWords(const GcodeLine& line) {
  std::map<char, std::optional<double>> words;
  std::optional<int> motion;
  for (const GcodeWord& word : line.words) {
    if (word.letter != 'G' && word.letter != 'M') {
      words[word.letter] = word.value;
      continue;
    }
    const int code = static_cast<int>(word.value.value_or(-1.0));
    if (word.letter == 'M') {
      is_filament_relative = code == 83;
    } else if (code == 20 || code == 21) {
      unit_mm = code == 20 ? 25.4 : 1.0;
    } else if (code == 90 || code == 91) {
      is_relative = is_filament_relative = code == 91;
    } else if (code >= 17 && code <= 19) {
      plane = code;
    } else {
      motion = code;
    }
  }
  const bool is_motion = !motion || (*motion >= 0 && *motion <= 3);
  if (is_motion && words.count('F') != 0) feed_mm_min = words['F'].value_or(0.0) * unit_mm;
  if (motion && is_motion) is_rapid = *motion == 0;
  if (is_motion && words.count('E') != 0)
    filament_mm = words['E'].value_or(0.0) * unit_mm + (is_filament_relative ? filament_mm : 0.0);
  if (motion == 92) setPosition(words);
  if (motion != 28) return;
  const bool homes_all = words.count('X') + words.count('Y') + words.count('Z') == 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!homes_all && words.count(kAxisLetters[axis]) == 0) continue;
    position[static_cast<int>(axis)] = shift[static_cast<int>(axis)] = 0.0;
  }
}

void ProgramState::setPosition(const std::map<char, std::optional<double>>& words) {
  const auto value = [&](char letter) {
    const auto found = words.find(letter);
    return found == words.end() ? 0.0 : found->second.value_or(0.0) * unit_mm;
  };
  const bool sets_all = words.count('X') + words.count('Y') + words.count('Z') + words.count('E') == 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!sets_all && words.count(kAxisLetters[axis]) == 0) continue;
    shift[static_cast<int>(axis)] = position[static_cast<int>(axis)] - value(kAxisLetters[axis]);
  }
  if (sets_all || words.count('E') != 0) filament_mm = value('E');
}

void ProgramState::runOther(const std::string& command) {
  if (const auto chosen = codeOf(command, 'T')) {
    tool = *chosen;
  } else if (const auto g = codeOf(command, 'G')) {
    if (*g >= 54 && *g <= 59) workplace = *g == 54 ? "" : command;
    if (*g == 10 || *g == 11) is_firmware_retracted = *g == 10;
    if (*g == 29) not_reproduced.push_back(command);
  } else if (const auto m = codeOf(command, 'M')) {
    if (*m == 200 &&
        (wordValue(command, 'D').value_or(0.0) > 0.0 || wordValue(command, 'S').value_or(0.0) > 0.0))
      throw InvalidProgram("line " + std::to_string(line_) +
                           ": M200 counts extrusion by volume, of which the rest cannot be made");
    if (*m == 220) speed_percent = wordValue(command, 'S').value_or(speed_percent);
    if (runTemperature(*m, command) || *m == 220 || *m == 200 || leavesNothingBehind(*m)) return;
    if (isSetting(*m)) {
      // A fan that is switched off was the same fan.
      const bool is_fan = *m == 106 || *m == 107;
      remember(is_fan ? "fan " + numberText(wordValue(command, 'P').value_or(0.0))
                      : "M" + std::to_string(*m) + lettersOf(command),
               command);
    } else {
      not_reproduced.push_back(command);
    }
  } else {
    not_reproduced.push_back(command);
  }
}

bool ProgramState::runTemperature(int code, const std::string& command) {
  auto target = wordValue(command, 'S');
  if (!target) target = wordValue(command, 'R');
  if (code == 104 || code == 109) {
    const int of = static_cast<int>(wordValue(command, 'T').value_or(tool));
    if (target) nozzle_c[of] = *target;
  } else if (code == 140 || code == 190) {
    if (target) bed_c = target;
  } else if (code == 141 || code == 191) {
    if (target) chamber_c = target;
  } else {
    return false;
  }
  return true;
}

/// The last command of each kind counts, in the order of these.
void ProgramState::remember(const std::string& key, const std::string& command) {
  const auto same = [&](const auto& entry) { return entry.first == key; };
  remembered.erase(std::remove_if(remembered.begin(), remembered.end(), same), remembered.end());
  remembered.emplace_back(key, command);
}

}  // namespace lamina
