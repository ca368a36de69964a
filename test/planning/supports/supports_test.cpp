// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Lattices that hold up what hangs over.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/overhang_areas.hpp"
#include "planning/supports/support_areas.hpp"
#include "support/supported_parts.hpp"

namespace lamina {
namespace {

using test::archOverSphere;
using test::kLayerHeight;
using test::rectangle;
using test::tee;

constexpr double kSideGap = 0.6;   // mm
constexpr double kLedgeGap = 0.2;  // mm: below walls that hang within the other

PlanSettings withSupports(double angle_deg = 45.0) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.supports.use = true;
  settings.supports.angle_deg = angle_deg;
  return settings;
}

Plan plannedWith(const std::vector<Layer>& layers, const PlanSettings& settings) {
  NoProgress nobody;
  Plan plan = planPart("part", layers, settings, nobody);
  validate(plan.toolpath);
  return plan;
}

bool isSupport(const Path& path) {
  return path.role == PathRole::Support || path.role == PathRole::SupportInterface;
}

/// Calls visit(path, layer) for all that is deposited as support.
template <class Visit>
void forEachSupport(const Toolpath& toolpath, const Visit& visit) {
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (const Path& path : toolpath.layers[l].paths)
      if (isSupport(path)) visit(path, l);
}

double highestSupport(const Toolpath& toolpath) {
  double highest = 0.0;
  forEachSupport(toolpath,
                 [&](const Path& path, std::size_t) { highest = std::max(highest, path.firstPoint().z()); });
  return highest;
}

TEST(Supports, OfATeeAreItsWingsLessTheGapBesideTheStem) {
  const Plan plan = plannedWith(tee(), withSupports());
  EXPECT_NEAR(plan.supports.overhang_mm2, 1200.0, 1e-6);
  EXPECT_NEAR(plan.supports.area_mm2, 2 * (15 - kSideGap) * 40, 1e-6);
  EXPECT_NEAR(plan.supports.unsupported_mm2, 0.0, 1e-6);
  EXPECT_NEAR(highestSupport(plan.toolpath), 19.8, 1e-9);
}

TEST(Supports, OfATeeTakeTheVolumeOfTheirDensities) {
  const Plan plan = plannedWith(tee(), withSupports());
  double lattice = 0.0;  // along the lines only
  double across = 0.0;
  double all = 0.0;
  forEachSupport(plan.toolpath, [&](const Path& path, std::size_t) {
    all += depositedVolume(path);
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
      const double volume = way.norm() * crossSection(path.bead.at(path.motionEnd(m)));
      if (path.role == PathRole::Support && std::abs(way.y()) < 1e-9) lattice += volume;
      if (path.role == PathRole::SupportInterface && std::abs(way.x()) < 1e-9) across += volume;
    }
  });
  const double wanted = 1152.0 * (97 * kLayerHeight * 0.15 + 2 * kLayerHeight * 0.8);  // 3721 mm3
  EXPECT_NEAR(lattice + across, wanted, 0.03 * wanted);
  EXPECT_LE(all, 1.2 * wanted);
  EXPECT_NEAR(plan.supports.support_mm3 + plan.supports.interface_mm3, all, 1e-6 * all);
}

TEST(Supports, EndInInterfacesAcrossTheirLines) {
  const Plan plan = plannedWith(tee(), withSupports());
  for (std::size_t l = 0; l < plan.toolpath.layers.size(); ++l) {
    std::array<bool, 2> has{};
    for (const Path& path : plan.toolpath.layers[l].paths) {
      has[0] |= path.role == PathRole::Support;
      has[1] |= path.role == PathRole::SupportInterface;
    }
    EXPECT_EQ(has[0], l < 97) << l;
    EXPECT_EQ(has[1], l == 97 || l == 98) << l;
  }
}

/// From a place to the nearest centre line.
double distanceToLines(const std::vector<Path>& paths, const Point2& place) {
  double nearest = 1000.0;
  for (const Path& path : paths)
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point2 from = path.points[m].head<2>();
      const Point2 way = path.points[path.motionEnd(m)].head<2>() - from;
      const double along = std::clamp((place - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from + along * way - place).norm());
    }
  return nearest;
}

