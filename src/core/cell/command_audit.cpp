// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/command_audit.hpp"

namespace lamina {
namespace {

constexpr double kRefusalInterval = 1.0;  // [s] between two rows of one refused command

}  // namespace

std::optional<AuditRow> CommandAudit::rowOf(const UnitRequest& request, const CommandAnswer& answer,
                                            CellTime now) {
  const std::string action = toString(request.command);
  const bool is_refused = answer.result != CommandResult::Accepted;
  const bool is_repeated = is_refused && refusal_.who == request.source && refusal_.action == action &&
                           now.steady_s - refusal_.written_s < kRefusalInterval;
  if (is_repeated) {
    ++refusal_.unwritten;
    return std::nullopt;
  }
  const std::string more = refusal_.unwritten > 0
                               ? " (before it, " + refusal_.action + " of '" + refusal_.who +
                                     "' was refused " + std::to_string(refusal_.unwritten) + " times more)"
                               : "";
  refusal_ = is_refused ? Refusal{request.source, action, now.steady_s, 0} : Refusal{};
  return AuditRow{now.utc_s, request.source, "", action, (is_refused ? answer.reason : "accepted") + more};
}

}  // namespace lamina
