// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// An execution of a job, from its begin on.
struct ExecutionRow {
  std::int64_t id = 0;
  std::int64_t job = 0;
  int attempt = 1;
  double started_s = 0.0;
  std::optional<double> ended_s;
  JobState outcome = JobState::Running;
  std::string reason;
  std::string operator_name;
  ExecutionProgress progress;
};

/// What is known of a layer of a part; nothing where it was not measured or reported.
struct LayerRow {
  std::int32_t layer = 0;
  std::optional<double> began_s;
  std::optional<double> ended_s;
  std::optional<double> expected_mm;  ///< planned top
  std::optional<double> mean_mm;      ///< errors: measured less expected
  std::optional<double> rms_mm;
  std::optional<double> flatness_mm;
  std::optional<double> worst_mm;
  std::optional<double> coverage;  ///< 0 to 1
  std::optional<double> gain;      ///< growth over commanded growth
  std::optional<double> nozzle_c;  ///< at its end
  std::optional<double> bed_c;
  std::optional<std::string> correction;  ///< digest of the map it was deposited by; empty: as planned
};

/// A value that was set, or stood, while a part was made.
struct SetpointRow {
  double time_s = 0.0;
  std::string key;  ///< "feed", "startup.bed"
  double value = 0.0;
  std::string source;  ///< who has set it, or how it was found
};

/// Time in which a job waited: held, suspended or cut off.
struct GapRow {
  double began_s = 0.0;
  std::optional<double> ended_s;
  std::uint64_t line = 0;  ///< taken last before it
  std::string reason;
};

/// An alarm with its end.
struct AlarmRecord {
  AlarmRow alarm;
  std::optional<double> acknowledged_s;
  std::string acknowledged_by;
  std::optional<double> gone_s;
};

/// The part that an execution has made, or what is there of it.
struct PartRow {
  std::string serial;   ///< unlike any other of the journal
  std::string verdict;  ///< "good", "defective", "aborted"
  std::string verdict_by;
  std::optional<double> removed_s;
  std::string removed_by;
  Artefact record;
};

/// What a journal keeps of each execution: its layers, values, gaps, transitions and alarms, and the part.
/// @see CellJournal, which it outlives not
class ExecutionLog {
 public:
  explicit ExecutionLog(CellJournal& journal) : store_(*journal.store_) {}

  /// The last execution of a job; nothing if it was never begun.
  std::optional<ExecutionRow> ofJob(std::int64_t job) const;
  /// @throws InvalidInput if there is none of that number
  ExecutionRow execution(std::int64_t id) const;

  /// The last execution that has ended, if no part was named since; nothing if there is none.
  std::optional<ExecutionRow> lastWithoutPart() const;

  /// Adds to what is known of a layer: what the row does not say stays as it was.
  void setLayer(std::int64_t execution, const LayerRow& row);
  std::vector<LayerRow> layers(std::int64_t execution) const;

  void add(std::int64_t execution, const SetpointRow& row);
  std::vector<SetpointRow> setpoints(std::int64_t execution) const;

  std::vector<GapRow> gaps(std::int64_t execution) const;
  /// From the one that began it on.
  std::vector<TransitionRow> transitions(std::int64_t execution) const;
  std::vector<AlarmRecord> alarms(std::int64_t execution) const;

  /// Names the part of an execution, or what has become of it.
  void setPart(std::int64_t execution, const PartRow& part, double time_s);
  std::optional<PartRow> part(std::int64_t execution) const;
  /// The last part that was not removed yet is now.
  void removePart(const std::string& by, double time_s);

 private:
  CellJournal::Store& store_;
};

}  // namespace lamina
