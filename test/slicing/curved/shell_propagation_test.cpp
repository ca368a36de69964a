// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/curved/shell_propagation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/layer_volume.hpp"
#include "support/curved_parts.hpp"

namespace lamina {
namespace {

ShellLimits freeUpTo(double farthest) {
  ShellLimits limits;
  limits.farthest_mm = farthest;
  return limits;
}

/// A piece of a sphere around the origin, 45 degrees to all sides of the lowest place, facing its centre.
Mesh bowl(double radius, int cells = 48) {
  return test::gridSurface(cells, [radius](double u, double v) {
    return Point3(
        radius *
        Point3(std::tan((u - 0.5) * M_PI / 2.0), std::tan((v - 0.5) * M_PI / 2.0), -1.0).normalized());
  });
}

/// Half a pipe around the y axis, facing the axis.
Mesh gutter(double radius) {
  return test::gridSurface(64, [radius](double u, double v) {
    return Point3(-radius * std::cos(u * M_PI), 10.0 * v, -radius * std::sin(u * M_PI));
  });
}

void expectVertices(const LayerSurface& shell, const std::function<double(const Point3&)>& missedBy,
                    double tolerance) {
  ASSERT_FALSE(shell.middle.triangles.empty());
  for (const Triangle& triangle : shell.middle.triangles)
    for (const std::uint32_t corner : triangle)
      ASSERT_NEAR(missedBy(shell.middle.vertices[corner]), 0.0, tolerance);
}

TEST(ShellPropagation, OfABowlAreBowlsOfLesserRadius) {
  NoProgress progress;
  const ShellPropagation shells({bowl(10.0), {}}, 5.0, freeUpTo(12.0), progress);
  for (const double offset : {0.1, 3.0, 6.0, 9.0}) {
    const LayerSurface shell = shells.shell({offset, 0.2, NozzleSide::Ahead});
    expectVertices(
        shell, [offset](const Point3& p) { return p.norm() - (10.0 - offset); }, 0.05);
    for (const std::uint32_t corner : shell.middle.triangles.front())
      EXPECT_GT(shell.normal[corner].dot(-shell.middle.vertices[corner].normalized()), 0.98);
  }
  EXPECT_TRUE(shells.shell({10.5, 0.2, NozzleSide::Ahead}).middle.triangles.empty());
}

TEST(ShellPropagation, OfAGutterAreGuttersOfLesserRadius) {
  NoProgress progress;
  const ShellPropagation shells({gutter(8.0), {}}, 5.0, freeUpTo(10.0), progress);
  const auto layers = shells.shells(0.4, NozzleSide::Ahead, progress);
  ASSERT_EQ(layers.size(), 20U);
  for (std::size_t i = 0; i < 19; ++i) {
    const double radius = 8.0 - 0.4 * (static_cast<double>(i) + 0.5);
    expectVertices(
        layers[i], [radius](const Point3& p) { return std::hypot(p.x(), p.z()) - radius; }, 0.04);
    // Both rims run straight up from their last facets, which lean by half a segment.
    const double astray = 2.0 * (8.0 - radius) * std::sin(M_PI / 128.0);
    EXPECT_NEAR(volume(layers[i]), M_PI * radius * 10.0 * 0.4, (astray + 0.05) * 10.0 * 0.4);
  }
}

// Along a cone's surface the radius of curvature grows with the distance from the tip, so that a shell has
// collapsed near the tip and not farther on; the tip's own path is the axis.
TEST(ShellPropagation, OfAConeAreTheConeMovedAlongItsAxis) {
  NoProgress progress;
  const Mesh cone = test::gridSurface(48, [](double u, double v) {
    const double r = 1.0 + 9.0 * v;
    return Point3(-r * std::cos(u * M_PI), r * std::sin(u * M_PI), r);
  });
  const ShellPropagation shells({cone, {}}, 5.0, freeUpTo(4.0), progress);
  const double offset = 3.0;
  const LayerSurface shell = shells.shell({offset, 0.2, NozzleSide::Ahead});
  std::size_t close = 0;
  for (const Point3& p : shell.middle.vertices)
    if (std::abs(p.z() - std::hypot(p.x(), p.y()) - offset * std::sqrt(2.0)) < 0.05) ++close;
  EXPECT_GT(static_cast<double>(close), 0.95 * static_cast<double>(shell.middle.vertices.size()));
}

TEST(ShellPropagation, SeenFromBehindItIsTurnedOverAndTheTipIsOnTheOtherSide) {
  NoProgress progress;
  const ShellPropagation shells({bowl(10.0), {}}, 5.0, freeUpTo(12.0), progress);
  const LayerSurface ahead = shells.shell({2.0, 0.2, NozzleSide::Ahead});
  const LayerSurface behind = shells.shell({2.0, 0.2, NozzleSide::Behind});
  ASSERT_EQ(ahead.tip.size(), behind.tip.size());
  for (std::size_t i = 0; i < ahead.tip.size(); ++i) {
    EXPECT_NEAR(ahead.tip[i].norm(), 7.9, 0.01);
    EXPECT_NEAR(behind.tip[i].norm(), 8.1, 0.01);
    EXPECT_NEAR((ahead.normal[i] + behind.normal[i]).norm(), 0.0, 1e-12);
    EXPECT_NEAR(ahead.height_mm[i], 0.2, 1e-12);
  }
  EXPECT_EQ(behind.middle.triangles[0][1], ahead.middle.triangles[0][2]);
}

/// A level field with two round hollows of different radius, facing up.
Mesh hollows() {
  const auto depth = [](const Point3& at, double x, double radius, double deep) {
    const double r = std::hypot(at.x() - x, at.y());
    const double centre = radius - deep;
    const double rim = std::sqrt(radius * radius - centre * centre);
    return r < rim ? std::sqrt(radius * radius - r * r) - centre : 0.0;
  };
  return test::gridSurface(80, [&depth](double u, double v) {
    Point3 at(-12.0 + 24.0 * u, -8.0 + 16.0 * v, 0.0);
    at.z() = -depth(at, -6.0, 3.0, 1.5) - depth(at, 5.0, 6.0, 1.5);
    return at;
  });
}

TEST(ShellPropagation, NothingOfAShellIsNearerToItsSurfaceThanTheOffset) {
  NoProgress progress;
  const Mesh surface = hollows();
  const NearestTriangle nearest(surface);
  const ShellPropagation shells({surface, {}}, 5.0, freeUpTo(8.0), progress);
  EXPECT_TRUE(rc::check([&] {
    const double offset = *rc::gen::inRange(1, 80) / 10.0;
    const LayerSurface shell = shells.shell({offset, 0.2, NozzleSide::Ahead});
    RC_ASSERT(!shell.middle.triangles.empty());
    for (const Triangle& corner : shell.middle.triangles) {
      const Point3 middle = (shell.middle.vertices[corner[0]] + shell.middle.vertices[corner[1]] +
                             shell.middle.vertices[corner[2]]) /
                            3.0;
      RC_ASSERT(nearest.nearest(middle).distance_mm > 0.97 * offset - 0.1);
    }
  }));
}

TEST(ShellPropagation, EachHollowCollapsesAtItsOwnRadius) {
  NoProgress progress;
  const ShellPropagation shells({hollows(), {}}, 5.0, freeUpTo(8.0), progress);
  // The lowest place above a hollow's middle: on its own shell until the offset is its radius.
  const auto lowestAbove = [&shells](double x, double offset) {
    const LayerSurface shell = shells.shell({offset, 0.2, NozzleSide::Ahead});
    double lowest = 1e9;
    for (const Point3& p : shell.middle.vertices)
      if (std::hypot(p.x() - x, p.y()) < 0.5) lowest = std::min(lowest, p.z());
    return lowest;
  };
  EXPECT_NEAR(lowestAbove(-6.0, 2.5), 1.0, 0.05);
  EXPECT_NEAR(lowestAbove(5.0, 2.5), 1.0, 0.05);
  EXPECT_NEAR(lowestAbove(5.0, 5.0), 3.5, 0.1);
  EXPECT_GT(lowestAbove(-6.0, 5.0), 3.9);
}

TEST(ShellPropagation, EachPieceOfASurfaceEndsOnItsOwn) {
  NoProgress progress;
  Mesh two = bowl(5.0);
  const Mesh other = bowl(3.0);
  const auto first = static_cast<std::uint32_t>(two.vertices.size());
  for (const Point3& vertex : other.vertices) two.vertices.emplace_back(vertex + Point3(30.0, 0.0, 0.0));
  for (Triangle triangle : other.triangles) {
    for (std::uint32_t& corner : triangle) corner += first;
    two.triangles.push_back(triangle);
  }
  const ShellPropagation shells({two, {}}, 5.0, freeUpTo(8.0), progress);
  const auto ends = shells.ends(0.2);
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_NEAR(ends[0].offset_mm, 5.0, 0.2);
  EXPECT_NEAR(ends[1].offset_mm, 3.0, 0.2);
  EXPECT_GT(ends[1].where.x(), 20.0);
}

}  // namespace
}  // namespace lamina
