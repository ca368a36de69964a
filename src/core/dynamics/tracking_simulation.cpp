// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/tracking_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kMillimetres = 1e3;  // in the metre
constexpr double kSliver = 1e-6;      // of a step: rounding of the time
constexpr double kFarAway = 1e6;      // m, rad/s: beyond it the platform has come off

// Where the parts of a state begin.
constexpr int kPosition = 0;
constexpr int kAttitude = 3;
constexpr int kTwist = 7;
constexpr int kIntegral = 13;
constexpr int kDoubleIntegral = 19;
constexpr int kEnergy = 25;
constexpr int kLinear = 26;
constexpr int kRotational = 27;

PlatformInertia loadedBy(double load_kg, PlatformInertia inertia) {
  inertia.platform_kg += load_kg;
  return inertia;
}

double squaredTurnError(const Eigen::Matrix3d& asked, const Eigen::Matrix3d& actual) {
  const PlatformAngles a = platformAngles(asked);
  const PlatformAngles b = platformAngles(actual);
  const Point3 error(a.alpha - b.alpha, std::remainder(a.beta - b.beta, 2.0 * M_PI),
                     std::remainder(a.gamma - b.gamma, 2.0 * M_PI));
  return error.squaredNorm();
}

Eigen::Isometry3d inMillimetres(Eigen::Isometry3d pose) {
  pose.translation() *= kMillimetres;
  return pose;
}

}  // namespace

void describe(SettingsSchema& schema, TrackingSettings& settings) {
  describe(schema, settings.inertia);
  schema.number("platform.unknown_load_kg", settings.unknown_load_kg, {0.0, 1000.0},
                "Mass on the platform that its controller does not know of.");
  describe(schema, settings.gains);
  schema.number("simulation.step_s", settings.step_s, Bounds::above(0.0, 1e-3),
                "Step of the integration in time, at most 1 ms.");
}

struct TrackingSimulation::Slope {
  State value;
  CrankAngles error = CrankAngles::Zero();
  CrankAngles torque = CrankAngles::Zero();
};

TrackingSimulation::TrackingSimulation(const TrackingReference& reference, const RusPlatform& platform,
                                       const Point3& tip_mm, const TrackingSettings& settings)
    : reference_(reference),
      platform_(platform),
      metric_(inMetres(platform)),
      tip_mm_(tip_mm),
      settings_(settings),
      loaded_(loadedBy(settings.unknown_load_kg, settings.inertia)),
      asked_(reference.at(0.0)) {
  requireStable(settings.gains);
  if (!(settings.step_s > 0.0))
    throw InvalidConfig("simulation.step_s is " + numberText(settings.step_s) + " s; must be positive");
  state_.segment<3>(kPosition) = asked_.pose.translation() / kMillimetres;
  state_.segment<4>(kAttitude) = Eigen::Quaterniond(asked_.pose.linear()).coeffs();
}

void TrackingSimulation::startAt(const CrankAngles& cranks) {
  const Eigen::Isometry3d pose = poseFromHome(platform_, cranks);
  time_s_ = 0.0;
  asked_ = reference_.at(0.0);
  report_ = {};
  state_.setZero();
  state_.segment<3>(kPosition) = pose.translation() / kMillimetres;
  state_.segment<4>(kAttitude) = Eigen::Quaterniond(pose.linear()).coeffs();
}

PlatformState TrackingSimulation::platformAt(const State& state) const {
  PlatformState platform;
  const Eigen::Quaterniond attitude(Eigen::Vector4d(state.segment<4>(kAttitude)));
  platform.pose.linear() = attitude.normalized().toRotationMatrix();
  platform.pose.translation() = state.segment<3>(kPosition);
  platform.twist = state.segment<6>(kTwist);
  const auto cranks = crankAnglesIfReached(metric_.platform, platform.pose);
  if (!cranks || !(state.cwiseAbs().maxCoeff() < kFarAway))
    throw Unreachable("the simulated platform comes out of reach " + numberText(time_s_) +
                      " s after the start");
  platform.cranks = *cranks;
  return platform;
}

