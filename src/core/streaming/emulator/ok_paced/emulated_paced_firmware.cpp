// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/ok_paced/emulated_paced_firmware.hpp"

#include <cstdlib>
#include <limits>

namespace lamina {

void EmulatedPacedFirmware::receive(std::string_view bytes, double now) {
  if (is_gone_) return;
  input_.erase(0, std::exchange(read_, 0));
  input_ += bytes;
  work(now);
}

void EmulatedPacedFirmware::elapse(double now) { work(now); }

double EmulatedPacedFirmware::nextDeadline() const {
  return held_.empty() && resting_s_ == 0.0 ? std::numeric_limits<double>::infinity() : busy_until_;
}

void EmulatedPacedFirmware::work(double now) {
  while (!is_gone_ && now >= busy_until_) {
    output_ += std::exchange(held_, {});
    resting_s_ = 0.0;
    if (read_ > input_.size()) read_ = 0;
    const std::size_t end = input_.find('\n', read_);
    if (end == std::string::npos) return;
    const std::string line = input_.substr(read_, end - read_);
    read_ = end + 1;
    const Answer answer = onLine(line);
    if (!answer.is_silent) held_ = answer.lines + (strikes(faults_.lost_ok) ? "" : answer.ok + "\n");
    busy_until_ = now + resting_s_;
  }
}

EmulatedPacedFirmware::Answer EmulatedPacedFirmware::run(const std::string& command) {
  Answer answer;
  if (strikes(faults_.refusal)) {
    answer.lines = refusalOf(command);
    return answer;
  }
  if (strikes(faults_.disconnect)) {
    is_cut_ = true;
    is_gone_ = true;
    answer.is_silent = true;
    return answer;
  }
  if (strikes(faults_.halt) || strikes(faults_.reset)) {
    const bool is_halt = faults_.reset == 0.0 || random_.uniform(0.0, 1.0) < 0.5;
    if (is_halt) {
      halt();
    } else {
      restart();
    }
    nozzle_target_ = 0.0;
    answer.is_silent = true;
    return answer;
  }
  if (strikes(faults_.slow)) rest(faults_.slow_s);
  if (command.compare(0, 4, "M104") == 0) {
    const std::size_t at = command.find('S');
    if (at != std::string::npos) nozzle_target_ = std::atof(command.c_str() + at + 1);
  }
  if (observer_) observer_(command);
  return answer;
}

}  // namespace lamina
