// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <string>

#include "messages.hpp"

namespace lamina {

/// State of the connection between PLC and unit.
struct PlcReach {
  bool is_unit_here = false;      ///< whether the unit reports
  std::string last_refusal;       ///< last refused request of the PLC; empty if none was refused
  std::string last_break;         ///< why a connection was closed last; empty if none was
  std::size_t broken_frames = 0;  ///< number of connections closed because of invalid frames
};

/// The link: OK, or a warning if the unit is silent or no heartbeat has come yet, or an error if the
/// heartbeat is lost.
void fillDiagnostics(const lamina_msgs::PlcInputs& said, const PlcReach& reach,
                     diagnostic_updater::DiagnosticStatusWrapper& diagnostics);

}  // namespace lamina