TrackingSimulation::Slope TrackingSimulation::slopeAt(const State& state,
                                                      const ReferenceState& reference) const {
  const PlatformState platform = platformAt(state);
  const PlatformRates rates = ratesOf(metric_, platform);
  const PlatformTerms terms = termsOf(platform, rates, loaded_);
  const bool is_known = settings_.unknown_load_kg == 0.0;
  const PlatformTerms known = is_known ? terms : termsOf(platform, rates, settings_.inertia);

  const TrackingError error{reference.cranks - platform.cranks, reference.rates - rates.cranks,
                            state.segment<6>(kIntegral), state.segment<6>(kDoubleIntegral)};
  Slope slope;
  slope.error = error.value;
  // The law of [Guacheta2021, eq. 1.8] does not answer for the friction.
  slope.torque = known.mass * askedAccelerations(settings_.gains, error) + known.coriolis + known.gravity;
  const CrankAngles accelerations = accelerationsFrom(terms, slope.torque);

  const Point3 turn = platform.twist.tail<3>();
  const Eigen::Quaterniond attitude(Eigen::Vector4d(state.segment<4>(kAttitude)));
  slope.value.segment<3>(kPosition) = platform.twist.head<3>();
  slope.value.segment<4>(kAttitude) =
      0.5 * (Eigen::Quaterniond(0.0, turn.x(), turn.y(), turn.z()) * attitude).coeffs();
  slope.value.segment<6>(kTwist) = rates.twist_from_rates * accelerations + rates.bias;
  slope.value.segment<6>(kIntegral) = error.value;
  slope.value.segment<6>(kDoubleIntegral) = error.integral;
  slope.value[kEnergy] = slope.torque.squaredNorm();
  slope.value[kLinear] = (reference.pose * tip_mm_ - inMillimetres(platform.pose) * tip_mm_).squaredNorm();
  slope.value[kRotational] = squaredTurnError(reference.pose.linear(), platform.pose.linear());
  return slope;
}

void TrackingSimulation::step() {
  const double left_s = reference_.duration() - time_s_;
  const bool is_last = left_s <= settings_.step_s * (1.0 + kSliver);
  const double step_s = is_last ? left_s : settings_.step_s;
  const ReferenceState middle = reference_.at(time_s_ + 0.5 * step_s);
  const ReferenceState end = reference_.at(time_s_ + step_s);
  const Slope first = slopeAt(state_, asked_);
  const State second = slopeAt(state_ + 0.5 * step_s * first.value, middle).value;
  const State third = slopeAt(state_ + 0.5 * step_s * second, middle).value;
  const State fourth = slopeAt(state_ + step_s * third, end).value;
  state_ += step_s / 6.0 * (first.value + 2.0 * (second + third) + fourth);
  state_.segment<4>(kAttitude).normalize();
  report_.greatest_torque_nm = std::max(report_.greatest_torque_nm, first.torque.cwiseAbs().maxCoeff());
  report_.greatest_crank_error_rad =
      std::max(report_.greatest_crank_error_rad, first.error.cwiseAbs().maxCoeff());
  report_.greatest_tip_error_mm = std::max(report_.greatest_tip_error_mm, std::sqrt(first.value[kLinear]));
  report_.greatest_turn_error_rad =
      std::max(report_.greatest_turn_error_rad, std::sqrt(first.value[kRotational]));
  time_s_ = is_last ? reference_.duration() : time_s_ + step_s;
  asked_ = end;
  report_.duration_s = time_s_;
  report_.control_energy_nm2_s = state_[kEnergy];
  report_.linear_ise_mm2_s = state_[kLinear];
  report_.rotational_ise_rad2_s = state_[kRotational];
}

TrackingSample TrackingSimulation::sample() const {
  const Slope slope = slopeAt(state_, asked_);
  return {time_s_,
          slope.error,
          slope.torque,
          inMillimetres(platformAt(state_).pose),
          std::sqrt(slope.value[kLinear]),
          std::sqrt(slope.value[kRotational])};
}

TrackingFigures simulateTracking(TrackingSimulation simulation, Progress& progress) {
  constexpr std::size_t kStepsPerReport = 200;
  const std::string stage = "simulate";
  for (std::size_t steps = 0; !simulation.isFinished(); ++steps) {
    if (steps % kStepsPerReport == 0) {
      throwIfCancelled(progress, stage);
      progress.report(stage, simulation.time() / simulation.duration());
    }
    simulation.step();
  }
  progress.report(stage, 1.0);
  return simulation.report();
}

}  // namespace lamina
