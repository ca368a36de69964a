// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/multi_direction/directed_pieces.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "support/grown_parts.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

/// Fewer directions and sequences, for speed.
DirectionRequest quickRequest() {
  DirectionRequest request;
  request.settings.count = 81;
  request.settings.beam = 3;
  return request;
}

DirectedPieces cutApart(const Mesh& mesh, const DirectionRequest& request = quickRequest()) {
  NoProgress progress;
  return directedPieces(mesh, pairHalfEdges(mesh), request, progress);
}

/// The T of `tShape`, 8 mm deep.
bool isInTShape(const Point3& place) {
  const bool is_deep = std::abs(place.y()) < 4.0;
  const bool is_in_stem = std::abs(place.x()) < 6.0 && place.z() > 0.0 && place.z() < 26.0;
  const bool is_in_bar = std::abs(place.x()) < 18.0 && place.z() > 20.0 && place.z() < 26.0;
  return is_deep && (is_in_stem || is_in_bar);
}

/// In how many layers a place is.
int timesPrinted(const DirectedPieces& found, const std::vector<std::vector<Layer>>& layers,
                 const Point3& place) {
  int times = 0;
  for (std::size_t piece = 0; piece < layers.size(); ++piece) {
    const Point3 own = found.pieces[piece].partFromPiece().conjugate() * place;
    for (const Layer& layer : layers[piece])
      if (own.z() >= layer.bounds.bottom_mm && own.z() < layer.bounds.top_mm &&
          contains(layer.section.contours, own.head<2>()))
        ++times;
  }
  return times;
}

std::vector<std::vector<Layer>> allLayers(const DirectedPieces& found, const Mesh& mesh) {
  NoProgress progress;
  std::vector<std::vector<Layer>> layers;
  for (std::size_t piece = 0; piece < found.pieces.size(); ++piece)
    layers.push_back(layersOf(found, piece, mesh, {}, progress));
  return layers;
}

TEST(DirectedPieces, OfABoxAreOne) {
  const DirectedPieces found = cutApart(test::boxBetween({-5, -4, 0}, {5, 4, 6}));
  ASSERT_EQ(found.pieces.size(), 1U);
  EXPECT_EQ(found.pieces[0].up, Point3(Point3::UnitZ()));
  EXPECT_EQ(found.pieces[0].from_mm, 0.0);
  EXPECT_EQ(found.pieces[0].to_mm, 6.0);
  EXPECT_EQ(found.unsupported_level_mm2, 0.0);
  EXPECT_EQ(found.cut_mm2, 0.0);
}

// What hangs of a T is the underside of its arms, 2 x 12 x 8 mm; a plane that leans by more than 45 deg
// leaves none.
TEST(DirectedPieces, OfATLeaveNothingUnsupported) {
  const DirectedPieces found = cutApart(test::tShape());
  EXPECT_NEAR(found.unsupported_level_mm2, 192.0, 1e-9);
  ASSERT_GE(found.pieces.size(), 2U);
  EXPECT_NEAR(found.unsupported(), 0.0, 1e-9);
  for (std::size_t piece = 1; piece < found.pieces.size(); ++piece) {
    EXPECT_NEAR(found.pieces[piece].up.norm(), 1.0, 1e-12);
    EXPECT_LT(found.pieces[piece].up.z(), std::cos(toRadians(45.0)));
    EXPECT_GT(found.pieces[piece].height(), 1.0);
  }
}

TEST(DirectedPieces, FillThePartOnce) {
  const Mesh part = test::tShape();
  const DirectedPieces found = cutApart(part);
  const std::vector<std::vector<Layer>> layers = allLayers(found, part);
  std::mt19937 random(20261128);
  std::uniform_real_distribution<double> x(-18.0, 18.0);
  std::uniform_real_distribution<double> y(-4.0, 4.0);
  std::uniform_real_distribution<double> z(0.0, 26.0);
  int inside = 0;
  int once = 0;
  int outside_printed = 0;
  for (int i = 0; i < 20000; ++i) {
    const Point3 place(x(random), y(random), z(random));
    const int times = timesPrinted(found, layers, place);
    if (!isInTShape(place)) {
      outside_printed += times > 0 ? 1 : 0;
      continue;
    }
    ++inside;
    once += times == 1 ? 1 : 0;
  }
  // Sections are taken half way up their layers, of 0.2 mm.
  EXPECT_GT(once, 0.98 * inside);
  EXPECT_LT(outside_printed, 0.01 * inside);
}

// What has been printed before a piece lies below its plane: the head works above it.
TEST(DirectedPieces, LieAboveAllThatIsPrintedBefore) {
  const Mesh part = test::tShape();
  const DirectedPieces found = cutApart(part);
  const std::vector<std::vector<Layer>> layers = allLayers(found, part);
  for (std::size_t before = 0; before < layers.size(); ++before)
    for (std::size_t piece = before + 1; piece < layers.size(); ++piece)
      for (const Layer& layer : layers[before])
        for (const Polygon& contour : layer.section.contours)
          for (const Point2& corner : contour) {
            const Point3 own(corner.x(), corner.y(), layer.bounds.cut());
            const Point3 place = found.pieces[before].partFromPiece() * own;
            EXPECT_LT(found.pieces[piece].up.dot(place), found.pieces[piece].from_mm + 1e-4);
          }
}

