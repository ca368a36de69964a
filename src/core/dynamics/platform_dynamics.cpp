// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/platform_dynamics.hpp"

#include <Eigen/Cholesky>

#include "base/dense_solvers.hpp"

namespace lamina {
namespace {

constexpr double kMetres = 1e-3;  // in the millimetre

/// Velocity of a point that goes with the platform.
Point3 velocityAt(const Twist& twist, const Point3& arm) {
  return twist.head<3>() + twist.tail<3>().cross(arm);
}

/// What is left of its acceleration where the twist's derivative is `change`.
Point3 accelerationAt(const Twist& change, const Twist& twist, const Point3& arm) {
  const Point3 turn = twist.tail<3>();
  return velocityAt(change, arm) + turn.cross(turn.cross(arm));
}

/// A force at a point of the platform as a force and moment at its origin.
Twist wrench(const Point3& force, const Point3& arm) {
  Twist result;
  result << force, arm.cross(force);
  return result;
}

Eigen::Matrix<double, 3, 6> motionMap(const Point3& arm) {
  Eigen::Matrix<double, 3, 6> map;
  map << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  map.rightCols<3>() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
  return map;
}

/// The mobile platform as it is turned.
struct TurnedPlatform {
  Point3 centre;            ///< of mass, from the origin [m, base frame]
  Eigen::Matrix3d inertia;  ///< about the centre of mass [kg m², base frame]
};
TurnedPlatform turned(const PlatformState& state, const PlatformInertia& inertia) {
  const Eigen::Matrix3d rotation = state.pose.linear();
  return {kMetres * (rotation * inertia.centre_mm),
          rotation * inertia.platform_kg_m2.asDiagonal() * rotation.transpose()};
}

/// A slender rod between two points has the kinetic energy m (a² + ab + b²) / 6 of their velocities, and so
/// the forces m (2a + b) / 6 and m (a + 2b) / 6 of their accelerations at them.
Matrix6 massOf(const PlatformRates& rates, const TurnedPlatform& body, const PlatformInertia& inertia) {
  const auto centre = motionMap(body.centre);
  Matrix6 carried = inertia.platform_kg * (centre.transpose() * centre);
  carried.bottomRightCorner<3, 3>() += body.inertia;
  Matrix6 shared;
  CrankAngles own;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const PlatformRates::Leg& leg = rates.legs[static_cast<std::size_t>(i)];
    const auto ball = motionMap(leg.arm);
    carried.noalias() += inertia.coupler_kg / 3.0 * (ball.transpose() * ball);
    shared.row(i) = inertia.coupler_kg / 6.0 * wrench(leg.tangent, leg.arm).transpose();
    own[i] = (inertia.crank_kg + inertia.coupler_kg) / 3.0 * leg.tangent.squaredNorm();
  }
  const Matrix6& carrying = rates.twist_from_rates;
  const Matrix6 coupled = shared * carrying;
  Matrix6 mass = carrying.transpose() * carried * carrying + coupled + coupled.transpose();
  mass.diagonal() += own;
  return mass;
}

CrankAngles coriolisOf(const PlatformState& state, const PlatformRates& rates, const TurnedPlatform& body,
                       const PlatformInertia& inertia) {
  const Point3 turn = state.twist.tail<3>();
  const Point3 force = inertia.platform_kg * accelerationAt(rates.bias, state.twist, body.centre);
  Twist sum = wrench(force, body.centre);
  sum.tail<3>() += body.inertia * rates.bias.tail<3>() + turn.cross(body.inertia * turn);
  CrankAngles torques;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const PlatformRates::Leg& leg = rates.legs[static_cast<std::size_t>(i)];
    const Point3 elbow = -rates.cranks[i] * rates.cranks[i] * leg.crank;
    const Point3 ball = accelerationAt(rates.bias, state.twist, leg.arm);
    sum += wrench(inertia.coupler_kg / 6.0 * (elbow + 2.0 * ball), leg.arm);
    torques[i] = inertia.coupler_kg / 6.0 * (2.0 * elbow + ball).dot(leg.tangent);
  }
  return torques + rates.twist_from_rates.transpose() * sum;
}

CrankAngles gravityOf(const PlatformRates& rates, const TurnedPlatform& body,
                      const PlatformInertia& inertia) {
  Twist sum = wrench(-inertia.platform_kg * inertia.gravity, body.centre);
  CrankAngles torques;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const PlatformRates::Leg& leg = rates.legs[static_cast<std::size_t>(i)];
    sum += wrench(-0.5 * inertia.coupler_kg * inertia.gravity, leg.arm);
    torques[i] = -0.5 * (inertia.coupler_kg + inertia.crank_kg) * inertia.gravity.dot(leg.tangent);
  }
  return torques + rates.twist_from_rates.transpose() * sum;
}

}  // namespace

