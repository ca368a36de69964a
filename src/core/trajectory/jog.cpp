// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/jog.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/dense_solvers.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kReserve = 0.9;    // of the acceleration, with which limits are braked for
constexpr double kRounding = 1e-9;  // of a share
constexpr double kStepReserve =
    0.125;  // of acceleration times a step's square: what a last step may go too far
constexpr double kMostOfRange = 0.25;    // that a margin takes of the range of a joint
constexpr double kSlowing = 3.0;         // times the least margin: from here on a singularity slows down
constexpr double kLook = 1e-3;           // s ahead, to see whether a singularity comes nearer
constexpr double kDamping = 0.1;         // at a singularity
constexpr double kDamped = 0.1;          // margin below which damping sets in
constexpr double kNone = 1e-6;           // of the greatest singular value: nothing moves so
constexpr double kMissed = 0.01;         // of what is asked of the nozzle, that no joint can do
constexpr double kKept = 1.0;            // s of points that are remembered
constexpr double kOnTheGrid = 1e-6;      // of a step
constexpr double kMillimetres = 1000.0;  // per metre: tip and turn are weighed in m and rad
constexpr double kLeastSteps = 2.0;      // of a lease behind the reaction: one may go to the grid of points
constexpr double kMostBeyond = 0.1;      // s of motion that must be clear beyond its rest; all of a turn
constexpr double kShares[] = {1.0, 0.5, 0.25, 0.125};

/// Rates scaled to a limit, in their direction.
void scaleTo(double share, const std::string& reason, JointValues& rates, JogAnswer& answer) {
  if (share >= 1.0 - kRounding) return;
  rates *= share;
  answer.scale *= share;
  answer.reason = reason;
}

}  // namespace

std::string JogLease::renew(const std::string& holder, double now_s) {
  const std::string present = this->holder(now_s);
  if (!present.empty() && present != holder)
    return present + " holds the lease; it is free once nothing is heard of it for " + numberText(lease_s_) +
           " s";
  holder_ = holder;
  until_s_ = now_s + lease_s_;
  return "";
}

void describe(SettingsSchema& schema, JogSettings& settings) {
  schema.number("jog.lease_s", settings.lease_s, Bounds::above(0.0, 2.0),
                "Time for which an order to jog holds without the next one; then the motion brakes.");
  schema.number("jog.reaction_s", settings.reaction_s, {0.0, 1.0},
                "From an order to jog to the first point that differs for it.");
  schema.number("jog.rate_hz", settings.rate_hz, {10.0, 1000.0}, "Points of a jog per second.");
  schema.number("jog.joint_share", settings.joint_share, Bounds::above(0.0, 1.0),
                "Greatest speed of joints that are jogged, of their greatest speeds.");
  schema.number("jog.tip_mm_s", settings.tip_mm_s, Bounds::above(0.0, 1e4),
                "Greatest speed of a nozzle tip that is jogged.");
  schema.number("jog.turn_deg_s", settings.turn_deg_s, Bounds::above(0.0, 360.0),
                "Greatest turn per second of a nozzle that is jogged.");
  schema.number("jog.limit_margin_deg", settings.limit_margin_deg, {0.0, 90.0},
                "Angle in front of the limits of a rotary joint at which a jog rests.");
  schema.number("jog.limit_margin_mm", settings.limit_margin_mm, {0.0, 1e3},
                "Way in front of the limits of a linear joint at which a jog rests.");
  schema.number("jog.least_margin_deg", settings.least_margin_deg, {0.0, 45.0},
                "Angle from a singularity below which no jog of the nozzle goes.");
  schema.number("jog.clearance_mm", settings.clearance_mm, {0.0, 1e3},
                "Way of the tip that must be clear beyond where a jog would rest; no more than it goes in "
                "0.1 s, so that slow jogs come nearer.");
  schema.numbers(
      "jog.workspace_mm", settings.workspace_mm, 6,
      "Where a tip that is jogged may go: lowest x,y,z, highest x,y,z over the bed; empty for anywhere.");
}

/// A motion from the switch to rest.
struct Jog::Planned {
  std::vector<JointState> points;
  JogAnswer answer;
  JointValues beyond;  ///< where it would go on to
};

