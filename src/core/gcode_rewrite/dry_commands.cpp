// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dry_commands.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace lamina {
namespace {

template <class Value, std::size_t count>
bool isIn(const std::array<Value, count>& all, const Value& value) {
  return std::find(all.begin(), all.end(), value) != all.end();
}

std::string upperCase(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper;
}

}  // namespace

// 26 prints a pattern and 76 heats. 6 is a direct move of steppers, without a place to go to.
DryVerdict verdictOnG(int code) {
  constexpr std::array kKept = {0,  1,  2,  3,  4,  5,  10, 12, 17, 18, 19, 20, 21, 27, 28,
                                29, 30, 31, 32, 33, 34, 38, 40, 43, 49, 50, 53, 54, 55, 56,
                                57, 58, 59, 60, 61, 64, 68, 69, 80, 90, 91, 92, 93, 94, 98};
  constexpr std::array kProcess = {11, 22, 23, 26, 76};
  if (isIn(kKept, code)) return DryVerdict::Keep;
  return isIn(kProcess, code) ? DryVerdict::Process : DryVerdict::Unknown;
}

DryVerdict verdictOnM(int code) {
  constexpr std::array kKept = {0,   1,   2,   5,   9,   17,  18,  30,  73,  75,  76,  77,  78,  82,  83,
                                84,  85,  105, 107, 112, 114, 115, 117, 118, 119, 120, 121, 154, 155, 201,
                                202, 203, 204, 205, 211, 220, 400, 401, 402, 413, 420, 428, 429, 486, 556,
                                557, 558, 561, 564, 566, 569, 593, 665, 666, 851, 906, 907, 913, 914, 915};
  constexpr std::array kTargets = {104, 106, 109, 140, 141, 190, 191};
  constexpr std::array kProcess = {3,   4,   6,   7,   8,   10,  11,  101, 103, 108, 116,
                                   126, 127, 143, 193, 207, 208, 209, 221, 302, 303, 306,
                                   563, 567, 568, 572, 600, 603, 701, 702, 703, 900};
  if (isIn(kKept, code)) return DryVerdict::Keep;
  if (isIn(kTargets, code)) return DryVerdict::Target;
  return isIn(kProcess, code) ? DryVerdict::Process : DryVerdict::Unknown;
}

DryVerdict verdictOnName(std::string_view name) {
  constexpr std::array<std::string_view, 16> kKept = {
      "BED_MESH_CALIBRATE",   "BED_MESH_CLEAR",        "BED_MESH_PROFILE",   "CLEAR_PAUSE",
      "EXCLUDE_OBJECT",       "EXCLUDE_OBJECT_DEFINE", "EXCLUDE_OBJECT_END", "EXCLUDE_OBJECT_START",
      "QUAD_GANTRY_LEVEL",    "RESTORE_GCODE_STATE",   "SAVE_GCODE_STATE",   "SET_GCODE_OFFSET",
      "SET_PRINT_STATS_INFO", "SET_VELOCITY_LIMIT",    "TURN_OFF_HEATERS",   "Z_TILT_ADJUST"};
  constexpr std::array<std::string_view, 9> kProcess = {
      "ACTIVATE_EXTRUDER", "SET_FAN_SPEED",    "SET_HEATER_TEMPERATURE", "SET_PIN",   "SET_PRESSURE_ADVANCE",
      "SET_RETRACTION",    "TEMPERATURE_WAIT", "SYNC_EXTRUDER_MOTION",   "FORCE_MOVE"};
  const std::string upper = upperCase(name);
  if (isIn(kKept, std::string_view(upper))) return DryVerdict::Keep;
  return isIn(kProcess, std::string_view(upper)) ? DryVerdict::Process : DryVerdict::Unknown;
}

int withoutWait(int code) {
  constexpr int kNozzle = 109;
  constexpr int kBed = 190;
  constexpr int kChamber = 191;
  if (code == kNozzle) return 104;
  if (code == kBed) return 140;
  return code == kChamber ? 141 : code;
}

bool isStatement(std::string_view name) {
  constexpr std::array<std::string_view, 6> kStatements = {"IF",    "ELIF",  "ELSE",
                                                           "WHILE", "BREAK", "CONTINUE"};
  return isIn(kStatements, std::string_view(upperCase(name)));
}

}  // namespace lamina
