// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Heights of layers that are not equal.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"
#include "lamina/base/atomic_file.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

constexpr char kCone[] = "cone radius_mm=6 top_radius_mm=3 height_mm=4 segments=24";

/// A cone whose heights stand in a table.
std::string fromTable(const SettingTexts& set) {
  static const ScratchFolder folder;
  writeFile(folder.file("low.csv"), "z_mm,height_mm\n1,1\n2,1\n3,1\n4,1\n");
  writeFile(folder.file("high.csv"), "z_mm,height_mm\n2,2\n4,2\n");
  SettingTexts with_file = set;
  for (SettingText& setting : with_file)
    if (setting.key == "slicing.heights_file") setting.text = folder.file(setting.text);
  return toolpathOf(kCone)(with_file);
}

SettingProbe tableProbe() {
  return {"heights from a table",
          "bead.width_mm=1.2;skirt.count=0;slicing.heights=file;slicing.heights_file=low.csv",
          fromTable,
          {{"slicing.heights_file=high.csv"}}};
}

SettingProbe adaptiveProbe() {
  return {"heights that follow slopes",
          "bead.width_mm=0.8;skirt.count=0;slicing.heights=adaptive",
          toolpathOf(kCone),
          {{"slicing.heights=equal"},
           {"adaptive.cusp_mm=0.15"},
           {"adaptive.least_mm=0.2"},
           {"adaptive.greatest_mm=0.14"},
           {"adaptive.greatest_ratio=1.1", "adaptive.cusp_mm=0.15"},
           {"adaptive.quantum_mm=0.05"}}};
}

}  // namespace

std::vector<SettingProbe> heightProbes() { return {tableProbe(), adaptiveProbe()}; }

}  // namespace lamina::test
