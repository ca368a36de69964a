// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// What is kept of a part: of which files it was made, by whom, what happened meanwhile, and how its layers
/// turned out. A JSON text (`docs/cell/part_record.schema.json`) and a CSV table of its layers, both
/// artefacts.
struct PartRecord {
  std::string json;
  std::string layers_csv;
};

/// How a part has turned out.
struct PartOutcome {
  std::string verdict;                ///< "good", "defective" or "aborted"
  double time_s = 0.0;                ///< UTC, of the record
  std::vector<Artefact> corrections;  ///< with which, and the program, what was sent can be made again
};

/// The record of an execution, as the journal stands.
/// @throws InvalidInput if there is no such execution
PartRecord partRecord(CellJournal& journal, std::int64_t execution, const PartOutcome& end);

/// Keeps the record of an execution and names its part in the journal, both durably.
void keepRecord(CellJournal& journal, ArtefactStore& store, std::int64_t execution, const PartOutcome& end);

/// A record that was read, and what is wrong with it or with the files that it names.
struct CheckedRecord {
  PartRecord record;
  std::vector<Artefact> files;      ///< of the job and its corrections, whose digests are right
  std::vector<std::string> faults;  ///< none if every digest is the one that the journal keeps
};

/// Reads the record of a job and checks all of its digests.
/// @throws InvalidInput if the job has none
/// @throws FileError if the record itself is gone
CheckedRecord readRecord(CellJournal& journal, const ArtefactStore& store, std::int64_t job);

}  // namespace lamina
