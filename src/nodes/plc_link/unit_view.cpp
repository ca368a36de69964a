// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "unit_view.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;            // of a metre
constexpr double kCubicMillimetres = 1e9;       // of a cubic metre
constexpr double kLongestProcessSilence = 1.0;  // [s]
constexpr double kLongestHeaterSilence = 2.0;   // [s]

UnitState stateOf(const UnitView& view) { return unitState(view.unit.state).value_or(UnitState::Aborted); }

AlarmCategory categoryOf(const std::string& letter) {
  for (int number = 0; number <= static_cast<int>(AlarmCategory::Abort); ++number) {
    const auto category = static_cast<AlarmCategory>(number);
    if (letter == std::string(1, letterOf(category))) return category;
  }
  return AlarmCategory::Warning;
}

std::vector<ActiveAlarm> alarmsOf(const UnitView& view) {
  std::vector<ActiveAlarm> alarms;
  for (const lamina_msgs::CellAlarm& reported : view.alarms.alarms) {
    ActiveAlarm alarm;
    alarm.id = reported.id;
    alarm.category = categoryOf(reported.category);
    alarm.value = reported.value;
    alarms.push_back(alarm);
  }
  return alarms;
}

/// Not proof of standstill: what has ended may still run out.
bool mayMove(std::uint8_t state) {
  using State = lamina_msgs::MachineState;
  return state != State::IDLE && state != State::HELD && state != State::SUSPENDED &&
         state != State::COMPLETE && state != State::STOPPED && state != State::ABORTED;
}

bool isStartedUp(const lamina_msgs::MachineState& machine) {
  using Step = lamina_msgs::StartupStep;
  return !machine.state_name.empty() &&
         std::all_of(machine.startup.begin(), machine.startup.end(), [](const Step& step) {
           return step.state == Step::DONE || step.state == Step::SKIPPED;
         });
}

/// By what was reported last, since a machine may go on heating when nothing runs on it. Temperatures and
/// targets are not a number where the firmware says none.
bool isHeating(const lamina_msgs::HeaterState& heaters) {
  return heaters.nozzle_target > 0.0 || heaters.bed_target > 0.0;
}

std::vector<StatusFlag> flagsOf(const UnitView& view, bool is_process_heard) {
  using Loop = lamina_msgs::LoopState;
  std::vector<StatusFlag> flags;
  const auto set = [&flags](StatusFlag flag, bool is_set) {
    if (is_set) flags.push_back(flag);
  };
  const UnitState state = stateOf(view);
  bool has_alarm = false;
  bool has_warning = false;
  for (const ActiveAlarm& alarm : alarmsOf(view)) {
    has_alarm = has_alarm || alarm.category > AlarmCategory::Warning;
    has_warning = has_warning || alarm.category == AlarmCategory::Warning;
  }
  set(StatusFlag::StateChanging, isActing(state) && state != UnitState::Execute);
  set(StatusFlag::Alarm, has_alarm);
  set(StatusFlag::Warning, has_warning);
  set(StatusFlag::JobLoaded, view.unit.job.id != 0);
  set(StatusFlag::HeatersOn, isHeating(view.heaters));
  set(StatusFlag::Motion, mayMove(view.machine.state));
  set(StatusFlag::BeamOn, is_process_heard && view.process.laser != 0);
  set(StatusFlag::PartOnPlate, view.unit.is_part_on_plate != 0);
  set(StatusFlag::StartupDone, isStartedUp(view.machine));
  set(StatusFlag::LoopActive, view.loop.state == Loop::ACTIVE);
  set(StatusFlag::LoopCoasting, view.loop.state == Loop::COASTING || view.loop.state == Loop::OPEN);
  set(StatusFlag::ResumeWaits, view.unit.resume_waits != 0);
  return flags;
}

std::uint32_t seconds(double time_s) {
  return static_cast<std::uint32_t>(std::clamp(std::floor(time_s), 0.0, 4294967294.0));
}

/// The first job that is allowed to start. The PLC's Start begins none while one that was cut off waits to be
/// decided on.
std::uint32_t nextJob(const UnitView& view) {
  if (view.unit.resume_waits != 0) return 0;
  const auto& jobs = view.queue.jobs;
  const auto next = std::find_if(jobs.begin(), jobs.end(), [](const lamina_msgs::CellJob& job) {
    return job.state == static_cast<std::uint8_t>(JobState::AllowedToStart);
  });
  return next == jobs.end() ? 0 : next->id;
}

