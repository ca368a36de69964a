// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/flow/flow_settings.hpp"

#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "planning/flow/role_advances.hpp"

namespace lamina {

void describe(SettingsSchema& schema, FlowSettings& flow) {
  schema.number("flow.greatest_mm3_s", flow.greatest_mm3_s, {0.0, 1e6},
                "Greatest volume per time that is deposited; feeds are lowered to it; 0 for no limit.");
  schema.number("flow.greatest_slope_mm3_s2", flow.greatest_slope_mm3_s2, {0.0, 1e9},
                "Greatest change of that along a run, per time; 0 for no limit.");
  schema.number("flow.coast_mm3", flow.coast_mm3, {0.0, 1e6},
                "Volume at the end of each run that is not pushed; 0 for none.");
  schema.number("flow.coast_longest_mm", flow.coast_longest_mm, {0.0, 1000.0},
                "Longest way that is deposited so; at most half the run.");
  schema.number("flow.advance_s", flow.advance_s, {0.0, 10.0},
                "Pressure advance that is sent to the firmware; 0 leaves it alone.");
  schema.text("flow.advance_by_role", flow.advance_by_role,
              "Roles that have another, as 'outer_wall=0.04, infill=0.06'.");
  schema.choice<AdvanceWord>("flow.advance_word", flow.advance_word,
                             {{"dialect", AdvanceWord::Dialect},
                              {"marlin", AdvanceWord::Marlin},
                              {"klipper", AdvanceWord::Klipper},
                              {"reprapfirmware", AdvanceWord::RepRapFirmware}},
                             "Firmware by whose word it is sent; dialect for that of program.dialect.");
  schema.number("flow.lag_s", flow.lag_s, {0.0, 100.0},
                "Time constant by which the flow follows what is pushed, made up for in the program.");
  schema.number("flow.dead_time_s", flow.dead_time_s, {0.0, 100.0},
                "Time before the flow follows at all, made up for likewise.");
}

void requireConsistent(const FlowSettings& flow) {
  advancesOf(flow);
  const bool makes_up = flow.lag_s > 0.0 || flow.dead_time_s > 0.0;
  if (!hasAdvance(flow) || !makes_up) return;
  throw InvalidConfig(
      "flow.advance_s is " + numberText(flow.advance_s) + " s with flow.lag_s " + numberText(flow.lag_s) +
      " s and flow.dead_time_s " + numberText(flow.dead_time_s) +
      " s; expected 0 for one of them: either the firmware or the program makes up for a lag");
}

}  // namespace lamina