TEST(Supports, HaveInterfacesWithoutGapsUpToTheirRims) {
  const Plan plan = plannedWith(tee(), withSupports());
  const double half = 0.5 * test::kLayerPitch;
  for (const std::size_t l : {97, 98}) {
    std::vector<Path> interfaces;
    for (const Path& path : plan.toolpath.layers[l].paths)
      if (path.role == PathRole::SupportInterface) interfaces.push_back(path);
    // Columns reach from 5.6 to 20 mm beside the stem, and along all of it.
    for (double x = 5.6 + half; x <= 20.0 - half; x += 0.2)
      for (double y = -20.0 + half; y <= 20.0 - half; y += 0.2)
        for (const double side : {-1.0, 1.0})
          EXPECT_LE(distanceToLines(interfaces, {side * x, y}),
                    0.5 * std::hypot(2.0 * half / 0.8, 2.0 * half))
              << x << ' ' << y;
    // On a lattice a loop would hang from line to line; the lines across it end at the rim.
    for (double y = -20.0 + half; l == 98 && y <= 20.0 - half; y += 0.2)
      EXPECT_LE(distanceToLines(interfaces, {5.6 + half, y}), 1e-3) << "along the rim";
  }
}

TEST(Supports, ComeBeforeTheIslandsOfTheirLayer) {
  PlanSettings settings = withSupports();
  settings.feed.first_layer_mm_s = 1000.0;
  const Plan plan = plannedWith(tee(), settings);
  std::size_t supports_beside_islands = 0;
  for (const ToolpathLayer& layer : plan.toolpath.layers) {
    std::size_t supports = 0;
    bool has_island = false;
    for (const Path& path : layer.paths) {
      if (isSupport(path)) {
        ++supports;
        EXPECT_FALSE(has_island) << layer.z_mm;
        EXPECT_EQ(path.feed_mm_s.at(1), path.role == PathRole::Support ? 60.0 : 40.0);
      }
      has_island |= path.role == PathRole::OuterWall;
    }
    if (has_island) supports_beside_islands += supports;
  }
  EXPECT_GT(supports_beside_islands, 0U);
}

TEST(Supports, MeetTheGapExactly) {
  struct Case {
    double gap_mm;
    double last_height_mm;  // of the uppermost bead
  };
  // 100 layers of 0.2 mm stand below the slab. Less than half a layer is shared out with the one below.
  for (const Case& each : {Case{0.0, 0.2}, Case{0.2, 0.2}, Case{0.25, 0.15}, Case{0.3, 0.1},
                           Case{0.35, 0.125}, Case{0.39, 0.105}, Case{0.4, 0.2}}) {
    PlanSettings settings = withSupports();
    settings.supports.top_gap_mm = each.gap_mm;
    const Plan plan = plannedWith(tee(), settings);
    EXPECT_NEAR(highestSupport(plan.toolpath), 20.0 - each.gap_mm, 1e-9) << each.gap_mm;
    double height = 0.0;
    double sum = 0.0;  // of the beads on each other, at one place
    double below = 0.0;
    forEachSupport(plan.toolpath, [&](const Path& path, std::size_t) {
      const double z = path.firstPoint().z();
      EXPECT_GE(path.bead.at(0).height_mm, 0.5 * kLayerHeight - 1e-9);
      if (z > 20.0 - each.gap_mm - 1e-9) height = path.bead.at(0).height_mm;
      if (z > below + 1e-9) {
        EXPECT_NEAR(z - path.bead.at(0).height_mm, below, 1e-9) << "it lies on the one below";
        sum += path.bead.at(0).height_mm;
        below = z;
      }
    });
    EXPECT_NEAR(height, each.last_height_mm, 1e-9) << each.gap_mm;
    EXPECT_NEAR(sum, 20.0 - each.gap_mm, 1e-9);
  }
}

/// A cone that stands on its tip's stump of 5 mm.
std::vector<Layer> coneOf(double half_angle_deg) {
  const double step = kLayerHeight * std::tan(half_angle_deg * M_PI / 180.0);
  return test::layersOf(60, [step](int l) {
    return std::vector<Polygon>{test::circle({0, 0}, 5.0 + step * l, 180)};
  });
}