JobStatus jobOf(const UnitView& view) {
  JobStatus job;
  job.id = view.unit.job.id;
  job.state = view.unit.job.state;
  const auto waits = [](const lamina_msgs::CellJob& queued) { return queued.state <= 2; };
  job.queued = static_cast<std::uint16_t>(
      std::min<std::ptrdiff_t>(65535, std::count_if(view.queue.jobs.begin(), view.queue.jobs.end(), waits)));
  job.next = nextJob(view);
  job.layer = view.unit.layer;
  job.layers = view.unit.layers;
  job.fraction = static_cast<float>(view.unit.fraction);
  job.gone_s = seconds(view.unit.elapsed);
  if (view.unit.remaining >= 0.0) job.left_s = seconds(view.unit.remaining);
  job.line = view.unit.lines_acknowledged;
  job.path_mm = static_cast<float>(view.unit.laid_length * kMillimetres);
  job.name = view.unit.job.name;
  return job;
}

float known(double value) { return std::isfinite(value) ? static_cast<float>(value) : 0.0F; }

/// Whether what came at a time is of now.
bool isRecent(double heard_s, double now_s, double longest_s) {
  return heard_s > 0.0 && now_s - heard_s <= longest_s;
}

ProcessFigures processOf(const UnitView& view, bool is_process_heard, double now_s) {
  ProcessFigures figures;
  if (isRecent(view.heaters_heard_s, now_s, kLongestHeaterSilence)) {
    figures.nozzle_c = known(view.heaters.nozzle);
    figures.bed_c = known(view.heaters.bed);
  }
  if (is_process_heard) {
    figures.flow_mm3_s = known(view.process.flow * kCubicMillimetres);
    figures.laser_w = known(view.process.laser_power);
    figures.wire_mm_s = known(view.process.wire_speed * kMillimetres);
  }
  if (isRecent(view.printed_heard_s, now_s, kLongestProcessSilence))
    figures.tip_speed_mm_s = known(view.printed.tip_speed * kMillimetres);
  figures.mean_error_mm = known(view.layer.mean_error * kMillimetres);
  figures.rmse_mm = known(view.layer.rms_error * kMillimetres);
  figures.coverage = known(view.layer.coverage);
  const auto correction = view.mean_corrections.find(view.figures.map_digest);
  const bool is_of_layer =
      view.figures.toolpath_id == view.layer.toolpath_id && view.figures.layer == view.layer.layer;
  if (is_of_layer && correction != view.mean_corrections.end())
    figures.mean_correction = known(correction->second);
  return figures;
}

}  // namespace

double meanCorrection(const lamina_msgs::CorrectionMap& map) {
  double length = 0.0;
  double amount = 0.0;
  for (const lamina_msgs::CorrectionPath& path : map.paths)
    for (const double at_station : path.amount) {
      length += path.station;
      amount += path.station * at_station;
    }
  return length > 0.0 ? amount / length : 0.0;
}

PlcStatus plcStatus(const UnitView& view, double now_s) {
  PlcStatus status;
  const bool is_process_heard = isRecent(view.process_heard_s, now_s, kLongestProcessSilence);
  const double age_s = std::max(0.0, now_s - view.unit_heard_s);
  status.flags = flagsOf(view, is_process_heard);
  status.mode = status.mode_requested = view.unit.mode;
  status.state = stateOf(view);
  const auto next = completed(status.state);
  status.state_requested = next && status.state != UnitState::Execute ? *next : status.state;
  status.stop_reason = view.unit.stop_reason;
  status.stop_value = static_cast<std::int32_t>(
      std::clamp(std::round(std::isfinite(view.unit.stop_value) ? view.unit.stop_value : 0.0), -2147483648.0,
                 2147483647.0));
  status.alarms = alarmsOf(view);
  status.job = jobOf(view);
  status.process = processOf(view, is_process_heard, now_s);
  status.counters = counted({}, view.unit.mode, status.state, view.unit.since_reset + age_s);
  status.counters.parts = view.unit.parts;
  status.counters.defective = view.unit.defective;
  status.in_state_s = view.unit.in_state + age_s;
  status.in_mode_s = view.unit.in_mode + age_s;
  return status;
}

}  // namespace lamina
