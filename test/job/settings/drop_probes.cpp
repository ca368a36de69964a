// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Drops: their fills, their voids and their programs.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/job/voids/drop_void_job.hpp"
#include "support/drop_programs.hpp"

namespace lamina::test {
namespace {

constexpr char kDrops[] =
    "machine.name=drop_printer;infill.strategy=drops_raster;drops.diameter_mm=1;drops.pitch_mm=1;"
    "slicing.layer_height_mm=0.8;slicing.first_layer_height_mm=0.8;skirt.count=0;walls.count=0;infill."
    "density=1;";

constexpr char kRing[] = "through_hole_plate x_mm=20 y_mm=20 z_mm=1.6 hole_radius_mm=7 segments=32";

SettingProbe dropFillProbe() {
  return {"drops",
          kDrops,
          toolpathOf(kRing),
          {{"drops.diameter_mm=0.9"},
           {"drops.pitch_mm=1.2"},
           {"drops.line_spacing_mm=1.3"},
           {"drops.contours=2"},
           {"drops.most_overlap=0.5", "infill.strategy=drops_dense;drops.most_overlap=0"}}};
}

SettingProbe dropVoidProbe() {
  return {"voids between drops",
          std::string(kDrops) + "drops.most_overlap=0",
          toolpathOf(kRing),
          {{"drop_voids.fill=true"},
           {"drop_voids.overlap=0.5", "drop_voids.fill=true"},
           {"drop_voids.definition=area", "drop_voids.fill=true"},
           {"drop_voids.detector=neighbours", "drop_voids.fill=true"},
           {"drop_voids.passes=until_full", "drop_voids.fill=true;drop_voids.overlap=0.5"}}};
}

SettingProbe dropProgramProbe() {
  return {"a program of drops",
          std::string(kDrops) + "drop_voids.fill=true;drop_voids.overlap=0.5",
          programOf(kRing, ".gcode"),
          {{"drop_program.discharge=M42"},
           {"drop_program.layer_mark=SHEET:"},
           {"drop_program.role_mark=ROLE:"},
           {"drop_program.contour=EDGE"},
           {"drop_program.infill=INSIDE"},
           {"drop_program.void_fill=PATCH"},
           {"drop_program.diameter_key=width"},
           {"drop_program.height_key=rise"},
           {"drop_program.strategy_key=fill"},
           {"drop_program.units_key=length"}}};
}

/// Whether two drops more for 160 are worth it.
std::string worthIt(const SettingTexts& set) {
  NoProgress nobody;
  const DropProgram program = parseDropProgram(squareProgram({{4, 4}, {2, 6}}), {});
  const FilledDropProgram filled =
      fillDropProgram(program, settingsWith<JobSettings>(set).drop_voids, {}, nobody);
  return filled.report.is_worth_it ? "worth it" : "not worth it";
}

}  // namespace

std::vector<SettingProbe> dropProbes() {
  return {dropFillProbe(),
          dropVoidProbe(),
          dropProgramProbe(),
          {"whether a program's voids are filled",
           "drop_voids.least_share=0.01",
           worthIt,
           {{"drop_voids.least_share=0.02"}}}};
}

}  // namespace lamina::test