TEST(Supports, HoldUpWallsThatLeanMoreThanTheirAngle) {
  EXPECT_EQ(plannedWith(coneOf(44), withSupports()).supports.overhang_mm2, 0.0);
  const Plan plan = plannedWith(coneOf(46), withSupports());
  std::array<bool, 36> is_held{};
  forEachSupport(plan.toolpath, [&](const Path& path, std::size_t) {
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point3 from = path.points[m];
      const Point3 way = path.points[path.motionEnd(m)] - from;
      for (int i = 0; i <= 20; ++i) {
        const Point3 at = from + 0.05 * i * way;
        const double turn = std::atan2(at.y(), at.x()) / (2 * M_PI) + 0.5;
        is_held[static_cast<std::size_t>(turn * 36) % 36] = true;
      }
    }
  });
  for (std::size_t i = 0; i < is_held.size(); ++i) EXPECT_TRUE(is_held[i]) << 10 * i << " deg";
  const double rings = M_PI * (std::pow(5.0 + 59 * kLayerHeight * std::tan(46 * M_PI / 180), 2) - 25.0);
  EXPECT_NEAR(plan.supports.overhang_mm2, rings, 0.002 * rings);
}

/// How near the middle of a bead of supports comes to the upright axis of the sphere, beyond the greatest
/// radius of it below that bead; every 0.1 mm along the beads.
double clearanceOverSphere(const Toolpath& toolpath) {
  double least = 1000.0;
  forEachSupport(toolpath, [&](const Path& path, std::size_t l) {
    double widest = 0.0;
    for (std::size_t k = 0; k < l; ++k) widest = std::max(widest, test::sphereRadiusIn(k));
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point3 from = path.points[m];
      const Point3 way = path.points[path.motionEnd(m)] - from;
      const int steps = std::max(1, static_cast<int>(std::ceil(way.norm() / 0.1)));
      for (int i = 0; i <= steps; ++i)
        least = std::min(least, (from + i * way / steps).head<2>().norm() - widest);
    }
  });
  return least;
}

TEST(Supports, OnTheBedOnlyLeaveASphereUnderAnArchAlone) {
  PlanSettings settings = withSupports();
  EXPECT_LT(clearanceOverSphere(plannedWith(archOverSphere(), settings).toolpath), -7.0)
      << "they stand on it";
  settings.supports.foot = SupportFoot::Bed;
  const Plan plan = plannedWith(archOverSphere(), settings);
  // Columns stand beside the sphere, a gap and half a bead off; outlines of circles are simplified by 0.02
  // mm.
  EXPECT_GT(clearanceOverSphere(plan.toolpath), kSideGap + 0.5 * test::kLayerPitch - 0.02);
  // Beside the sphere columns stand, so what is reported to hang is its shadow: wider by the gap, and less
  // what columns reach, which is the gap and the tolerance of their outlines.
  const double below_sphere = plannedWith(archOverSphere(0.0), settings).supports.unsupported_mm2;
  const double shadow = M_PI * std::pow(test::kSphereRadius - 0.02, 2);
  EXPECT_NEAR(plan.supports.unsupported_mm2 - below_sphere, shadow, 0.01 * shadow);
}

TEST(Supports, StandAGapAboveThePart) {
  // A plate, a post on it and a roof: columns stand on the plate.
  const auto layers = test::layersOf(60, [](int l) {
    if (l < 10 || l >= 50) return std::vector<Polygon>{rectangle(-15, -15, 15, 15)};
    return std::vector<Polygon>{rectangle(-3, -3, 3, 3)};
  });
  for (const auto& [gap_mm, first] : {std::pair<double, std::size_t>{0.2, 11}, {0.0, 10}, {0.3, 12}}) {
    PlanSettings settings = withSupports();
    settings.supports.bottom_gap_mm = gap_mm;
    std::size_t lowest = layers.size();
    std::size_t interfaces = 0;
    std::size_t last = layers.size();
    forEachSupport(plannedWith(layers, settings).toolpath, [&](const Path& path, std::size_t l) {
      lowest = std::min(lowest, l);
      if (path.role == PathRole::SupportInterface && l != last) ++interfaces;
      if (path.role == PathRole::SupportInterface) last = l;
    });
    EXPECT_EQ(lowest, first) << gap_mm;
    EXPECT_EQ(interfaces, 4U) << "two on the plate, two below the roof";
  }
}

