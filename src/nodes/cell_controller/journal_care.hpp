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
  double least_free_gib = 2.0;  ///< of the disk; 7002 below
  JournalCopySettings copies;
};

/// An alarm of the journal, or that its cause is gone.
struct CareAlarm {
  int id = 0;
  double value = 0.0;
  std::string message;
  bool is_gone = false;
};

/// Looks after a journal: its audit as the node starts, the room on its disk, its nightly copies, which are
/// made in a thread of their own so that the unit never waits for them.
class JournalCare {
 public:
  JournalCare(const CellJournal& journal, std::string folder, const JournalCareSettings& settings);

  /// What has changed since the last look; cheap within a few seconds of it.
  std::vector<CareAlarm> look(CellTime now);

  /// What stands against Start.
  std::vector<UnmetGuard> againstStart() const;

 private:
  std::vector<CareAlarm> lookAtDisk();
  void followCopy(CellTime now);

  std::string folder_;
  JournalCareSettings settings_;
  std::string broken_audit_;  ///< what is wrong with it; empty if it is whole
  bool is_audit_reported_ = false;
  bool is_disk_low_ = false;
  double looked_s_ = -1e9;
  double tried_s_ = -1e9;
  std::future<std::string> copy_;  ///< what went wrong with it; empty if it was made
};

}  // namespace lamina
