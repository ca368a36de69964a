// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What profiles set beside planning: comments of programs, dialects, letters.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/error.hpp"

namespace lamina::test {
namespace {

constexpr char kFlat[] =
    "slicing.layer_height_mm=0.5;slicing.first_layer_height_mm=0.5;bead.width_mm=1;skirt.count=0;";

SettingProbe annotationProbe() {
  return {"comments of a program",
          kFlat,
          programOf("box x_mm=10 y_mm=6 z_mm=1", ".gcode"),
          {{"program.thumbnails=32x16 png"},
           {"program.closing_comments=true"},
           {"program.settings_in_file=true"},
           {"program.progress=true"},
           {"program.accelerations=true"},
           {"material.name=PLA", "program.settings_in_file=true"},
           {"material.density_g_cm3=1.24", "program.closing_comments=true"}}};
}

SettingProbe lettersProbe() {
  return {"letters of rotary joints",
          std::string(kFlat) + "machine.name=five_axis_table_bc;five_axis.use=always",
          programOf("box x_mm=10 y_mm=6 z_mm=1", ".gcode"),
          {{"five_axis.letters=b=U,c=V"}}};
}

/// What settings are refused with that a machine is not capable of.
std::string refusedBy(const SettingTexts& set) {
  try {
    validate(settingsWith<JobSettings>(set));
    return "nothing is refused";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

SettingProbe capabilitiesProbe() {
  return {"what a machine is capable of",
          "fan.use=true;program.nozzle_temperature_c=210;program.bed_temperature_c=60;"
          "slicing.layer_height_mm=0.2;slicing.first_layer_height_mm=0.2",
          refusedBy,
          {{"machine.nozzle_mm=0.15"},
           {"machine.greatest_nozzle_c=200"},
           {"machine.greatest_bed_c=50"},
           {"machine.least_layer_mm=0.25"},
           {"machine.greatest_layer_mm=0.15"},
           {"machine.has_bed_heater=false"},
           {"machine.has_fan=false"}}};
}

}  // namespace

std::vector<SettingProbe> profileProbes() { return {annotationProbe(), lettersProbe(), capabilitiesProbe()}; }

}  // namespace lamina::test
