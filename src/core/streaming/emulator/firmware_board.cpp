// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/firmware_board.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// A host that has sent nothing for this long has nothing to send [s, wall].
constexpr double kQuiet = 0.05;
// By which machine time may be short of an event that is due [s].
constexpr double kTimeRounding = 1e-9;

}  // namespace

EmulatedFirmware::Board::Board(const EmulatedSettings& settings, std::vector<Fault> faults,
                               EmulatedObserver observer)
    : settings_(settings),
      observer_(std::move(observer)),
      faults_(std::move(faults), static_cast<std::uint64_t>(settings.fault_seed)),
      heaters_(settings),
      vacuum_(settings),
      motion_(settings.motion, static_cast<std::size_t>(settings.block_queue), observer_.motion),
      reader_(makeReader()) {}

EmulatedCounts EmulatedFirmware::Board::counts() const {
  EmulatedCounts counts = counts_;
  counts.starvations = motion_.starvations();
  counts.machine_time_s = clock_s_;
  return counts;
}

void EmulatedFirmware::Board::receive(std::string_view bytes, double wall_s) {
  elapse(wall_s);
  if (is_halted_) return;
  last_received_s_ = wall_s;
  listenForEmergencies(bytes);
  while (!bytes.empty()) {
    const std::size_t capacity = settings_.rx_buffer_bytes > 0
                                     ? static_cast<std::size_t>(settings_.rx_buffer_bytes)
                                     : std::numeric_limits<std::size_t>::max();
    const std::size_t room = std::min(bytes.size(), capacity - std::min(capacity, rx_.size()));
    rx_ += bytes.substr(0, room);
    bytes.remove_prefix(room);
    work();
    if (room > 0 || rx_.size() < capacity) continue;
    counts_.bytes_lost += bytes.size();
    break;
  }
}

/// Real boards look for these in every byte received, however full their queues are.
void EmulatedFirmware::Board::listenForEmergencies(std::string_view bytes) {
  if (!settings_.emergency_parser) return;
  constexpr std::size_t kLongest = 16;
  for (const char byte : bytes) {
    if (byte != '\n') {
      if (byte != '\r' && emergency_line_.size() < kLongest) emergency_line_ += byte;
      continue;
    }
    emergency(emergency_line_);
    emergency_line_.clear();
  }
}

void EmulatedFirmware::Board::emergency(std::string_view line) {
  if (line == "M108") {
    if (!needs_rest_) wait_until_s_.reset();
  } else if (line == "M410") {
    motion_.quickStop(clock_s_);
    requested_.clear();
    planned_ = motion_.positionAt(clock_s_);
  } else if (line == "M112") {
    motion_.quickStop(clock_s_);
    heaters_.switchOff();
    vacuum_.switchOff();
    is_homed_ = {};
    commands_.clear();
    rx_.clear();
    is_halted_ = true;
    replies_.say("Error:Printer halted. kill() called!\n");
  }
}

bool EmulatedFirmware::Board::takeLine() {
  const std::size_t end = rx_.find('\n');
  if (end == std::string::npos) return false;
  std::string line = withoutErased(rx_.substr(0, end));
  rx_.erase(0, end + 1);
  onLine(line.substr(0, static_cast<std::size_t>(settings_.max_line_bytes)));
  return true;
}

void EmulatedFirmware::Board::onLine(std::string line) {
  auto number = lineNumberOf(line);
  // Faults strike the lines of a job, wherever it counts from.
  if (number) *number -= std::min(*number, gate_.firstNumber());
  if (number && isLineEaten(*number)) return;
  if (number && strikes(FaultKind::CorruptedLine, *number)) line = faults_.corrupted(std::move(line));
  const GatedLine taken = gate_.take(line);
  if (!taken.refusal.empty()) {
    refuse(taken.refusal);
    return;
  }
  if (taken.command.empty()) return;
  Command command{{taken.command, taken.number}};
  if (number) {
    command.loses_ok = strikes(FaultKind::LostOk, *number);
    command.delays_ok = strikes(FaultKind::DelayedOk, *number);
    command.asks_again = strikes(FaultKind::SpuriousResend, *number);
  }
  commands_.push_back(std::move(command));
}

/// Faults that keep the line from being received.
bool EmulatedFirmware::Board::isLineEaten(std::uint64_t number) {
  if (strikes(FaultKind::Reset, number)) {
    reset();
    return true;
  }
  if (strikes(FaultKind::Disconnect, number)) {
    is_link_cut_ = true;
    return true;
  }
  if (strikes(FaultKind::Silence, number)) asleep_until_s_ = wall_s_ + settings_.fault_silence_s;
  return strikes(FaultKind::LostLine, number);
}

bool EmulatedFirmware::Board::strikes(FaultKind kind, std::uint64_t line) {
  const bool is_struck = faults_.strikes(kind, line);
  if (is_struck) ++counts_.faults;
  return is_struck;
}