// A cylinder of radius r that begins 25 mm above the tip is in the bed by r sin(t) - 25 cos(t) at a tilt t.
TEST(DirectedPieces, LeaveTheHeadRoomOverTheBed) {
  DirectionRequest request = quickRequest();
  request.head = {{25.0, 80.0, 30.0}};
  const DirectedPieces found = cutApart(test::tShape(), request);
  ASSERT_GE(found.pieces.size(), 2U);
  const std::vector<std::vector<Layer>> layers = allLayers(found, test::tShape());
  for (std::size_t piece = 1; piece < layers.size(); ++piece) {
    const Point3& up = found.pieces[piece].up;
    const double least = 30.0 * up.head<2>().norm() - 25.0 * up.z();
    for (const Layer& layer : layers[piece])
      for (const Polygon& contour : layer.section.contours)
        for (const Point2& corner : contour) {
          const Point3 place =
              found.pieces[piece].partFromPiece() * Point3(corner.x(), corner.y(), layer.bounds.top_mm);
          EXPECT_GT(place.z(), least - found.cell_mm);
        }
  }
}

TEST(DirectedPieces, AreRefusedWithWhatStaysUnsupported) {
  DirectionRequest request = quickRequest();
  request.settings.max_tilt_deg = 0.0;
  const Mesh part = test::tShape();
  try {
    cutApart(part, request);
    FAIL() << "not refused";
  } catch (const Unsliceable& refusal) {
    EXPECT_NEAR(surfaceArea(refusal.region()), 192.0, 1e-9);
    EXPECT_NE(std::string(refusal.what()).find("192"), std::string::npos) << refusal.what();
  }
  request.settings.largest_unsupported_percent = 100.0;
  EXPECT_EQ(cutApart(part, request).pieces.size(), 1U);
}

std::string cutRefusal(const Mesh& mesh, const DirectionRequest& request) {
  try {
    cutApart(mesh, request);
  } catch (const Unsliceable& refusal) {
    return refusal.what();
  }
  return "not refused";
}

// The surface is 2 x 456 + 124 x 8 = 1904 mm², of which a cut has to free 0.5 %.
TEST(DirectedPieces, AreRefusedWithWhatACutWouldHaveToFree) {
  DirectionRequest request = quickRequest();
  request.settings.max_tilt_deg = 0.0;
  const std::string refusal = cutRefusal(test::tShape(), request);
  EXPECT_NE(refusal.find("across 1 a cut would free less than 9.52 mm²"), std::string::npos) << refusal;
}

// The rim of a head of radius 1000 mm, 5 mm above its tip, is lower than the tip of a head that leans, and by
// more than the part is high from a lean of 1.8 deg on.
TEST(DirectedPieces, AreRefusedWithTheRoomThatTheHeadNeeds) {
  DirectionRequest request = quickRequest();
  request.head = {{5.0, 80.0, 1000.0}};
  const std::string refusal = cutRefusal(test::tShape(), request);
  EXPECT_NE(refusal.find("the head would be in the bed"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("in a part 26 mm high"), std::string::npos) << refusal;
  const std::string before = "its tip has to stay ";
  ASSERT_NE(refusal.find(before), std::string::npos) << refusal;
  const double height = std::stod(refusal.substr(refusal.find(before) + before.size()));
  EXPECT_GT(height, 26.0);
  EXPECT_LT(height, 1000.0);
}

// Even the outline of the part, 12 x 26 + 24 x 6 = 456 mm², is less than a square of 4 beads of 6 mm.
TEST(DirectedPieces, AreRefusedWithTheBaseThatAPieceNeeds) {
  DirectionRequest request = quickRequest();
  request.bead_mm = 6.0;
  const std::string refusal = cutRefusal(test::tShape(), request);
  EXPECT_NE(refusal.find(" a piece would lie on less than 576 mm²"), std::string::npos) << refusal;
}

// A head as wide as the room leaves no plane.
TEST(DirectedPieces, AreNotCutWhereTheHeadWouldBeInTheBed) {
  DirectionRequest request = quickRequest();
  request.head = {{5.0, 80.0, 1000.0}};
  request.settings.largest_unsupported_percent = 100.0;
  EXPECT_EQ(cutApart(test::tShape(), request).pieces.size(), 1U);
}

TEST(DirectedPieces, AreTheSameForAnyNumberOfThreads) {
  const DirectedPieces by_all = cutApart(test::tShape());
  const ThreadLimit limit(1);
  const DirectedPieces by_one = cutApart(test::tShape());
  ASSERT_EQ(by_all.pieces.size(), by_one.pieces.size());
  for (std::size_t i = 0; i < by_all.pieces.size(); ++i) {
    EXPECT_EQ(by_all.pieces[i].up, by_one.pieces[i].up);
    EXPECT_EQ(by_all.pieces[i].from_mm, by_one.pieces[i].from_mm);
  }
}

TEST(DirectedPieces, NeedASolid) {
  Mesh open = test::boxBetween({0, 0, 0}, {5, 5, 5});
  open.triangles.pop_back();
  EXPECT_THROW(cutApart(open), InvalidMesh);
}

// Growth counts what is printed before: that of a place of a piece is above that of all before it.
TEST(DirectedPieces, KnowTheRoomOfTheHead) {
  DirectionRequest request = quickRequest();
  request.head = {{4.0, 60.0, 3.0}};
  const DirectedPieces found = cutApart(test::tShape(), request);
  const double all = found.growthBefore(found.pieces.size());
  const Point3 above_bar(0.0, 0.0, 27.0);
  const Point3 in_stem(0.0, 0.0, 5.0);
  EXPECT_TRUE(found.room->isClear(above_bar, Point3::UnitZ(), all));
  EXPECT_FALSE(found.room->isClear(in_stem, Point3::UnitZ(), all));
  EXPECT_TRUE(found.room->isClear(in_stem, Point3::UnitZ(), 5.0));
}

}  // namespace
}  // namespace lamina
