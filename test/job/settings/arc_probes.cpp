// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Arcs in programs.
#include "job/settings/setting_probe.hpp"
#include "job/settings/sliced_text.hpp"

namespace lamina::test {

std::vector<SettingProbe> arcProbes() {
  return {{"a cylinder by arcs",
           "bead.width_mm=0.8;skirt.count=0;infill.density=0",
           programOf("cylinder radius_mm=6 height_mm=1 segments=90", ".gcode"),
           {{"program.arcs_tolerance_mm=0.05"}}}};
}

}  // namespace lamina::test
