// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/chunk_correction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/control/layer_cells.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

constexpr double kRate = 250.0;  // Hz
constexpr double kSpeed = 10.0;  // mm/s
const Point3 kPlace(100.0, 120.0, 0.0);

DrivenToolpath driven() {
  const Toolpath part{"beads", {test::straightBeadLayer({0.0}, 40.0)}};
  return {"beads", part, Eigen::Isometry3d(Eigen::Translation3d(kPlace))};
}

/// The amount rises by 0.01 per mm, the height is the same all along.
CorrectionMap risingMap(double dz_mm) {
  const LayerCells cells = layerCells(driven().toolpath.layers[0], 0, 0.5);
  CellCorrections corrections;
  for (const double along : cells.along_mm) corrections.amount.push_back(0.01 * along);
  corrections.dz_mm.assign(cells.size(), dz_mm);
  return correctionMap(cells, corrections, "beads", 1);
}

/// Along the bead at constant speed, from one time to another.
TrajectoryChunk chunkOf(double from_s, double to_s, const KinematicModel& model) {
  TrajectoryChunk chunk;
  for (double time = from_s; time < to_s + 1e-9; time += 1.0 / kRate) {
    JointState state;
    state.time_s = time;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(M_PI, Point3::UnitX()).toRotationMatrix();
    pose.translation() = kPlace + Point3(kSpeed * time, 0.0, 1.5);
    state.position = model.solutions(pose, JointValues::Zero(3)).front().values;
    state.velocity = JointValues::Zero(3);
    state.acceleration = JointValues::Zero(3);
    state.process.flow_mm3_s = 45.0;
    state.process.levels[ProcessLevel::WireSpeed] = 12.0;
    state.process.levels[ProcessLevel::LaserPower] = 900.0;
    state.heading_for = {0, 0, 1};
    chunk.points.push_back(state);
  }
  return chunk;
}

double tipZ(const JointState& state, const KinematicModel& model) {
  return model.bedFromNozzle(state.position).translation().z();
}

class CorrectedChunks : public testing::Test {
 protected:
  std::unique_ptr<KinematicModel> model = kinematicModelByName("cartesian_gantry");
  ChunkCorrection correction{driven(), LoopSettings(), *model};
};

TEST_F(CorrectedChunks, WithoutMapsAreTheSame) {
  const TrajectoryChunk chunk = chunkOf(0.0, 0.2, *model);
  const TrajectoryChunk corrected = correction.corrected(chunk);
  for (std::size_t i = 0; i < chunk.points.size(); ++i) {
    EXPECT_EQ(corrected.points[i].position, chunk.points[i].position);
    EXPECT_EQ(corrected.points[i].process, chunk.points[i].process);
  }
}

TEST_F(CorrectedChunks, HaveTheFlowOfTheirPlaces) {
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  for (const JointState& point : correction.corrected(chunkOf(1.0, 1.2, *model)).points) {
    EXPECT_NEAR(point.process.flow_mm3_s, 45.0 * (1.0 + 0.01 * kSpeed * point.time_s), 1e-6);
    EXPECT_NEAR(point.process.levels[ProcessLevel::WireSpeed], 12.0 * (1.0 + 0.01 * kSpeed * point.time_s),
                1e-6);
    EXPECT_EQ(point.process.levels[ProcessLevel::LaserPower], 900.0);
  }
}

