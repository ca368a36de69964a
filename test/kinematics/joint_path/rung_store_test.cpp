// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/rung_store.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kNoWay = std::numeric_limits<double>::infinity();

/// Two joints, five samples of three branches, of which some nodes do not exist; those hold zeros.
Rung rungWithGaps(Random& random) {
  Rung rung;
  rung.kind = SampleKind::Yaw;
  rung.samples = 5;
  rung.branches = 3;
  rung.joints = 2;
  for (std::size_t slot = 0; slot < 15; ++slot) {
    const bool is_there = random.below(3) != 0;
    rung.penalty.push_back(is_there ? random.uniform(0.0, 1.0) : kNoWay);
    for (int j = 0; j < 2; ++j) rung.values.push_back(is_there ? random.uniform(-3.0, 3.0) : 0.0);
  }
  return rung;
}

Station storedAt(double x_mm) {
  Station station;
  station.position = Point3(x_mm, 2.0, 3.0);
  return station;
}

TEST(RungStore, KeepsARungBitForBit) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    const Rung rung = rungWithGaps(random);
    const Rung kept = KeptRung(rung).rung();
    EXPECT_EQ(kept.kind, rung.kind);
    EXPECT_EQ(kept.samples, 5);
    EXPECT_EQ(kept.rows, 1);
    EXPECT_EQ(kept.branches, 3);
    EXPECT_EQ(kept.joints, 2);
    EXPECT_EQ(kept.penalty, rung.penalty);
    EXPECT_EQ(kept.values, rung.values);
  }
}

TEST(RungStore, FindsTheStationOfTheSamePoseAxesAndRedundancyOnly) {
  Random random(4);
  const Rung rung = rungWithGaps(random);
  RungStore store(100'000);
  EXPECT_FALSE(store.find(storedAt(1.0)));
  store.add(storedAt(1.0), KeptRung(rung));
  ASSERT_TRUE(store.find(storedAt(1.0)));
  EXPECT_EQ(store.find(storedAt(1.0))->values, rung.values);
  Station on_another_way = storedAt(1.0);
  on_another_way.motion.duration_s = 9.0;
  EXPECT_TRUE(store.find(on_another_way));
  EXPECT_FALSE(store.find(storedAt(1.0 + 1e-15)));
  Station turned = storedAt(1.0);
  turned.orientation = Eigen::Quaterniond::Identity();
  EXPECT_FALSE(store.find(turned));
  Station moved = storedAt(1.0);
  moved.external[2] = 0.1;
  EXPECT_FALSE(store.find(moved));
  Station bent = storedAt(1.0);
  bent.redundancy = 0.1;
  EXPECT_FALSE(store.find(bent));
}

TEST(RungStore, IsFullOnceARungDoesNotFit) {
  Random random(4);
  const KeptRung kept(rungWithGaps(random));
  RungStore store(2 * kept.bytes());
  store.add(storedAt(1.0), kept);
  store.add(storedAt(2.0), kept);
  EXPECT_TRUE(store.isFull());
  store.add(storedAt(3.0), kept);
  EXPECT_TRUE(store.find(storedAt(1.0)));
  EXPECT_TRUE(store.find(storedAt(2.0)));
  EXPECT_FALSE(store.find(storedAt(3.0)));
  EXPECT_TRUE(RungStore(0).isFull());
}

}  // namespace
}  // namespace lamina
