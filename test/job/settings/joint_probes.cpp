// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Joints: how a machine or robot is led along a toolpath.
#include <cmath>
#include <functional>

#include "job/settings/setting_probe.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/run_settings.hpp"
#include "support/arms.hpp"
#include "support/gantry_head.hpp"
#include "support/tilting_arm.hpp"

namespace lamina::test {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr char kNearLimits[] = "joints.limit_margin_deg=90;joints.limit_weight=1000";

Eigen::Quaterniond leaning(double azimuth_deg, double tilt_deg) {
  const Eigen::Vector3d axis(-std::sin(azimuth_deg * kDegree), std::cos(azimuth_deg * kDegree), 0.0);
  return Eigen::AngleAxisd(-tilt_deg * kDegree, axis) * nozzleDown();
}

/// A bead of some 60 mm along x on which the nozzle leans to an azimuth that goes round.
Path leaningBead(double y_mm, double azimuth_deg, double turn_deg, double tilt_deg) {
  Path path;
  path.role = PathRole::OuterWall;
  path.feed_mm_s = 20.0;
  path.bead = Bead{0.5, 0.2};
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = 0; i <= 12; ++i) {
    path.points.emplace_back(5.0 * i, y_mm, 0.2);
    nozzles.push_back(leaning(azimuth_deg + turn_deg / 12.0 * i, tilt_deg));
  }
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return path;
}

Path travelBetween(const Path& from, const Path& to) {
  Path path;
  path.role = PathRole::Travel;
  path.feed_mm_s = 100.0;
  path.points = {from.lastPoint(), to.firstPoint()};
  path.orientation = AlongPath<Eigen::Quaterniond>(
      std::vector<Eigen::Quaterniond>{from.orientation.at(12), to.orientation.at(0)});
  return path;
}

Toolpath beads(double turn_deg, double tilt_deg) {
  const Path first = leaningBead(0.0, 20.0, turn_deg, tilt_deg);
  const Path second = leaningBead(40.0, 200.0, turn_deg, tilt_deg);
  return {"beads", {{0.2, 0.2, {first, travelBetween(first, second), second}}}};
}

std::string jointsText(const JointPath& path) {
  std::string text;
  for (const JointValues& values : path.values)
    text += numbersText({values.data(), values.data() + values.size()});
  for (const FaultyWaypoint& fault : path.faults) text += fault.reason + "\n";
  return text;
}

std::function<std::string(const SettingTexts& set)> jointsOn(const std::string& machine,
                                                             const Toolpath& toolpath, const Point3& place) {
  return [machine, toolpath, place](const SettingTexts& set) {
    NoProgress nobody;
    return jointsText(runOn(*kinematicModelByName(machine), toolpath,
                            Eigen::Isometry3d(Eigen::Translation3d(place)),
                            settingsWith<RunSettings>(set).joints, nobody)
                          .path);
  };
}

SettingProbe armProbe() {
  return {"joints of an arm",
          "joints.yaw_samples=24",
          jointsOn("irb_4600", beads(60.0, 15.0), {60, 60, 0}),
          {{"joints.yaw=held"},
           {"joints.yaw_samples=18", kNearLimits},
           {"joints.yaw_reach=0", kNearLimits},
           {"joints.yaw_weight=500", kNearLimits},
           {"joints.smooth_yaw=false", kNearLimits},
           {"joints.max_turn_deg=0.05"},
           {"joints.singular_margin_deg=80", "joints.singular_weight=1000"},
           {"joints.singular_weight=1000", "joints.singular_margin_deg=80"},
           {"joints.limit_margin_deg=90", "joints.limit_weight=1000"},
           {"joints.limit_weight=1000", "joints.limit_margin_deg=90"},
           {"joints.least_margin_deg=85"},
           {"joints.max_step_mm=2"},
           {"joints.max_step_deg=1"},
           {"joints.tip_tolerance_mm=0.0005", "joints.max_step_mm=100;joints.max_step_deg=90"},
           {"joints.tool_axis_tolerance_deg=0.002",
            "joints.max_step_mm=100;joints.max_step_deg=90;joints.tip_tolerance_mm=100"}}};
}

/// Joints along a toolpath that lies on the bed of a description.
std::function<std::string(const SettingTexts&)> jointsOfDescription(const std::string& urdf,
                                                                    const Toolpath& toolpath) {
  return [urdf, toolpath](const SettingTexts& set) {
    NoProgress nobody;
    return jointsText(runOn(*kinematicModelFromUrdf(urdf), toolpath, Eigen::Isometry3d::Identity(),
                            settingsWith<RunSettings>(set).joints, nobody)
                          .path);
  };
}