TEST_F(CorrectedChunks, GoOverToTheirHeightWithoutAJump) {
  const TrajectoryChunk before = correction.corrected(chunkOf(0.0, 0.2, *model));
  EXPECT_NEAR(tipZ(before.points.back(), *model), 1.5, 1e-9);
  EXPECT_EQ(correction.hear(risingMap(0.3), "digest"), "");
  const TrajectoryChunk first = correction.corrected(chunkOf(0.2, 0.4, *model));
  const TrajectoryChunk second = correction.corrected(chunkOf(0.4, 0.6, *model));
  EXPECT_NEAR(tipZ(first.points.front(), *model), 1.5, 1e-9) << "where it joins what was handed over";
  // 0.3 mm at 5 mm/s take 60 ms.
  for (const JointState& point : first.points)
    EXPECT_NEAR(tipZ(point, *model), 1.5 + std::min(0.3, 5.0 * (point.time_s - 0.2)), 1e-6);
  EXPECT_NEAR(first.points[5].velocity.norm(), ChunkCorrection::kHeightSpeed, 1e-6) << "on the way up";
  EXPECT_NEAR(second.points.front().velocity.norm(), 0.0, 1e-6);
  EXPECT_NEAR(tipZ(second.points.front(), *model), tipZ(first.points.back(), *model), 1e-9);
}

/// A bead on the bed of an arm whose nozzle is tilted.
TrajectoryChunk tiltedChunk(const KinematicModel& arm, const Eigen::Matrix3d& bed_from_nozzle) {
  TrajectoryChunk chunk = chunkOf(0.0, 0.4, *kinematicModelByName("cartesian_gantry"));
  for (JointState& state : chunk.points) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = bed_from_nozzle;
    pose.translation() = kPlace + Point3(kSpeed * state.time_s, 0.0, 1.5);
    const JointValues near =
        &state == &chunk.points.front() ? JointValues(JointValues::Zero(6)) : (&state - 1)->position;
    const InverseSolutions ways = arm.solutions(pose, near);
    state.position = ways.front().values;
    state.velocity = state.acceleration = JointValues::Zero(6);
  }
  return chunk;
}

TEST(CorrectedArmChunks, GoBackAlongTheToolAxisExactly) {
  const auto arm = kinematicModelByName("irb_4600");
  const Eigen::Matrix3d tilted =
      (Eigen::AngleAxisd(0.3, Point3::UnitX()) * Eigen::AngleAxisd(M_PI, Point3::UnitX())).toRotationMatrix();
  ChunkCorrection correction(driven(), LoopSettings(), *arm);
  EXPECT_EQ(correction.hear(risingMap(1.2), "digest"), "");
  const TrajectoryChunk planned = tiltedChunk(*arm, tilted);
  const TrajectoryChunk corrected = correction.corrected(planned);
  EXPECT_EQ(correction.takeRefusal(), "");
  for (std::size_t i = 0; i < planned.points.size(); ++i) {
    const Eigen::Isometry3d before = arm->bedFromNozzle(planned.points[i].position);
    const Eigen::Isometry3d after = arm->bedFromNozzle(corrected.points[i].position);
    const double height = std::min(1.2, 5.0 * planned.points[i].time_s);
    // Down, turned about x by 0.3 rad: back is up, and towards -y.
    const Point3 back(0.0, -std::sin(0.3), std::cos(0.3));
    EXPECT_LT((after.translation() - before.translation() - height * back).norm(), 1e-6) << i;
    EXPECT_LT((after.linear() - before.linear()).norm(), 1e-9) << i;
    EXPECT_LT((corrected.points[i].position - planned.points[i].position).cwiseAbs().maxCoeff(), 0.01) << i;
  }
}