TEST(Supports, HoldAHangingPoint) {
  // A tip of 0.2 mm that hangs beside a wall and widens by 27 deg until it meets it.
  const auto layers = test::layersOf(100, [](int l) {
    std::vector<Polygon> contours{rectangle(-20, -5, -10, 5)};
    const double half = 0.1 + 0.1 * (l - 40);
    if (l >= 40) contours.push_back(rectangle(-half, -half, half, half));
    return contours;
  });
  const Plan plan = plannedWith(layers, withSupports());
  bool is_held = false;
  forEachSupport(plan.toolpath, [&](const Path& path, std::size_t l) {
    EXPECT_LT(l, 39U);
    for (const Point3& point : path.points) {
      EXPECT_LT(point.head<2>().norm(), 0.5);
      is_held |= l == 38;
    }
  });
  EXPECT_TRUE(is_held);
}

TEST(Supports, HoldAHangingEdge) {
  // An edge of 20 mm along y, 0.3 mm wide, that hangs beside a wall; its faces lean just less than the limit.
  const auto layers = test::layersOf(100, [](int l) {
    std::vector<Polygon> contours{rectangle(-40, -5, -30, 5)};
    const double half = 0.15 + 0.199 * (l - 40);
    if (l >= 40) contours.push_back(rectangle(-half, -10, half, 10));
    return contours;
  });
  const Plan plan = plannedWith(layers, withSupports());
  EXPECT_GE(plan.supports.overhang_mm2, 6.0);
  EXPECT_NEAR(plan.supports.unsupported_mm2, 0.0, 1e-6);
  forEachSupport(plan.toolpath, [&](const Path& path, std::size_t l) {
    EXPECT_LT(l, 39U);
    for (const Point3& point : path.points) EXPECT_LT(std::abs(point.x()), 0.5);
  });
  std::vector<Path> last;
  for (const Path& path : plan.toolpath.layers[38].paths)
    if (isSupport(path)) last.push_back(path);
  ASSERT_FALSE(last.empty());
  for (double y = -9.8; y <= 9.8; y += 0.2) EXPECT_LE(distanceToLines(last, {0.0, y}), 0.4) << y;
}

/// Of a stack of steps of eight layers: the last two layers below the gap reach ledges of the next step.
double gapBeside(std::size_t layer) { return layer % 8 == 5 || layer % 8 == 6 ? kLedgeGap : kSideGap; }

TEST(Supports, KeepTheirDistanceFromAnyPart) {
  ASSERT_TRUE(rc::check("supports keep the gap beside the part, and lie on support or bed", [] {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000)));
    std::vector<Polygon> outlines_of_steps;
    for (int step = 0; step < 4; ++step)
      outlines_of_steps.push_back(
          test::star(random, {random.uniform(-3, 3), random.uniform(-3, 3)}, 3, 12, 12));
    const auto layers = test::layersOf(
        32, [&](int l) { return std::vector<Polygon>{outlines_of_steps[static_cast<std::size_t>(l / 8)]}; });
    PlanSettings settings = withSupports();
    settings.supports.foot = random.uniform(0, 1) < 0.5 ? SupportFoot::Bed : SupportFoot::Everywhere;
    const Plan plan = plannedWith(layers, settings);
    forEachSupport(plan.toolpath, [&](const Path& path, std::size_t l) {
      const std::vector<Polygon> part = layers[l].section.contours;
      for (std::size_t m = 0; m < path.motionCount(); ++m)
        for (const double share : {0.0, 0.25, 0.5, 0.75}) {
          const Point3 at = path.points[m] + share * (path.points[path.motionEnd(m)] - path.points[m]);
          RC_ASSERT(!contains(part, at.head<2>()));
          RC_ASSERT(test::distanceToOutline(part, at.head<2>()) > gapBeside(l) + 0.15);
          if (settings.supports.foot != SupportFoot::Bed) continue;
          for (std::size_t below = 0; below < l; below += 4)
            RC_ASSERT(!contains(layers[below].section.contours, at.head<2>()));
        }
    });
  }));
}

TEST(Supports, DoNotDependOnThreads) {
  const Plan many = plannedWith(archOverSphere(), withSupports());
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(plannedWith(archOverSphere(), withSupports()).toolpath), toolpathId(many.toolpath));
}

