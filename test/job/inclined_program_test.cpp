// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Programs of inclined layers read back: sliced inclined, or sliced level and inclined afterwards.
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/job/incline_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/program/gcode/toolpath_from_gcode.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/scratch_folder.hpp"
#include "support/solids.hpp"

namespace lamina {
namespace {

constexpr double kWritten = 2e-3;  // mm: three decimals, turned

SliceJob boxJob(const std::string& part, const std::string& output) {
  SliceJob job;
  job.part = part;
  job.output = output;
  job.settings.placement = Placement::AsIs;
  job.settings.planning.skirt.count = 0;
  job.settings.planning.anchoring.strategy = Anchoring::None;
  job.settings.slicing.layer_height_mm = 0.5;
  job.settings.slicing.first_layer_height_mm = 0.5;
  return job;
}

/// A box that stands on the bed, 20 x 15 x 10 mm.
Mesh uprightBox() { return test::boxBetween({100, 100, 0}, {120, 115, 10}); }

Mesh turnedBack(Mesh mesh) {
  const AffineMap back = rotation(Point3::UnitX(), -45.0);
  for (Point3& vertex : mesh.vertices) vertex = back.map(vertex);
  return mesh;
}

class InclinedProgram : public testing::Test {
 protected:
  Toolpath sliceInclined() {
    writeStl(folder_.file("box.stl"), uprightBox());
    SliceJob job = boxJob(folder_.file("box.stl"), folder_.file("native.gcode"));
    job.settings.machine.name = "large_gantry_45";
    job.settings.slicing.plane.angle_deg = 45.0;
    planned_ = runSliceJob(job, nobody_).toolpath;
    return toolpathFromGcodeFile(job.output, job.settings.program);
  }

  Toolpath sliceLevelAndIncline() {
    Mesh mesh = turnedBack(uprightBox());
    double lowest = 1e9;
    double least_y = 1e9;
    for (const Point3& vertex : mesh.vertices) {
      lowest = std::min(lowest, vertex.z());
      least_y = std::min(least_y, vertex.y());
    }
    for (Point3& vertex : mesh.vertices) vertex += Point3(0, 10.0 - least_y, -lowest);
    writeStl(folder_.file("turned.stl"), mesh);
    const SliceJob job = boxJob(folder_.file("turned.stl"), folder_.file("level.gcode"));
    runSliceJob(job, nobody_);
    const InclineSettings settings = loadInclineSettings("", {{"machine.name", "large_gantry_45"},
                                                              {"incline.table_position_mm", "110,107.5"},
                                                              {"incline.layer_height_mm", "0.5"}});
    runInclineJob(inclineJob(settings, job.output, folder_.file("inclined.gcode")), nobody_);
    return toolpathFromGcodeFile(folder_.file("inclined.gcode"), job.settings.program);
  }

  void expectInclined(const Toolpath& toolpath) {
    EXPECT_NEAR(inclinationDeg(toolpath), 45.0, 1e-9);
    const Point3 normal = layerNormal(toolpath);
    EXPECT_LT((normal - Point3(0, -M_SQRT1_2, M_SQRT1_2)).norm(), 1e-9);
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l) {
      const ToolpathLayer& layer = toolpath.layers[l];
      EXPECT_NEAR(layer.height_mm, 0.5, 1e-9) << l;
      EXPECT_NEAR(layer.z_mm - toolpath.layers[0].z_mm, 0.5 * static_cast<double>(l), kWritten) << l;
      for (const Path& path : layer.paths) {
        EXPECT_LT((path.orientation.at(0) * Point3::UnitZ() + normal).norm(), 1e-9);
        if (path.role == PathRole::Travel) continue;
        for (const Point3& point : path.points) ASSERT_NEAR(normal.dot(point), layer.z_mm, kWritten) << l;
      }
    }
  }

  const test::ScratchFolder folder_;
  NoProgress nobody_;
  Toolpath planned_;
};

TEST_F(InclinedProgram, NativeLayersAreReadBackAsTheyWerePlanned) {
  const Toolpath read = sliceInclined();
  expectInclined(read);
  ASSERT_EQ(read.layers.size(), planned_.layers.size());
  for (std::size_t l = 0; l < read.layers.size(); ++l)
    EXPECT_NEAR(read.layers[l].z_mm, planned_.layers[l].z_mm, kWritten) << l;
  const Box3 box = depositionBox(read);
  EXPECT_LT((box.low - depositionBox(planned_).low).norm(), kWritten);
  EXPECT_LT((box.high - depositionBox(planned_).high).norm(), kWritten);
}

TEST_F(InclinedProgram, LevelLayersInclinedAfterwardsAreTheNativeOnes) {
  const Toolpath native = sliceInclined();
  const Toolpath inclined = sliceLevelAndIncline();
  expectInclined(inclined);
  ASSERT_EQ(inclined.layers.size(), native.layers.size());
  for (std::size_t l = 0; l < native.layers.size(); ++l) {
    const std::vector<Path>& ones = inclined.layers[l].paths;
    const std::vector<Path>& others = native.layers[l].paths;
    const auto deposits = [](const std::vector<Path>& paths) {
      double sum = 0.0;
      for (const Path& path : paths) sum += depositedVolume(path);
      return sum;
    };
    // The walls are the same; the infill starts where the sliced mesh lies.
    EXPECT_NEAR(deposits(ones), deposits(others), 0.05 * deposits(others) + 1.0) << l;
  }
  const Box3 one = depositionBox(inclined);
  const Box3 other = depositionBox(native);
  EXPECT_LT((one.size() - other.size()).norm(), 0.1);
  // Nozzle tips are half a layer above the plane that is sliced, and table_position is of the tips.
  const Point2 tips(110.0, 107.5 - 0.25 * M_SQRT1_2);
  EXPECT_LT((other.centre().head<2>() - tips).norm(), 0.1);
  EXPECT_LT((one.centre().head<2>() - Point2(110.0, 107.5)).norm(), kWritten);
}

}  // namespace
}  // namespace lamina
