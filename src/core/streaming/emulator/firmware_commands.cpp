// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "lamina/base/error.hpp"
#include "program/gcode/command_words.hpp"
#include "streaming/emulator/firmware_board.hpp"

namespace lamina {
namespace {

std::optional<int> codeOf(std::string_view command, char letter) {
  if (command.empty() || command.front() != letter) return std::nullopt;
  int code = 0;
  const auto read = std::from_chars(command.data() + 1, command.data() + command.size(), code);
  const bool is_whole = read.ptr == command.data() + command.size() || *read.ptr == ' ';
  return read.ec == std::errc() && is_whole ? std::optional<int>(code) : std::nullopt;
}

/// Commands that are right and change nothing an emulated machine shows.
bool changesNothing(int m_code) {
  constexpr std::array<int, 36> kCodes = {5,   17,  42,  73,  75,  76,  77,  80,  81,  85,  92,  106,
                                          107, 108, 110, 111, 113, 117, 118, 119, 145, 200, 201, 203,
                                          204, 205, 206, 207, 208, 211, 290, 300, 486, 500, 780, 900};
  return std::find(kCodes.begin(), kCodes.end(), m_code) != kCodes.end();
}

}  // namespace

std::unique_ptr<GcodeReader> EmulatedFirmware::Board::makeReader() {
  GcodeHandlers handlers;
  handlers.motion = [this](const GcodeMotion& motion) { request(motion); };
  handlers.dwell = [this](std::size_t, double seconds) {
    needs_rest_ = true;
    wait_s_ = seconds;
  };
  handlers.other = [this](std::size_t, std::string_view command) { runOther(command); };
  return std::make_unique<GcodeReader>(GcodeReaderSettings{}, std::move(handlers));
}

/// Runs what can be run now.
/// @return true if something changed
bool EmulatedFirmware::Board::runFront() {
  if (current_) return tryFinish();
  while (commands_.size() < static_cast<std::size_t>(settings_.command_queue) && wall_s_ >= asleep_until_s_) {
    if (!takeLine()) break;
  }
  if (commands_.empty() || wall_s_ < asleep_until_s_) return false;
  begin();
  return true;
}

void EmulatedFirmware::Board::begin() {
  current_ = std::move(commands_.front());
  commands_.pop_front();
  busy_at_s_ = wall_s_ + settings_.busy_interval_s;
  ++counts_.lines_run;
  const std::string& command = current_->line.command;
  if (observer_.line) observer_.line(current_->line);
  try {
    reader_->read(command + "\n");
  } catch (const Error& error) {
    replies_.say(std::string("echo:Unknown command: ") + error.what() + "\n");
  }
  tryFinish();
}

bool EmulatedFirmware::Board::tryFinish() {
  bool has_moved_on = false;
  for (; !requested_.empty() && !motion_.isFull(); requested_.pop_front()) {
    motion_.add(requested_.front(), clock_s_);
    has_moved_on = true;
  }
  if (!requested_.empty() || (needs_rest_ && !motion_.isEmpty())) return has_moved_on;
  needs_rest_ = false;
  if (wait_s_ > 0.0) wait_until_s_ = clock_s_ + std::exchange(wait_s_, 0.0);
  if (wait_until_s_ && clock_s_ < *wait_until_s_) return has_moved_on;
  wait_until_s_.reset();
  answer();
  return true;
}

void EmulatedFirmware::Board::answer() {
  const Command done = std::move(*current_);
  current_.reset();
  replies_.say(std::exchange(reply_, {}));
  const std::string remark = std::exchange(reply_in_ok_, {});
  if (done.delays_ok) replies_.holdUntil(wall_s_ + settings_.fault_delay_s);
  if (!done.loses_ok) replies_.say(remark.empty() ? std::string("ok\n") : "ok " + remark + "\n");
  if (done.asks_again) replies_.say("Resend: " + std::to_string(gate_.lastNumber() + 1) + "\nok\n");
}

void EmulatedFirmware::Board::request(const GcodeMotion& motion) {
  if (!mayMove(motion)) return;
  RequestedMotion requested{planned_, placeAfter(motion), motion.extrusion_mm,
                            motion.feed_mm_s * feed_factor_};
  const bool is_in_place = (motion.end - motion.start).norm() == 0.0;
  if (!is_in_place) requested.filament_mm *= flow_factor_;
  planned_ = requested.end;
  requested_.push_back(requested);
}

void EmulatedFirmware::Board::runOther(std::string_view command) {
  if (command.substr(0, 3) == "G28") {
    home(current_->line.command);
  } else if (codeOf(command, 'G') == 29) {
    mapHeights();
  } else if (const auto m_code = codeOf(command, 'M')) {
    runM(*m_code, command);
  } else if (!codeOf(command, 'T')) {
    replies_.say("echo:Unknown command: \"" + std::string(command) + "\"\n");
  }
}

void EmulatedFirmware::Board::runM(int code, std::string_view command) {
  switch (code) {
    case 18:
    case 84:
      motorsOff(command);
      needs_rest_ = true;
      break;
    case 400:
      needs_rest_ = true;
      break;
    case 104:
    case 109:
      heat(heaters_.nozzle, command);
      break;
    case 140:
    case 190:
      heat(heaters_.bed, command);
      break;
    case 105:
      reply_in_ok_ = heaters_.report();
      break;
    case 112:
      emergency("M112");
      break;
    case 114:
      sayPosition(planned_);
      break;
    case 115:
      reply_ =
          "FIRMWARE_NAME:Marlin 2.1 (emulated by Lamina) PROTOCOL_VERSION:1.0 EXTRUDER_COUNT:1\n"
          "Cap:AUTOREPORT_POS:1\nCap:AUTOREPORT_TEMP:1\n";
      reply_ += settings_.emergency_parser ? "Cap:EMERGENCY_PARSER:1\n" : "Cap:EMERGENCY_PARSER:0\n";
      break;
    case 154:
      setReport(position_interval_s_, next_position_s_, command);
      break;
    case 155:
      setReport(temperature_interval_s_, next_temperature_s_, command);
      break;
    case 220:
      setFeedFactor(command);
      break;
    case 221:
      flow_factor_ = wordValue(command, 'S').value_or(100.0 * flow_factor_) / 100.0;
      break;
    case 410:
      emergency("M410");
      break;
    default:
      if (!runPeriphery(code, command) && !changesNothing(code))
        replies_.say("echo:Unknown command: \"" + std::string(command) + "\"\n");
  }
}

void EmulatedFirmware::Board::setFeedFactor(std::string_view command) {
  const double percent = wordValue(command, 'S').value_or(100.0 * feed_factor_);
  if (percent > 0.0) {
    feed_factor_ = percent / 100.0;
  } else {
    replies_.say("echo:Ignored: \"" + std::string(command) + "\"; expected S above 0 percent\n");
  }
}

void EmulatedFirmware::Board::heat(EmulatedHeater& heater, std::string_view command) {
  const auto at_least = wordValue(command, 'S');
  const auto exactly = wordValue(command, 'R');
  if (at_least) heater.setTarget(*at_least);
  if (exactly) heater.setTarget(*exactly);
  const std::string_view code = command.substr(0, 4);
  const bool waits = code == "M109" || code == "M190" || code == "M191";
  if (waits) wait_s_ = exactly ? heater.timeToReach() : heater.timeToHeat();
}

void EmulatedFirmware::Board::home(std::string_view command) {
  constexpr double kHomingFeed = 50.0;  // mm/s
  constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
  const std::string_view words = command.substr(std::min(command.find("G28") + 3, command.size()));
  const bool homes_all = words.find_first_of("XYZ") == std::string_view::npos;
  Point3 home = planned_;
  for (int axis = 0; axis < 3; ++axis) {
    if (homes_all || words.find(kAxes[static_cast<std::size_t>(axis)]) != std::string_view::npos)
      home[axis] = 0.0, is_homed_[static_cast<std::size_t>(axis)] = true;
  }
  requested_.push_back({planned_, home, 0.0, kHomingFeed});
  planned_ = home;
  needs_rest_ = true;
}

void EmulatedFirmware::Board::setReport(double& interval_s, double& next_s, std::string_view command) const {
  interval_s = std::max(wordValue(command, 'S').value_or(0.0), 0.0);
  next_s = clock_s_ + interval_s;
}

void EmulatedFirmware::Board::sayPosition(const Point3& position) {
  char text[128];
  std::snprintf(text, sizeof text, "X:%.3f Y:%.3f Z:%.3f E:%.4f Count X:0 Y:0 Z:0\n", position.x(),
                position.y(), position.z(), motion_.filament());
  replies_.say(text);
}

}  // namespace lamina
