// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_watch.hpp"
#include "lamina/base/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr double kMoved = 1e-5;        // m or rad: above what encoders at rest report
constexpr double kPresentShare = 0.1;  // of the band: an effect that should be noticed

/// What of an input is judged, and by what.
struct Judged {
  const InputChannel& input;
  double measured = 0.0;
  const ChannelDrive* drive = nullptr;  ///< null if it is judged by itself
};

std::uint16_t alarmOf(const Judged& judged) {
  if (judged.input.check == InputCheck::Ready) return 5102;
  if (judged.input.check == InputCheck::Follows) return 5101;
  const ProcessQuantity quantity = judged.drive->channel().quantity;
  return quantity == ProcessQuantity::WireOn || quantity == ProcessQuantity::WireSpeed ? 5106 : 5107;
}

/// What is wrong, in words; nothing if all is well.
std::optional<std::string> defectOf(const Judged& judged) {
  const InputChannel& input = judged.input;
  const std::string is = input.name + " of " + input.device + " is " + numberText(judged.measured);
  if (input.check == InputCheck::Ready) {
    if (judged.measured >= input.least) return std::nullopt;
    return is + "; expected at least " + numberText(input.least);
  }
  const OutputChannel& channel = judged.drive->channel();
  const double expected = judged.drive->expected();
  const std::string unit = nameOf(channel.quantity);
  if (input.check == InputCheck::Follows) {
    if (std::abs(judged.measured - expected) <= input.tolerance) return std::nullopt;
    return is + " (" + unit + "); expected " + numberText(expected) + ", within " +
           numberText(input.tolerance);
  }
  const bool is_on = std::abs(expected - channel.safe) > kPresentShare * (channel.high - channel.low);
  if (!is_on || judged.measured >= input.least) return std::nullopt;
  return is + " while " + channel.name + " is at " + numberText(expected) + " (" + unit +
         "); expected at least " + numberText(input.least);
}

}  // namespace

void RaisedAlarms::set(std::uint16_t id, const AlarmSource& source, const std::optional<std::string>& wrong,
                       double value) {
  const auto key = std::make_tuple(id, source.name, source.table);
  const auto found = raised_.find(key);
  if (wrong && found == raised_.end()) {
    raised_.emplace(key, ProcessAlarm{id, source.name, value, *wrong, false});
    changes_.push_back({id, source.name, value, *wrong, false});
  } else if (!wrong && found != raised_.end()) {
    raised_.erase(found);
    const auto other = raised_.lower_bound({id, std::string(), AlarmSource::Table::Devices});
    if (other == raised_.end() || other->second.id != id)
      changes_.push_back({id, source.name, value, {}, true});
  }
}

std::vector<ProcessAlarm> RaisedAlarms::all() const {
  std::vector<ProcessAlarm> alarms;
  for (const auto& [key, alarm] : raised_) alarms.push_back(alarm);
  return alarms;
}

void InputWatch::look(const std::vector<double>& measured, const std::vector<ChannelDrive>& drives,
                      double now_s, RaisedAlarms& raised) {
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const InputChannel& input = inputs_[i];
    if (input.check == InputCheck::Shown) continue;
    const auto drive = std::find_if(drives.begin(), drives.end(), [&input](const ChannelDrive& each) {
      return each.channel().name == input.channel;
    });
    const Judged judged{input, measured[i], drive == drives.end() ? nullptr : &*drive};
    const auto defect = std::isnan(measured[i]) ? std::nullopt : defectOf(judged);
    if (!defect) wrong_since_[i].reset();
    if (defect && !wrong_since_[i]) wrong_since_[i] = now_s;
    const bool is_wrong = defect && now_s - *wrong_since_[i] >= input.after_s;
    raised.set(alarmOf(judged), {input.name, AlarmSource::Table::Inputs}, is_wrong ? defect : std::nullopt,
               measured[i]);
  }
}

void StandstillWatch::hear(const std::map<std::string, double>& positions, double now_s) {
  for (const auto& [joint, position] : positions) {
    if (!std::isfinite(position)) continue;
    const auto [known, is_first] = positions_.try_emplace(joint, position);
    if (is_first || std::abs(position - known->second) <= kMoved) continue;
    known->second = position;
    moved_s_ = now_s;
  }
}

double StandstillWatch::stillFor(double since_s, double now_s) const {
  return now_s - (moved_s_ ? std::max(*moved_s_, since_s) : since_s);
}

}  // namespace lamina
