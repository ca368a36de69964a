// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The six-legged platform under its controller.
#include "job/settings/setting_probe.hpp"
#include "lamina/dynamics/tracking_simulation.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/kinematics/platform/rus_description.hpp"

namespace lamina::test {
namespace {

/// A way of 2 mm and a turn, from rest to rest.
Toolpath shortWay() {
  Path path;
  path.points = {{50, 50, 20}, {52, 50, 20}};
  path.orientation = AlongPath<Eigen::Quaterniond>(std::vector<Eigen::Quaterniond>{
      nozzleDown(), Eigen::AngleAxisd(0.02, Point3(1, 1, 1).normalized()) * nozzleDown()});
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 50.0;
  return {"way", {{20.0, 0.2, {path}}}};
}

std::string tracked(const SettingTexts& set) {
  static const RusDescription platform = rusDescriptionFromUrdf(kinematicModelByName("rus_platform")->urdf());
  const ToolpathReference reference(shortWay(), Eigen::Isometry3d::Identity(), MotionLimits{}, platform);
  NoProgress nobody;
  const TrackingFigures figures = simulateTracking(
      TrackingSimulation(reference, platform.platform, platform.platform_from_nozzle.translation(),
                         settingsWith<TrackingSettings>(set)),
      nobody);
  return numbersText({figures.linear_ise_mm2_s, figures.rotational_ise_rad2_s, figures.control_energy_nm2_s,
                      figures.greatest_torque_nm});
}

}  // namespace

std::vector<SettingProbe> platformProbes() {
  return {{"the platform",
           "platform.unknown_load_kg=0.2",
           tracked,
           {{"platform.mass_kg=2"},
            {"platform.crank_mass_kg=0.3"},
            {"platform.coupler_mass_kg=0.3"},
            {"platform.inertia_x_kg_m2=0.01"},
            {"platform.inertia_y_kg_m2=0.01"},
            {"platform.inertia_z_kg_m2=0.02"},
            {"platform.centre_z_mm=20"},
            {"platform.viscous_friction_nm_s=0.1"},
            {"platform.unknown_load_kg=0.4"},
            {"controller.k1=80"},
            {"controller.k2=1500"},
            {"controller.k3=9000"},
            {"controller.reach_rad_s2=10"},
            {"controller.boundary_rad_s=0.6"},
            {"simulation.step_s=0.0005"}}}};
}

}  // namespace lamina::test
