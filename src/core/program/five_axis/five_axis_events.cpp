// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/five_axis_events.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "program/gcode/command_words.hpp"
#include "program/gcode/fixed_point.hpp"
#include "program/gcode/process_words.hpp"

namespace lamina {
namespace {

constexpr double kLongestWaitS = 1e6;

std::string thousandths(double value) {
  char digits[32];
  return std::string(digits, writeFixed<3>(digits, std::llround(1e3 * value)));
}

/// How a controller is commanded to wait.
struct WaitWord {
  char letter = 'P';
  double unit_s = 1.0;
};

WaitWord waitWord(const ProgramSettings& settings) {
  switch (settings.five_axis.dialect) {
    case FiveAxisDialect::LinuxCnc:
      return {'P', 1.0};
    case FiveAxisDialect::Siemens:
      return {'F', 1.0};
    case FiveAxisDialect::Fanuc:
      return {'P', 1e-3};
    case FiveAxisDialect::Generic:
      break;
  }
  return {'P', gcodeDialects().find(settings.dialect).dwells_in_seconds ? 1.0 : 1e-3};
}

}  // namespace

void writeFiveAxisEvent(const ToolpathEvent& event, const ProgramSettings& settings, std::string& text) {
  const FiveAxisDialect dialect = settings.five_axis.dialect;
  if (dialect == FiveAxisDialect::Generic) return writeEvent(event, settings, text);
  if (const auto* dwell = std::get_if<Dwell>(&event)) {
    const WaitWord word = waitWord(settings);
    const bool is_whole = word.unit_s < 1.0;
    text += std::string("G4 ") + word.letter +
            (is_whole ? std::to_string(std::llround(dwell->duration_s / word.unit_s))
                      : thousandths(dwell->duration_s)) +
            "\n";
  } else if (const auto* fan = std::get_if<FanShare>(&event)) {
    const std::string word = dialect == FiveAxisDialect::LinuxCnc ? "M67 E0 Q" : "; fan ";
    text += word + thousandths(fan->share) + "\n";
  } else if (std::holds_alternative<OperatorPause>(event)) {
    text += "M0\n";
  } else {
    writeEvent(event, settings, text);
  }
}

std::optional<ToolpathEvent> readFiveAxisEvent(std::string_view command, const ProgramSettings& settings) {
  if (isCommand(command, "G4")) {
    const WaitWord word = waitWord(settings);
    const std::optional<double> duration = wordValue(command, word.letter);
    if (!duration || !(*duration >= 0.0 && *duration * word.unit_s <= kLongestWaitS))
      throw InvalidProgram("found '" + std::string(command) + "'; expected G4 " + word.letter +
                           " with a duration of 0 to 1e6 s");
    return Dwell{*duration * word.unit_s};
  }
  if (settings.five_axis.dialect == FiveAxisDialect::LinuxCnc && isCommand(command, "M67"))
    return FanShare{std::clamp(wordValue(command, 'Q').value_or(0.0), 0.0, 1.0)};
  return readEvent(command);
}

}  // namespace lamina
