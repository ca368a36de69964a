// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/complaints.hpp"

namespace lamina {
namespace {

bool hasAtStart(std::string_view line, std::string_view text) { return line.substr(0, text.size()) == text; }
bool holds(std::string_view line, std::string_view text) { return line.find(text) != std::string_view::npos; }

}  // namespace

Complaint klipperComplaint(std::string_view line) {
  if (hasAtStart(line, "!!")) return Complaint::Error;
  return hasAtStart(line, "// Unknown command:") ? Complaint::NotDone : Complaint::None;
}

Complaint reprapComplaint(std::string_view line) {
  if (hasAtStart(line, "Error:")) return Complaint::Error;
  if (!hasAtStart(line, "Warning:")) return Complaint::None;
  // "Driver 0 stall", "motor stall reported by driver(s) 0"
  const bool is_stall = holds(line, "stall") && holds(line, "river");
  const bool is_not_done =
      is_stall || holds(line, "Command is not supported") || holds(line, "was not driven");
  return is_not_done ? Complaint::NotDone : Complaint::None;
}

}  // namespace lamina
