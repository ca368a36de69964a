// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lamina/streaming/guard/machine_pulse.hpp"
#include "lamina/streaming/guard/machine_stop.hpp"

namespace lamina {

/// Times by which `MachineGuard` decides. A streamer is a process that moves a machine and sends pulses.
struct GuardSettings {
  double silence_s = 1.0;  ///< time without a pulse after which a process that still runs counts as lost
  double grace_s = 10.0;   ///< time from the loss of a streamer at work to the stop; 0 for an immediate stop
  /// Time after which the machine is stopped if a streamer sends pulses again but does not take up the work;
  /// 0 for no such limit.
  double unattended_s = 600.0;
  double retry_s = 2.0;  ///< time from a stop that was not confirmed to the next attempt
};

/// An order to stop a machine now.
struct GuardOrder {
  MachinePulse machine;  ///< last pulse of the lost streamer
  int hung_process = 0;  ///< process that holds the port but sends nothing, to be killed first; 0 for none
};

/// What `MachineGuard` reports.
enum class GuardNewsKind : std::uint8_t {
  Lost,        ///< a streamer at work, or one that had come back, was lost
  Back,        ///< the lost streamer, or another process in its place, sends pulses
  Stopped,     ///< the machine has confirmed its stop, or its stop had begun when its streamer came back
  NotStopped,  ///< the machine has not confirmed its stop, which is tried again
};

/// A report of `MachineGuard`.
struct GuardNews {
  GuardNewsKind kind = GuardNewsKind::Lost;
  std::string message;
};

/// Decides when a machine is to be stopped on behalf of the process that moves it: when that process was lost
/// at work, and no process has taken up the work in time. Its inputs are pulses, ends of connections and
/// times; its outputs are orders and news. Times are seconds since any start and never go back.
///
/// A lost process that was not at work leads to no stop. The work of a lost process is taken up by that
/// process itself, or by a job of another process; a step of a start-up sequence only delays the stop. Once a
/// stop has begun, the work is lost: a process that then takes it up causes the news Stopped.
///
/// If the machine is a controller that follows trajectories, it is stopped without grace, since its motion
/// ends within a second in any case and no process resumes it.
class MachineGuard {
 public:
  explicit MachineGuard(GuardSettings settings) : settings_(settings) {}

  /// Accepts a pulse.
  /// @param process  process number (PID) of the sender
  void hear(const MachinePulse& pulse, int process, double now_s);
  /// States that the connection of a process has ended, and with it the process.
  void end(int process, double now_s);
  /// The order to stop a machine, if one is due; it is given once. To be called at `nextDeadline` at the
  /// latest.
  std::optional<GuardOrder> due(double now_s);
  /// The order to stop, without further grace, a machine whose work nobody has taken up; for the end of the
  /// watch.
  std::optional<GuardOrder> dueAtEnd();
  /// States the result of the last order.
  void onStop(const MachineStopReport& report, double now_s);

  /// Time [s] at which `due` is to be called next; infinite if time alone has no effect.
  double nextDeadline() const;
  /// The news since the last call.
  std::vector<GuardNews> takeNews();

 private:
  struct Streamer {
    MachinePulse pulse;
    int process = 0;
    double heard_s = 0.0;
  };
  /// The work that a lost streamer left.
  struct Left {
    MachinePulse machine;
    int process = 0;          ///< process that left it and may still run; 0 once it has ended
    int hung_process = 0;     ///< as in `GuardOrder`
    double due_s = 0.0;       ///< time of the stop
    bool is_touched = false;  ///< whether an unconfirmed stop has already sent bytes
    bool is_watched_again = false;
    bool is_failure_told = false;
  };
  void takeUp(const MachinePulse& pulse, int process);
  void watchAgain(const MachinePulse& pulse, int process, double now_s);
  std::optional<GuardOrder> order();
  void lose(const Streamer& streamer, int hung_process, const std::string& how, double now_s);

  GuardSettings settings_;
  std::map<int, Streamer> streamers_;  ///< streamers that send pulses, by process number
  std::optional<Left> left_;           ///< nothing unless a streamer was lost at work
  bool is_stopping_ = false;
  std::vector<GuardNews> news_;
};

}  // namespace lamina