Jog::Jog(const KinematicModel& model, const JogSettings& settings, double ramp_s, const JointValues& start)
    : model_(model), settings_(settings), acceleration_(start.size()) {
  SettingsSchema schema;
  describe(schema, settings_);
  schema.validate();
  if (settings_.lease_s < settings_.reaction_s + kLeastSteps * step())
    throw InvalidConfig("jog.lease_s is " + numberText(settings_.lease_s) + " s; expected at least " +
                        numberText(settings_.reaction_s + kLeastSteps * step()) +
                        " s, jog.reaction_s and two points at jog.rate_hz, or nothing moves");
  for (Eigen::Index j = 0; j < start.size(); ++j)
    acceleration_[j] = model.joints()[static_cast<std::size_t>(j)].max_speed / ramp_s;
  JointState rest;
  rest.position = start;
  rest.velocity = rest.acceleration = JointValues::Zero(start.size());
  points_.push_back(std::move(rest));
}

JogAnswer Jog::order(const JogOrder& order, double now_s, const JogGuard& guard, const JogClock& clock) {
  const JointState from = switchPoint(now_s);
  JogOrder rest;
  rest.rates = JointValues::Zero(from.position.size());
  JogAnswer refused{0.0, ""};
  const auto isLate = [&] { return clock && clock() > from.time_s; };
  const auto brake = [&] {
    const Planned plan = planned(rest, from, now_s, 1.0);
    if (!isLate()) take(plan.points);
  };
  chunk_.points.clear();
  for (const double share : kShares) {
    std::optional<Planned> plan;
    try {
      plan = planned(order, from, now_s, share);
    } catch (const InvalidInput&) {
      brake();
      throw;
    }
    refused.reason = refusalOf(*plan, guard);
    if (isLate()) return {0.0, "the order is checked too late to be followed within jog.reaction_s"};
    if (!refused.reason.empty()) continue;
    take(plan->points);
    plan->answer.scale *= share;
    if (share < 1.0 && plan->answer.reason.empty()) plan->answer.reason = "the way beyond is not clear";
    return plan->answer;
  }
  brake();
  return refused;
}

std::string Jog::refusalOf(const Planned& plan, const JogGuard& guard) const {
  const std::vector<JointValues> places = {plan.points.front().position,
                                           plan.points[plan.points.size() / 2].position,
                                           plan.points.back().position, plan.beyond};
  if (!settings_.workspace_mm.empty()) {
    const auto beyondBox = [&](const JointValues& place) {
      const Eigen::Vector3d tip = model_.bedFromNozzle(place).translation();
      const Eigen::Map<const Eigen::Vector3d> low(settings_.workspace_mm.data());
      const Eigen::Map<const Eigen::Vector3d> high(settings_.workspace_mm.data() + 3);
      return Eigen::Array3d((low - tip).cwiseMax(tip - high));
    };
    // Who stands outside may come back, along each axis by itself.
    const Eigen::Array3d out = beyondBox(places[2]);
    if ((out > 0.0 && out > beyondBox(places[0])).any())
      return "the tip would leave jog.workspace_mm by " + numberText(out.maxCoeff()) + " mm";
  }
  return guard ? guard(places) : std::string();
}

Jog::Planned Jog::planned(const JogOrder& order, const JointState& from, double now_s, double share) const {
  Planned plan;
  plan.points.push_back(from);
  const auto held =
      static_cast<int>(std::floor((now_s + settings_.lease_s - from.time_s) * settings_.rate_hz));
  for (int i = 0; i < held; ++i) {
    const JointState& last = plan.points.back();
    plan.answer = {};
    JointValues wanted = share * ratesFor(order, last.position, plan.answer);
    for (Eigen::Index j = 0; j < wanted.size(); ++j) {
      const DrivenJoint& joint = model_.joints()[static_cast<std::size_t>(j)];
      // What is left of rounding must not stop the others at this joint's limit.
      if (std::abs(wanted[j]) < kRounding * joint.max_speed) wanted[j] = 0.0;
      if (wanted[j] != 0.0)
        scaleTo(allowedRate(j, last, wanted[j]) / std::abs(wanted[j]),
                "joint '" + joint.name + "' is near its limit", wanted, plan.answer);
    }
    JointState next = stepped(last, wanted);
    if (order.kind == JogOrder::Kind::Nozzle && restsTooNear(next, last)) {
      next = stepped(last, JointValues::Zero(wanted.size()));
      plan.answer = {0.0, "a singularity is near"};
    }
    plan.points.push_back(std::move(next));
  }
  const JointState moving = plan.points.back();
  const JointValues none = JointValues::Zero(from.position.size());
  while (!plan.points.back().velocity.isZero(0.0)) plan.points.push_back(stepped(plan.points.back(), none));
  plan.points.back().acceleration = none;
  const double tip_mm_s = (model_.jacobian(moving.position).topRows<3>() * moving.velocity).norm();
  const double beyond_s =
      tip_mm_s > 0.0 ? std::min(kMostBeyond, settings_.clearance_mm / tip_mm_s) : kMostBeyond;
  plan.beyond = plan.points.back().position + beyond_s * moving.velocity;
  return plan;
}

