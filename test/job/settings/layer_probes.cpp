// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Layers that are inclined or not plane, and how the nozzle is held over them.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/atomic_file.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

constexpr char kThick[] =
    "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;bead.width_mm=1;walls.count=1;"
    "infill.density=0.5;skirt.count=0;";

SettingProbe inclinedProbe() {
  return {"inclined layers",
          std::string(kThick) +
              "machine.name=cartesian_gantry;slicing.plane.angle_deg=30;slicing.plane.tool_axis=down",
          toolpathOf("box x_mm=12 y_mm=10 z_mm=8"),
          {{"slicing.plane.angle_deg=40"},
           {"slicing.plane.axis_heading_deg=90"},
           {"slicing.plane.tool_axis=normal"},
           {"anchoring.strategy=none"}}};
}

SettingProbe beltProbe() {
  return {"copies on a belt",
          std::string(kThick) + "machine.name=belt_45;slicing.plane.angle_deg=45",
          toolpathOf("box x_mm=8 y_mm=6 z_mm=4"),
          {{"part.copies=2"}, {"part.spacing_mm=20", "part.copies=2"}}};
}

SettingProbe adaptedProbe() {
  return {"adapted layers",
          std::string(kThick) + "slicing.mode=adapted;infill.density=0",
          toolpathOf("cone radius_mm=6 top_radius_mm=8 height_mm=4 segments=64"),
          {{"slicing.mode=planar"},
           {"adapted.step_mm=0.3"},
           {"adapted.smoothing_window=5"},
           {"adapted.computing_height_mm=1.5"},
           {"adapted.max_lean_deg=20"},
           {"walls.contour_offset=0.3"}}};
}

SettingProbe curvedProbe() {
  return {"curved layers",
          std::string(kThick) + "slicing.mode=curved",
          toolpathOf("sphere radius_mm=5 segments=32"),
          {{"curved.normal_limit=0.5"},
           {"curved.longest_edge_mm=2"},

           {"flattening.method=smacof"},
           {"flattening.landmarks=5", "flattening.method=landmark_mds"},
           {"flattening.tolerance=0.02"},
           {"lifting.position_tolerance_mm=0.1"},
           {"lifting.normal_tolerance_deg=0.02"},

           {"lifting.widest_bead=1"}}};
}

SettingProbe gapProbe() {
  return {
      "curved layers that leave gaps",
      std::string(kThick) + "slicing.mode=curved;curved.largest_gap_percent=100;curved.largest_void_mm3=1000",
      toolpathOf("blade points=16 sections=6 chord_mm=20 height_mm=12"),
      {{"curved.largest_gap_percent=1"}, {"curved.largest_void_mm3=0.01"}}};
}

SettingProbe conformalProbe() {
  return {"a coat",
          std::string(kThick) + "slicing.mode=conformal",
          toolpathOf("sphere radius_mm=6 segments=32"),
          {{"conformal.max_tilt_deg=40"},
           {"conformal.direction=1,0,0"},
           {"conformal.thickness_mm=1.5"},
           {"conformal.longest_edge_mm=2"}}};
}

/// A cone whose layers are laid on a box that it goes through.
std::string onBase(const SettingTexts& set) {
  static const std::string box = partFile("box x_mm=30 y_mm=30 z_mm=1");
  SettingTexts with_base = set;
  for (SettingText& setting : with_base)
    if (setting.key == "conformal.base" && setting.text == "box") setting.text = box;
  return toolpathOf("cone radius_mm=8 top_radius_mm=6 height_mm=3 segments=32")(with_base);
}

SettingProbe baseProbe() {
  return {"layers on a base",
          std::string(kThick) + "slicing.mode=conformal;conformal.largest_gap_percent=90",
          onBase,
          {{"conformal.base=box"}, {"conformal.largest_gap_percent=0.001", "conformal.base=box"}}};
}

SettingProbe heightFieldProbe() {
  return {"bent layers",
          std::string(kThick) + "slicing.mode=heightfield",
          toolpathOf("cone radius_mm=8 top_radius_mm=1 height_mm=2 segments=48"),
          {{"lifting.height_tolerance=0.001", "lifting.position_tolerance_mm=1"},
           {"heightfield.cell_mm=0.8"},
           {"heightfield.max_slope_deg=5"},
           {"heightfield.min_thickness=0.9"},
           {"heightfield.max_thickness=1.1"},
           {"heightfield.evenness=0.5"}}};
}

SettingProbe volumetricProbe() {
  return {"volumetric layers",
          std::string(kThick) + "slicing.mode=volumetric;volumetric.cell_mm=0.5",
          toolpathOf("cone radius_mm=3 top_radius_mm=6 height_mm=4 segments=32"),
          {{"volumetric.cell_mm=0.7"},
           {"volumetric.max_overhang_deg=40"},
           {"volumetric.overhang_used_deg=10"},
           {"volumetric.max_thickness=1.05", "volumetric.overhang_used_deg=10"},
           {"volumetric.max_tilt_deg=2"},
           {"volumetric.sink_mm=1"},
           {"volumetric.target=smooth"},
           {"volumetric.rounds=2", "volumetric.target=smooth"},
           {"volumetric.skin_slope_deg=1", "volumetric.target=surface"},
           {"volumetric.deviation_deg=0", "machine.name=five_axis_head_table;volumetric.overhang_used_deg=0"},
           {"volumetric.largest_pendant_percent=1",
            "volumetric.max_tilt_deg=2;volumetric.largest_unsupported_percent=100;"
            "volumetric.largest_pendant_percent=100"},
           {"volumetric.largest_unsupported_percent=1",
            "volumetric.max_tilt_deg=2;volumetric.largest_pendant_percent=100;"
            "volumetric.largest_unsupported_percent=100"},
           {"volumetric.largest_uneven_percent=0",
            "volumetric.max_thickness=1;volumetric.largest_uneven_percent=100"},
           {"volumetric.largest_uncovered_percent=0"}}};
}