TEST(Supports, AreNoneUnlessAskedFor) {
  PlanSettings settings = withSupports();
  settings.supports.use = false;
  EXPECT_EQ(plannedWith(tee(), settings).supports.overhang_mm2, 0.0);
  EXPECT_EQ(highestSupport(plannedWith(tee(), settings).toolpath), 0.0);
}

TEST(Supports, StandOutsideTheSkirtOfThePartAlone) {
  PlanSettings settings = withSupports();
  settings.skirt.count = 1;
  const Plan plan = plannedWith(tee(), settings);
  for (const Path& path : plan.toolpath.layers.front().paths) {
    if (path.role != PathRole::Skirt) continue;
    Box2 box;
    for (const Point3& point : path.points) box.include(point.head<2>());
    EXPECT_NEAR(box.high.x(), 20.0 + settings.skirt.distance_mm + 0.2, 1e-3) << "from the columns";
  }
}

/// The tee in layers of 45 deg about x, by their own x and height along the layer: its slab lies beyond 20
/// mm, its ends beyond 20 mm to both sides.
std::vector<Layer> inclinedTee() {
  std::vector<Layer> layers;
  const double root = std::sqrt(0.5);
  for (int i = 0; i < 229; ++i) {
    Layer layer{{-20 * root + kLayerHeight * i, -20 * root + kLayerHeight * (i + 1)}, {}};
    const double n = layer.bounds.cut();
    const auto lay = [&](double half_width, double from_z, double to_z) {
      const double low = std::max(from_z / root - n, n - 20 / root);
      const double high = std::min(to_z / root - n, n + 20 / root);
      if (high > low) layer.section.contours.push_back(rectangle(-half_width, low, half_width, high));
    };
    lay(5, 0, 20);
    lay(20, 20, 25);
    layers.push_back(layer);
  }
  return layers;
}

TEST(Supports, FallAlongGravityThroughInclinedLayers) {
  NoProgress nobody;
  const double root = std::sqrt(0.5);
  const StackedMaterial stack = stackedMaterial(inclinedTee(), 0.005, BedPlane{{0, root, root}, 0.0}, nobody);
  SupportSettings settings = withSupports(30.0).supports;
  const std::vector<Regions> overhangs = overhangAreas(stack, settings, nobody);
  const SupportAreas areas =
      supportAreas(stack, {overhangs, {0, stack.size()}}, settings, {0.4, 0.8}, nobody);
  // Amid the part each layer cuts the columns from the bed to the gap below the slab.
  for (const std::size_t l : {90U, 110U, 130U}) {
    double sum = 0.0;
    double lowest = 100.0;
    for (const SupportSection& section : areas.layers[l])
      for (const SharedRegions& regions : {section.lattice, section.interface}) {
        sum += area(*regions);
        for (const Region& region : *regions)
          for (const Point2& point : region.outer) lowest = std::min(lowest, point.y());
      }
    EXPECT_NEAR(sum, 2 * (15 - kSideGap) * (20 / root - kSideGap), 2.0) << l;
    EXPECT_NEAR(lowest, -stack.bounds[l].cut(), 1e-3) << "on the bed";
  }
}

/// The same elsewhere on the belt, in layers over a bed of 45 deg.
Plan inclinedTeeAt(const Point2& by) {
  std::vector<Layer> layers = inclinedTee();
  for (Layer& layer : layers)
    for (Polygon& contour : layer.section.contours)
      for (Point2& point : contour) point += by;
  const double root = std::sqrt(0.5);
  LayerIncline incline;
  incline.bed = {{0, root, root}, root * by.y()};
  PlanSettings settings = withSupports(30.0);
  settings.supports.raster_angle_deg = 30.0;
  NoProgress nobody;
  return planPart("part", layers, settings, incline, nobody);
}

/// Where the lines of a lattice lie across their direction, as shares of their distance: least and greatest.
std::pair<double, double> linePhases(const Toolpath& toolpath, const Point2& by) {
  const double spacing = planWidth({0.4, kLayerHeight}) / SupportSettings().density;
  const Point2 along(std::cos(M_PI / 6.0), std::sin(M_PI / 6.0));
  const Point2 across(-along.y(), along.x());
  std::pair<double, double> phases = {1.0, -1.0};
  forEachSupport(toolpath, [&](const Path& path, std::size_t) {
    if (path.role != PathRole::Support || path.is_closed) return;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Point2 way = (path.points[i] - path.points[i - 1]).head<2>();
      if (way.norm() < 2.0 || std::abs(way.normalized().dot(across)) > 1e-4) continue;
      const double place = across.dot(path.points[i].head<2>() - by) / spacing;
      phases.first = std::min(phases.first, place - std::round(place));
      phases.second = std::max(phases.second, place - std::round(place));
    }
  });
  return phases;
}