/// Whether braking from here would end nearer to a singularity than allowed, and than it is.
bool Jog::restsTooNear(const JointState& from, const JointState& last) const {
  double brake_s = 0.0;
  for (Eigen::Index j = 0; j < from.velocity.size(); ++j)
    if (from.velocity[j] != 0.0) brake_s = std::max(brake_s, std::abs(from.velocity[j]) / acceleration_[j]);
  const double margin = model_.singularityMargin(from.position + 0.5 * (brake_s + step()) * from.velocity);
  return margin < std::sin(toRadians(settings_.least_margin_deg)) &&
         margin < model_.singularityMargin(last.position);
}

JointValues Jog::ratesFor(const JogOrder& order, const JointValues& position, JogAnswer& answer) const {
  const bool is_of_joints = order.kind == JogOrder::Kind::Joints;
  if (is_of_joints && (order.rates.size() != position.size() || !order.rates.allFinite()))
    throw InvalidInput("a jog is of " + std::to_string(order.rates.size()) + " rates of joints; expected " +
                       std::to_string(position.size()) + " finite ones");
  JointValues rates = order.rates;
  if (!is_of_joints) rates = nozzleRates(order, position, answer);
  for (Eigen::Index j = 0; j < rates.size(); ++j) {
    const DrivenJoint& joint = model_.joints()[static_cast<std::size_t>(j)];
    const double most = settings_.joint_share * joint.max_speed;
    if (std::abs(rates[j]) > most)
      scaleTo(most / std::abs(rates[j]),
              "joint '" + joint.name + "' goes at jog.joint_share of its greatest speed", rates, answer);
  }
  if (is_of_joints) return rates;
  const double margin = model_.singularityMargin(position);
  const double least = std::sin(toRadians(settings_.least_margin_deg));
  if (margin < kSlowing * least && model_.singularityMargin(position + kLook * rates) < margin)
    scaleTo(std::max(0.0, (margin - least) / ((kSlowing - 1.0) * least)), "a singularity is near", rates,
            answer);
  return rates;
}

/// Damped least squares: what the nozzle is to do in m and rad, linear joints in m.
JointValues Jog::nozzleRates(const JogOrder& order, const JointValues& position, JogAnswer& answer) const {
  if (!order.linear_mm_s.allFinite() || !order.angular_velocity_rad_s.allFinite())
    throw InvalidInput("a jog of the nozzle is not finite; expected a velocity and a turn");
  Eigen::Matrix<double, 6, 1> asked;
  asked << order.linear_mm_s / kMillimetres, order.angular_velocity_rad_s;
  Eigen::MatrixXd jacobian = model_.jacobian(position);
  jacobian.topRows<3>() /= kMillimetres;
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    if (model_.joints()[static_cast<std::size_t>(j)].kind == JointKind::Linear)
      jacobian.col(j) *= kMillimetres;
  const double damping = kDamping * std::max(0.0, 1.0 - model_.singularityMargin(position) / kDamped);
  const SingularParts parts = singularParts(jacobian);
  const Eigen::VectorXd& values = parts.values;
  Eigen::VectorXd inverse = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (values[i] > kNone * values[0]) inverse[i] = values[i] / (values[i] * values[i] + damping * damping);
  const Eigen::VectorXd shares = inverse.cwiseProduct(parts.left.transpose() * asked);
  const Eigen::VectorXd found = parts.right * shares;
  if (damping == 0.0 && (jacobian * found - asked).norm() > kMissed * asked.norm())
    throw InvalidInput(model_.name() +
                       " cannot move its nozzle so; expected a motion that its joints can do");
  JointValues rates = found;
  for (Eigen::Index j = 0; j < rates.size(); ++j)
    if (model_.joints()[static_cast<std::size_t>(j)].kind == JointKind::Linear) rates[j] *= kMillimetres;
  const double speed = order.linear_mm_s.norm();
  const double turn = order.angular_velocity_rad_s.norm();
  if (speed > settings_.tip_mm_s)
    scaleTo(settings_.tip_mm_s / speed, "the tip goes at jog.tip_mm_s", rates, answer);
  const double most_turn = toRadians(settings_.turn_deg_s);
  if (turn * answer.scale > most_turn)
    scaleTo(most_turn / (turn * answer.scale), "the nozzle turns at jog.turn_deg_s", rates, answer);
  return rates;
}