/// Volumetric layers across a direction from a table.
std::string acrossTable(const SettingTexts& set) {
  static const ScratchFolder folder;
  writeFile(folder.file("east.csv"), "x,y,z,nx,ny,nz\n0,0,0,1,0,9\n");
  writeFile(folder.file("west.csv"), "x,y,z,nx,ny,nz\n0,0,0,-1,0,9\n");
  SettingTexts with_file = set;
  for (SettingText& setting : with_file)
    if (setting.key == "volumetric.target_file") setting.text = folder.file(setting.text);
  return toolpathOf("cone radius_mm=3 top_radius_mm=6 height_mm=4 segments=32")(with_file);
}

SettingProbe givenProbe() {
  return {"volumetric layers across given directions",
          std::string(kThick) +
              "slicing.mode=volumetric;volumetric.cell_mm=0.5;volumetric.target=given;"
              "volumetric.target_file=east.csv",
          acrossTable,
          {{"volumetric.target_file=west.csv"}, {"volumetric.foot=free"}}};
}

SettingProbe fitProbe() {
  return {"volumetric layers with a fold that the head does not enter",
          std::string(kThick) +
              "slicing.mode=volumetric;volumetric.cell_mm=0.5;volumetric.overhang_used_deg=10;machine.name="
              "five_axis_head_table",
          toolpathOf("bridge length_mm=18 width_mm=6 gap_mm=8 pillar_mm=8 plate_mm=3"),
          {{"volumetric.largest_left_out_percent=10"}}};
}

SettingProbe directionsProbe() {
  return {"pieces along directions of their own",
          std::string(kThick) + "slicing.mode=multi_direction",
          toolpathOf("bridge length_mm=18 width_mm=6 gap_mm=8 pillar_mm=8 plate_mm=3"),
          {{"directions.count=20"},
           {"directions.beam=1"},
           {"directions.most_cuts=1"},
           {"directions.max_tilt_deg=30", "directions.largest_unsupported_percent=100"},
           {"directions.max_overhang_deg=30"},
           {"directions.cell_mm=1.5"},
           {"directions.largest_unsupported_percent=1",
            "directions.most_cuts=0;directions.largest_unsupported_percent=100"}}};
}

SettingProbe automaticProbe() {
  return {
      "a mode chosen by what it leaves unsupported",
      std::string(kThick) + "slicing.mode=auto;machine.name=five_axis_head_table;auto.max_overhang_deg=30",
      toolpathOf("cone radius_mm=3 top_radius_mm=6 height_mm=4 segments=32"),
      {{"auto.good_unsupported_percent=60"},
       {"auto.alike_percent=100"},
       {"auto.longest_time=1", "auto.alike_percent=100"},
       {"auto.max_overhang_deg=40"}}};
}

SettingProbe skinsProbe() {
  return {"a mode chosen by the part's skins",
          std::string(kThick) + "slicing.mode=auto",
          toolpathOf("cone radius_mm=8 top_radius_mm=1 height_mm=2 segments=48"),
          {{"auto.follow_skins=true"}}};
}

SettingProbe orientationProbe() {
  return {"the nozzle's orientation",
          std::string(kThick) + "machine.name=five_axis_head_ac",
          toolpathOf("cone radius_mm=6 top_radius_mm=6.5 height_mm=1 segments=32"),
          {{"orientation.mode=wall"},
           {"orientation.fixed_lean_deg=20", "orientation.mode=fixed"},
           {"orientation.fixed_heading_deg=50", "orientation.mode=fixed;orientation.fixed_lean_deg=20"},
           {"orientation.wall_max_lean_deg=20", "orientation.mode=wall"},
           {"orientation.lead_deg=5"},
           {"orientation.tilt_deg=5"},
           {"orientation.smoothing_window=5", "orientation.lead_deg=5"},
           {"orientation.max_lean_deg=3", "orientation.lead_deg=5"},
           {"orientation.max_turn_deg_per_mm=0.5", "orientation.lead_deg=5"},
           {"orientation.max_off_normal_deg=3", "orientation.lead_deg=5"},
           {"orientation.heading_deg=30"}}};
}

}  // namespace

std::vector<SettingProbe> layerProbes() {
  return {inclinedProbe(),  beltProbe(),       adaptedProbe(),     curvedProbe(),     gapProbe(),
          conformalProbe(), baseProbe(),       heightFieldProbe(), volumetricProbe(), givenProbe(),
          fitProbe(),       directionsProbe(), automaticProbe(),   skinsProbe(),      orientationProbe()};
}

}  // namespace lamina::test
