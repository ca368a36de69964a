// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/supervision.hpp"

#include <cmath>
#include <cstdio>

namespace lamina {
namespace {

constexpr int kLayersRunning = 3;
constexpr int kDeviatingLayers = 2;
constexpr double kContestedShare = 0.2;
constexpr double kDeviatingShare = 0.02;
constexpr double kSaturatedShare = 0.05;
constexpr double kStepLayers = 0.75;
constexpr double kGrowingBy = 1.2;
constexpr double kGrowingLayers = 0.3;  // of a layer, below which growth is noise
constexpr double kLeastGrowth = 0.5;
constexpr double kGreatestGrowth = 1.8;
constexpr double kLeastConsistency = 0.5;
constexpr double kGreatestConsistency = 2.0;
constexpr double kStuckVariance = 1e-9;  // mm²
constexpr int kStuckProfiles = 50;
constexpr double kOffsetSigmas = 3.0;

std::string value(double number, const char* unit) {
  char text[48];
  std::snprintf(text, sizeof text, "%.3g%s", number, unit);
  return text;
}

void coast(LoopStep& step, CoastingFor why, const std::string& reason) {
  if (!isCorrecting(step.status.state)) return;
  // What only the operator ends is not ended by sight.
  if (step.status.state == LoopState::Coasting && step.status.coasting_for > why) return;
  step.status.state = LoopState::Coasting;
  step.status.coasting_for = why;
  step.status.reason = reason;
}

void raise(LoopStep& step, LoopAlarm alarm, LoopReaction reaction, std::string reason) {
  step.alarms.push_back({alarm, reaction, std::move(reason)});
}

LoopReaction reactionOf(Replanning replan) {
  if (replan == Replanning::Off) return LoopReaction::Warn;
  return replan == Replanning::Hold ? LoopReaction::Hold : LoopReaction::Replan;
}

/// A layer of which nothing can be used.
void missLayer(LoopStep& step, const LoopSettings& settings) {
  LoopStatus& status = step.status;
  ++status.unmeasured_layers;
  coast(step, CoastingFor::Sight, "the layer was not measured");
  if (!isSightLost(status) || !isCorrecting(status.state)) return;
  const std::string reason = std::to_string(status.unmeasured_layers) + " layers running were not measured";
  if (settings.on_loss == LossOfSight::Hold)
    return raise(step, LoopAlarm::Silent, LoopReaction::Hold, reason);
  raise(step, LoopAlarm::Silent, LoopReaction::Open, reason);
  status.state = LoopState::Open;
  status.coasting_for = CoastingFor::Nothing;
  status.reason = reason;
}

/// A mean over the cells seen and over what came off.
double withFallen(const LayerFigures& figures, double of_seen, double of_fallen) {
  const FallenLength& fallen = figures.fallen;
  if (fallen.share == 0.0) return of_seen;
  return (figures.coverage * of_seen + fallen.share * of_fallen) / (figures.coverage + fallen.share);
}

double meanError(const LayerFigures& figures) {
  return withFallen(figures, figures.mean_error_mm, figures.fallen.depth_mm);
}

std::string whereFallen(const FallenLength& fallen) {
  if (fallen.share == 0.0) return {};
  return "; " + value(100.0 * fallen.share, " %") + " of the length lies " + value(fallen.depth_mm, " mm") +
         " below the plan";
}

void judgeStep(LoopStep& step, const LayerFigures& figures) {
  if (!step.status.has_figures) return;
  // Layers that were not measured in between may each have drifted.
  const std::size_t last = step.status.layer;
  const auto layers = static_cast<double>(figures.layer > last ? figures.layer - last : 1);
  const double jump = meanError(figures) - step.status.mean_error_mm;
  const double most = layers * kStepLayers * figures.height_mm;
  if (std::abs(jump) <= most) return;
  raise(step, LoopAlarm::Step, LoopReaction::Hold,
        "the mean error jumped by " + value(jump, " mm") + " within " + value(layers, "") +
            " layers; expected at most " + value(most, " mm") + ": something broke or came off" +
            whereFallen(figures.fallen));
}

void judgeDeviation(LoopStep& step, const LayerFigures& figures, const LoopSettings& settings) {
  int& layers = step.status.deviating_layers;
  const double deviating = withFallen(figures, figures.deviating_share, 1.0);
  layers = deviating > kDeviatingShare ? layers + 1 : 0;
  if (layers == 0) return;
  raise(step, LoopAlarm::Deviation, layers >= kDeviatingLayers ? LoopReaction::Hold : LoopReaction::Warn,
        value(100.0 * deviating, " %") + " of the cells are off by more than " +
            value(settings.alarm_layers * figures.height_mm, " mm") + "; expected at most 2 %" +
            whereFallen(figures.fallen));
}

void judgeTrend(LoopStep& step, const LayerFigures& figures) {
  LoopStatus& status = step.status;
  // What limits leave uncorrected grows without the loop being wrong: 6113 reports that.
  const bool is_limited = figures.limited_share > kSaturatedShare;
  const bool grows = status.has_figures && !is_limited && figures.rmse_mm > kGrowingBy * status.rmse_mm;
  status.growing_layers = grows ? status.growing_layers + 1 : 0;
  if (status.growing_layers < kLayersRunning || figures.rmse_mm <= kGrowingLayers * figures.height_mm) return;
  if (status.state != LoopState::Active) return;
  const std::string reason = "the error grew three layers running, to " + value(figures.rmse_mm, " mm") +
                             "; expected it to fall: the loop itself is suspect";
  raise(step, LoopAlarm::Diverging, LoopReaction::Coast, reason);
  coast(step, CoastingFor::Suspect, reason);
}

void judgeGrowth(LoopStep& step, const LayerFigures& figures) {
  if (figures.gain_least >= kLeastGrowth && figures.gain_greatest <= kGreatestGrowth) return;
  raise(step, LoopAlarm::Growth, LoopReaction::Warn,
        "growth over commanded growth is " + value(figures.gain_least, "") + " to " +
            value(figures.gain_greatest, "") + "; expected 0.5 to 1.8: look at feeder, nozzle and material");
}

void judgeConsistency(LoopStep& step, const LayerFigures& figures) {
  const auto isOutside = [](double figure) {
    return figure < kLeastConsistency || figure > kGreatestConsistency;
  };
  const bool is_sensor = isOutside(figures.repeatability);
  int& layers = step.status.inconsistent_layers;
  layers = is_sensor || isOutside(figures.consistency) ? layers + 1 : 0;
  if (layers < kLayersRunning) return;
  raise(step, LoopAlarm::Inconsistent, LoopReaction::Warn,
        is_sensor ? "readings scatter " + value(figures.repeatability, "") +
                        " times as expected; expected 0.5 to 2: the sensor's noise is wrong"
                  : "growth scatters " + value(figures.consistency, "") +
                        " times as expected; expected 0.5 to 2: the spread of growth is wrong");
}

std::string stuckReason(const SensorWatch& watch) {
  return std::to_string(watch.profiles) + " profiles" +
         (watch.sensor.empty() ? "" : " of sensor '" + watch.sensor + "'") +
         " are the same or no numbers, with a variance of " + value(watch.variance_mm2, " mm²") +
         "; expected 1e-9 mm² at least while the nozzle moves";
}

}  // namespace

bool isCondition(LoopAlarm alarm) {
  return alarm == LoopAlarm::Silent || alarm == LoopAlarm::NoTransform || alarm == LoopAlarm::Stuck ||
         alarm == LoopAlarm::TimeOffset;
}

bool isRunning(LoopState state) { return state != LoopState::Off && state != LoopState::Blocked; }

bool isSightLost(const LoopStatus& status) { return status.unmeasured_layers >= kLayersRunning; }

bool isStuck(int profiles, double variance_mm2) {
  return profiles >= kStuckProfiles && !(variance_mm2 >= kStuckVariance);
}

bool isLeftOut(const SensorWatch& watch) {
  return watch.is_seen_otherwise && isStuck(watch.profiles, watch.variance_mm2);
}

LoopStatus afterRequest(LoopRequest request, const StabilityReport& report) {
  LoopStatus next;
  if (request == LoopRequest::Off) return next;
  next.reason = report.reason;
  if (!report.may_start)
    next.state = LoopState::Blocked;
  else
    next.state = request == LoopRequest::Active ? LoopState::Active : LoopState::Identifying;
  return next;
}

LoopStep afterWatch(const LoopStatus& status, const SensorWatch& watch, const LoopSettings& settings) {
  LoopStep step{status, {}};
  if (!isRunning(status.state)) return step;
  const auto lose = [&](LoopAlarm alarm, CoastingFor why, const std::string& reason) {
    raise(step, alarm, LoopReaction::Coast, reason);
    coast(step, why, reason);
  };
  if (watch.is_scanning && watch.silent_s > settings.silence_s)
    lose(LoopAlarm::Silent, CoastingFor::Sight,
         std::string("no cloud") + (isLeftOut(watch) ? " of a sensor that is not stuck" : "") + " for " +
             value(watch.silent_s, " s") + "; expected one every " + value(settings.silence_s, " s"));
  else if (watch.is_scanning && watch.blind_s > settings.silence_s)
    lose(LoopAlarm::NoTransform, CoastingFor::Sight,
         "clouds, but no pose of the nozzle for " + value(watch.blind_s, " s") + "; expected one every " +
             value(settings.silence_s, " s"));
  else if (watch.is_scanning && watch.unplaced_s > settings.silence_s)
    lose(LoopAlarm::NoTransform, CoastingFor::Sight,
         "clouds, but none whose frame tf knows over the bed for " + value(watch.unplaced_s, " s") +
             "; expected one every " + value(settings.silence_s, " s"));
  if (isLeftOut(watch))
    raise(step, LoopAlarm::Stuck, LoopReaction::Warn,
          stuckReason(watch) + "; its clouds are left out, those of the others count");
  else if (isStuck(watch.profiles, watch.variance_mm2))
    lose(LoopAlarm::Stuck, CoastingFor::Sight, stuckReason(watch));
  if (watch.time_offset_sigmas > kOffsetSigmas)
    lose(LoopAlarm::TimeOffset, CoastingFor::TimeOffset,
         (watch.offset_sensor.empty() ? "the sensor's time offset"
                                      : "the time offset of sensor '" + watch.offset_sensor + "'") +
             " has moved by " + value(1e3 * watch.time_offset_s, " ms") + ", which is " +
             value(watch.time_offset_sigmas, "") + " standard deviations; expected 3 at most: calibrate it");
  else if (!watch.moved.empty())
    lose(LoopAlarm::TimeOffset, CoastingFor::TimeOffset, watch.moved);
  if (watch.map_late_s > 0.0 && watch.map_late_s >= settings.wait_s)
    raise(step, LoopAlarm::MapLate, LoopReaction::Coast,
          "the layer's map is " + value(watch.map_late_s, " s") + " late; expected it within " +
              value(settings.wait_s, " s"));
  return step;
}

LoopStep afterLayer(const LoopStatus& status, const LayerFigures& figures, const LoopSettings& settings) {
  LoopStep step{status, {}};
  if (!isRunning(status.state)) return step;
  if (figures.contested_share > kContestedShare) {
    raise(step, LoopAlarm::Contested, LoopReaction::LeaveOut,
          value(100.0 * figures.contested_share, " %") +
              " of the layer's cells are contested; expected 20 % at most");
    missLayer(step, settings);
    return step;
  }
  LoopStatus& next = step.status;
  if (!figures.is_measured) {
    missLayer(step, settings);
    if (figures.fallen.share == 0.0) return step;
    judgeStep(step, figures);
    next.layer = figures.layer;
    next.mean_error_mm = meanError(figures);
    return step;
  }
  next.unmeasured_layers = 0;
  if (next.state == LoopState::Coasting && next.coasting_for == CoastingFor::Sight) {
    next.state = LoopState::Active;
    next.coasting_for = CoastingFor::Nothing;
    next.reason.clear();
  }
  judgeStep(step, figures);
  judgeDeviation(step, figures, settings);
  judgeTrend(step, figures);
  judgeGrowth(step, figures);
  judgeConsistency(step, figures);
  next.saturated_layers = figures.limited_share > kSaturatedShare ? next.saturated_layers + 1 : 0;
  if (next.saturated_layers >= kLayersRunning)
    raise(step, LoopAlarm::Saturated, reactionOf(settings.replan),
          "corrections are at their limits on " + value(100.0 * figures.limited_share, " %") +
              " of the length, three layers running; expected 5 % at most");
  next.has_figures = true;
  next.layer = figures.layer;
  next.mean_error_mm = meanError(figures);
  next.rmse_mm = figures.rmse_mm;
  return step;
}

LoopStatus afterReplan(const LoopStatus& status, double raised_mm) {
  LoopStatus next;
  next.state = LoopState::Active;
  next.has_figures = status.has_figures;
  next.layer = status.layer;
  next.mean_error_mm = status.mean_error_mm + raised_mm;
  next.rmse_mm = std::max(status.rmse_mm, std::abs(next.mean_error_mm));
  return next;
}

LoopStep beforeLayer(const LoopStatus& status, double lump_mm, double clearance_mm) {
  LoopStep step{status, {}};
  if (!isRunning(status.state) || !(lump_mm > clearance_mm)) return step;
  raise(step, LoopAlarm::Lump, LoopReaction::Hold,
        "a lump stands " + value(lump_mm, " mm") +
            " above the nozzle; expected less than the head's clearance of " + value(clearance_mm, " mm"));
  return step;
}

}  // namespace lamina
