// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/process_schedule.hpp"

#include <algorithm>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

const char* toString(ProcessChannel channel) {
  switch (channel) {
    case ProcessChannel::Laser:
      return "laser";
    case ProcessChannel::Wire:
      return "wire";
    case ProcessChannel::Powder:
      return "powder";
    case ProcessChannel::Gas:
      return "gas";
  }
  return "";
}

ProcessSchedule::ProcessSchedule(const Timeline& timeline, double averaging_s,
                                 const ProcessSettings& settings, Beads beads)
    : settings_(settings) {
  if (settings.kind == ProcessKind::Extruder) return;
  const Intervals deposited = beadsOf(timeline, averaging_s);
  laser_ = shifted(deposited, {settings.laser_on_lead_s, settings.laser_off_lead_s}, "laser", beads);
  carriers_ = runsOf(timeline, averaging_s);
  if (settings.kind == ProcessKind::Wire)
    wire_ = shifted(deposited, {settings.wire_on_lead_s, settings.wire_off_lead_s}, "wire", beads);
}

ProcessSchedule::Intervals ProcessSchedule::beadsOf(const Timeline& timeline, double averaging_s) {
  Intervals beads;
  bool was_laying = false;
  for (std::size_t i = 0; i < timeline.phases().size(); ++i) {
    const Phase& phase = timeline.phases()[i];
    const bool is_laying = phase.kind == PhaseKind::Move && phase.curve->spanEnd(phase.span).area_mm2 > 0.0;
    if (is_laying && !was_laying) beads.push_back({phase.time_s, 0.0});
    if (is_laying) beads.back().to_s = timeline.endOf(i) + averaging_s;
    was_laying = is_laying;
  }
  return beads;
}

ProcessSchedule::Intervals ProcessSchedule::runsOf(const Timeline& timeline, double averaging_s) {
  Intervals runs;
  bool was_running = false;
  for (std::size_t i = 0; i < timeline.phases().size(); ++i) {
    const Phase& phase = timeline.phases()[i];
    const bool is_running = phase.kind != PhaseKind::Halt;
    if (is_running && !was_running) runs.push_back({phase.time_s, 0.0});
    if (is_running) runs.back().to_s = timeline.endOf(i) + averaging_s;
    was_running = is_running;
  }
  return runs;
}

ProcessSchedule::Intervals ProcessSchedule::shifted(const Intervals& beads, const Leads& leads,
                                                    const char* what, Beads kind) {
  Intervals result;
  for (const Interval& bead : beads) {
    const Interval on{bead.from_s - leads.on_s, bead.to_s - leads.off_s};
    if (on.to_s <= on.from_s && kind == Beads::Cut) continue;
    if (on.to_s <= on.from_s)
      throw InvalidInput("the bead at " + numberText(bead.from_s) + " s takes " +
                         numberText(bead.to_s - bead.from_s) + " s; the " + what +
                         " would be switched off before it is on");
    if (!result.empty() && on.from_s <= result.back().to_s)
      result.back().to_s = std::max(result.back().to_s, on.to_s);
    else
      result.push_back(on);
  }
  return result;
}

bool ProcessSchedule::isIn(const Intervals& intervals, double time_s) {
  const auto later = std::upper_bound(intervals.begin(), intervals.end(), time_s,
                                      [](double time, const Interval& on) { return time < on.from_s; });
  return later != intervals.begin() && time_s < std::prev(later)->to_s;
}

ProcessSignals ProcessSchedule::signalsAt(double time_s, const ProcessSignals& motion) const {
  if (time_s >= safe_from_s_) return safeSignals();
  ProcessSignals signals = motion;
  const bool is_running = isIn(carriers_, time_s);
  signals.is_laser_on = isIn(laser_, time_s);
  signals.is_wire_fed = isIn(wire_, time_s);
  signals.is_powder_on = is_running && settings_.kind == ProcessKind::Powder;
  signals.is_gas_on = is_running;
  const auto gate = [&signals](ProcessLevel level, bool is_on) {
    if (!is_on && signals.levels.has(level)) signals.levels[level] = 0.0;
  };
  gate(ProcessLevel::LaserPower, signals.is_laser_on);
  gate(ProcessLevel::WireSpeed, signals.is_wire_fed);
  gate(ProcessLevel::ScrewSpeed, signals.flow_mm3_s > 0.0);
  gate(ProcessLevel::Powder, signals.is_powder_on);
  gate(ProcessLevel::Gas, signals.is_gas_on);
  return signals;
}

std::vector<ProcessEvent> ProcessSchedule::events() const {
  std::vector<ProcessEvent> events;
  const auto add = [&](const Intervals& intervals, ProcessChannel channel) {
    for (const Interval& on : intervals) {
      if (on.from_s >= safe_from_s_) break;
      events.push_back({on.from_s, channel, true});
      events.push_back({std::min(on.to_s, safe_from_s_), channel, false});
    }
  };
  add(laser_, ProcessChannel::Laser);
  add(wire_, ProcessChannel::Wire);
  if (settings_.kind == ProcessKind::Powder) add(carriers_, ProcessChannel::Powder);
  add(carriers_, ProcessChannel::Gas);
  std::stable_sort(events.begin(), events.end(),
                   [](const ProcessEvent& a, const ProcessEvent& b) { return a.time_s < b.time_s; });
  return events;
}

}  // namespace lamina
