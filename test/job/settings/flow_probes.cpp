// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// First layer, compensation, flow, ways of travels; starts, leads, entries, process values and weaving of
// runs.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {
namespace {

constexpr char kBroad[] =
    "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8;skirt.count=0";

SettingProbe firstLayerProbe() {
  return {"the first layer is another",
          kBroad,
          toolpathOf("box x_mm=12 y_mm=9 z_mm=2"),
          {{"first_layer.width_factor=1.2"},
           {"first_layer.feed_factor=0.5"},
           {"first_layer.flow=1.1"},
           {"first_layer.nozzle_temperature_c=215"},
           {"first_layer.bed_temperature_c=65"},
           {"first_layer.inset_mm=0.2"},
           {"first_layer.inset_layers=3", "first_layer.inset_mm=0.2"}}};
}

SettingProbe compensationProbe() {
  return {"a plate with a hole is compensated",
          kBroad,
          toolpathOf("through_hole_plate x_mm=12 y_mm=12 z_mm=0.8 hole_radius_mm=3 segments=32"),
          {{"compensation.outline_mm=0.1"},
           {"compensation.holes_mm=0.1"},
           {"compensation.least_hole_mm=5", "compensation.holes_mm=0.1"},
           {"compensation.shrink_xy=0.01"},
           {"compensation.shrink_z=0.3"}}};
}

SettingProbe flowProbe() {
  return {"the flow is kept within limits",
          std::string(kBroad) + ";infill.density=1",
          toolpathOf("pyramid width_mm=12 depth_mm=12 height_mm=2"),
          {{"flow.greatest_mm3_s=4"},
           {"flow.greatest_slope_mm3_s2=5"},
           {"flow.coast_mm3=0.2"},
           {"flow.coast_longest_mm=0.3", "flow.coast_mm3=0.2"},
           {"flow.advance_s=0.05"},
           {"flow.advance_word=klipper", "flow.advance_s=0.05"},
           {"flow.advance_by_role=outer_wall=0.06", "flow.advance_s=0.05"},
           {"flow.lag_s=0.05"},
           {"flow.dead_time_s=0.02"}}};
}

SettingProbe wayProbe() {
  return {"travels keep inside",
          std::string(kBroad) + ";infill.density=0;travel.comb=inside;travel.retraction_threshold_mm=0.1",
          toolpathOf("through_hole_plate x_mm=12 y_mm=12 z_mm=0.8 hole_radius_mm=3 segments=32"),
          {{"travel.comb=none"},
           {"travel.keep_off_mm=0.5"},
           {"travel.comb_longest_mm=0.5"},
           {"travel.comb_detour=1.001"},
           {"travel.hop=never", "travel.comb=none"},
           {"travel.wipe_mm=2", "travel.comb=none"},
           {"travel.wipe_share=0.2", "travel.comb=none;travel.wipe_mm=2"}}};
}

SettingProbe skinWayProbe() {
  return {
      "travels keep off top skins",
      std::string(kBroad) + ";skins.top_layers=1;skins.bottom_layers=0;travel.retraction_threshold_mm=0.1",
      toolpathOf("pyramid width_mm=24 depth_mm=24 height_mm=2"),
      {{"travel.comb=no_skin", "travel.comb=inside"}, {"travel.hop=over_skin"}}};
}

constexpr char kRuns[] =
    "slicing.layer_height_mm=0.8;slicing.first_layer_height_mm=0.8;bead.width_mm=1.6;skirt.count=0;"
    "walls.count=1;infill.density=0;feed.outer_wall_mm_s=8";
constexpr char kRunPart[] = "box x_mm=24 y_mm=18 z_mm=2.4";

SettingProbe leadProbe() {
  return {"leads of walls",
          std::string(kRuns) + ";lead.in=line;lead.length_mm=6",
          toolpathOf(kRunPart),
          {{"lead.in=arc"},
           {"lead.in=loop"},
           {"lead.out=line"},
           {"lead.length_mm=4"},
           {"lead.angle_deg=45"},
           {"lead.rise_deg=20"},
           {"lead.radius_mm=3", "lead.in=arc"},
           {"lead.sweep_deg=45", "lead.in=arc"},
           {"lead.process=bead"},
           {"lead.overlap_mm=5"},
           {"lead.overlap_mm=-0.5"}}};
}

SettingProbe leadRoomProbe() {
  return {"leads within a hole",
          std::string(kRuns) + ";lead.in=line;lead.length_mm=20;lead.angle_deg=90",
          toolpathOf("through_hole_plate x_mm=24 y_mm=24 z_mm=1.6 hole_radius_mm=5 segments=32"),
          {{"lead.least_mm=12"}}};
}

SettingProbe runStartProbe() {
  return {"starts and entries of walls",
          std::string(kRuns) + ";starts.rule=golden;entry.distance_mm=3",
          toolpathOf(kRunPart),
          {{"starts.rule=opposite"},
           {"starts.first_share=0.3"},
           {"entry.distance_mm=5"},
           {"entry.feed_mm_s=4"},
           {"entry.direction=tangent"},
           {"entry.direction=level",
            "slicing.plane.angle_deg=45;starts.rule=keep;machine.name=large_gantry_45"}}};
}

SettingProbe levelProbe() {
  return {"process values of walls",
          std::string(kRuns) +
              ";levels.values=laser_power_w=1000, wire_speed_mm_s=from_bead;levels.start_mm=4;"
              "levels.start_share=0.6;levels.end_mm=3;levels.end_share=0.5",
          toolpathOf(kRunPart),
          {{"levels.values=laser_power_w=900"},
           {"levels.wire_diameter_mm=1"},
           {"levels.start_share=0.7"},
           {"levels.start_mm=5"},
           {"levels.end_share=0.4"},
           {"levels.channels={laser_power_w: {dead_time_s: 0.3}}"},
           {"levels.rules=[{when: {role: outer_wall}, set: {laser_power_w: 1500}}]"},
           {"levels.end_mm=2"}}};
}

SettingProbe weaveProbe() {
  return {"walls are woven",
          std::string(kRuns) + ";weave.kind=sine;weave.amplitude_mm=0.7;weave.wavelength_mm=3",
          toolpathOf(kRunPart),
          {{"weave.kind=zigzag"},
           {"weave.kind=circle"},
           {"weave.kind=eight"},
           {"weave.swing_deg=10", "machine.name=irb_4600"},
           {"weave.amplitude_mm=0.5"},
           {"weave.wavelength_mm=4"},
           {"weave.flat_share=0.1", "weave.kind=trapezium"},
           {"weave.left_s=0.2"},
           {"weave.right_s=0.2"},
           {"weave.feed=tip"},
           {"weave.tolerance_mm=0.005"}}};
}

}  // namespace

std::vector<SettingProbe> flowProbes() {
  return {firstLayerProbe(), compensationProbe(), flowProbe(), wayProbe(), skinWayProbe()};
}

std::vector<SettingProbe> runProbes() {
  return {leadProbe(), leadRoomProbe(), runStartProbe(), levelProbe(), weaveProbe()};
}

}  // namespace lamina::test