TEST_F(CorrectedChunks, NameTheJointThatEndsAHeight) {
  EXPECT_EQ(correction.hear(risingMap(1.5), "digest"), "");
  TrajectoryChunk chunk = chunkOf(0.0, 0.4, *model);
  // The machine's highest is 1 mm above the bead.
  const auto z = static_cast<Eigen::Index>(2);
  const double highest = model->joints()[2].high;
  const double sense = [&] {
    JointValues up = chunk.points.front().position;
    up[z] += 1.0;
    return model->bedFromNozzle(up).translation().z() > 1.5 ? 1.0 : -1.0;
  }();
  const double end = sense > 0.0 ? highest : model->joints()[2].low;
  for (JointState& point : chunk.points) point.position[z] = end - sense;
  const TrajectoryChunk corrected = correction.corrected(chunk);
  const std::string refusal = correction.takeRefusal();
  EXPECT_NE(refusal.find("layer 0, path 0: the height stays at"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find(model->joints()[2].name + " would be at"), std::string::npos) << refusal;
  EXPECT_EQ(correction.takeRefusal(), "") << "reported once";
  EXPECT_NEAR(corrected.points.back().position[z], end, 5.0 / kRate + 1e-9);
  EXPECT_LE(sense * corrected.points.back().position[z], sense * end);
}

TEST_F(CorrectedChunks, DoNotTakeMapsThatCannotBeFollowed) {
  CorrectionMap other = risingMap(0.0);
  other.toolpath_id = "other";
  EXPECT_NE(correction.hear(other, "digest").find("of toolpath other; expected toolpath beads"),
            std::string::npos);
  CorrectionMap beyond = risingMap(0.0);
  beyond.layer = 1;
  EXPECT_NE(correction.hear(beyond, "digest").find("the toolpath has 1"), std::string::npos);
  EXPECT_NE(correction.hear(risingMap(1.6), "digest").find("moves the nozzle by 1.6"), std::string::npos);
  CorrectionMap fast = risingMap(0.0);
  fast.paths[0].stations[3].speed = 0.1;
  EXPECT_NE(correction.hear(fast, "digest").find("changes the speed by 0.1"), std::string::npos);
}

/// What was handed over before a map came is reported with the place up to which it was.
TEST_F(CorrectedChunks, TellFromWhereAMapHolds) {
  correction.corrected(chunkOf(0.0, 1.2, *model));
  EXPECT_TRUE(correction.takeLayers().empty()) << "its map may still come";
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].digest, "digest");
  EXPECT_EQ(reported[0].missed.layer, 0U);
  ASSERT_TRUE(reported[0].missed.held_from);
  EXPECT_EQ(reported[0].missed.held_from->path, 0U);
  EXPECT_NEAR(reported[0].missed.held_from->along_mm, 1.2 * kSpeed, 1e-6);
  EXPECT_EQ(correction.hear(risingMap(0.1), "later"), "");
  EXPECT_TRUE(correction.takeLayers().empty()) << "a trim of what is driven by a map";
  const std::string refusal = correction.hear(risingMap(1.6), "too much");
  const std::vector<DrivenLayer> stays = correction.takeLayers();
  ASSERT_EQ(stays.size(), 1U) << "that a trim is not used";
  EXPECT_EQ(stays[0].digest, "later");
  EXPECT_EQ(stays[0].missed.reason, refusal);
  ASSERT_TRUE(stays[0].missed.held_from);
  EXPECT_NEAR(stays[0].missed.held_from->along_mm, 1.2 * kSpeed, 1e-6);
}

TEST_F(CorrectedChunks, TellThatAMapHoldsFromTheBeginning) {
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].digest, "digest");
  EXPECT_FALSE(reported[0].missed.held_from);
}

TEST_F(CorrectedChunks, TellThatAMapIsNotTaken) {
  const std::string refusal = correction.hear(risingMap(1.6), "digest");
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].digest, "");
  EXPECT_EQ(reported[0].missed.reason, refusal);
  correction.hear(risingMap(1.6), "digest");
  EXPECT_TRUE(correction.takeLayers().empty()) << "once";
  EXPECT_EQ(correction.hear(risingMap(0.3), "better"), "");
  const std::vector<DrivenLayer> after = correction.takeLayers();
  ASSERT_EQ(after.size(), 1U) << "it is driven by a map after all";
  EXPECT_EQ(after[0].digest, "better");
  EXPECT_EQ(after[0].missed.reason, "");
}

TEST_F(CorrectedChunks, TellNothingOfLayersThatAreNotThere) {
  CorrectionMap beyond = risingMap(0.0);
  beyond.layer = 1;
  EXPECT_NE(correction.hear(beyond, "digest"), "");
  correction.giveUp(7, 2.0);
  EXPECT_TRUE(correction.takeLayers().empty());
}

