// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// Keeps the maps that an execution was corrected by, their record and the toolpath they are of, from the
/// folder in which `gcode_streamer` leaves them (`corrections.folder`).
/// @return what is kept; nothing if the folder's record is of another program, or was not written during the
///   execution
/// @throws FileError if a file cannot be read, or the store not written
std::vector<Artefact> keptCorrections(ArtefactStore& store, const std::string& folder, const QueuedJob& job,
                                      const ExecutionRow& execution);

}  // namespace lamina
