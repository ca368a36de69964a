// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What is measured on a toolpath: overhang, clearance, deposit, sweep, stiffness and metrics.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/deposition/toolpath_deposit.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/metrics/toolpath_metrics.hpp"
#include "lamina/stiffness/stiffness.hpp"
#include "lamina/sweep/solid_union.hpp"
#include "lamina/verification/collision/clearance.hpp"
#include "lamina/verification/overhang/overhang.hpp"
#include "support/toolpaths.hpp"
#include "support/voxel_shapes.hpp"
#include "sweep/specimen.hpp"

namespace lamina::test {
namespace {

const Eigen::Isometry3d kInPlace = Eigen::Isometry3d::Identity();

/// A square of one layer, and a bead over it that leaves it sideways.
Toolpath ledge() {
  Toolpath toolpath = twoLayers();
  Path& above = toolpath.layers[1].paths[0];
  above.points = {{0, 0.35, 0.4}, {10, 0.35, 0.4}, {14.33, 0.35, 0.4}};
  return toolpath;
}

std::string overhangs(const SettingTexts& set) {
  NoProgress nobody;
  const OverhangTotals sums =
      totals(findOverhangs(ledge(), kInPlace, settingsWith<JobSettings>(set).overhang, nobody));
  return numbersText({sums.all.overhang_mm, sums.all.bridge_mm, sums.longest_overhang_mm,
                      double(sums.overhangs), double(sums.bridges)});
}

/// A short bead of 5 mm, and a travel across it that goes into it by a tenth of a millimetre.
std::string collisions(const SettingTexts& set) {
  Toolpath toolpath;
  Path wall = straightPath({19, 0, 5}, {21, 0, 5});
  wall.bead = Bead{6, 5};
  Path travel = straightPath({21, 0, 5}, {21, 0, 50});
  travel.points.insert(travel.points.end(), {{0, 0, 50}, {0, 0, 4.9}, {40, 0, 4.9}});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  toolpath.layers = {{5, 5, {wall, travel}}};
  NoProgress nobody;
  const ClearanceReport report = checkClearance(
      {toolpath, Eigen::Isometry3d(Eigen::Translation3d(100, 100, 0)), machineByName("cartesian_gantry")},
      settingsWith<JobSettings>(set).clearance, nobody);
  std::string text = numbersText({double(report.waypoints), double(report.colliding)});
  for (const Collision& collision : report.first_of_layers)
    text += numbersText({collision.tip.x(), collision.tip.y(), collision.tip.z()});
  return text;
}

std::string deposited(const SettingTexts& set) {
  Toolpath toolpath = twoLayers();
  Path skirt = straightPath({-3, 0, 0.2}, {-3, 5, 0.2});
  skirt.role = PathRole::Skirt;
  toolpath.layers[0].paths.insert(toolpath.layers[0].paths.begin(), skirt);
  Path thick = straightPath({2, 5, 0.1}, {8, 5, 0.1});
  thick.bead = Bead{1.2, 0.8};
  toolpath.layers[1].paths.push_back(thick);
  toolpath.layers[1].paths.push_back(thick);
  NoProgress nobody;
  const ToolpathDeposit deposit =
      depositedVoxels(toolpath, settingsWith<JobSettings>(set).deposition, nobody);
  return numbersText({double(deposit.grid.solidCount()), deposit.totals.deposited_mm3,
                      deposit.totals.excess_mm3, deposit.highest_mm, deposit.totals.held_mm3});
}

std::string swept(const SettingTexts& set) {
  const SweepSettings settings = settingsWith<JobSettings>(set).sweep;
  Path path = straightPath({0, 0, 0.2}, {4, 0, 0.2});
  path.points.insert(path.points.end(),
                     {{4, 3, 0.2}, {4.1, 0.2, 0.2}, {8, 0.2, 0.2}, {8, 0.65, 0.2}, {5, 0.68, 0.2}});
  Path higher = path;
  for (Point3& point : higher.points) point.z() += 3.0;
  const auto solids =
      beadSolids(sweepsOf({"beads", {{0.2, 0.2, {path}}, {3.2, 0.2, {higher}}}}, settings), settings.corners);
  NoProgress nobody;
  const VoxelGrid inside = voxelUnion(solids, settings.voxel_mm, nobody);
  return numbersText({double(solids.size()), double(inside.solidCount()), unionVolume(solids, nobody)});
}

/// Sections of a bead of the second layer that ends 0.17 mm from where it begins.
std::string cutInto(const SettingTexts& set) {
  const Toolpath toolpath = layered({1.2, 1.5}, [](std::size_t, double z, double h) {
    std::vector<Path> paths;
    if (h < 0.5) paths = {bead({{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 0.17, z}}, {0.3, h})};
    return paths;
  });
  return std::to_string(sweepsOf(toolpath, settingsWith<JobSettings>(set).sweep).size());
}

/// How a nozzle is held that leans into the bed, if it is not refused.
SettingProbe headInBedProbe() {
  return {"a head in the bed",
          "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;bead.width_mm=1;skirt.count=0;"
          "machine.name=five_axis_head_table;orientation.mode=fixed;orientation.fixed_lean_deg=50;"
          "clearance.need=never",
          programOf("box x_mm=6 y_mm=4 z_mm=0.5", ".gcode"),
          {{"clearance.need=turning"},
           {"clearance.raise_tool_axis=false", "clearance.need=turning;clearance.raise_tool_axis=true"}}};
}

/// A bar of voxels of 1 mm.
std::string stiffnessOf(const std::array<int, 3>& count, const SettingTexts& set) {
  NoProgress nobody;
  const StiffnessResult result =
      solveStiffness(solidBox(count, 1.0), settingsWith<JobSettings>(set).stiffness, nobody);
  return numbersText({result.force_n, result.modulus_mpa, double(result.iterations), result.residual});
}

std::string metrics(const SettingTexts& set) {
  static const Mesh part = makePart("box", {{"x_mm", "4"}, {"y_mm", "3"}, {"z_mm", "3"}});
  static const SlicedPart sliced =
      slicedBy("box x_mm=4 y_mm=3 z_mm=1",
               settingTexts("skirt.count=0;slicing.layer_height_mm=0.25;slicing.first_layer_height_mm=0.25;"
                            "part.placement=as_is;machine.name=irb_4600"));
  NoProgress nobody;
  return numbersText(metricValues(
      measureToolpath(sliced.toolpath, part, kInPlace, settingsWith<JobSettings>(set).metrics, nobody)));
}

SettingProbe stiffnessProbe() {
  return {"stiffness",
          "stiffness.span_mm=8;stiffness.axis=x",
          [](const SettingTexts& set) {
            return stiffnessOf({12, 4, 4}, set);
          },
          {{"stiffness.youngs_modulus_mpa=2000"},
           {"stiffness.poissons_ratio=0.2"},
           {"stiffness.load=bending", "stiffness.axis=z"},
           {"stiffness.axis=y"},
           {"stiffness.compression_mm=0.1"},
           {"stiffness.deflection_mm=0.5", "stiffness.load=bending;stiffness.axis=z"},
           {"stiffness.span_mm=6", "stiffness.load=bending;stiffness.axis=z"},
           {"stiffness.area_mm2=20"},
           {"stiffness.residual=0.05", "stiffness.load=bending;stiffness.axis=z"},
           {"stiffness.iterations=1", "stiffness.residual=1e-9"}}};
}

SettingProbe metricsProbe() {
  return {"metrics",
          "",
          metrics,
          {{"metrics.surface=false"},
           {"metrics.simulate_platform=true"},
           {"metrics.speed_mm_s=20"},
           {"metrics.acceleration_mm_s2=300"},
           {"metrics.depth_mm=0.4"},
           {"metrics.bead_line=tip"},
           {"metrics.surface_width=code"},
           {"metrics.face_pieces=within"},
           {"metrics.overlaps=all"},
           {"metrics.uncovered_faces=skip"},
           {"metrics.surface_step_mm=0.05"},
           {"metrics.volume_section=strand"},
           {"metrics.strand_area_mm2=0.2", "metrics.volume_section=strand"},
           {"metrics.strand_ends=commercial", "metrics.volume_section=strand"},
           {"metrics.fill_share=0.5"},
           {"metrics.platform_middle_mm=5,5", "metrics.simulate_platform=true"}}};
}

}  // namespace

std::vector<SettingProbe> measureProbes() {
  return {{"overhang",
           "",
           overhangs,
           {{"overhang.step_mm=0.5"}, {"overhang.reach=4"}, {"overhang.overlap=0.02"}}},
          {"clearance", "", collisions, {{"clearance.spacing_mm=40"}, {"clearance.tolerance_mm=2"}}},
          {"a deposit",
           "",
           deposited,
           {{"deposition.voxel_mm=0.2"},
            {"deposition.step=0.25"},
            {"deposition.reach_mm=0.3"},
            {"deposition.bed_z_mm=0.1"},
            {"deposition.skirt=true"},
            {"deposition.memory_limit_mb=0.001"}}},
          {"sweeps", "", swept, {{"sweep.corners=lines"}, {"sweep.voxel_mm=0.2"}}},
          {"a bead that is cut", "", cutInto, {{"sweep.cut_height=absolute"}}},
          headInBedProbe(),
          stiffnessProbe(),
          {"the memory of stiffness",
           "stiffness.residual=0.01",
           [](const SettingTexts& set) {
             return stiffnessOf({24, 24, 24}, set);
           },
           {{"stiffness.memory_mb=1"}}},
          metricsProbe()};
}

}  // namespace lamina::test