double amountOf(const JointState& point) { return point.process.flow_mm3_s / 45.0 - 1.0; }

/// A quarter of the flow more at the end of the first layer, and no map of the second: half of it a second.
TEST(ChunkCorrection, FadesWhereALayerHasNoMap) {
  const auto model = kinematicModelByName("cartesian_gantry");
  DrivenToolpath two = driven();
  two.toolpath.layers.push_back(two.toolpath.layers.front());
  ChunkCorrection correction(two, LoopSettings(), *model);
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  EXPECT_NEAR(amountOf(correction.corrected(chunkOf(2.3, 2.5, *model)).points.back()), 0.25, 1e-9);
  TrajectoryChunk next = chunkOf(2.5, 3.5, *model);
  for (JointState& point : next.points) point.heading_for.layer = 1;
  for (const JointState& point : correction.corrected(next).points)
    EXPECT_NEAR(amountOf(point), std::max(0.0, 0.25 - 0.5 * (point.time_s - 2.5)), 1e-9) << point.time_s;
}

/// Of the second layer the first centimetre is support, which is as planned, and so is the bead behind it.
TEST(ChunkCorrection, LaysSupportAsPlannedWhereItFades) {
  const auto model = kinematicModelByName("cartesian_gantry");
  DrivenToolpath two = driven();
  two.toolpath.layers.push_back(two.toolpath.layers.front());
  const Path bead = two.toolpath.layers[1].paths[0];
  two.toolpath.layers[1].paths.push_back(bead);
  two.toolpath.layers[1].paths[0].role = PathRole::Support;
  ChunkCorrection correction(two, LoopSettings(), *model);
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  correction.corrected(chunkOf(2.3, 2.5, *model));
  TrajectoryChunk next = chunkOf(2.5, 3.5, *model);
  for (JointState& point : next.points) point.heading_for = {1, point.time_s < 2.6 ? 0U : 1U, 1};
  for (const JointState& point : correction.corrected(next).points)
    EXPECT_NEAR(amountOf(point), 0.0, 1e-12) << point.time_s;
}

/// Two seconds of the layer were handed over when its map comes, which asks for 0.2 there and 0.1 a second
/// more.
TEST_F(CorrectedChunks, GoOverToAMapThatComesLate) {
  EXPECT_NEAR(amountOf(correction.corrected(chunkOf(1.5, 2.0, *model)).points.back()), 0.0, 1e-12);
  EXPECT_EQ(correction.hear(risingMap(0.0), "digest"), "");
  const TrajectoryChunk first = correction.corrected(chunkOf(2.0, 2.4, *model));
  const TrajectoryChunk second = correction.corrected(chunkOf(2.4, 3.0, *model));
  for (const TrajectoryChunk& chunk : {first, second})
    for (const JointState& point : chunk.points)
      EXPECT_NEAR(amountOf(point), std::min(0.5 * (point.time_s - 2.0), 0.1 * point.time_s), 1e-9)
          << point.time_s;
}

/// 0.3 mm at 5 mm/s from 0.2 s on take until 0.26 s; a brake replaces what is queued from 0.252 s on.
TEST_F(CorrectedChunks, JoinWhatIsQueuedWhereTheyReplaceIt) {
  correction.corrected(chunkOf(0.0, 0.2, *model));
  EXPECT_EQ(correction.hear(risingMap(0.3), "digest"), "");
  const TrajectoryChunk rising = correction.corrected(chunkOf(0.2, 0.4, *model));
  correction.corrected(chunkOf(0.4, 0.6, *model));
  const TrajectoryChunk brake = correction.corrected(chunkOf(0.252, 0.452, *model));
  EXPECT_NEAR(tipZ(brake.points.front(), *model), 1.76, 1e-6);
  EXPECT_NEAR(tipZ(brake.points.front(), *model), tipZ(rising.points[13], *model), 1e-9);
  EXPECT_NEAR(amountOf(brake.points.front()), amountOf(rising.points[13]), 1e-9);
  for (const JointState& point : correction.corrected(chunkOf(0.452, 0.6, *model)).points)
    EXPECT_NEAR(tipZ(point, *model), 1.8, 1e-6);
}

