// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/cell/cell_time.hpp"
#include "lamina/cell/unit_machine.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// Makes the audit's rows of commands. A command that one source repeats and that is refused each time gets
/// one row a second, so that it fills neither disk nor audit; the next row counts the omitted repetitions.
class CommandAudit {
 public:
  /// The row of a command and its answer; nothing if it is only counted.
  std::optional<AuditRow> rowOf(const UnitRequest& request, const CommandAnswer& answer, CellTime now);

 private:
  /// The last command that was refused, and the number of repetitions that were not written.
  struct Refusal {
    std::string who;
    std::string action;
    double written_s = 0.0;
    std::size_t unwritten = 0;
  };
  Refusal refusal_;
};

}  // namespace lamina