/// Stretches of a belt are looked at near the origin, one after the other.
TEST(Supports, AreTheSameFarOutOnABelt) {
  const Plan here = inclinedTeeAt(Point2::Zero());
  EXPECT_GT(here.supports.support_mm3, 1000.0);
  const auto [least, greatest] = linePhases(here.toolpath, Point2::Zero());
  EXPECT_NEAR(least, 0.0, 1e-3);
  EXPECT_NEAR(greatest, 0.0, 1e-3);
  // 12.5 m: some layers lie nearer to 12 m, others to 13 m.
  for (const Point2& by : {Point2(12000, 0), Point2(0, 12500), Point2(0, 30500)}) {
    const Plan there = inclinedTeeAt(by);
    EXPECT_NEAR(there.supports.overhang_mm2, here.supports.overhang_mm2, 1e-3) << by.transpose();
    EXPECT_NEAR(there.supports.unsupported_mm2, here.supports.unsupported_mm2, 1e-3) << by.transpose();
    EXPECT_NEAR(there.supports.area_mm2, here.supports.area_mm2, 1e-3) << by.transpose();
    EXPECT_NEAR(there.supports.support_mm3 / here.supports.support_mm3, 1.0, 0.01) << by.transpose();
    EXPECT_NEAR(there.supports.interface_mm3 / here.supports.interface_mm3, 1.0, 0.01) << by.transpose();
    // Lines go on from stretch to stretch as if nothing had been moved.
    const auto [low, high] = linePhases(there.toolpath, Point2::Zero());
    EXPECT_LT(high - low, 1e-3) << by.transpose();
    Box2 box;
    forEachSupport(there.toolpath, [&](const Path& path, std::size_t) {
      for (const Point3& point : path.points) box.include(point.head<2>() - by);
    });
    EXPECT_GT(box.low.x(), -20.1);
    EXPECT_LT(box.high.x(), 20.1);
  }
}

TEST(Supports, LeaveWhatBridgesSpan) {
  // A plank over a gap of 20 mm.
  const auto layers = test::layersOf(60, [](int l) {
    if (l >= 50) return std::vector<Polygon>{rectangle(-20, -10, 20, 10)};
    return std::vector<Polygon>{rectangle(-20, -10, -10, 10), rectangle(10, -10, 20, 10)};
  });
  PlanSettings settings = withSupports();
  EXPECT_NEAR(plannedWith(layers, settings).supports.overhang_mm2, 400.0, 1e-6);
  settings.bridges.is_used = true;
  EXPECT_EQ(plannedWith(layers, settings).supports.overhang_mm2, 0.0);
  settings.bridges.longest_mm = 15.0;
  EXPECT_NEAR(plannedWith(layers, settings).supports.overhang_mm2, 400.0, 1e-6) << "too long";
  settings.bridges.longest_mm = 25.0;
  EXPECT_EQ(plannedWith(layers, settings).supports.overhang_mm2, 0.0);
  settings.supports.under_bridges = true;
  EXPECT_NEAR(plannedWith(layers, settings).supports.overhang_mm2, 400.0, 1e-6);
  // The wings of a tee are held on one side only.
  settings.supports.under_bridges = false;
  EXPECT_NEAR(plannedWith(tee(), settings).supports.overhang_mm2, 1200.0, 1e-6);
}

TEST(OverhangAreas, ReachUpToTheWallTheyHangOn) {
  const Regions below = {{rectangle(-5, -20, 5, 20), {}}};
  const Regions layer = {{rectangle(-20, -20, 20, 20), {}}};
  EXPECT_NEAR(area(overhangOf(layer, below, 0.2)), 1200.0, 1e-6);
  EXPECT_TRUE(overhangOf({{rectangle(-5.1, -20, 5.1, 20), {}}}, below, 0.2).empty());
  EXPECT_NEAR(area(toHoldUp(layer, below)), 1200.0, 1e-6) << "not what is held otherwise";
}

}  // namespace
}  // namespace lamina