SettingProbe sevenAxisProbe() {
  return {"joints of an arm of seven axes",
          "joints.yaw_samples=24",
          jointsOfDescription(test::sphericalSeven().urdf(), beads(60.0, 15.0)),
          {{"joints.redundancy_samples=1"}}};
}

SettingProbe turntableProbe() {
  return {"joints of an arm with a table",
          "joints.yaw_samples=24",
          jointsOn("irb_4600_turntable", beads(60.0, 15.0), {0, 0, 0}),
          {{"joints.external=follow"},
           {"joints.external_deg=20"},
           {"joints.external_azimuth_deg=40", "joints.external=follow"}}};
}

SettingProbe tiltingTableProbe() {
  return {"joints of an arm with a table that tilts",
          "joints.yaw_samples=24;joints.external=gravity",
          jointsOfDescription(tiltingArm(), beads(60.0, 15.0)),
          {{"joints.external_cone_deg=3"}}};
}

SettingProbe railProbe() {
  const Toolpath toolpath = beads(60.0, 15.0);
  return {"joints of an arm on a rail",
          "joints.yaw_samples=24",
          [toolpath](const SettingTexts& set) {
            NoProgress nobody;
            return jointsText(planJointPath(toolpath, Eigen::Isometry3d(Eigen::Translation3d(3000, 0, 0)),
                                            *kinematicModelFromUrdf(railArm()),
                                            settingsWith<RunSettings>(set).joints, nobody));
          },
          {{"joints.rail=follow"}}};
}

SettingProbe uprightHeadProbe() {
  return {"joints of a head near its singularity",
          "",
          jointsOn("five_axis_head_ac", beads(170.0, 0.3), {60, 60, 0}),
          {{"joints.singular_tool_axis_tolerance_deg=1"}, {"joints.swing_tolerance_deg=0.2"}}};
}

/// A bead over whose middle the tool axis passes straight down at 0.2 deg.
Toolpath beadOverASingularity() {
  Path path = leaningBead(0.0, 0.0, 0.0, 0.0);
  const Eigen::Quaterniond aside = leaning(90.0, 0.2) * nozzleDown().inverse();
  std::vector<Eigen::Quaterniond> nozzles;
  for (int i = -6; i <= 6; ++i) nozzles.push_back(aside * leaning(0.0, 0.5 * i));
  path.orientation = AlongPath<Eigen::Quaterniond>(std::move(nozzles));
  return {"bead", {{0.2, 0.2, {path}}}};
}

SettingProbe swingProbe() {
  return {"joints of a head that swings beside its singularity",
          "joints.max_step_mm=1000",
          jointsOn("five_axis_head_ac", beadOverASingularity(), {60, 60, 0}),
          {{"joints.max_slowdown=1.5"}}};
}

/// Beads between which a head with so much way for its joint c would turn far, or tilt to the other side.
std::string branches(double c_limit_deg, const SettingTexts& set) {
  const Path first = leaningBead(0.0, -40.0, 50.0, 30.0);
  const Path second = leaningBead(40.0, -10.0, 50.0, 30.0);
  const Path third = leaningBead(80.0, 150.0, 50.0, 30.0);
  const Toolpath toolpath{
      "beads",
      {{0.2, 0.2, {first, travelBetween(first, second), second, travelBetween(second, third), third}}}};
  NoProgress nobody;
  return jointsText(planJointPath(toolpath, Eigen::Isometry3d::Identity(),
                                  GantryHead(ToolAxisSpin::Free, c_limit_deg),
                                  settingsWith<RunSettings>(set).joints, nobody));
}

std::vector<SettingProbe> branchProbes() {
  return {{"joints of a head that has to change its branch",
           "",
           [](const SettingTexts& set) { return branches(110.0, set); },
           {{"joints.branch_change=never"}}},
          {"joints of a head that may change its branch",
           "joints.branch_change_cost=0",
           [](const SettingTexts& set) { return branches(200.0, set); },
           {{"joints.branch_change_cost=1e6"}}}};
}

}  // namespace

std::vector<SettingProbe> jointProbes() {
  std::vector<SettingProbe> probes = {armProbe(),  sevenAxisProbe(),   turntableProbe(), tiltingTableProbe(),
                                      railProbe(), uprightHeadProbe(), swingProbe()};
  for (SettingProbe& probe : branchProbes()) probes.push_back(std::move(probe));
  return probes;
}

}  // namespace lamina::test
