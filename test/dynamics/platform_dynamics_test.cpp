// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/dynamics/platform_dynamics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Cholesky>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kStep = 1e-5;  // of differences

/// A Hunt platform anywhere near its home, moving and accelerating, its centre of mass off its middle.
struct MovingPlatform {
  explicit MovingPlatform(std::uint64_t seed) : metric(inMetres(huntPlatform())) {
    Random random(seed);
    inertia.centre_mm = Point3(3, -5, -12);
    cranks = crankAngles(huntPlatform(), huntPlatform().home);
    for (double& crank : cranks) crank += random.uniform(-0.25, 0.25);
    for (double& rate : rates) rate = random.uniform(-2.0, 2.0);
    for (double& acceleration : accelerations) acceleration = random.uniform(-20.0, 20.0);
  }

  PlatformState stateOf(const CrankAngles& at, const CrankAngles& moving) const {
    PlatformState state;
    state.pose = poseFromHome(metric.platform, at);
    state.cranks = at;
    state.twist = ratesOf(metric, state).twist_from_rates * moving;
    return state;
  }
  PlatformTerms terms(const CrankAngles& at, const CrankAngles& moving) const {
    const PlatformState state = stateOf(at, moving);
    return termsOf(state, ratesOf(metric, state), inertia);
  }
  double kinetic(const CrankAngles& at, const CrankAngles& moving) const {
    const PlatformState state = stateOf(at, moving);
    return kineticEnergy(state, ratesOf(metric, state), inertia);
  }
  double potential(const CrankAngles& at) const {
    return potentialEnergy(metric, stateOf(at, CrankAngles::Zero()), inertia);
  }

  MetricPlatform metric;
  PlatformInertia inertia;
  CrankAngles cranks = CrankAngles::Zero();
  CrankAngles rates = CrankAngles::Zero();
  CrankAngles accelerations = CrankAngles::Zero();
};

/// Central differences over each crank.
template <class Energy>
CrankAngles gradient(const Energy& energy, const CrankAngles& at) {
  CrankAngles slopes;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const CrankAngles step = kStep * CrankAngles::Unit(i);
    slopes[i] = (energy(at + step) - energy(at - step)) / (2.0 * kStep);
  }
  return slopes;
}

TEST(PlatformDynamics, MassMatrixIsSymmetricPositiveDefiniteAndHoldsTheKineticEnergy) {
  EXPECT_TRUE(rc::check("as summed over the bodies", [](std::uint64_t seed) {
    const MovingPlatform moving(seed);
    const Matrix6 mass = moving.terms(moving.cranks, moving.rates).mass;
    RC_ASSERT((mass - mass.transpose()).norm() < 1e-15);
    RC_ASSERT(mass.llt().info() == Eigen::Success);
    const double expected = moving.kinetic(moving.cranks, moving.rates);
    RC_ASSERT(std::abs(0.5 * moving.rates.dot(mass * moving.rates) - expected) < 1e-12);
  }));
}

TEST(PlatformDynamics, GravityIsTheGradientOfThePotentialEnergy) {
  EXPECT_TRUE(rc::check("by differences", [](std::uint64_t seed) {
    const MovingPlatform moving(seed);
    const CrankAngles slopes =
        gradient([&](const CrankAngles& at) { return moving.potential(at); }, moving.cranks);
    RC_ASSERT((slopes - moving.terms(moving.cranks, moving.rates).gravity).norm() < 1e-7);
  }));
}

TEST(PlatformDynamics, TorquesAreThoseOfLagrange) {
  EXPECT_TRUE(
      rc::check("d/dt dT/dq' - dT/dq + dU/dq, by differences of the energies", [](std::uint64_t seed) {
        const MovingPlatform moving(seed);
        const auto momentum = [&](double time) {
          const CrankAngles at = moving.cranks + time * moving.rates;
          const CrankAngles rates = moving.rates + time * moving.accelerations;
          return CrankAngles(moving.terms(at, rates).mass * rates);
        };
        const CrankAngles expected =
            (momentum(kStep) - momentum(-kStep)) / (2.0 * kStep) -
            gradient([&](const CrankAngles& at) { return moving.kinetic(at, moving.rates); }, moving.cranks) +
            gradient([&](const CrankAngles& at) { return moving.potential(at); }, moving.cranks);
        const PlatformTerms terms = moving.terms(moving.cranks, moving.rates);
        RC_ASSERT((torquesFor(terms, moving.accelerations) - expected).norm() < 1e-6);
      }));
}

TEST(PlatformDynamics, ForwardAnswersInverse) {
  EXPECT_TRUE(rc::check("accelerations come back, friction and all", [](std::uint64_t seed) {
    MovingPlatform moving(seed);
    moving.inertia.viscous_friction = 0.3;
    const PlatformTerms terms = moving.terms(moving.cranks, moving.rates);
    RC_ASSERT((terms.friction - 0.3 * moving.rates).norm() < 1e-12);
    const CrankAngles back = accelerationsFrom(terms, torquesFor(terms, moving.accelerations));
    RC_ASSERT((back - moving.accelerations).norm() < 1e-9);
  }));
}

TEST(PlatformDynamics, PowerOfTheMotorsIsTheChangeOfEnergy) {
  EXPECT_TRUE(rc::check("without friction", [](std::uint64_t seed) {
    const MovingPlatform moving(seed);
    const auto energy = [&](double time) {
      const CrankAngles at = moving.cranks + time * moving.rates + 0.5 * time * time * moving.accelerations;
      return moving.kinetic(at, moving.rates + time * moving.accelerations) + moving.potential(at);
    };
    const PlatformTerms terms = moving.terms(moving.cranks, moving.rates);
    const double power = moving.rates.dot(torquesFor(terms, moving.accelerations));
    RC_ASSERT(std::abs((energy(kStep) - energy(-kStep)) / (2.0 * kStep) - power) < 1e-6);
  }));
}

/// Weak: the layout is guessed, so only the order of magnitude can agree with 3.7 (N m)², the
/// energy over the time of [Guacheta2021, tables 5-4 to 5-11].
TEST(PlatformDynamics, HoldingAtHomeTakesTorquesOfThePublishedOrder) {
  const MovingPlatform moving(1);
  const PlatformState state =
      moving.stateOf(crankAngles(huntPlatform(), huntPlatform().home), CrankAngles::Zero());
  const double squares = termsOf(state, ratesOf(moving.metric, state), {}).gravity.squaredNorm();
  EXPECT_GT(squares, 1.5);
  EXPECT_LT(squares, 5.0);
}

}  // namespace
}  // namespace lamina
