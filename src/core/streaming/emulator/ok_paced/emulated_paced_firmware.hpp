// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

#include "lamina/base/random.hpp"

namespace lamina {

/// Faults of firmware that is paced by `ok`, each with a probability per command.
struct PacedFaults {
  double lost_ok = 0.0;  ///< the command is run, its ok is never sent
  double slow = 0.0;     ///< the command takes `slow_s`, as with a full queue
  double slow_s = 4.0;
  double refusal = 0.0;     ///< the command is not run, and the firmware reports that
  double halt = 0.0;        ///< the firmware halts by itself
  double reset = 0.0;       ///< the firmware restarts and loses its state
  double disconnect = 0.0;  ///< the link is lost for good
  std::uint64_t seed = 1;
};

/// Firmware without a machine that answers each line by one `ok`, in order. It receives bytes and times, and
/// returns bytes. Derived classes define the meaning of lines.
class EmulatedPacedFirmware {
 public:
  /// Called with each command that is run, except questions.
  using Observer = std::function<void(const std::string&)>;

  EmulatedPacedFirmware(const PacedFaults& faults, Observer observer)
      : faults_(faults), observer_(std::move(observer)), random_(faults.seed) {}
  virtual ~EmulatedPacedFirmware() = default;
  EmulatedPacedFirmware(const EmulatedPacedFirmware&) = delete;
  EmulatedPacedFirmware& operator=(const EmulatedPacedFirmware&) = delete;

  void receive(std::string_view bytes, double now);
  /// States the time; to be called at `nextDeadline` at the latest.
  void elapse(double now);
  std::string takeOutput() { return std::exchange(output_, {}); }
  double nextDeadline() const;
  /// Whether a fault has cut the link since the last call.
  bool takeDisconnect() { return std::exchange(is_cut_, false); }

  double nozzleTarget() const { return nozzle_target_; }  ///< [°C]; 0 is off

 protected:
  /// The answer to a line. Its ok is sent once the command was run.
  struct Answer {
    std::string lines;  ///< lines sent before the ok, each with its end
    std::string ok = "ok";
    bool is_silent = false;  ///< the line gets no answer
  };

  /// @param line  without its end
  virtual Answer onLine(std::string_view line) = 0;
  virtual std::string refusalOf(const std::string& command) const = 0;
  virtual void halt() = 0;
  virtual void restart() = 0;

  /// Runs a command, unless one of the faults affects it.
  /// @return the answer to the command
  Answer run(const std::string& command);
  void say(const std::string& text) { output_ += text; }
  void forgetInput() { input_.clear(); }
  void rest(double seconds) { resting_s_ += seconds; }
  void setNozzleTarget(double target_c) { nozzle_target_ = target_c; }
  double temperatureTarget() const { return nozzle_target_; }

 private:
  bool strikes(double rate) { return rate > 0.0 && random_.uniform(0.0, 1.0) < rate; }
  void work(double now);

  PacedFaults faults_;
  Observer observer_;
  Random random_;
  std::string input_;
  std::size_t read_ = 0;
  std::string output_;
  std::string held_;  ///< answer to the command being run
  double busy_until_ = 0.0;
  double resting_s_ = 0.0;
  bool is_cut_ = false;
  bool is_gone_ = false;
  double nozzle_target_ = 0.0;
};

}  // namespace lamina
