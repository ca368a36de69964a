// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <future>
#include <string>
#include <vector>

#include "lamina/cell/guards.hpp"
#include "lamina/cell/production_cell.hpp"
#include "lamina/journal/journal_copies.hpp"

namespace lamina {

struct JournalCareSettings {
  double least_free_gib = 2.0;  ///< free space of the disk; less raises alarm 7002
  JournalCopySettings copies;
};

/// An alarm of the journal, or that its cause is gone.
struct CareAlarm {
  int id = 0;
  double value = 0.0;
  std::string message;
  bool is_gone = false;
};

/// Maintains a journal: checks the audit when the node starts, watches the free space of the disk, and makes
/// nightly copies in a separate thread, for which the unit never waits.
class JournalCare {
 public:
  JournalCare(const CellJournal& journal, std::string folder, const JournalCareSettings& settings);

  /// Changes since the last call; cheap if called again within a few seconds.
  std::vector<CareAlarm> look(CellTime now);

  /// Conditions that prevent Start.
  std::vector<UnmetGuard> againstStart() const;

 private:
  std::vector<CareAlarm> lookAtDisk();
  void followCopy(CellTime now);

  std::string folder_;
  JournalCareSettings settings_;
  std::string broken_audit_;  ///< fault of the audit; empty if it is intact
  bool is_audit_reported_ = false;
  bool is_disk_low_ = false;
  double looked_s_ = -1e9;
  double tried_s_ = -1e9;
  std::future<std::string> copy_;  ///< fault of the copy; empty if it was made
};

}  // namespace lamina