void EmulatedFirmware::Board::refuse(const std::string& why) {
  ++counts_.lines_refused;
  const std::string last = std::to_string(gate_.lastNumber());
  const std::string next = std::to_string(gate_.lastNumber() + 1);
  replies_.say("Error:" + why + last + "\nResend: " + next + "\nok\n");
  // Marlin discards what it has received meanwhile, the head of a line that is just arriving too.
  rx_.clear();
}

void EmulatedFirmware::Board::reset() {
  motion_.quickStop(clock_s_);
  heaters_.switchOff();
  vacuum_.switchOff();
  is_homed_ = {};
  gate_.reset();
  rx_.clear();
  commands_.clear();
  current_.reset();
  requested_.clear();
  needs_rest_ = false;
  wait_s_ = 0.0;
  wait_until_s_.reset();
  planned_ = motion_.positionAt(clock_s_);
  feed_factor_ = flow_factor_ = 1.0;
  temperature_interval_s_ = position_interval_s_ = 0.0;
  reader_ = makeReader();
  replies_.clear();
  replies_.say("start\necho:Marlin 2.1 (emulated by Lamina)\n");
}

void EmulatedFirmware::Board::elapse(double wall_s) {
  if (!has_begun_) wall_s_ = wall_s;
  has_begun_ = true;
  const double passed = std::max(wall_s - wall_s_, 0.0);
  wall_s_ += passed;
  replies_.elapse(wall_s_);
  if (!is_halted_ && wall_s_ >= asleep_until_s_) {
    // Time that was not used while waiting for the host is lost, not caught up.
    budget_s_ = isInstant() ? kNever : clock_s_ + passed * settings_.speed_up;
    work();
  }
}

void EmulatedFirmware::Board::work() {
  while (wall_s_ >= asleep_until_s_ && !is_halted_) {
    if (runFront()) continue;
    const auto event = nextEvent();
    const double end_s = isInstant() ? clock_s_ : budget_s_;
    if (!event) {
      advanceTo(end_s);
      break;
    }
    if (!mayPass() || *event > budget_s_ + kTimeRounding) {
      // Up to the event and not through it: what comes after may depend on lines still to come.
      advanceTo(std::min(end_s, std::nextafter(*event, 0.0)));
      break;
    }
    advanceTo(*event);
  }
  if (current_ && wall_s_ >= busy_at_s_ && !is_halted_) {
    replies_.say("echo:busy: processing\n");
    busy_at_s_ = wall_s_ + settings_.busy_interval_s;
  }
}

std::optional<double> EmulatedFirmware::Board::nextEvent() const {
  const auto motion = motion_.nextEvent();
  if (!wait_until_s_) return motion;
  return motion ? std::min(*motion, *wait_until_s_) : *wait_until_s_;
}

bool EmulatedFirmware::Board::mayPass() const {
  if (current_) return true;
  const bool is_faster_than_wall = isInstant() || settings_.speed_up > 1.0;
  return !is_faster_than_wall || wall_s_ >= last_received_s_ + kQuiet;
}

void EmulatedFirmware::Board::advanceTo(double clock_s) {
  const double passed = clock_s - clock_s_;
  if (!(passed > 0.0)) {
    motion_.advance(clock_s_);
    return;
  }
  clock_s_ = clock_s;
  heaters_.elapse(passed);
  vacuum_.elapse(passed);
  motion_.advance(clock_s_);
  report();
}

void EmulatedFirmware::Board::report() {
  if (temperature_interval_s_ > 0.0 && clock_s_ + kTimeRounding >= next_temperature_s_) {
    next_temperature_s_ = clock_s_ + temperature_interval_s_;
    replies_.say(" " + heaters_.report() + "\n");
  }
  if (position_interval_s_ > 0.0 && clock_s_ + kTimeRounding >= next_position_s_) {
    next_position_s_ = clock_s_ + position_interval_s_;
    sayPosition(position());
  }
}

double EmulatedFirmware::Board::nextDeadline() const {
  double deadline = replies_.nextDeadline(kNever);
  if (is_halted_) return deadline;
  if (wall_s_ < asleep_until_s_) return std::min(deadline, asleep_until_s_);
  if (current_) deadline = std::min(deadline, busy_at_s_);
  const auto event = nextEvent();
  if (event && !mayPass()) deadline = std::min(deadline, last_received_s_ + kQuiet);
  if (isInstant()) return deadline;
  const auto wallOf = [&](double machine_s) {
    return wall_s_ + std::max(machine_s - clock_s_, 0.0) / settings_.speed_up;
  };
  if (event && mayPass()) deadline = std::min(deadline, wallOf(*event));
  if (temperature_interval_s_ > 0.0) deadline = std::min(deadline, wallOf(next_temperature_s_));
  if (position_interval_s_ > 0.0) deadline = std::min(deadline, wallOf(next_position_s_));
  return deadline;
}

}  // namespace lamina
