// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace lamina {

/// How often the journal is copied.
struct JournalCopySettings {
  int hour = 3;  ///< of the day, UTC, from which on the day's copy is due; -1 for no copies
  int kept = 7;  ///< number of copies that are kept, the latest ones
};

/// The name of the copy that is due, in a journal's folder: `copies/cell-2026-11-24.db`. A copy is due if
/// there is none of the present day, which lasts from `hour` to the same hour of the next day; otherwise the
/// name is empty.
/// @param utc_s  since 1970
std::string copyDue(const std::string& folder, double utc_s, const JournalCopySettings& settings);

/// Copies the journal `cell.db` of a folder, also while its cell writes, and removes the oldest copies beyond
/// those to be kept. A copy gets its name only once it is complete.
/// @throws FileError if the copy cannot be made; an incomplete copy is removed
void copyJournal(const std::string& folder, const std::string& name, int kept);

}  // namespace lamina
