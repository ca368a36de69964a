// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "lamina/toolpath/scan_height.hpp"
#include "support/plain_job.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kRadians = M_PI / 180.0;
constexpr double kSamePoint = 1e-9;  // mm

/// Layers at that angle and heading, for a head that points straight down: every machine has a place for
/// them.
SliceJob upright(const std::string& part, double angle_deg, double heading_deg) {
  SliceJob job;
  job.part = part;
  job.settings.slicing.plane = {angle_deg, heading_deg, ToolAxis::Down};
  return job;
}

SlicedPart run(const SliceJob& job) {
  NoProgress nobody;
  return runSliceJob(job, nobody);
}

template <class Failure>
std::string failureOf(const SliceJob& job) {
  try {
    run(job);
    return "";
  } catch (const Failure& error) {
    return error.what();
  }
}

/// With all digits, which STL does not hold.
std::string objOf(const Mesh& mesh) {
  std::string text;
  char line[128];
  for (const Point3& vertex : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", vertex.x(), vertex.y(), vertex.z());
    text += line;
  }
  for (const Triangle& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %u %u %u\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

/// The rotation of [Garcia2024, eq. 4.1 to 4.3], written out for an axis of that heading.
Eigen::Matrix3d documentedRotation(double angle_deg, double heading_deg) {
  const double c = std::cos(angle_deg * kRadians);
  const double s = std::sin(angle_deg * kRadians);
  const double v = 1.0 - c;
  const double nx = std::cos(heading_deg * kRadians);
  const double ny = std::sin(heading_deg * kRadians);
  Eigen::Matrix3d matrix;
  matrix << c + nx * nx * v, nx * ny * v, ny * s, ny * nx * v, c + ny * ny * v, -nx * s, -ny * s, nx * s, c;
  return matrix;
}

double largestDifference(const Toolpath& a, const Toolpath& b, const Eigen::Matrix3d& a_from_b) {
  double largest = 0.0;
  EXPECT_EQ(a.layers.size(), b.layers.size());
  for (std::size_t l = 0; l < a.layers.size(); ++l) {
    EXPECT_EQ(a.layers[l].paths.size(), b.layers[l].paths.size()) << l;
    for (std::size_t p = 0; p < a.layers[l].paths.size(); ++p) {
      const std::vector<Point3>& ones = a.layers[l].paths[p].points;
      const std::vector<Point3>& others = b.layers[l].paths[p].points;
      EXPECT_EQ(ones.size(), others.size()) << l << " " << p;
      for (std::size_t i = 0; i < std::min(ones.size(), others.size()); ++i)
        largest = std::max(largest, (ones[i] - a_from_b * others[i]).norm());
    }
  }
  return largest;
}

TEST(InclinedJob, DirectSlicingIsPlanarSlicingOfTheTurnedMeshTurnedBack) {
  const test::ScratchFolder folder;
  const Mesh mesh =
      joined(test::boxBetween({0, 0, 0}, {20, 15, 10}), test::boxBetween({30, 2, 0}, {41, 9, 25}));
  for (const auto& [angle, heading] : {std::pair{45.0, 0.0}, {30.0, 90.0}, {60.0, 217.0}}) {
    const Eigen::Matrix3d rotation = documentedRotation(angle, heading);
    Mesh turned_mesh = mesh;
    for (Point3& vertex : turned_mesh.vertices) vertex = rotation.transpose() * vertex;
    writeFile(folder.file("upright.obj"), objOf(mesh));
    writeFile(folder.file("turned.obj"), objOf(turned_mesh));
    SliceJob direct = upright(folder.file("upright.obj"), angle, heading);
    direct.settings = test::plainSettings();  // bridges know of the bed, and waits of the part's box
    direct.settings.slicing.plane = {angle, heading, ToolAxis::Down};
    direct.settings.planning.anchoring.strategy = Anchoring::None;
    direct.settings.planning.skirt.count = 0;
    SliceJob planar = direct;
    planar.part = folder.file("turned.obj");
    planar.settings.slicing.plane = {};
    const Toolpath inclined = run(direct).toolpath;
    EXPECT_GT(totals(inclined).waypoints, 1000U);
    EXPECT_LT(largestDifference(inclined, run(planar).toolpath, rotation), kSamePoint) << angle;
  }
}

TEST(InclinedJob, EveryWaypointLiesInItsPlaneAndOverTheBed) {
  const test::ScratchFolder folder;
  writeStl(folder.file("tube.stl"), makePart("tube", {{"height_mm", "6"}}));
  EXPECT_TRUE(rc::check("any angle, any heading", [&](std::uint64_t seed) {
    Random random(seed);
    const double angle = random.uniform(1.0, 75.0);
    SliceJob job = upright(folder.file("tube.stl"), angle, random.uniform(0.0, 360.0));
    job.settings.slicing.layer_height_mm = 0.4;
    job.settings.slicing.first_layer_height_mm = 0.4;
    const SlicedPart sliced = run(job);
    const Point3 normal = layerNormal(sliced.toolpath);
    // Beads lie half a layer above where their contour meets the bed.
    const double lowest = 0.5 * 0.4 * std::cos(angle * kRadians) - job.settings.planning.simplification_mm;
    for (const ToolpathLayer& layer : sliced.toolpath.layers)
      for (const Path& path : layer.paths)
        for (const Point3& point : path.points) {
          const double height = normal.dot(point) - layer.z_mm;
          RC_ASSERT(path.role == PathRole::Travel || std::abs(height) < kSamePoint);
          RC_ASSERT((sliced.bed_from_part * point).z() > lowest);
        }
  }));
}

TEST(InclinedJob, DepositsTheVolumeOfTheMeshAtAnyAngle) {
  EXPECT_TRUE(rc::check("solid, any angle and heading", [](std::uint64_t seed) {
    Random random(seed);
    SliceJob job = upright("box", random.uniform(5.0, 75.0), random.uniform(0.0, 360.0));
    job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 0.4;
    job.settings.planning.infill.density = 1.0;
    const SliceSummary summary = run(job).summary;
    RC_ASSERT(std::abs(summary.sliced_volume_mm3 / 8000.0 - 1.0) < 1e-3);
    RC_ASSERT(std::abs(summary.deposited_mm3 / 8000.0 - 1.0) < 0.03);
  }));
}

TEST(InclinedJob, TheFirstWaypointIsALayerHeightOverTheEdgeAlongTheNormal) {
  // A cube of 20 mm round the origin: its edge at y = 10 is the first to be met; layer 0 lies h / cos a above
  // it.
  for (const double angle : {30.0, 45.0, 60.0}) {
    SliceJob job = upright("box", angle, 0.0);
    job.settings.slicing.first_layer_height_mm = 0.4;
    const SlicedPart sliced = run(job);
    const Point3 normal = layerNormal(sliced.toolpath);
    const double edge = -std::sin(angle * kRadians) * 10.0;
    const double vertical = (sliced.toolpath.layers[0].z_mm - edge) / normal.z();
    EXPECT_NEAR(vertical, 0.4 / std::cos(angle * kRadians), 1e-9) << angle;
  }
}

TEST(InclinedJob, RunsBeginOnBedOrMaterialWhereTheyCan) {
  SliceJob job = upright("tube", 60.0, 0.0);
  job.settings.planning.anchoring.strategy = Anchoring::None;
  const AnchoredStarts as_deposited = run(job).summary.anchored;
  EXPECT_EQ(as_deposited.moved, 0U);
  EXPECT_GT(as_deposited.in_air, 10U);
  job.settings.planning.anchoring.strategy = Anchoring::SupportedStart;
  // The last sliver at the rim lies farther out than the layer before it.
  EXPECT_LE(run(job).summary.anchored.in_air, 1U);
}

/// A ball whose lowest place along the normal of layers at 45 deg lies r (1 - cos 45) above the bed.
SliceJob ballAt45(const test::ScratchFolder& folder) {
  SliceJob job = upright(folder.file("ball.stl"), 45.0, 0.0);
  job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 0.4;
  job.settings.planning.bead.width_mm = 0.8;
  writeStl(job.part, makePart("sphere", {{"radius_mm", "20"}, {"segments", "48"}}));
  return job;
}

double lowestOverBed(const SlicedPart& sliced, std::size_t layer) {
  double lowest = 1e9;
  for (const Path& path : sliced.toolpath.layers[layer].paths)
    for (const Point3& point : path.points)
      if (path.role != PathRole::Travel) lowest = std::min(lowest, (sliced.bed_from_part * point).z());
  return lowest;
}

TEST(InclinedJob, RefusesAPartThatBeginsInTheAirUnlessAsked) {
  const test::ScratchFolder folder;
  SliceJob job = ballAt45(folder);
  const std::string refusal = failureOf<InvalidInput>(job);
  const std::string before = "the first layer of the part lies ";
  ASSERT_EQ(refusal.rfind(before, 0), 0U) << refusal;
  // The first layer is cut 0.2 mm above the lowest place, in a disc of sqrt(2 20 0.2 - 0.2^2) = 2.82 mm. The
  // middle of its wall is 2.46 mm beside the axis, (20 (1 - cos 45) + 0.4 cos 45 - 2.46 sin 45) = 4.40 mm
  // above the bed, and the lowest corner of the bead 0.4 (cos 45 + sin 45) below that.
  EXPECT_NEAR(std::stod(refusal.substr(before.size())), 3.83, 0.15);
  EXPECT_NE(refusal.find("expected at most 0.8 mm"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("supports.use true"), std::string::npos) << refusal;
  job.settings.planning.anchoring.strategy = Anchoring::None;
  EXPECT_NEAR(lowestOverBed(run(job), 0), 4.40, 0.15);
}

/// A pillar on the bed, with an arm at its top away from the layers' way: they meet it first at its lower
/// edge at (y, z) = (30, 24), in mid-air.
SliceJob pillarWithArm(const test::ScratchFolder& folder) {
  SliceJob job = upright(folder.file("pillar.stl"), 45.0, 0.0);
  writeStl(job.part,
           joined(test::boxBetween({0, 0, 0}, {10, 10, 30}), test::boxBetween({0, 8, 24}, {10, 30, 30})));
  return job;
}

TEST(InclinedJob, RefusesIslandsThatBeginInTheAirUnlessAsked) {
  const test::ScratchFolder folder;
  SliceJob job = pillarWithArm(folder);
  const std::string refusal = failureOf<InvalidInput>(job);
  EXPECT_EQ(refusal.rfind("islands of layers that begin in mid-air: 1, the first in layer ", 0), 0U)
      << refusal;
  Point3 place = Point3::Zero();
  const std::size_t at = refusal.find('(');
  ASSERT_NE(at, std::string::npos) << refusal;
  ASSERT_EQ(std::sscanf(refusal.c_str() + at, "(%lf, %lf, %lf)", &place.x(), &place.y(), &place.z()), 3);
  EXPECT_NEAR(place.y(), 30.0, 1.0) << refusal;
  EXPECT_NEAR(place.z(), 24.0, 1.0) << refusal;
  job.settings.planning.anchoring.strategy = Anchoring::WherePossible;
  EXPECT_EQ(failureOf<InvalidInput>(job), "");
}

/// Whatever their angle, to the last bit as before.
TEST(InclinedJob, LaysAPartThatStandsOnTheBedAtAnyAngle) {
  const test::ScratchFolder folder;
  // A blade that twisted as much over less height would lean farther than layers at 75 deg allow.
  const std::map<std::string, std::vector<SettingText>> low = {
      {"box", {{"z_mm", "8"}}},
      {"tube", {{"height_mm", "8"}}},
      {"blade", {{"height_mm", "8"}, {"twist_deg", "4"}}},
      {"cone", {{"height_mm", "8"}}}};
  for (const auto& [part, parameters] : low) writeStl(folder.file(part + ".stl"), makePart(part, parameters));
  EXPECT_TRUE(rc::check("parts with a level face", [&](std::uint64_t seed) {
    Random random(seed);
    SliceJob job =
        upright(folder.file(std::next(low.begin(), static_cast<std::ptrdiff_t>(seed % 4))->first + ".stl"),
                random.uniform(5.0, 75.0), random.uniform(0.0, 360.0));
    job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 0.4;
    RC_ASSERT(!run(job).toolpath.layers.empty());
  }));
}

TEST(InclinedJob, SupportsReachFromTheBedToAPartThatBeginsInTheAir) {
  const test::ScratchFolder folder;
  SliceJob job = ballAt45(folder);
  job.settings.planning.anchoring.strategy = Anchoring::None;
  const std::size_t layers = run(job).toolpath.layers.size();
  job.settings.planning.anchoring.strategy = Anchoring::SupportedStart;
  job.settings.planning.supports.use = true;
  const SlicedPart sliced = run(job);
  EXPECT_EQ(sliced.summary.empty_layers, 0U);
  // The shadow of the ball on the bed begins at y = r, r (2 sin 45 - 1) before the ball along the normal: 21
  // layers. The gap beside the part and narrow columns take some of them.
  EXPECT_GT(sliced.toolpath.layers.size(), layers + 10U);
  EXPECT_LE(sliced.toolpath.layers.size(), layers + 23U);
  EXPECT_LT(lowestOverBed(sliced, 0), 0.8);
  EXPECT_GT(lowestOverBed(sliced, 0), 0.0);
  EXPECT_NE(sliced.toolpath.layers.front().paths.front().role, PathRole::Travel);
}

TEST(InclinedJob, AHeadAt45DegreesLaysItsOwnLayersAndNoOthers) {
  SliceJob job;
  job.part = "box";
  job.settings.machine.name = "gantry_45";
  job.settings.slicing.plane.angle_deg = 45.0;
  EXPECT_NO_THROW(run(job));
  job.settings.slicing.plane.angle_deg = 30.0;
  EXPECT_EQ(failureOf<Unreachable>(job),
            "slicing.plane of 30 deg about 0 deg needs the tool axis along (0.000, 0.500, -0.866); the head "
            "of gantry_45 "
            "holds it along (0.000, 0.707, -0.707), for slicing.plane.angle_deg 45 and "
            "slicing.plane.axis_heading_deg 0");
  job.settings.slicing.plane = {45.0, 180.0, ToolAxis::Normal};
  EXPECT_NE(failureOf<Unreachable>(job), "");
  job.settings.machine.name = "large_gantry_45_reverse";
  EXPECT_NO_THROW(run(job));
}

TEST(InclinedJob, AnUprightHeadLaysInclinedLayersIfTheNozzleStaysUpright) {
  SliceJob job = upright("box", 20.0, 0.0);
  EXPECT_NO_THROW(run(job));
  job.settings.slicing.plane.tool_axis = ToolAxis::Normal;
  EXPECT_NE(failureOf<Unreachable>(job).find("slicing.plane.tool_axis 'down'"), std::string::npos);
}

TEST(InclinedJob, RefusesWhatNeedsLevelLayers) {
  SliceJob job = upright("box", 20.0, 0.0);
  job.settings.planning.skirt.count = 3;
  EXPECT_NE(failureOf<InvalidConfig>(job).find("skirt.count is 3"), std::string::npos);
}

/// The sensor is carried over every layer in the layer's own plane, on the machines that look at it squarely
/// and on those that look down on it.
TEST(InclinedJob, ScansItsLayers) {
  for (const char* machine : {"belt_45", "gantry_45"}) {
    SliceJob job;
    job.part = "box";
    job.settings.machine.name = machine;
    job.settings.slicing.plane.angle_deg = 45.0;
    job.settings.scan.every_layers = 1;
    const Toolpath level = inLayerFrame(run(job).toolpath);
    for (const ToolpathLayer& layer : level.layers) {
      EXPECT_TRUE(isScanned(layer, 1.0)) << machine;
      Box2 printed;
      Box2 swept;  // by the middle of the line, 25 mm beside the nozzle
      for (const Path& path : layer.paths)
        for (const Point3& point : path.points) {
          if (path.role != PathRole::Travel) printed.include(Point2(point.head<2>()));
          if (path.role == PathRole::Travel && std::abs(point.z() - scanHeight(layer, 1.0)) < 1e-6)
            swept.include(Point2(point.head<2>() + Point2(25, 0)));
        }
      EXPECT_LT(swept.low.y(), printed.low.y()) << machine;
      EXPECT_GT(swept.high.y(), printed.high.y()) << machine;
    }
  }
}

TEST(InclinedJob, ABeltPrintsPartsOfAnyLengthFromItsStart) {
  const test::ScratchFolder folder;
  SliceJob job;
  job.part = folder.file("beam.stl");
  job.settings.machine.name = "belt_45";
  job.settings.slicing.plane.angle_deg = 45.0;
  job.settings.slicing.layer_height_mm = 5.0;
  job.settings.slicing.first_layer_height_mm = 5.0;
  job.settings.planning.bead.width_mm = 6.0;
  writeStl(job.part, test::boxBetween({0, 0, 0}, {50, 20000, 40}));
  const SlicedPart sliced = run(job);
  const CartesianMachine machine = machineByName("belt_45");
  double start = 1e9;
  double end = 0.0;
  for (const ToolpathLayer& layer : sliced.toolpath.layers)
    for (const Path& path : layer.paths)
      for (const Point3& point : path.points) {
        if (path.role == PathRole::Travel) continue;
        const AxisValues values = axisValues(machine, sliced.bed_from_part * point);
        start = std::min(start, values.z());
        end = std::max(end, values.z());
        // The belt stands still in a layer: its normal height over the sine of the angle.
        const Point3 normal = layerNormal(sliced.toolpath);
        const double offset = normal.dot(sliced.bed_from_part.translation());
        EXPECT_NEAR(values.z(), (layer.z_mm + offset) * M_SQRT2, 1e-6);
      }
  EXPECT_GT(start, 0.0);
  EXPECT_LT(start, 2.0 * 5.0 * M_SQRT2 + 1e-9);
  EXPECT_NEAR(end, 20000.0 + 40.0, 2.0 * 5.0 * M_SQRT2);
}

std::map<PathRole, double> volumesByRole(const ToolpathLayer& layer) {
  std::map<PathRole, double> volumes;
  for (const Path& path : layer.paths)
    if (path.role != PathRole::Travel) volumes[path.role] += depositedVolume(path);
  return volumes;
}

/// Areas are on a grid that ends 10 m from the origin; the first layers lie at 12 and 14 m in their planes.
TEST(InclinedJob, ABeltClosesALongBeamAlikeAllAlong) {
  for (const double length_mm : {17000.0, 20000.0}) {
    const test::ScratchFolder folder;
    SliceJob job;
    job.part = folder.file("beam.stl");
    job.settings.machine.name = "belt_45";
    job.settings.slicing.plane.angle_deg = 45.0;
    job.settings.slicing.layer_height_mm = job.settings.slicing.first_layer_height_mm = 5.0;
    job.settings.planning.bead.width_mm = 6.0;
    writeStl(job.part, test::boxBetween({0, 0, 0}, {50, length_mm, 80}));
    const SlicedPart sliced = run(job);
    const std::size_t count = sliced.toolpath.layers.size();
    ASSERT_GT(count, 2400U);
    const auto near = volumesByRole(sliced.toolpath.layers[count - 100]);
    EXPECT_GT(near.at(PathRole::Skin), 100.0) << "where four layers do not cover it";
    for (const std::size_t far : {100U, 500U, 1000U, 1500U, 2000U}) {
      const auto volumes = volumesByRole(sliced.toolpath.layers[far]);
      ASSERT_EQ(volumes.size(), near.size()) << far;
      for (const PathRole role : {PathRole::OuterWall, PathRole::InnerWall, PathRole::Skin})
        EXPECT_NEAR(volumes.at(role), near.at(role), 0.03 * near.at(role)) << far << ", " << toString(role);
    }
  }
}

TEST(InclinedJob, ABeltAtAnotherAngleIsDescribedByAFileAndLeavesTheBedAlone) {
  const test::ScratchFolder folder;
  const std::string text = machineByName("belt_45").urdf;
  for (const double angle : {15.0, 30.0, 60.0, 75.0}) {
    const std::string number = "rpy=\"0.785398163397448 0 0\"";
    char exact[64];
    std::snprintf(exact, sizeof exact, "rpy=\"%.17g 0 0\"", angle * kRadians);
    std::string turned = text;
    turned.replace(turned.find(number), number.size(), exact);
    writeFile(folder.file("belt.urdf"), turned);
    SliceJob job;
    job.part = "box";
    job.settings.machine.urdf = folder.file("belt.urdf");
    job.settings.slicing.plane.angle_deg = angle;
    const SlicedPart sliced = run(job);
    const CartesianMachine machine = machineOf(job.settings.machine);
    // The nozzle never comes nearer to the belt than half a layer's foot along the incline.
    const double nearest = 0.1 / std::tan(angle * kRadians) - 0.01;
    for (const ToolpathLayer& layer : sliced.toolpath.layers)
      for (const Path& path : layer.paths)
        for (const Point3& point : path.points)
          ASSERT_GT(axisValues(machine, sliced.bed_from_part * point).y(), nearest) << angle;
  }
}

}  // namespace
}  // namespace lamina
