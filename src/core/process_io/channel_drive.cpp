// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/channel_drive.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kLongestPreview = 4.0;  // time constants: beyond, a step is reached whatever the band

constexpr double kSameTime = 1e-6;  // s: less than any cycle, more than rounding

AskedValue off(const OutputChannel& channel) { return {channel.safe, false}; }

AskedValue on(const OutputChannel& channel, double value) {
  return value > 0.0 ? AskedValue{value, true} : off(channel);
}

AskedValue switched(const OutputChannel& channel, bool is_on) { return on(channel, is_on ? 1.0 : 0.0); }

/// A speed that follows from the flow; the nominal one where the channel does not know how.
double speedFor(const OutputChannel& channel, double flow_mm3_s) {
  if (channel.quantity == ProcessQuantity::WireSpeed && channel.wire_diameter_mm > 0.0)
    return flow_mm3_s / (0.25 * M_PI * channel.wire_diameter_mm * channel.wire_diameter_mm);
  if (channel.quantity == ProcessQuantity::ScrewSpeed && !channel.screw.empty())
    return screwSpeed(flow_mm3_s, channel.screw);
  return channel.nominal;
}

}  // namespace

AskedValue askedOf(const OutputChannel& channel, const ProcessSignals& signals) {
  const auto level = [&](ProcessLevel which, bool is_on) {
    if (!is_on) return off(channel);
    return on(channel,
              signals.levels.has(which) ? signals.levels[which] : speedFor(channel, signals.flow_mm3_s));
  };
  switch (channel.quantity) {
    case ProcessQuantity::LaserOn:
      return switched(channel, signals.is_laser_on);
    case ProcessQuantity::LaserPower:
      return level(ProcessLevel::LaserPower, signals.is_laser_on);
    case ProcessQuantity::WireOn:
      return switched(channel, signals.is_wire_fed);
    case ProcessQuantity::WireSpeed:
      return level(ProcessLevel::WireSpeed, signals.is_wire_fed);
    case ProcessQuantity::ScrewSpeed:
      return level(ProcessLevel::ScrewSpeed, signals.flow_mm3_s > 0.0);
    case ProcessQuantity::Flow:
      return on(channel, signals.flow_mm3_s);
    case ProcessQuantity::PowderOn:
      return switched(channel, signals.is_powder_on);
    case ProcessQuantity::Powder:
      return level(ProcessLevel::Powder, signals.is_powder_on);
    case ProcessQuantity::GasOn:
      return switched(channel, signals.is_gas_on);
    case ProcessQuantity::Gas:
      return level(ProcessLevel::Gas, signals.is_gas_on);
    case ProcessQuantity::Fan:
      return on(channel,
                signals.levels.has(ProcessLevel::Fan) ? signals.levels[ProcessLevel::Fan] : channel.nominal);
  }
  return off(channel);
}

/// Without a lag a value holds for a cycle about the instant that it is for; an effect that lags comes to its
/// value at the end of the cycle.
double ChannelDrive::lead() const {
  return channel_.dead_time_s + (channel_.lag_s > 0.5 * cycle_s_ ? cycle_s_ : 0.5 * cycle_s_);
}

AskedValue ChannelDrive::askedAt(const ProcessPlan& plan, double time_s) const {
  const std::optional<ProcessSignals> signals = plan.at(time_s);
  return signals ? askedOf(channel_, *signals) : off(channel_);
}

/// How long before a step the effect must set out to be halfway when it is planned [s].
double ChannelDrive::earlyBy(double to) const {
  const double from = *effect_;
  const double limit = to > from ? channel_.high : std::min(channel_.safe, channel_.low);
  const double all = std::abs(limit - from);
  const double half = 0.5 * std::abs(to - from);
  if (all <= half) return kLongestPreview * channel_.lag_s;
  return channel_.lag_s * std::log(all / (all - half));
}

/// What is to be headed for: what is planned next that cannot wait.
AskedValue ChannelDrive::target(const ProcessPlan& plan, double from_s) const {
  AskedValue target = askedAt(plan, from_s);
  if (channel_.lag_s <= 0.0) return target;
  const double farthest_s = kLongestPreview * channel_.lag_s;
  const double look_s = 0.5 * cycle_s_;
  for (double ahead_s = look_s; ahead_s <= farthest_s; ahead_s += look_s) {
    if (from_s + ahead_s > plan.validUntil()) break;
    const AskedValue next = askedAt(plan, from_s + ahead_s);
    // The nearest cycle to the one that it should set out at; no effect comes beyond the band.
    const double reached = std::min(next.value, channel_.high);
    if (earlyBy(reached) >= ahead_s + 0.5 * (cycle_s_ - look_s)) target = next;
  }
  return target;
}

void ChannelDrive::advance(double now_s) {
  if (!effect_) effect_ = channel_.safe;
  if (at_s_ && channel_.lag_s > 0.0)
    *effect_ += (sent() - *effect_) * -std::expm1(-(now_s - *at_s_) / channel_.lag_s);
  else if (at_s_)
    *effect_ = sent();
  at_s_ = now_s;
  effects_.emplace_back(now_s, *effect_);
  while (effects_.size() > 1 && effects_[1].first <= now_s - channel_.dead_time_s + kSameTime)
    effects_.pop_front();
}

double ChannelDrive::expected() const { return effects_.empty() ? channel_.safe : effects_.front().second; }

double ChannelDrive::step(const ProcessPlan& plan, double now_s) {
  advance(now_s);
  const AskedValue wanted = target(plan, now_s + lead());
  asked_ = wanted.is_on ? wanted.value : 0.0;
  if (!wanted.is_on) return makeSafe(now_s);
  double value = wanted.value;
  if (channel_.lag_s > 0.0) value = *effect_ + (value - *effect_) / -std::expm1(-cycle_s_ / channel_.lag_s);
  value = std::clamp(value, channel_.low, channel_.high);
  if (channel_.slew_per_s > 0.0) {
    const double before = std::clamp(sent(), channel_.low, channel_.high);
    const double most = channel_.slew_per_s * cycle_s_;
    value = std::clamp(value, before - most, before + most);
  }
  is_on_ = true;
  sent_ = value;
  return value;
}

double ChannelDrive::makeSafe(double now_s) {
  if (!at_s_ || now_s > *at_s_) advance(now_s);
  is_on_ = false;
  return channel_.safe;
}

}  // namespace lamina
