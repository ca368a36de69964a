// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Reading, placing, planning: what a toolpath over level layers depends on.
#include <filesystem>

#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

constexpr char kCoarse[] = "slicing.layer_height_mm=0.4;slicing.first_layer_height_mm=0.4;bead.width_mm=0.8";

/// A box with a triangle missing.
std::string openBox(const SettingTexts& set) {
  static const ScratchFolder folder;
  const std::string file = folder.file("open.stl");
  if (!std::filesystem::exists(file)) {
    Mesh mesh = makePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "1.2"}});
    mesh.triangles.pop_back();
    writeStl(file, mesh);
  }
  NoProgress nobody;
  return toolpathId(runSliceJob({file, "", settingsWith<JobSettings>(set)}, nobody).toolpath);
}

/// A cylinder of 6 mm radius with faces that are curved.
std::string curvedSolid(const SettingTexts& set) {
  NoProgress nobody;
  const std::string file = std::string(LAMINA_SOURCE_DIR) + "/test/data/cylinder.step";
  return toolpathId(runSliceJob({file, "", settingsWith<JobSettings>(set)}, nobody).toolpath);
}

/// A rectangle that is extruded.
std::string outline(const SettingTexts& set) {
  static const ScratchFolder folder;
  const std::string file = folder.file("plate.svg");
  if (!std::filesystem::exists(file))
    writeFile(file,
              "<svg width='12mm' height='9mm' viewBox='0 0 12 9'><rect x='2' y='2' width='8' "
              "height='5'/></svg>");
  NoProgress nobody;
  return toolpathId(runSliceJob({file, "", settingsWith<JobSettings>(set)}, nobody).toolpath);
}

SettingProbe readingProbe() {
  return {"a box is read and placed",
          kCoarse,
          toolpathOf("box x_mm=8 y_mm=6 z_mm=1.2"),
          {{"input.scale=1.5"},
           {"input.unit=cm"},
           {"part.placement=as_is"},
           {"machine.name=irb_4600"},
           {"machine.urdf=urdf/irb_4600.urdf"},
           {"slicing.layer_height_mm=0.3"},
           {"slicing.first_layer_height_mm=0.3"}}};
}

SettingProbe planningProbe() {
  return {"a box is planned",
          kCoarse,
          toolpathOf("box x_mm=12 y_mm=9 z_mm=2"),
          {{"bead.width_mm=0.6"},
           {"bead.pitch_mm=0.7"},
           {"walls.count=1"},
           {"walls.order=outside_in"},
           {"infill.strategy=hilbert"},
           {"infill.density=0.4"},
           {"infill.bead_width_mm=0.7"},
           {"infill.pitch_mm=1.1"},
           {"infill.outer_layers=1"},
           {"infill.outer_pitch_mm=1.5", "infill.outer_layers=1"},
           {"infill.angle_deg=30"},
           {"infill.alternation_deg=45"},
           {"infill.wall_overlap=0.3"},
           {"infill.every_layers=2", "machine.nozzle_mm=1"},
           {"infill.link=none"},
           {"infill.link_mm=3", "infill.link=up_to_mm"},
           {"skirt.count=2"},
           {"skirt.distance_mm=5"},
           {"seam.placement=rear"},
           {"seam.seed=2", "seam.placement=random"},
           {"travel.feed_mm_s=90"},
           {"travel.hop_mm=0.5"},
           {"travel.retraction_threshold_mm=0.5"},
           {"feed.outer_wall_mm_s=15"},
           {"feed.inner_wall_mm_s=25"},
           {"feed.infill_mm_s=35"},
           {"feed.skirt_mm_s=10"},
           {"feed.first_layer_mm_s=12"},
           {"smoothing.window_mm=1", "infill.density=0.3"},
           {"smoothing.step_mm=0.2", "infill.density=0.3;smoothing.window_mm=1"},
           {"scan.every_layers=2"},
           {"scan.clearance_mm=2", "scan.every_layers=2"},
           {"scan.feed_mm_s=50", "scan.every_layers=2"},
           {"scan.swath_mm=5", "scan.every_layers=2"},
           {"scan.margin_mm=3", "scan.every_layers=2"}}};
}

