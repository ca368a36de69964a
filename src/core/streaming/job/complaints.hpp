// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace lamina {

/// What a line of the firmware complains of, by its own words, over a link as by a print server.
enum class Complaint {
  None,
  NotDone,  ///< a command was not run, or a motor has missed steps of it, and the firmware goes on
  Error,    ///< a command was refused, or not run to its end
};

Complaint klipperComplaint(std::string_view line);
Complaint reprapComplaint(std::string_view line);

}  // namespace lamina
