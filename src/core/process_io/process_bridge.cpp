// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/process_io/process_bridge.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kKept = 1.0;         // s of the plan that are kept behind now
constexpr double kRest = 0.5;         // s that the process must be off before it may be on again
constexpr double kQuiet = 1.0;        // s between two tellings of lateness
constexpr double kBeamShare = 0.01;   // of the band: a beam that is on
constexpr double kOverBand = 1.0001;  // of the band: more than rounding

std::string milliseconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", 1e3 * time_s);
  return text;
}

bool isOff(const ProcessSignals& signals) {
  return signals.flow_mm3_s == 0.0 && !signals.is_laser_on && !signals.is_wire_fed;
}

}  // namespace

void describe(SettingsSchema& schema, ProcessBridgeSettings& settings) {
  schema.number("rate_hz", settings.rate_hz, {10.0, 250.0}, "Values sent to devices a second.");
  schema.number("late_s", settings.late_s, Bounds::above(0.0, 60.0),
                "Lateness of an output that is warned of.");
  schema.number("too_late_s", settings.too_late_s, Bounds::above(0.0, 60.0),
                "Lateness of an output after which all are safe, and the unit aborts.");
  schema.number("standstill_s", settings.standstill_s, {0.0, 60.0},
                "Time that beam or arc may be on without motion by machine_position; 0 for no limit.");
  schema.number("connect_wait_s", settings.connect_wait_s, {0.0, 600.0},
                "Time from the start until a device that was never there is an alarm.");
}

ProcessBridge::ProcessBridge(const ProcessTables& tables, const ProcessBridgeSettings& settings, double now_s)
    : tables_(tables),
      settings_(settings),
      begin_s_(now_s),
      inputs_(tables.inputs),
      was_connected_(tables.devices.size(), false),
      late_reported_s_(-std::numeric_limits<double>::infinity()) {
  for (const OutputChannel& channel : tables.channels) {
    drives_.emplace_back(channel, 1.0 / settings.rate_hz);
    longest_lead_s_ = std::max(longest_lead_s_, drives_.back().lead());
  }
}

void ProcessBridge::accept(const ProcessChunk& chunk, double now_s) {
  const double known_s = plan_.validUntil();
  plan_.accept(chunk);
  const PlannedProcess& first = chunk.points.front();
  // From rest nothing flows: what flows at once was begun where nobody heard of it. The chunks of one motion
  // may be apart by what a busy host adds, since each is timed by itself.
  if (first.signals.flow_mm3_s > 0.0 && first.time_s > known_s + kRest) {
    mid_bead_s_ = first.time_s;
    const std::string text =
        "the plan of the process begins in the middle of a bead; expected it off at first";
    events_.push_back({5104, "process_io", 0.0, text, false});
    trip(text);
  }
  const double sent_until_s = now_s + longest_lead_s_;
  if (chunk.points.front().time_s < std::min(known_s, sent_until_s) - ProcessPlan::kMeet) ++overtaken_;
  const auto first_on = std::find_if(
      chunk.points.begin(), chunk.points.end(),
      [&](const PlannedProcess& point) { return point.time_s >= known_s && !isOff(point.signals); });
  if (first_on == chunk.points.end() || first_on->time_s >= sent_until_s) return;
  ++late_chunks_;
  chunk_late_s_ = std::max(chunk_late_s_, sent_until_s - first_on->time_s);
}

bool ProcessBridge::isProcessOn() const {
  return std::any_of(drives_.begin(), drives_.end(), [](const ChannelDrive& drive) { return drive.isOn(); });
}

void ProcessBridge::trip(const std::string& why) {
  if (trip_.empty()) trip_ = why;
}

void ProcessBridge::lookAtDevices(double now_s, const std::vector<DeviceView>& devices) {
  are_all_connected_ = true;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const std::string& name = tables_.devices[i].name;
    const bool is_expected = was_connected_[i] || now_s - begin_s_ >= settings_.connect_wait_s;
    std::optional<std::string> wrong;
    if (!devices[i].is_connected) {
      are_all_connected_ = false;
      const std::string text = name + " is not connected: " + devices[i].reason;
      trip(text);
      if (is_expected) wrong = text;
    }
    if (devices[i].is_connected) was_connected_[i] = true;
    raised_.set(5102, {name, AlarmSource::Table::Devices}, wrong, 0.0);
  }
}

