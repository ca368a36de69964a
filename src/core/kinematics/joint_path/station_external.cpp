// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "kinematics/joint_path/stations.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/kinematics/arm/external_axis.hpp"

namespace lamina {

bool isExternal(const std::string& joint) { return joint.rfind("external_", 0) == 0; }

void setExternalAxes(std::vector<Station>& stations, const KinematicModel& model,
                     const JointPathSettings& settings) {
  const auto& joints = model.joints();
  const bool has_external = std::any_of(joints.begin(), joints.end(),
                                        [](const DrivenJoint& joint) { return isExternal(joint.name); });
  if (!has_external) return;
  const TableHeading heading{settings.external_azimuth_deg * kDegree};
  double value = settings.external_deg * kDegree;
  for (Station& station : stations) {
    if (settings.external == ExternalChoice::Follow)
      value = tableValue(model, station.orientation * Point3::UnitZ(), heading, value);
    station.external = value;
  }
}

}  // namespace lamina