/// A quarter more at the end of the first layer; of the second a coasting map of 0.1, by which it goes on
/// when it was waited for in vain, and after half a second its own of 0.2.
TEST(ChunkCorrection, TakesTheCoastingMapOfALayerThatIsWaitedForInVain) {
  const auto model = kinematicModelByName("cartesian_gantry");
  DrivenToolpath two = driven();
  two.toolpath.layers.push_back(two.toolpath.layers.front());
  ChunkCorrection correction(two, LoopSettings(), *model);
  const LayerCells cells = layerCells(two.toolpath.layers[1], 1, 0.5);
  const auto even = [&](double amount, std::uint64_t sequence) {
    return correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, "beads", sequence);
  };
  EXPECT_EQ(correction.hear(risingMap(0.0), "first"), "");
  EXPECT_EQ(correction.hear(even(0.1, 0), "coasting"), "");
  EXPECT_FALSE(correction.isKnown(1)) << "its own is waited for";
  correction.corrected(chunkOf(2.3, 2.5, *model));
  correction.takeLayers();
  correction.giveUp(1, 2.0);
  const std::vector<DrivenLayer> coasts = correction.takeLayers();
  ASSERT_EQ(coasts.size(), 1U);
  EXPECT_EQ(coasts[0].digest, "coasting");
  EXPECT_EQ(coasts[0].missed.reason, "");
  EXPECT_EQ(coasts[0].missed.waited_s, 2.0);
  const auto handOver = [&](double from_s, double to_s) {
    TrajectoryChunk chunk = chunkOf(from_s, to_s, *model);
    for (JointState& point : chunk.points) point.heading_for.layer = 1;
    return correction.corrected(chunk);
  };
  for (const JointState& point : handOver(2.5, 3.0).points)
    EXPECT_NEAR(amountOf(point), std::max(0.1, 0.25 - 0.5 * (point.time_s - 2.5)), 1e-9) << point.time_s;
  EXPECT_EQ(correction.hear(even(0.2, 1), "own"), "");
  const std::vector<DrivenLayer> own = correction.takeLayers();
  ASSERT_EQ(own.size(), 1U) << "no trim, but the map that was waited for";
  EXPECT_EQ(own[0].digest, "own");
  ASSERT_TRUE(own[0].missed.held_from);
  EXPECT_NEAR(own[0].missed.held_from->along_mm, 30.0, 1e-6);
  for (const JointState& point : handOver(3.0, 3.5).points)
    EXPECT_NEAR(amountOf(point), std::min(0.2, 0.1 + 0.5 * (point.time_s - 3.0)), 1e-9) << point.time_s;
}

/// Of two layers the first is handed over without a map, which then comes too late.
TEST(ChunkCorrection, ReportsThatALayerWasHandedOverWithoutItsMap) {
  const auto model = kinematicModelByName("cartesian_gantry");
  DrivenToolpath two = driven();
  two.toolpath.layers.push_back(two.toolpath.layers.front());
  ChunkCorrection correction(two, LoopSettings(), *model);
  TrajectoryChunk chunk = chunkOf(0.0, 0.2, *model);
  correction.corrected(chunk);
  for (JointState& point : chunk.points) point.heading_for.layer = 1;
  correction.corrected(chunk);
  const std::vector<DrivenLayer> reported = correction.takeLayers();
  ASSERT_EQ(reported.size(), 1U);
  EXPECT_EQ(reported[0].missed.layer, 0U);
  EXPECT_NE(reported[0].missed.reason.find("handed over"), std::string::npos) << reported[0].missed.reason;
  EXPECT_NE(correction.hear(risingMap(0.0), "digest").find("comes when layer 1 is on its way"),
            std::string::npos);
  EXPECT_TRUE(correction.takeLayers().empty()) << "once";
}

}  // namespace
}  // namespace lamina
