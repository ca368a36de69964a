// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/simulated_controller.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lamina {
namespace {

constexpr double kAtRest = 1e-9;  // of a joint's speed per second: numbers that stand for none
constexpr int kSubsteps = 8;      // of a cycle, of a lag of second order
constexpr double kOnTime = 1e-9;  // s

bool isMovingJoints(const JointState& state) { return state.velocity.cwiseAbs().maxCoeff() > kAtRest; }

/// The cubic through two points with their velocities.
JointValues between(const JointState& a, const JointState& b, double time_s) {
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  const double v = 1.0 - u;
  return v * v * (1.0 + 2.0 * u) * a.position + u * u * (1.0 + 2.0 * v) * b.position +
         h * u * v * (v * a.velocity - u * b.velocity);
}

/// The rate of change of the same.
JointValues rateBetween(const JointState& a, const JointState& b, double time_s) {
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  const double v = 1.0 - u;
  return 6.0 * u * v / h * (b.position - a.position) + v * (v - 2.0 * u) * a.velocity +
         u * (u - 2.0 * v) * b.velocity;
}

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
      position_(start),
      velocity_(JointValues::Zero(start.size())),
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
    velocity_.setZero();
    process_ = safeSignals();
    return;
  }
  if (points_.empty()) return;
  wanted_ = asked(time_s);
  follow(wanted_);
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
  return between(from, points_[1], time_s);
}

void SimulatedController::brake() {
  if (points_.empty()) return;
  JointState here;
  here.time_s = start_s_ + static_cast<double>(cycles_) / settings_.rate_hz;
  here.position = wanted_;
  const bool is_between = points_.size() > 1 && here.time_s >= points_.front().time_s;
  here.velocity =
      is_between ? rateBetween(points_.front(), points_[1], here.time_s) : JointValues::Zero(wanted_.size());
  late_.clear();
  brakeFrom(std::move(here));
}

/// All joints come to rest together, each with the same deceleration all the way.
void SimulatedController::brakeFrom(JointState moving) {
  moving.process = safeSignals();
  double duration_s = 0.0;
  double room_s =
      std::numeric_limits<double>::infinity();  // for the first joint that has to stop at its limit
  for (std::size_t j = 0; j < model_.joints().size(); ++j) {
    const DrivenJoint& joint = model_.joints()[j];
    const auto i = static_cast<Eigen::Index>(j);
    const double speed = moving.velocity[i];
    if (speed == 0.0) continue;
    duration_s = std::max(duration_s, settings_.brake_s * std::abs(speed) / joint.max_speed);
    const double room = speed > 0.0 ? joint.high - moving.position[i] : moving.position[i] - joint.low;
    room_s = std::min(room_s, 2.0 * std::max(0.0, room) / std::abs(speed));
  }
  duration_s = std::min(duration_s, room_s);
  JointState rest = moving;
  rest.time_s += duration_s;
  rest.position += 0.5 * duration_s * moving.velocity;
  rest.velocity.setZero();
  points_.clear();
  if (duration_s > kOnTime) points_.push_back(std::move(moving));
  points_.push_back(std::move(rest));
}

void SimulatedController::follow(const JointValues& asked) {
  const double step_s = 1.0 / settings_.rate_hz;
  if (settings_.lag_s <= 0.0 || settings_.damping <= 0.0) {
    const double part = settings_.lag_s > 0.0 ? 1.0 - std::exp(-step_s / settings_.lag_s) : 1.0;
    const JointValues next = position_ + part * (asked - position_);
    velocity_ = (next - position_) / step_s;
    position_ = next;
    return;
  }
  const double natural = 1.0 / settings_.lag_s;
  const auto substeps = kSubsteps * static_cast<int>(std::ceil(step_s * natural * settings_.damping + 1.0));
  const double h = step_s / substeps;
  for (int i = 0; i < substeps; ++i) {
    // Implicit in the damping: stable whatever the step.
    velocity_ = (velocity_ + h * natural * natural * (asked - position_)) /
                (1.0 + 2.0 * settings_.damping * natural * h);
    position_ += h * velocity_;
  }
}

void SimulatedController::measure(const JointValues& asked) {
  const JointValues error = asked - position_;
  const double tip_mm =
      (model_.bedFromNozzle(asked).translation() - model_.bedFromNozzle(position_).translation()).norm();
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
