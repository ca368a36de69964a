// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/simulated_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lamina/trajectory/joint_braking.hpp"
#include "lamina/trajectory/joint_cubic.hpp"

namespace lamina {
namespace {

constexpr double kAtRest = 1e-9;  // of a joint's speed per second: numbers that stand for none
constexpr double kOnTime = 1e-9;  // s

bool isMovingJoints(const JointState& state) { return state.velocity.cwiseAbs().maxCoeff() > kAtRest; }

}  // namespace

void describe(SettingsSchema& schema, ServoSettings& settings) {
  schema.number("servo.rate_hz", settings.rate_hz, {1.0, 10000.0},
                "Cycles of the simulated controller per second.");
  schema.number("servo.lag_s", settings.lag_s, {0.0, 10.0},
                "Time constant with which simulated joints follow.");
  schema.number("servo.damping", settings.damping, {0.0, 10.0},
                "Damping of a lag of second order; 0 for one of first order.");
  schema.number(
      "servo.brake_s", settings.brake_s, {0.0, 10.0},
      "Time in which a joint comes to rest from its greatest speed when nothing is left to follow.");
}

SimulatedController::SimulatedController(const Clock& clock, const KinematicModel& model,
                                         const ServoSettings& settings, const JointValues& start,
                                         const ControllerFaults& faults)
    : clock_(clock),
      model_(model),
      settings_(settings),
      faults_(faults),
      start_s_(clock.now()),
      wanted_(start),
      servo_(settings.lag_s, settings.damping, start),
      squares_(JointValues::Zero(start.size())) {
  ServoSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  report_.greatest = JointValues::Zero(start.size());
  report_.least_queue_s = std::numeric_limits<double>::infinity();
}

void SimulatedController::accept(const TrajectoryChunk& chunk) {
  const bool is_late = faults_.late_chunk == accepted_++;
  // Chunks arrive in order: those behind a late one wait with it.
  if (is_late || !late_.empty())
    late_.push_back({is_late ? clock_.now() + faults_.late_s : late_.back().arrival_s, chunk});
  else
    enqueue(chunk);
}

void SimulatedController::enqueue(const TrajectoryChunk& chunk) {
  if (chunk.points.empty()) return;
  const double first_s = chunk.points.front().time_s;
  while (!points_.empty() && points_.back().time_s >= first_s - kOnTime) points_.pop_back();
  points_.insert(points_.end(), chunk.points.begin(), chunk.points.end());
}

void SimulatedController::receiveLate(double time_s) {
  for (const Late& late : late_)
    if (late.arrival_s <= time_s) enqueue(late.chunk);
  late_.erase(
      std::remove_if(late_.begin(), late_.end(), [&](const Late& late) { return late.arrival_s <= time_s; }),
      late_.end());
}

void SimulatedController::advance() {
  const double now_s = clock_.now();
  for (;;) {
    const double time_s = start_s_ + static_cast<double>(cycles_ + 1) / settings_.rate_hz;
    if (time_s > now_s + kOnTime) return;
    ++cycles_;
    receiveLate(time_s);
    cycle(time_s);
  }
}

void SimulatedController::cycle(double time_s) {
  if (faults_.stop_s && time_s >= *faults_.stop_s) {
    report_.is_stopped = true;
    servo_.stop();
    process_ = safeSignals();
    return;
  }
  if (points_.empty()) return;
  wanted_ = asked(time_s);
  servo_.follow(wanted_, 1.0 / settings_.rate_hz);
  measure(wanted_);
}

void SimulatedController::pass(double time_s) {
  while (points_.size() > 1 && points_[1].time_s <= time_s + kOnTime) points_.pop_front();
}

JointValues SimulatedController::asked(double time_s) {
  pass(time_s);
  if (isMovingJoints(points_.back()))
    report_.least_queue_s = std::min(report_.least_queue_s, std::max(0.0, points_.back().time_s - time_s));
  if (points_.size() == 1 && isMovingJoints(points_.front()) && time_s > points_.front().time_s + kOnTime) {
    ++report_.starvations;
    brakeFrom(points_.front());
    pass(time_s);
  }
  const JointState& from = points_.front();
  process_ = from.process;
  if (points_.size() == 1 || time_s <= from.time_s) return from.position;
  return cubicPosition(from, points_[1], time_s);
}

void SimulatedController::brake() {
  if (points_.empty()) return;
  JointState here;
  here.time_s = start_s_ + static_cast<double>(cycles_) / settings_.rate_hz;
  here.position = wanted_;
  const bool is_between = points_.size() > 1 && here.time_s >= points_.front().time_s;
  here.velocity = is_between ? cubicVelocity(points_.front(), points_[1], here.time_s)
                             : JointValues::Zero(wanted_.size());
  late_.clear();
  brakeFrom(std::move(here));
}

/// All joints come to rest together, each with the same deceleration all the way.
void SimulatedController::brakeFrom(JointState moving) {
  moving.process = safeSignals();
  const double duration_s = std::min(brakeTime(moving.velocity, model_.joints(), settings_.brake_s),
                                     brakeRoom(moving.position, moving.velocity, model_.joints()));
  JointState rest = moving;
  rest.time_s += duration_s;
  rest.position += 0.5 * duration_s * moving.velocity;
  rest.velocity.setZero();
  points_.clear();
  if (duration_s > kOnTime) points_.push_back(std::move(moving));
  points_.push_back(std::move(rest));
}

void SimulatedController::measure(const JointValues& asked) {
  const JointValues error = asked - position();
  const double tip_mm =
      (model_.bedFromNozzle(asked).translation() - model_.bedFromNozzle(position()).translation()).norm();
  ++report_.cycles;
  report_.greatest = report_.greatest.cwiseMax(error.cwiseAbs());
  squares_ += error.cwiseAbs2();
  report_.tip_greatest_mm = std::max(report_.tip_greatest_mm, tip_mm);
  tip_squares_ += tip_mm * tip_mm;
}

double SimulatedController::queued() const {
  const double now_s = start_s_ + static_cast<double>(cycles_) / settings_.rate_hz;
  return points_.empty() ? 0.0 : std::max(0.0, points_.back().time_s - now_s);
}

std::optional<double> SimulatedController::runsOutAt() const {
  if (points_.empty() || !isMovingJoints(points_.back())) return std::nullopt;
  return points_.back().time_s;
}

TrackingReport SimulatedController::report() const {
  TrackingReport report = report_;
  const double cycles = std::max(1.0, static_cast<double>(report_.cycles));
  report.rms = (squares_ / cycles).cwiseSqrt();
  report.tip_rms_mm = std::sqrt(tip_squares_ / cycles);
  return report;
}

}  // namespace lamina
