// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the emulated firmware does besides printing: homing flags, dryer, vacuum, height map.
#include <cmath>
#include <cstdio>

#include "program/gcode/command_words.hpp"
#include "streaming/emulator/firmware_board.hpp"

namespace lamina {
namespace {

constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
constexpr int kMapPoints = 5;         // in each direction
constexpr double kProbingTime = 2.0;  // of a point [s]

/// A bump of Gauss' shape in the middle of a square of side 1.
double bumpAt(double x, double y) {
  constexpr double kWidth = 0.25;
  return std::exp(-((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5)) / (kWidth * kWidth));
}

}  // namespace

/// @return false if the code is none of these
bool EmulatedFirmware::Board::runPeriphery(int code, std::string_view command) {
  if (code == 119) {
    sayHomed();
  } else if ((code == 141 || code == 191) && heaters_.dryer) {
    heat(*heaters_.dryer, command);
  } else if (code == 42 && settings_.vacuum_zones > 0) {
    switchPin(command);
  } else if (code == 43 && settings_.vacuum_zones > 0) {
    sayPin(command);
  } else {
    return false;
  }
  return true;
}

void EmulatedFirmware::Board::motorsOff(std::string_view command) {
  const std::string_view words = command.substr(std::min<std::size_t>(3, command.size()));
  const bool is_all = words.find_first_of("XYZE") == std::string_view::npos;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (is_all || words.find(kAxes[axis]) != std::string_view::npos) is_homed_[axis] = false;
}

void EmulatedFirmware::Board::sayHomed() {
  std::string homed;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (is_homed_[axis]) homed += kAxes[axis];
  reply_ += "Reporting endstop status\nhomed: " + (homed.empty() ? std::string("-") : homed) + "\n";
}

void EmulatedFirmware::Board::switchPin(std::string_view command) {
  const int zone = static_cast<int>(wordValue(command, 'P').value_or(0.0));
  if (!vacuum_.has(zone)) {
    replies_.say("echo:Ignored: \"" + std::string(command) + "\"; expected P of a vacuum zone\n");
  } else if (wordValue(command, 'S').value_or(0.0) > 0.0) {
    vacuum_.open(zone);
  } else {
    vacuum_.close(zone);
  }
}

void EmulatedFirmware::Board::sayPin(std::string_view command) {
  const int zone = static_cast<int>(wordValue(command, 'P').value_or(0.0));
  if (!vacuum_.has(zone)) return;
  char text[64];
  std::snprintf(text, sizeof text, "zone %d: %.1f kPa\n", zone, vacuum_.pressure(zone));
  reply_ += text;
}

/// Says which axes must be homed first, as Marlin does, if the motion needs them.
bool EmulatedFirmware::Board::mayMove(const GcodeMotion& motion) {
  if (settings_.moves_unhomed) return true;
  std::string unhomed;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    if (!is_homed_[axis] && motion.end[i] != motion.start[i]) unhomed += kAxes[axis];
  }
  if (!unhomed.empty()) replies_.say("echo:Home " + unhomed + " First\n");
  return unhomed.empty();
}

/// Axes that a motion leaves alone stay where they are, which after a motion that was refused or stopped is
/// not where the program is.
Point3 EmulatedFirmware::Board::placeAfter(const GcodeMotion& motion) const {
  Point3 place = planned_;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (motion.end[axis] != motion.start[axis]) place[axis] = motion.end[axis];
  return place;
}

void EmulatedFirmware::Board::mapHeights() {
  if (!settings_.moves_unhomed && !(is_homed_[0] && is_homed_[1] && is_homed_[2])) {
    replies_.say("echo:Home XYZ First\n");
    return;
  }
  reply_ = "Bilinear Leveling Grid:\n     ";
  for (int column = 0; column < kMapPoints; ++column) reply_ += "      " + std::to_string(column);
  for (int row = 0; row < kMapPoints; ++row) {
    reply_ += "\n " + std::to_string(row);
    for (int column = 0; column < kMapPoints; ++column) {
      char text[32];
      std::snprintf(text, sizeof text, " %+.3f",
                    settings_.bump_mm * bumpAt(column / (kMapPoints - 1.0), row / (kMapPoints - 1.0)));
      reply_ += text;
    }
  }
  reply_ += "\n";
  needs_rest_ = true;
  wait_s_ = kProbingTime * kMapPoints * kMapPoints;
}

}  // namespace lamina
