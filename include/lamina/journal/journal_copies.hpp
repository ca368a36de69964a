// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

struct JournalCopySettings {
  int hour = 3;  ///< of the day, UTC, from which on its copy is made; -1 for no copies
  int kept = 7;  ///< the last ones
};

/// The name of the copy that is due in a journal's folder: `copies/cell-2026-11-24.db`, once a day from its
/// hour on; empty if there is nothing to do.
/// @param utc_s  since 1970
std::string copyDue(const std::string& folder, double utc_s, const JournalCopySettings& settings);

/// Copies the journal `cell.db` of a folder, also while its cell writes, and removes the oldest copies beyond
/// those to be kept. A copy has its name only when it is whole.
/// @throws FileError if the copy cannot be made; what was begun of it is removed
void copyJournal(const std::string& folder, const std::string& name, int kept);

}  // namespace lamina
