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

struct GuardSettings {
  double silence_s = 1.0;  ///< silence after which a living process counts as lost
  double grace_s = 10.0;   ///< from the loss of a streamer at work to the stop; 0: at once
  /// Time for which a streamer that came back may leave the machine as the lost one left it, before it is
  /// stopped; 0 for any time.
  double unattended_s = 600.0;
  double retry_s = 2.0;  ///< to the next try of a stop that was not confirmed
};

/// A machine that is to be stopped now.
struct GuardOrder {
  MachinePulse machine;  ///< as its streamer said last
  int hung_process = 0;  ///< that has the port and says nothing: to be ended first; 0 for none
};

enum class GuardNewsKind : std::uint8_t {
  Lost,        ///< a streamer that was at work
  Back,        ///< it, or another in its place
  Stopped,     ///< the machine, which has confirmed it
  NotStopped,  ///< which is tried again
};

struct GuardNews {
  GuardNewsKind kind = GuardNewsKind::Lost;
  std::string message;
};

/// Decides when a machine is stopped in the place of the process that streams to it: when that process was
/// lost at work, and no other has taken up its work in time. Pulses, ends of connections and times come in;
/// orders and news come out. Times are seconds since any start and never go back.
///
/// A controller that follows trajectories has no grace: its motion ends within a second in any case, and no
/// process resumes it.
///
/// A machine at rest is never stopped. The work of a lost process is taken up by a job of another process, or
/// by that process itself; a step of a start-up only delays the stop. Once a stop has begun, the work is
/// lost. A job that takes it up is then informed as if the stop had been confirmed.
class MachineGuard {
 public:
  explicit MachineGuard(GuardSettings settings) : settings_(settings) {}

  /// @param process  that sent it, by its number in the system
  void hear(const MachinePulse& pulse, int process, double now_s);
  /// The connection of a process has ended, and so has the process.
  void end(int process, double now_s);
  /// The machine that is to be stopped now, once; to be called at `nextDeadline` at the latest.
  std::optional<GuardOrder> due(double now_s);
  /// The watch ends: what nobody has taken up is to be stopped now.
  std::optional<GuardOrder> dueAtEnd();
  /// What became of the last order.
  void onStop(const MachineStopReport& report, double now_s);

  /// When time alone may have an effect; infinite for never.
  double nextDeadline() const;
  std::vector<GuardNews> takeNews();

 private:
  struct Streamer {
    MachinePulse pulse;
    int process = 0;
    double heard_s = 0.0;
  };
  struct Left {
    MachinePulse machine;
    int process = 0;       ///< that left it and may still live; 0: it has ended
    int hung_process = 0;  ///< as in the order
    double due_s = 0.0;
    bool is_touched = false;  ///< by a stop that was not confirmed
    bool is_watched_again = false;
    bool is_failure_told = false;
  };
  void takeUp(const MachinePulse& pulse, int process);
  void watchAgain(const MachinePulse& pulse, int process, double now_s);
  std::optional<GuardOrder> order();
  void lose(const Streamer& streamer, int hung_process, const std::string& how, double now_s);

  GuardSettings settings_;
  std::map<int, Streamer> streamers_;  ///< that give signs of life, by their processes
  std::optional<Left> left_;           ///< as a lost one left it
  bool is_stopping_ = false;
  std::vector<GuardNews> news_;
};

}  // namespace lamina
