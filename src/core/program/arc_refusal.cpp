// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/arc_refusal.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

void refuseArcs(const ProgramSettings& settings, const std::string& where) {
  throw InvalidConfig("program.arcs_tolerance_mm is " + numberText(settings.arcs_tolerance_mm) +
                      " mm; expected 0: there are no arcs in " + where);
}

}  // namespace lamina
