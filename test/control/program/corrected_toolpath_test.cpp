// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/corrected_toolpath.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/program/rapid/reader/rapid_reader.hpp"
#include "lamina/program/rapid/writer/rapid_writer.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// A map of the first bead of a layer of `stackedBeads`, 40 mm long.
CorrectionMap firstBeadMap(const Toolpath& part, std::size_t layer, std::vector<PointCorrection> stations) {
  const double spacing_mm = 40.0 / static_cast<double>(stations.size());
  return {toolpathId(part), layer, 1, {{layer == 0 ? 0U : 1U, spacing_mm, std::move(stations)}}};
}

double timeOf(const Path& path) {
  double time_s = 0.0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    time_s += (path.points[end] - path.points[m]).norm() / path.feed_mm_s.at(end);
  }
  return time_s;
}

std::vector<PointCorrection> waveOf(double amount, double dz_mm) {
  std::vector<PointCorrection> stations;
  for (int i = 0; i < 80; ++i)
    stations.push_back({amount * std::sin(0.3 * i), 0.0, dz_mm * std::sin(0.2 * i)});
  return stations;
}

double meanOfStations(const std::vector<PointCorrection>& stations) {
  double sum = 0.0;
  for (const PointCorrection& place : stations) sum += place.amount;
  return sum / static_cast<double>(stations.size());
}

TEST(CorrectedToolpath, GivesEachMillimetreTheTimeOfItsAmount) {
  const Toolpath part = test::stackedBeads(3);
  const std::vector<PointCorrection> wave = waveOf(0.3, 0.0);
  const Toolpath corrected = correctedToolpath(part, {firstBeadMap(part, 1, wave)}, 0.02);
  // 40 mm at 10 mm/s take 4 s; amounts are linear between the middles of equal pieces.
  EXPECT_NEAR(timeOf(corrected.layers[1].paths[1]), 4.0 * (1.0 + meanOfStations(wave)), 1e-9);
  EXPECT_NEAR(timeOf(corrected.layers[1].paths[3]), 4.0, 1e-12) << "the other bead";
  const Path& bead = corrected.layers[1].paths[1];
  EXPECT_GT(bead.points.size(), 30U);
  for (std::size_t i = 1; i < bead.points.size(); ++i) {
    EXPECT_GE(bead.feed_mm_s.at(i), 10.0 / 1.3 - 1e-9);
    EXPECT_LE(bead.feed_mm_s.at(i), 10.0 / 0.7 + 1e-9);
    EXPECT_EQ(bead.bead.at(i), part.layers[1].paths[1].bead.at(0));
  }
}

/// A wall that is to be a quarter thicker where a led feeder goes a fifth slower at its usual rate: a steady
/// feeder goes a fifth slower too, and not slower by both.
TEST(CorrectedToolpath, TakesTheAmountOnceWhereTheMapHasSpeeds) {
  const Toolpath part = test::stackedBeads(2);
  const Toolpath corrected = correctedToolpath(part, {firstBeadMap(part, 1, {{0.25, -0.2, 0.0}})}, 0.02);
  EXPECT_NEAR(timeOf(corrected.layers[1].paths[1]), 4.0 * 1.25, 1e-9);
  for (std::size_t i = 1; i < corrected.layers[1].paths[1].points.size(); ++i)
    EXPECT_NEAR(corrected.layers[1].paths[1].feed_mm_s.at(i), 8.0, 1e-9);
}

TEST(CorrectedToolpath, WithoutCorrectionIsTheSame) {
  const Toolpath part = test::stackedBeads(2);
  EXPECT_EQ(toolpathId(correctedToolpath(part, {}, 0.02)), toolpathId(part));
  EXPECT_EQ(toolpathId(correctedToolpath(part, {firstBeadMap(part, 1, {{}, {}})}, 0.02)), toolpathId(part));
}

TEST(CorrectedToolpath, MovesBackAlongTheToolAxis) {
  Toolpath part = test::stackedBeads(2);
  const Eigen::Quaterniond tilted =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX())) * nozzleDown();
  for (ToolpathLayer& layer : part.layers)
    for (Path& path : layer.paths) path.orientation = tilted;
  const Toolpath corrected = correctedToolpath(part, {firstBeadMap(part, 1, {{0.0, 0.0, 0.4}})}, 0.02);
  const Path& bead = corrected.layers[1].paths[1];
  // A nozzle that points down and is turned about x by 0.5 rad: back is up and towards -y.
  const Point3 shift(0.0, -0.4 * std::sin(0.5), 0.4 * std::cos(0.5));
  for (const Point3& point : bead.points)
    EXPECT_NEAR((point - Point3(point.x(), 0, 3.0) - shift).norm(), 0.0, 1e-12);
  EXPECT_EQ(corrected.layers[1].paths[0].points.back(), bead.points.front()) << "the travel leads there";
  EXPECT_EQ(corrected.layers[1].paths[2].points.front(), bead.points.back()) << "and away";
  EXPECT_NO_THROW(validate(corrected));
}