SettingProbe skinProbe() {
  return {"a pyramid has skins",
          std::string(kCoarse) +
              ";skirt.count=0;skins.top_layers=2;skins.bottom_layers=1;skins.least_infill_mm2=2",
          toolpathOf("pyramid width_mm=24 depth_mm=24 height_mm=2"),
          {{"skins.top_layers=1"},
           {"skins.bottom_layers=2"},
           {"skins.top_mm=1.2"},
           {"skins.bottom_mm=1.2"},
           {"skins.bead_width_mm=0.7"},
           {"skins.strategy=hilbert"},
           {"skins.angle_deg=10"},
           {"skins.narrowest=2"},
           {"skins.anchor_mm=0.2"},
           {"skins.least_infill_mm2=100"},
           {"feed.skin_mm_s=31"},
           {"feed.top_skin_mm_s=21"}}};
}

SettingProbe coolingProbe() {
  return {"a tower cools",
          std::string(kCoarse) + ";skirt.count=0;infill.density=0;cooling.least_layer_time_s=5;fan.use=true",
          toolpathOf("box x_mm=10 y_mm=10 z_mm=2"),
          {{"cooling.least_layer_time_s=8"},
           {"cooling.by=dwell"},
           {"cooling.least_feed_mm_s=14"},
           {"cooling.lift_mm=3", "cooling.by=dwell"},
           {"cooling.park=corner", "cooling.by=dwell"},
           {"fan.use=false"},
           {"fan.off_layers=2"},
           {"fan.least=0.2", "fan.full_below_s=1"},
           {"fan.greatest=0.8"},
           {"fan.full_below_s=1"},
           {"fan.least_at_s=20", "fan.full_below_s=1"},
           {"fan.beyond=none", "fan.full_below_s=1;fan.least_at_s=2"}}};
}

SettingProbe narrowProbe() {
  return {"narrow places are filled",
          std::string(kCoarse) + ";skirt.count=0",
          toolpathOf("pyramid width_mm=10 depth_mm=2 height_mm=2"),
          {{"walls.narrowest=0.9"}, {"raster.narrowest=0.9", "infill.density=1;walls.count=0"}}};
}

SettingProbe refillProbe() {
  return {"voids are refilled",
          "skirt.count=0;walls.count=1;infill.density=1;infill.strategy=hilbert",
          toolpathOf("through_hole_plate x_mm=12 y_mm=12 z_mm=0.2 hole_radius_mm=3 segments=32"),
          {{"voids.refill=beads"}, {"voids.least_area=5", "voids.refill=beads"}}};
}

SettingProbe curvedOutlineProbe() {
  return {"a cylinder's outline is simplified",
          std::string(kCoarse) + ";skirt.count=0;infill.density=1",
          toolpathOf("cylinder radius_mm=6 height_mm=0.8 segments=256"),
          {{"planning.simplification_mm=0.5"}, {"smoothing.tolerance_mm=0.4", "infill.strategy=contour"}}};
}

}  // namespace

std::vector<SettingProbe> sliceProbes() {
  return {
      readingProbe(),
      {"an open box is read", kCoarse, openBox, {{"input.repair=strict"}}},
      {"an outline is read", std::string(kCoarse) + ";input.extrude_mm=1", outline, {{"input.extrude_mm=2"}}},
      {"a curved solid is read",
       std::string(kCoarse) + ";input.deflection_deg=90",
       curvedSolid,
       {{"input.deflection_mm=1"}, {"input.deflection_deg=5"}}},
      planningProbe(),
      skinProbe(),
      coolingProbe(),
      narrowProbe(),
      refillProbe(),
      curvedOutlineProbe()};
}

}  // namespace lamina::test
