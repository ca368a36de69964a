// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/print_server/emulated_printer.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "lamina/base/text.hpp"

namespace lamina {

bool EmulatedPrinter::print(const std::string& file) {
  if (state_ == State::Printing || is_halted || files.count(file) == 0) return false;
  state_ = State::Printing;
  outcome_ = Outcome::None;
  file_ = file;
  position_ = 0;
  print_time_s_ = line_debt_ = 0.0;
  return true;
}

void EmulatedPrinter::pause() {
  if (state_ == State::Printing) state_ = State::Paused;
}

void EmulatedPrinter::resume() {
  if (state_ == State::Paused) state_ = State::Printing;
}

void EmulatedPrinter::cancel() {
  if (state_ != State::Idle) end(Outcome::Stopped);
}

void EmulatedPrinter::breakDown() {
  if (state_ != State::Idle) end(Outcome::Failed);
}

void EmulatedPrinter::end(Outcome outcome) {
  state_ = State::Idle;
  outcome_ = outcome;
}

void EmulatedPrinter::restart() {
  state_ = State::Idle;
  outcome_ = Outcome::None;
  file_.clear();
  moving_until_ = 0.0;
  position_ = 0;
  nozzle_target_c = bed_target_c = 0.0;
  is_halted = false;
}

void EmulatedPrinter::halt() {
  is_halted = true;
  if (isMoving()) moving_until_ = std::numeric_limits<double>::infinity();
  breakDown();
  nozzle_target_c = bed_target_c = 0.0;
}

void EmulatedPrinter::change(const std::string& command) {
  constexpr std::array<std::string_view, 6> kKnown = {
      "M220 ", "M221 ", "M290 ", "M486 ", "SET_GCODE_OFFSET ", "EXCLUDE_OBJECT "};
  const bool is_known = std::any_of(kKnown.begin(), kKnown.end(), [&](std::string_view known) {
    return command.compare(0, known.size(), known) == 0;
  });
  (is_known ? changes : unknown).push_back(command);
}

void EmulatedPrinter::elapse(double now) {
  const double step = now - now_;
  now_ = now;
  if (state_ != State::Printing) return;
  print_time_s_ += step;
  line_debt_ += step * lines_per_s;
  const std::string& text = files[file_];
  while (state_ == State::Printing && line_debt_ >= 1.0) {
    const std::size_t end = text.find('\n', position_);
    if (end == std::string::npos) return this->end(Outcome::Complete);  // what has no end of line is not run
    runLine(text.substr(position_, end - position_));
    position_ = end + 1;
    line_debt_ -= 1.0;
  }
}

void EmulatedPrinter::runLine(const std::string& text) {
  const std::string command(trimmed(std::string_view(text).substr(0, text.find(';'))));
  if (command.empty()) return;
  executed_.push_back(command);
  moving_until_ = now_ + queue_s;
  if (command.compare(0, 7, "UNKNOWN") == 0) unknown.push_back(command);
  const std::size_t s = command.find('S');
  const double target = s == std::string::npos ? 0.0 : std::atof(command.c_str() + s + 1);
  if (command.compare(0, 4, "M104") == 0) nozzle_target_c = target;
  if (command.compare(0, 4, "M140") == 0) bed_target_c = target;
}

}  // namespace lamina
