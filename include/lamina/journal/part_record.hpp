// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/journal/artefact_store.hpp"
#include "lamina/journal/execution_log.hpp"

namespace lamina {

/// Record of a part: the files from which it was made, the persons, the events, and the results of its
/// layers. It consists of a JSON text (`docs/cell/part_record.schema.json`) and a CSV table of the layers,
/// both artefacts.
struct PartRecord {
  std::string json;
  std::string layers_csv;
};

/// How a part has turned out, for its record.
struct PartOutcome {
  std::string verdict;  ///< "good", "defective" or "aborted"
  double time_s = 0.0;  ///< time of the record, UTC
  /// Files from which, together with the program, the lines that were sent can be made again.
  std::vector<Artefact> corrections;
};

/// The record of an execution, from what the journal holds now.
/// @throws InvalidInput if there is no such execution
PartRecord partRecord(CellJournal& journal, std::int64_t execution, const PartOutcome& end);

/// Stores the record of an execution and enters its part in the journal, both durably.
void keepRecord(CellJournal& journal, ArtefactStore& store, std::int64_t execution, const PartOutcome& end);

/// A record, and the faults that were found in it or in the files that it names.
struct CheckedRecord {
  PartRecord record;
  std::vector<Artefact> files;      ///< files of the job and its corrections whose digests are right
  std::vector<std::string> faults;  ///< empty if every digest agrees with the journal
};

/// Reads the record of a job and checks all of its digests.
/// @throws InvalidInput if the job has no record
/// @throws FileError if the record itself is missing
CheckedRecord readRecord(CellJournal& journal, const ArtefactStore& store, std::int64_t job);

}  // namespace lamina
