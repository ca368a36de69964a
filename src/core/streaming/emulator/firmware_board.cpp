// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/emulator/firmware_board.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "lamina/base/error.hpp"
#include "program/gcode/command_words.hpp"
#include "streaming/emulator/emulated_height_map.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// A host that has sent nothing for this long has nothing to send [s, wall].
constexpr double kQuiet = 0.05;
// By which machine time may be short of an event that is due [s].
constexpr double kTimeRounding = 1e-9;

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
    homed_.forget();
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
  homed_.forget();
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

// Commands.

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
      homed_.release(command.substr(std::min<std::size_t>(3, command.size())));
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
      home[axis] = 0.0, homed_.home(static_cast<std::size_t>(axis));
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

void EmulatedFirmware::Board::sayHomed() {
  const std::string homed = homed_.letters();
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
  const std::string unhomed = homed_.lettersMissing(motion);
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
  if (!settings_.moves_unhomed && !homed_.areAll()) {
    replies_.say("echo:Home XYZ First\n");
    return;
  }
  reply_ = heightMapText(settings_.bump_mm);
  needs_rest_ = true;
  wait_s_ = heightMapTime();
}

// Time.

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
