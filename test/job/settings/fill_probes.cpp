// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Infill strategies, each over a small part.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {
namespace {

constexpr char kPlain[] =
    "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;bead.width_mm=1;walls.count=0;"
    "skirt.count=0;infill.density=1;";

SettingProbe rasterProbe() {
  return {"a raster",
          kPlain,
          toolpathOf("through_hole_plate x_mm=24 y_mm=16 z_mm=1 hole_radius_mm=5 segments=32"),
          {{"raster.direction=fewest_turns"},
           {"raster.longest_connection_mm=0"},
           {"raster.most_connection=0.5"}}};
}

SettingProbe hybridProbe() {
  return {"a hybrid fill",
          std::string(kPlain) + "infill.strategy=hybrid;infill.density=0.5",
          toolpathOf("cylinder radius_mm=9 height_mm=2 segments=48"),
          {{"hybrid.lines=metal"},
           {"raster.order=ends"},
           {"hybrid.longitudinal=two_pass", "hybrid.lines=metal"},
           {"hybrid.grid_x_mm=0.7", "hybrid.lines=metal"},
           {"hybrid.grid_y_mm=0.7", "hybrid.lines=metal;infill.angle_deg=90"},
           {"hybrid.perimeter_step=1", "hybrid.lines=metal;hybrid.longitudinal=two_pass"},
           {"hybrid.add_above=3", "hybrid.lines=metal"},
           {"hybrid.delete_below=2.9", "hybrid.lines=metal;hybrid.add_above=3"},
           {"hybrid.approach=1.4", "hybrid.lines=metal"},
           {"hybrid.curve_points=6", "hybrid.lines=metal"},
           {"hybrid.end_margin=1.5", "hybrid.lines=metal"},
           {"hybrid.extra_perimeter_every=2"}}};
}

SettingProbe perimetersProbe() {
  return {"perimeters",
          std::string(kPlain) + "infill.strategy=perimeters",
          toolpathOf("box x_mm=12 y_mm=8 z_mm=2"),
          {{"perimeters.count=2"},
           {"perimeters.offset=normals"},
           {"perimeters.order=inside_out"},
           {"perimeters.first_inset=1"},
           {"perimeters.end_gap=0"},
           {"perimeters.seam=random"},
           {"perimeters.seam_step=5"},
           {"perimeters.seed=2", "perimeters.seam=random"}}};
}

SettingProbe otherFillsProbe() {
  return {"other fills",
          kPlain,
          toolpathOf("through_hole_plate x_mm=24 y_mm=16 z_mm=1.5 hole_radius_mm=4 segments=32"),
          {{"contour.link=tangential", "infill.strategy=contour"},
           {"contour.seed=2", "infill.strategy=contour"},
           {"hilbert.angles=5", "infill.strategy=hilbert;infill.density=0.5"}}};
}

SettingProbe vaseProbe() {
  return {"a vase",
          std::string(kPlain) + "infill.strategy=vase;infill.density=0.2",
          toolpathOf("box x_mm=12 y_mm=8 z_mm=4"),
          {{"vase.base_layers=2"}, {"vase.base_strategy=hilbert"}}};
}

SettingProbe lightningProbe() {
  return {"branches under a roof",
          "skins.top_layers=2;infill.strategy=lightning;infill.density=0.2",
          toolpathOf("box x_mm=20 y_mm=20 z_mm=4"),
          {{"lightning.angle_deg=20"}}};
}

}  // namespace

std::vector<SettingProbe> fillProbes() {
  return {rasterProbe(), hybridProbe(), perimetersProbe(), otherFillsProbe(), vaseProbe(), lightningProbe()};
}

}  // namespace lamina::test
