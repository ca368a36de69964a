// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lamina/journal/cell_journal.hpp"

namespace lamina {

/// An execution of a job, running or ended.
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

/// Data of a layer of a part; nothing where a value was not measured or reported.
struct LayerRow {
  std::int32_t layer = 0;
  std::optional<double> began_s;
  std::optional<double> ended_s;
  std::optional<double> expected_mm;  ///< planned height of the layer's top
  std::optional<double> mean_mm;      ///< mean error: measured less expected, as the errors below
  std::optional<double> rms_mm;
  std::optional<double> flatness_mm;
  std::optional<double> worst_mm;
  std::optional<double> coverage;  ///< 0 to 1
  std::optional<double> gain;      ///< growth measured, over growth commanded
  std::optional<double> nozzle_c;  ///< temperature at the end of the layer
  std::optional<double> bed_c;     ///< temperature at the end of the layer
  /// Digest of the map by which it was corrected; empty if deposited as planned.
  std::optional<std::string> correction;
};

/// A value that was set, or held, while a part was made.
struct SetpointRow {
  double time_s = 0.0;
  std::string key;  ///< "feed", "startup.bed"
  double value = 0.0;
  std::string source;  ///< who has set it, or how it was determined
};

/// A period in which a job waited: held, suspended or cut off.
struct GapRow {
  double began_s = 0.0;
  std::optional<double> ended_s;
  std::uint64_t line = 0;  ///< last line that the machine had taken before it
  std::string reason;
};

/// An alarm, with its acknowledgement and its end.
struct AlarmRecord {
  AlarmRow alarm;
  std::optional<double> acknowledged_s;
  std::string acknowledged_by;
  std::optional<double> gone_s;
};

/// The part that an execution has made, or as much of it as there is.
struct PartRow {
  std::string serial;   ///< unique in the journal
  std::string verdict;  ///< "good", "defective", "aborted"
  std::string verdict_by;
  std::optional<double> removed_s;
  std::string removed_by;
  Artefact record;
};

/// The data that a journal keeps of each execution: its layers, setpoints, gaps, transitions and alarms, and
/// the part. It must not outlive the `CellJournal`.
class ExecutionLog {
 public:
  explicit ExecutionLog(CellJournal& journal) : store_(*journal.store_) {}

  /// The last execution of a job; nothing if none was begun.
  std::optional<ExecutionRow> ofJob(std::int64_t job) const;
  /// The execution of that number.
  /// @throws InvalidInput if there is none
  ExecutionRow execution(std::int64_t id) const;

  /// The last execution that has ended, if it has no part yet; nothing if no execution has ended since the
  /// last one with a part.
  std::optional<ExecutionRow> lastWithoutPart() const;

  /// Adds data of a layer; values that the row does not have stay as they were.
  void setLayer(std::int64_t execution, const LayerRow& row);
  std::vector<LayerRow> layers(std::int64_t execution) const;

  void add(std::int64_t execution, const SetpointRow& row);
  std::vector<SetpointRow> setpoints(std::int64_t execution) const;

  std::vector<GapRow> gaps(std::int64_t execution) const;
  /// The changes of state during an execution, beginning with the one that started it.
  std::vector<TransitionRow> transitions(std::int64_t execution) const;
  std::vector<AlarmRecord> alarms(std::int64_t execution) const;

  /// Adds the part of an execution or, if it has one, replaces that part's verdict and record.
  void setPart(std::int64_t execution, const PartRow& part, double time_s);
  std::optional<PartRow> part(std::int64_t execution) const;
  /// Numbers of the executions that have a part: at most the last `most`, the latest first.
  std::vector<std::int64_t> withPart(std::size_t most) const;
  /// Marks the latest part as removed from the machine. Without effect if it is marked already.
  void removePart(const std::string& by, double time_s);

 private:
  CellJournal::Store& store_;
};

}  // namespace lamina
