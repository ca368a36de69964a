// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Seen skins, their ironing, and what cools them.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {
namespace {

constexpr char kThickLayers[] = "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;skirt.count=0";

SettingProbe seenSkinProbe() {
  return {"a plate with a pit is seen from above",
          std::string(kThickLayers) + ";skins.top_layers=1;skins.bottom_layers=1;ironing.use=true",
          toolpathOf("blind_hole_plate x_mm=16 y_mm=12 z_mm=2 hole_radius_mm=4 hole_depth_mm=1"),
          {{"skins.monotonic=false"},
           {"ironing.use=false"},
           {"ironing.flow=0.2"},
           {"ironing.spacing_mm=0.2"},
           {"ironing.inset_mm=0.5"},
           {"feed.ironing_mm_s=15"}}};
}

SettingProbe fanProbe() {
  return {"a fan blows harder on what is seen",
          std::string(kThickLayers) + ";skins.top_layers=1;skins.bottom_layers=1;fan.use=true;" +
              "fan.full_below_s=0;fan.least=0.2;fan.least_at_s=1;fan.by_role=top_skin=0.9",
          toolpathOf("box x_mm=10 y_mm=10 z_mm=3"),
          {{"fan.by_role=top_skin=0.8"}, {"fan.spin_up_s=0.3"}}};
}

SettingProbe placeProbe() {
  return {"a place is left alone",
          std::string(kThickLayers) + ";infill.density=0;cooling.by=dwell;cooling.least_layer_time_s=8",
          toolpathOf("box x_mm=10 y_mm=10 z_mm=2"),
          {{"cooling.interval=place"}}};
}

}  // namespace

std::vector<SettingProbe> skinProbes() { return {seenSkinProbe(), fanProbe(), placeProbe()}; }

}  // namespace lamina::test
