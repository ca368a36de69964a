// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <optional>
#include <utility>

#include "lamina/process_io/process_plan.hpp"
#include "lamina/process_io/process_tables.hpp"

namespace lamina {

/// What is asked of a channel.
struct AskedValue {
  double value = 0.0;  ///< [unit of its quantity]; the safe value while it is off
  bool is_on = false;
};

/// What signals ask of a channel. Levels that nothing states follow from the flow where the channel knows how
/// (wire, screw), else are the nominal value; a value of 0 is off.
AskedValue askedOf(const OutputChannel& channel, const ProcessSignals& signals);

/// Finds what to send to a channel now, so that its effect is in step with the plan: the value that is
/// planned for when the effect begins, with the lag of first order inverted. Where the band does not let the
/// effect follow a step, it sets out early, so that half of the step is reached when the step is planned. Off
/// is sent at once, whatever the slew.
class ChannelDrive {
 public:
  /// @param cycle_s  from one call of `step` to the next
  ChannelDrive(OutputChannel channel, double cycle_s) : channel_(std::move(channel)), cycle_s_(cycle_s) {}

  const OutputChannel& channel() const { return channel_; }

  /// The value to be sent from now on: the safe one, or one within the band. Times must not go back.
  double step(const ProcessPlan& plan, double now_s);
  /// The safe value is sent from now on.
  double makeSafe(double now_s);

  /// Sent last; the safe value before the first.
  double sent() const { return is_on_ ? sent_ : channel_.safe; }
  /// False while the safe value is sent.
  bool isOn() const { return is_on_; }
  /// The effect there should be at the last time, by dead time and lag.
  double expected() const;
  /// The greatest value that was asked for in the last step, before it was limited to the band.
  double asked() const { return asked_; }
  /// From sending a value to the instant that it is for [s].
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
  std::optional<double> at_s_;                     ///< of the last call
  std::optional<double> effect_;                   ///< once the dead time is over
  std::deque<std::pair<double, double>> effects_;  ///< that and when, for the dead time
};

}  // namespace lamina
