// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/complaints.hpp"

#include "lamina/base/text_search.hpp"

namespace lamina {
Complaint klipperComplaint(std::string_view line) {
  if (startsWith(line, "!!")) return Complaint::Error;
  return startsWith(line, "// Unknown command:") ? Complaint::NotDone : Complaint::None;
}

Complaint reprapComplaint(std::string_view line) {
  if (startsWith(line, "Error:")) return Complaint::Error;
  if (!startsWith(line, "Warning:")) return Complaint::None;
  // "Driver 0 stall", "motor stall reported by driver(s) 0"
  const bool is_stall = contains(line, "stall") && contains(line, "river");
  const bool is_not_done =
      is_stall || contains(line, "Command is not supported") || contains(line, "was not driven");
  return is_not_done ? Complaint::NotDone : Complaint::None;
}

}  // namespace lamina