MetricPlatform inMetres(RusPlatform platform) {
  for (RusLeg& leg : platform.legs) {
    leg.motor *= kMetres;
    leg.ball *= kMetres;
    leg.crank_mm *= kMetres;
    leg.coupler_mm *= kMetres;
  }
  platform.home.translation() *= kMetres;
  return {platform};
}

PlatformRates ratesOf(const MetricPlatform& metric, const PlatformState& state) {
  PlatformRates rates;
  Matrix6 pose_rates;
  CrankAngles crank_rates;
  std::array<Point3, kLegs> couplers;
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = metric.platform.legs[i];
    const auto row = static_cast<Eigen::Index>(i);
    PlatformRates::Leg& at = rates.legs[i];
    at.arm = state.pose.linear() * leg.ball;
    at.crank = leg.crank_mm * leg.crankDirection(state.cranks[row]);
    at.tangent = leg.crank_mm * leg.crankTangent(state.cranks[row]);
    couplers[i] = state.pose.translation() + at.arm - leg.motor - at.crank;
    pose_rates.row(row) = wrench(couplers[i], at.arm).transpose();
    crank_rates[row] = couplers[i].dot(at.tangent);
  }
  rates.cranks = (pose_rates * state.twist).cwiseQuotient(crank_rates);

  CrankAngles change;
  for (std::size_t i = 0; i < kLegs; ++i) {
    const PlatformRates::Leg& leg = rates.legs[i];
    const auto row = static_cast<Eigen::Index>(i);
    const double rate = rates.cranks[row];
    const Point3 stretching = velocityAt(state.twist, leg.arm) - rate * leg.tangent;
    const Point3 towards = accelerationAt(Twist::Zero(), state.twist, leg.arm) + rate * rate * leg.crank;
    change[row] = -stretching.squaredNorm() - couplers[i].dot(towards);
  }
  const Matrix6 inverse = inverseOf(pose_rates);
  rates.twist_from_rates = inverse * crank_rates.asDiagonal();
  rates.bias = inverse * change;
  return rates;
}

PlatformTerms termsOf(const PlatformState& state, const PlatformRates& rates,
                      const PlatformInertia& inertia) {
  const TurnedPlatform body = turned(state, inertia);
  return {massOf(rates, body, inertia), coriolisOf(state, rates, body, inertia),
          gravityOf(rates, body, inertia), inertia.viscous_friction * rates.cranks};
}

CrankAngles torquesFor(const PlatformTerms& terms, const CrankAngles& accelerations) {
  return terms.mass * accelerations + terms.withoutAcceleration();
}

CrankAngles accelerationsFrom(const PlatformTerms& terms, const CrankAngles& torques) {
  return terms.mass.llt().solve(torques - terms.withoutAcceleration());
}

double kineticEnergy(const PlatformState& state, const PlatformRates& rates, const PlatformInertia& inertia) {
  const TurnedPlatform body = turned(state, inertia);
  const Point3 turn = state.twist.tail<3>();
  double twice = inertia.platform_kg * velocityAt(state.twist, body.centre).squaredNorm() +
                 turn.dot(body.inertia * turn);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const PlatformRates::Leg& leg = rates.legs[i];
    const Point3 elbow = rates.cranks[static_cast<Eigen::Index>(i)] * leg.tangent;
    const Point3 ball = velocityAt(state.twist, leg.arm);
    twice += inertia.crank_kg / 3.0 * elbow.squaredNorm() +
             inertia.coupler_kg / 3.0 * (elbow.squaredNorm() + elbow.dot(ball) + ball.squaredNorm());
  }
  return 0.5 * twice;
}

double potentialEnergy(const MetricPlatform& metric, const PlatformState& state,
                       const PlatformInertia& inertia) {
  Point3 moment = inertia.platform_kg * (state.pose * (kMetres * inertia.centre_mm));
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = metric.platform.legs[i];
    const Point3 elbow = leg.elbow(state.cranks[static_cast<Eigen::Index>(i)]);
    moment += 0.5 * inertia.crank_kg * (leg.motor + elbow) +
              0.5 * inertia.coupler_kg * (elbow + state.pose * leg.ball);
  }
  return -inertia.gravity.dot(moment);
}

}  // namespace lamina
