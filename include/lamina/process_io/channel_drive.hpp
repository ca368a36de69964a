// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "lamina/process_io/process_plan.hpp"
#include "lamina/process_io/process_tables.hpp"

namespace lamina {

/// The value that the plan requires of a channel.
struct AskedValue {
  double value = 0.0;  ///< [unit of its quantity]; the safe value while the channel is off
  bool is_on = false;
};

/// The value that signals require of a channel. A level that the signals do not state follows from the flow
/// if the channel is a wire or screw with the data for it; otherwise it is the nominal value. A value of 0 is
/// off.
AskedValue askedOf(const OutputChannel& channel, const ProcessSignals& signals);

/// Finds the value to be sent to a channel now so that its effect keeps to the plan: the value planned for
/// the time at which the effect begins, corrected for the first-order lag. If the band is too narrow for the
/// effect to follow a step, the change begins early, so that half of the step is reached when it is planned.
/// Off is sent at once, whatever the greatest slew is.
class ChannelDrive {
 public:
  /// @param cycle_s  time from one call of `step` to the next
  ChannelDrive(OutputChannel channel, double cycle_s) : channel_(std::move(channel)), cycle_s_(cycle_s) {}

  const OutputChannel& channel() const { return channel_; }

  /// The value to be sent from now on: the safe one, or one within the band. Times must not go back.
  double step(const ProcessPlan& plan, double now_s);
  /// Sends the safe value from now on, and returns it.
  double makeSafe(double now_s);

  /// The value that was sent last; the safe value before the first.
  double sent() const { return is_on_ ? sent_ : channel_.safe; }
  /// False while the safe value is sent.
  bool isOn() const { return is_on_; }
  /// The effect at the time of the last call, as computed with dead time and lag.
  double expected() const;
  /// The value that the last step headed for, which may lie beyond the band; 0 if it was off.
  double asked() const { return asked_; }
  /// Time from sending a value to the instant for which it is planned [s].
  double lead() const;

 private:
  AskedValue askedAt(const ProcessPlan& plan, double time_s) const;
  AskedValue target(const ProcessPlan& plan, double from_s) const;
  double earlyBy(double to) const;
  void advance(double now_s);

  OutputChannel channel_;
  double cycle_s_;
  bool is_on_ = false;
  double sent_ = 0.0;
  double asked_ = 0.0;
  std::optional<double> at_s_;    ///< time of the last call
  std::optional<double> effect_;  ///< effect at that time; nothing before the dead time is over
  std::deque<std::pair<double, double>> effects_;  ///< [time, effect], kept for the dead time
};

}  // namespace lamina
