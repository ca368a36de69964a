// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace lamina {

/// The kind of complaint in a line of the firmware, received over a link or from a print server.
enum class Complaint {
  None,
  NotDone,  ///< a command was not run, or a motor missed steps; the firmware continues
  Error,    ///< a command was refused, or not run to its end
};

Complaint klipperComplaint(std::string_view line);
Complaint reprapComplaint(std::string_view line);

}  // namespace lamina