/// Greatest rate in the direction of `direction` at the end of a step, from which a joint still comes to rest
/// in front of its limit.
double Jog::allowedRate(Eigen::Index joint, const JointState& from, double direction) const {
  const DrivenJoint& limits = model_.joints()[static_cast<std::size_t>(joint)];
  const double asked =
      limits.kind == JointKind::Linear ? settings_.limit_margin_mm : toRadians(settings_.limit_margin_deg);
  const double margin = std::min(asked, kMostOfRange * (limits.high - limits.low));
  const double at = from.position[joint];
  const double room = direction > 0.0 ? limits.high - margin - at : at - limits.low - margin;
  const double rate = direction > 0.0 ? from.velocity[joint] : -from.velocity[joint];
  const double a = kReserve * acceleration_[joint];
  const double left = room - kStepReserve * a * step() * step() - 0.5 * rate * step();
  if (left <= 0.0) return 0.0;
  return a * (std::sqrt(0.25 * step() * step() + 2.0 * left / a) - 0.5 * step());
}

JointState Jog::stepped(const JointState& from, const JointValues& wanted) const {
  const JointValues change = wanted - from.velocity;
  double share = 1.0;
  for (Eigen::Index j = 0; j < change.size(); ++j)
    if (std::abs(change[j]) > acceleration_[j] * step())
      share = std::min(share, acceleration_[j] * step() / std::abs(change[j]));
  JointState next;
  next.time_s = std::round((from.time_s + step()) * settings_.rate_hz) / settings_.rate_hz;
  next.velocity = share == 1.0 ? wanted : JointValues(from.velocity + share * change);
  for (Eigen::Index j = 0; j < change.size(); ++j) {
    const double rate = next.velocity[j];
    if (rate == 0.0) continue;
    const double most =
        std::max(allowedRate(j, from, rate), std::abs(from.velocity[j]) - acceleration_[j] * step());
    if (std::abs(rate) > most) next.velocity[j] = std::copysign(std::max(0.0, most), rate);
  }
  next.acceleration = (next.velocity - from.velocity) / step();
  next.position = from.position + 0.5 * step() * (from.velocity + next.velocity);
  return next;
}

JointState Jog::switchPoint(double now_s) const {
  const double time_s =
      std::ceil((std::max(0.0, now_s) + settings_.reaction_s) * settings_.rate_hz - kOnTheGrid) /
      settings_.rate_hz;
  JointState state = at(time_s);
  state.time_s = time_s;
  return state;
}

JointState Jog::at(double time_s) const {
  const auto later =
      std::upper_bound(points_.begin(), points_.end(), time_s + kOnTheGrid * step(),
                       [](double time, const JointState& point) { return time < point.time_s; });
  JointState state = later == points_.begin() ? points_.front() : *std::prev(later);
  if (later == points_.begin() || later == points_.end()) return state;
  const double passed_s = time_s - state.time_s;
  state.acceleration = later->acceleration;
  state.position += passed_s * (state.velocity + 0.5 * passed_s * state.acceleration);
  state.velocity += passed_s * state.acceleration;
  state.time_s = time_s;
  return state;
}

void Jog::take(const std::vector<JointState>& points) {
  const double first_s = points.front().time_s;
  while (!points_.empty() && points_.back().time_s >= first_s - kOnTheGrid * step()) points_.pop_back();
  points_.erase(points_.begin(), std::find_if(points_.begin(), points_.end(), [&](const JointState& point) {
                  return point.time_s >= first_s - kKept;
                }));
  points_.insert(points_.end(), points.begin(), points.end());
  chunk_.points = points;
}

}  // namespace lamina