TEST(CorrectedToolpath, AClosedPathEndsWhereItBegan) {
  Path ring;
  ring.role = PathRole::OuterWall;
  ring.is_closed = true;
  ring.bead = Bead{3.0, 1.5};
  ring.feed_mm_s = 10.0;
  ring.points = {{0, 0, 1.5}, {20, 0, 1.5}, {20, 20, 1.5}, {0, 20, 1.5}};
  const Toolpath part{"ring", {{1.5, 1.5, {ring}}}};
  const Toolpath corrected =
      correctedToolpath(part, {{toolpathId(part), 0, 1, {{0, 80.0, {{0.25, 0.0, 0.0}}}}}}, 0.02);
  const Path& path = corrected.layers[0].paths[0];
  EXPECT_FALSE(path.is_closed);
  EXPECT_EQ(path.points.size(), 5U);
  EXPECT_EQ(path.points.back(), path.points.front());
  EXPECT_NEAR(timeOf(path), 8.0 * 1.25, 1e-12);
}

TEST(CorrectedToolpath, ReadsBackFromRapidToTheSameFigures) {
  const Toolpath part = test::stackedBeads(3);
  const Toolpath corrected = correctedToolpath(
      part, {firstBeadMap(part, 1, waveOf(0.3, 0.5)), firstBeadMap(part, 2, waveOf(-0.2, 1.0))}, 0.02);
  std::string text;
  writeRapid(corrected, Eigen::Isometry3d::Identity(), {}, [&](std::string_view piece) { text += piece; });
  const Toolpath read = readRapid({{"corrected.mod", text}}, "beads");
  requireSamePaths(read, corrected, 1e-4);  // RAPID has four decimals
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t p = 0; p < corrected.layers[k].paths.size(); ++p)
      EXPECT_NEAR(timeOf(read.layers[k].paths[p]), timeOf(corrected.layers[k].paths[p]), 1e-3)
          << k << ", " << p;
}

TEST(CorrectedToolpath, IsOfAProgramWithWaypointsOnTheWay) {
  const Toolpath part = test::stackedBeads(2);
  Toolpath divided = part;
  std::vector<Point3>& points = divided.layers[1].paths[1].points;
  const Point3 middle = 0.5 * (points[0] + points[1]);
  points.insert(points.begin() + 1, middle);
  EXPECT_NO_THROW(requireSamePaths(divided, part, 1e-3));
  EXPECT_THROW(requireSamePaths(part, divided, 1e-3), InvalidInput) << "fewer";
  points[1].y() += 0.01;
  EXPECT_THROW(requireSamePaths(divided, part, 1e-3), InvalidInput) << "beside the way";
  points[1] = middle;
  points.back() = middle;
  EXPECT_THROW(requireSamePaths(divided, part, 1e-3), InvalidInput) << "not to the end";
}

TEST(CorrectedToolpath, KeepsWaitsBeforeAndBehindABead) {
  Toolpath part = test::stackedBeads(2);
  part.layers[1].paths[1].events = {{0, Dwell{1.0}}, {part.layers[1].paths[1].motionCount(), Dwell{2.0}}};
  const Toolpath corrected = correctedToolpath(part, {firstBeadMap(part, 1, waveOf(0.3, 0.0))}, 0.02);
  const Path& bead = corrected.layers[1].paths[1];
  ASSERT_GT(bead.motionCount(), part.layers[1].paths[1].motionCount());
  ASSERT_EQ(bead.events.size(), 2U);
  EXPECT_EQ(bead.events[0].motion, 0U);
  EXPECT_EQ(bead.events[1].motion, bead.motionCount());
  EXPECT_EQ(std::get<Dwell>(bead.events[1].event).duration_s, 2.0);
  EXPECT_NO_THROW(validate(corrected));
}

TEST(CorrectedToolpath, RefusesWhatItCannotLay) {
  const Toolpath part = test::stackedBeads(2);
  CorrectionMap other = firstBeadMap(part, 1, {{0.1, 0.0, 0.0}});
  other.toolpath_id = "other";
  EXPECT_THROW(correctedToolpath(part, {other}, 0.02), InvalidInput);
  EXPECT_THROW(correctedToolpath(part, {firstBeadMap(part, 1, {{0.0, 0.0, 1.6}})}, 0.02), InvalidInput);
  EXPECT_THROW(correctedToolpath(part, {}, 0.0), InvalidInput);
  Toolpath with_dwell = part;
  Path& amid = with_dwell.layers[1].paths[1];
  amid.points.insert(amid.points.begin() + 1, 0.5 * (amid.points[0] + amid.points[1]));
  amid.events = {{1, Dwell{1.0}}};
  EXPECT_THROW(correctedToolpath(with_dwell, {firstBeadMap(with_dwell, 1, {{0.1, 0.0, 0.0}})}, 0.02),
               InvalidInput);
  Toolpath joined = part;
  Path next = joined.layers[1].paths[1];
  next.points = {next.lastPoint(), next.lastPoint() + Point3(0, 1, 0)};
  joined.layers[1].paths.insert(joined.layers[1].paths.begin() + 2, next);
  EXPECT_THROW(correctedToolpath(joined, {firstBeadMap(joined, 1, {{0.0, 0.0, 0.4}})}, 0.02), InvalidInput)
      << "no travel between two heights";
  Toolpath moved = part;
  moved.layers[1].paths[1].points[1].y() += 0.01;
  EXPECT_THROW(requireSamePaths(moved, part, 1e-3), InvalidInput);
  EXPECT_THROW(requireSamePaths(test::stackedBeads(3), part, 1e-3), InvalidInput);
}

}  // namespace
}  // namespace lamina
