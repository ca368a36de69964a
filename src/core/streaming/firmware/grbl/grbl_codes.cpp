// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "lamina/streaming/firmware/grbl/grbl_protocol.hpp"

namespace lamina {
namespace {

using GrblCodes = std::map<int, const char*>;

const GrblCodes& commonErrors() {
  static const GrblCodes kCodes = {
      {1, "a letter was expected"},
      {2, "a number is missing or not one"},
      {3, "the $ command is not known"},
      {4, "a value is negative where it must not be"},
      {5, "the setting that this needs is off, such as homing"},
      {6, "the step pulse is too short"},
      {7, "a stored setting could not be read"},
      {8, "this is only done while the machine is idle"},
      {9, "the machine is locked (alarm) or jogs"},
      {10, "soft limits need homing"},
      {11, "the line is too long"},
      {12, "the step rate is higher than the board's highest"},
      {13, "the safety door is open"},
      {14, "the line is too long to be stored"},
      {15, "the jog would leave the machine's travel"},
      {16, "the jog command is not complete"},
      {17, "laser mode needs a spindle of variable speed"},
      {20, "the firmware does not know this command"},
      {21, "two commands of one modal group stand in the line"},
      {22, "no feed rate is set"},
      {23, "a command's number must be whole"},
      {24, "two commands of the line both want the axes"},
      {25, "a word stands twice in the line"},
      {26, "the command needs axes and has none"},
      {27, "the line number is too high"},
      {28, "a word that the command needs is missing"},
      {29, "the work coordinate system is not known"},
      {30, "G53 goes with G0 and G1 only"},
      {31, "axes stand in the line and no command uses them"},
      {32, "an arc has no axis of its plane"},
      {33, "the target cannot be reached by this motion"},
      {34, "the arc's radius does not reach its end"},
      {35, "an arc has no offset in its plane"},
      {36, "words stand in the line that nothing uses"},
      {37, "G43.1 names another axis than the tool's"},
      {38, "the tool's number is too high"},
  };
  return kCodes;
}

const GrblCodes& errorsOf(GrblDialect dialect) {
  static const GrblCodes kHal = {
      {18, "the machine was reset"},       {19, "the value must be above zero"},
      {39, "a value is out of its range"}, {40, "a tool is still to be changed"},
      {41, "the spindle does not turn"},   {43, "the feed rate is too high"},
      {44, "the speed is out of range"},   {45, "a limit switch is engaged"},
      {46, "the machine must be homed"},   {50, "the emergency stop is engaged"},
      {51, "a motor has failed"},
  };
  static const GrblCodes kFluid = {
      {18, "no homing cycle is configured"},
      {19, "axes are homed together only"},
      {39, "a P value is too high"},
      {40, "a control input was active at the start"},
      {120, "the machine runs a job of another channel"},
      {152, "the machine's configuration is not valid"},
  };
  static const GrblCodes kNone;
  if (dialect == GrblDialect::GrblHal) return kHal;
  return dialect == GrblDialect::FluidNc ? kFluid : kNone;
}

const GrblCodes& commonAlarms() {
  static const GrblCodes kCodes = {
      {1, "a limit switch was hit; the position is likely lost"},
      {2, "a motion would leave the machine's travel; the position is kept"},
      {3, "reset in motion; the position is likely lost"},
      {4, "the probe was not as expected before probing"},
      {5, "the probe did not touch within its travel"},
      {6, "homing was reset"},
      {7, "the safety door was opened while homing"},
      {8, "homing could not leave the limit switch"},
      {9, "homing did not find the limit switch"},
  };
  return kCodes;
}

const GrblCodes& alarmsOf(GrblDialect dialect) {
  static const GrblCodes kGrbl = {{10, "homing did not find the second switch of an axis with two"}};
  static const GrblCodes kHal = {
      {10, "the emergency stop is engaged"},
      {11, "the machine must be homed"},
      {12, "a limit switch is engaged"},
      {13, "the probe's protection has triggered"},
      {14, "the spindle did not reach its speed"},
      {15, "homing did not find the second switch of an axis with two"},
      {16, "the self-test has failed"},
      {17, "a motor has failed"},
      {18, "homing has failed"},
      {19, "the spindle's bus does not answer"},
      {22, "the receive buffer has overflowed"},
  };
  static const GrblCodes kFluid = {
      {10, "the spindle could not be controlled"},
      {11, "an input was active at the start"},
      {12, "homing met a switch of two meanings"},
      {13, "an input has stopped the machine"},
      {14, "the machine must be homed"},
      {15, "the machine has just started"},
      {16, "a board of inputs and outputs was reset"},
      {17, "a line of G-code was refused"},
      {18, "a limit switch was hit while probing"},
  };
  if (dialect == GrblDialect::GrblHal) return kHal;
  return dialect == GrblDialect::FluidNc ? kFluid : kGrbl;
}

std::string meaningIn(const GrblCodes& common, const GrblCodes& own, int code) {
  for (const GrblCodes* codes : {&common, &own}) {
    const auto found = codes->find(code);
    if (found != codes->end()) return found->second;
  }
  return "a code that the firmware's own manual explains";
}

}  // namespace

std::string meaningOfGrblError(int code, GrblDialect dialect) {
  return meaningIn(commonErrors(), errorsOf(dialect), code);
}

std::string meaningOfGrblAlarm(int code, GrblDialect dialect) {
  return meaningIn(commonAlarms(), alarmsOf(dialect), code);
}

}  // namespace lamina
