// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/streaming/emulator/emulated_firmware.hpp"
#include "streaming/emulator/emulated_heaters.hpp"
#include "streaming/emulator/emulated_vacuum.hpp"
#include "streaming/emulator/homed_axes.hpp"
#include "streaming/emulator/line_gate.hpp"

namespace lamina {

/// Replies to the host, in order. A delayed reply holds back all that follow.
class ReplyQueue {
 public:
  void say(std::string_view text) { (held_.empty() ? ready_ : held_.back().text) += text; }
  /// Holds back all further replies until `wall_s`.
  void holdUntil(double wall_s) { held_.push_back({wall_s, {}}); }
  void elapse(double wall_s) {
    for (; !held_.empty() && held_.front().until <= wall_s; held_.pop_front()) ready_ += held_.front().text;
  }
  double nextDeadline(double otherwise) const { return held_.empty() ? otherwise : held_.front().until; }
  std::string take() { return std::exchange(ready_, {}); }
  void clear() {
    ready_.clear();
    held_.clear();
  }

 private:
  struct Held {
    double until = 0.0;
    std::string text;
  };
  std::string ready_;
  std::deque<Held> held_;
};

/// Implementation of the emulated firmware.
class EmulatedFirmware::Board {
 public:
  Board(const EmulatedSettings& settings, std::vector<Fault> faults, EmulatedObserver observer);

  void receive(std::string_view bytes, double wall_s);
  void elapse(double wall_s);
  std::string takeOutput() { return replies_.take(); }
  double nextDeadline() const;
  bool takeDisconnect() { return std::exchange(is_link_cut_, false); }

  bool isIdle() const { return rx_.empty() && commands_.empty() && !current_ && motion_.isEmpty(); }
  EmulatedCounts counts() const;
  Point3 position() const { return motion_.positionAt(clock_s_); }
  const EmulatedHeaters& heaters() const { return heaters_; }

 private:
  struct Command {
    ExecutedLine line;
    bool loses_ok = false;
    bool delays_ok = false;
    bool asks_again = false;
  };

  // Receiving.
  void listenForEmergencies(std::string_view bytes);
  void emergency(std::string_view line);
  bool takeLine();
  void onLine(std::string line);
  bool isLineEaten(std::uint64_t number);
  void refuse(const std::string& why);
  bool strikes(FaultKind kind, std::uint64_t line);
  void reset();

  // Running commands.
  bool runFront();
  bool tryFinish();
  void answer();
  void begin();
  void request(const GcodeMotion& motion);
  void runOther(std::string_view command);
  void runM(int code, std::string_view command);
  void setFeedFactor(std::string_view command);
  void heat(EmulatedHeater& heater, std::string_view command);
  void home(std::string_view command);
  bool runPeriphery(int code, std::string_view command);
  void switchPin(std::string_view command);
  void sayPin(std::string_view command);
  void sayHomed();
  bool mayMove(const GcodeMotion& motion);
  Point3 placeAfter(const GcodeMotion& motion) const;
  void mapHeights();
  void setReport(double& interval_s, double& next_s, std::string_view command) const;
  void sayPosition(const Point3& position);
  std::unique_ptr<GcodeReader> makeReader();

  // Time.
  void work();
  std::optional<double> nextEvent() const;
  bool mayPass() const;
  void advanceTo(double clock_s);
  void report();
  bool isInstant() const { return settings_.speed_up <= 0.0; }

  EmulatedSettings settings_;
  EmulatedObserver observer_;
  FaultInjector faults_;
  EmulatedHeaters heaters_;
  EmulatedVacuum vacuum_;
  HomedAxes homed_;
  EmulatedMotion motion_;
  std::unique_ptr<GcodeReader> reader_;
  LineGate gate_;
  ReplyQueue replies_;
  EmulatedCounts counts_;

  std::string rx_;
  std::string emergency_line_;
  std::deque<Command> commands_;
  std::optional<Command> current_;  ///< begun and not yet answered
  /// Motions of the current command for which the queue has no room yet.
  std::deque<RequestedMotion> requested_;
  bool needs_rest_ = false;  ///< whether the current command ends only when all motions have ended
  double wait_s_ = 0.0;      ///< dwell of the current command after its motions
  std::optional<double> wait_until_s_;
  std::string reply_;        ///< sent before the ok of the current command
  std::string reply_in_ok_;  ///< sent on the line of the ok

  Point3 planned_ = Point3::Zero();
  double feed_factor_ = 1.0;
  double flow_factor_ = 1.0;
  double temperature_interval_s_ = 0.0;
  double next_temperature_s_ = 0.0;
  double position_interval_s_ = 0.0;
  double next_position_s_ = 0.0;

  double clock_s_ = 0.0;   ///< machine time
  double budget_s_ = 0.0;  ///< machine time that may be reached now
  double wall_s_ = 0.0;
  double last_received_s_ = 0.0;
  double busy_at_s_ = 0.0;
  double asleep_until_s_ = 0.0;
  bool has_begun_ = false;
  bool is_halted_ = false;
  bool is_link_cut_ = false;
};

}  // namespace lamina
