// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "journal/database.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// The database of a journal, with what several of its statements share.
struct CellJournal::Store {
  mutable Database database;

  void requireState(std::int64_t id, JobState expected, const char* to_do) const;
  void setState(std::int64_t id, JobState state);
  std::int64_t jobOf(std::int64_t execution) const;
  void addAudit(const AuditRow& row);
  void addArtefacts(std::int64_t job, const std::vector<Artefact>& artefacts, double time_s);
  void keepArtefact(const Artefact& artefact, double time_s);
  std::vector<Artefact> artefactsOf(std::int64_t job) const;
  std::optional<JobState> stateOf(std::int64_t id) const;
  std::optional<std::int64_t> openExecution() const;
};

}  // namespace lamina
