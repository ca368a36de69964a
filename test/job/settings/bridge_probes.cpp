// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Bridges and overhanging walls.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/job/slice_job.hpp"

namespace lamina::test {
namespace {

constexpr char kWideBeads[] =
    "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;skirt.count=0";

constexpr char kFan[] = ";fan.use=true;fan.full_below_s=0;fan.least=0.2;fan.least_at_s=1";

SettingProbe overhangProbe() {
  return {"a cone leans out",
          std::string(kWideBeads) + kFan + ";infill.density=0;overhangs.use=true",
          programOf("cone radius_mm=3 top_radius_mm=10 height_mm=4 segments=32", ".gcode"),
          {{"overhangs.use=false"},
           {"overhangs.shares=0.25,0.5,0.8,0.9"},
           {"overhangs.feed_factors=1,0.7,0.5,0.45"},
           {"overhangs.flow_factors=1,1,1,1.1"},
           {"overhangs.reverse=true"},
           {"fan.overhang=0.8"}}};
}

SettingProbe bridgeProbe() {
  return {"a plate spans two pillars",
          std::string(kWideBeads) + kFan + ";skins.top_layers=2;skins.bottom_layers=2;bridges.use=true",
          programOf("bridge length_mm=20 width_mm=10 gap_mm=10 pillar_mm=1.2 plate_mm=2.4", ".gcode"),
          {{"bridges.use=false"},
           {"bridges.anchor_mm=2"},
           {"bridges.angle_deg=5", "bridges.least_held=0.1"},
           {"bridges.least_held=1", "bridges.angle_deg=5"},
           {"bridges.flow=0.9"},
           {"bridges.thread=round"},
           {"bridges.thread_mm=0.6", "bridges.thread=round"},
           {"bridges.over_infill=true"},
           {"feed.bridge_mm_s=15"},
           {"fan.bridge=0.7"}}};
}

/// What the summary tells.
SettingProbe longBridgeProbe() {
  return {"a long bridge is told",
          std::string(kWideBeads) + ";bridges.use=true",
          [](const SettingTexts& set) {
            NoProgress nobody;
            const std::string part =
                partFile("bridge length_mm=20 width_mm=10 gap_mm=10 pillar_mm=1.2 plate_mm=1.2");
            const SlicedPart sliced = runSliceJob({part, "", settingsWith<JobSettings>(set)}, nobody);
            return std::to_string(sliced.summary.bridging.too_long);
          },
          {{"bridges.longest_mm=5"}}};
}

}  // namespace

std::vector<SettingProbe> bridgeProbes() { return {overhangProbe(), bridgeProbe(), longBridgeProbe()}; }

}  // namespace lamina::test
