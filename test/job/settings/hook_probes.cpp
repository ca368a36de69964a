// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Code of the user's own, and pauses.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {
namespace {

constexpr char kHookedLayers[] =
    "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;skirt.count=0";
constexpr char kHookedPart[] = "box x_mm=8 y_mm=6 z_mm=1.6";

SettingProbe hookProbe() {
  return {"a box with hooks",
          kHookedLayers,
          programOf(kHookedPart, ".gcode"),
          {{"hooks.part_start=M117 begins"},
           {"hooks.part_end=M117 ends"},
           {"hooks.layer_start=M117 {layer}"},
           {"hooks.layer_end=M400"},
           {"hooks.pause=M300", "pause.at_layers=2"},
           {"hooks.before_role={infill: M204 S500}"},
           {"hooks.after_role={infill: M204 S900}"},
           {"hooks.at_layer={1: M117 nuts}"},
           {"hooks.at_height_mm={0.8: M117 nuts}"},
           {"hooks.moves=true", "hooks.layer_end=M400"}}};
}

SettingProbe pauseProbe() {
  return {"a box with pauses",
          kHookedLayers,
          programOf(kHookedPart, ".gcode"),
          {{"pause.at_layers=1,3"}, {"pause.at_heights_mm=0.8"}, {"pause.code=M600", "pause.at_layers=1"}}};
}

}  // namespace

std::vector<SettingProbe> hookProbes() { return {hookProbe(), pauseProbe()}; }

}  // namespace lamina::test