void ProcessBridge::lookAtLateness(double now_s, double late_s) {
  late_s = std::max(late_s, chunk_late_s_);
  chunk_late_s_ = 0.0;
  if (late_s <= settings_.late_s || !isProcessOn()) return;
  const bool is_too_late = late_s > settings_.too_late_s;
  const std::string text = "an output is " + milliseconds(late_s) + " late; expected at most " +
                           milliseconds(is_too_late ? settings_.too_late_s : settings_.late_s);
  if (is_too_late) trip(text);
  if (!is_too_late && now_s - late_reported_s_ < kQuiet) return;
  late_reported_s_ = now_s;
  const std::uint16_t alarm = is_too_late ? 5104 : 5103;
  events_.push_back({alarm, "process_io", 1e3 * late_s, text, false});
}

void ProcessBridge::lookAtAsked() {
  for (const ChannelDrive& drive : drives_) {
    const OutputChannel& channel = drive.channel();
    std::optional<std::string> wrong;
    if (drive.asked() > kOverBand * channel.high)
      wrong = channel.name + " is asked for " + numberText(drive.asked()) + " (" + nameOf(channel.quantity) +
              "); expected " + numberText(channel.low) + " to " + numberText(channel.high);
    raised_.set(5101, {channel.name, AlarmSource::Table::Channels}, wrong, drive.asked());
  }
}

void ProcessBridge::lookAtBeam(double now_s) {
  const bool is_lit = std::any_of(drives_.begin(), drives_.end(), [](const ChannelDrive& drive) {
    const OutputChannel& channel = drive.channel();
    return isBeam(channel.quantity) && drive.expected() - channel.safe > kBeamShare * channel.high;
  });
  if (!is_lit) return beam_since_s_.reset();
  if (!beam_since_s_) beam_since_s_ = now_s;
  const double still_s = motion_.stillFor(*beam_since_s_, now_s);
  if (settings_.standstill_s <= 0.0 || still_s <= settings_.standstill_s || !trip_.empty()) return;
  const std::string text = "beam or arc is on without motion for " + milliseconds(still_s) +
                           "; expected at most " + milliseconds(settings_.standstill_s);
  events_.push_back({5105, "process_io", still_s, text, false});
  trip(text);
}

void ProcessBridge::rearm(double now_s) {
  if (mid_bead_s_ && now_s >= *mid_bead_s_) mid_bead_s_.reset();
  // A bead that is on its way is not over before it comes, though nothing is known until then.
  if (!isOff(planned(now_s)) || !are_all_connected_ || mid_bead_s_) return off_since_s_.reset();
  if (!off_since_s_) off_since_s_ = now_s;
  if (now_s - *off_since_s_ >= kRest) trip_.clear();
}

BridgeCycle ProcessBridge::cycle(double now_s, const CycleView& view) {
  plan_.forget(now_s - kKept);
  rearm(now_s);
  lookAtDevices(now_s, view.devices);
  lookAtLateness(now_s, view.late_s);
  lookAtBeam(now_s);
  BridgeCycle cycle;
  for (ChannelDrive& drive : drives_)
    cycle.values.push_back(trip_.empty() ? drive.step(plan_, now_s) : drive.makeSafe(now_s));
  lookAtAsked();
  inputs_.look(view.measured, drives_, now_s, raised_);
  cycle.alarms = raised_.takeChanges();
  for (ProcessAlarm& event : events_) cycle.alarms.push_back(std::move(event));
  events_.clear();
  cycle.fault = trip_.empty() ? raised_.first() : trip_;
  return cycle;
}

std::vector<double> ProcessBridge::stop(double now_s) {
  plan_ = ProcessPlan();
  std::vector<double> values;
  for (ChannelDrive& drive : drives_) values.push_back(drive.makeSafe(now_s));
  return values;
}

}  // namespace lamina
