// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The way to where a job begins.
#include "job/settings/setting_probe.hpp"
#include "lamina/trajectory/approach.hpp"

namespace lamina::test {
namespace {

std::string approached(const SettingTexts& set) {
  const auto model = kinematicModelByName("cartesian_gantry");
  JointValues from(3), to(3);
  from << 50, 50, 20;
  to << 120, 90, 30;
  const Approach way = approach(from, to, *model, settingsWith<ApproachSettings>(set), {});
  std::string text = numbersText({way.motion->duration()});
  for (const JointValues& station : way.stations)
    text += numbersText({station.data(), station.data() + station.size()});
  return text;
}

}  // namespace

std::vector<SettingProbe> approachProbes() {
  return {{"an approach",
           "",
           approached,
           {{"approach.lift_mm=10"}, {"approach.lift_mm_s=10"}, {"approach.joint_speed=0.5"}}}};
}

}  // namespace lamina::test
