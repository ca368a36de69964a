// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Several tools.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {
namespace {

constexpr char kTwoTools[] =
    "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;skirt.count=0;"
    "tools.list=[{name: a}, {name: "
    "b}];tool.infill=1;skins.top_layers=1;skins.bottom_layers=1;tools.purge_mm3=20";

}  // namespace

std::vector<SettingProbe> toolProbes() {
  return {{"a box by two tools",
           kTwoTools,
           programOf("box x_mm=12 y_mm=9 z_mm=1.6", ".gcode"),
           {{"tool.walls=1"},
            {"tool.support=1", "brim.width_mm=1"},
            {"tool.infill=0"},
            {"tool.skin=1"},
            {"tools.list=[{name: a}, {name: b, offset_mm: [30, 0, 0]}]"},
            {"tools.purge_mm3=40"},
            {"tools.tower_mm=25"},
            {"tools.purge_into_infill=true"},
            {"tools.tower_at_mm=-30,4"},
            {"bead.flow=0.9"},
            {"hooks.tool_change=M117 {tool}"}}},
          {"supports by two tools",
           std::string(kTwoTools) + ";supports.use=true;supports.interface_layers=1",
           programOf("bridge length_mm=12 width_mm=4 gap_mm=8 pillar_mm=2 plate_mm=0.8", ".gcode"),
           {{"tool.interface=1"}}}};
}

}  // namespace lamina::test
