// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/execution_log.hpp"

#include "journal/journal_store.hpp"
#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr const char* kExecutionColumns =
    "SELECT e.id, e.job, e.attempt, e.started, e.ended, e.outcome, e.reason, e.operator, p.sent_through, "
    "p.taken_through, p.layer, p.path_mm, p.laid_mm3 FROM execution e LEFT JOIN progress p ON p.execution = "
    "e.id ";

ExecutionRow executionIn(const Statement& row) {
  ExecutionRow execution;
  execution.id = row.integer(0);
  execution.job = row.integer(1);
  execution.attempt = static_cast<int>(row.integer(2));
  execution.started_s = row.number(3);
  execution.ended_s = row.optionalNumber(4);
  if (!row.isNull(5)) execution.outcome = static_cast<JobState>(row.integer(5));
  execution.reason = row.text(6);
  execution.operator_name = row.text(7);
  if (row.isNull(8)) return execution;
  execution.progress = {static_cast<std::uint64_t>(row.integer(8)),
                        static_cast<std::uint64_t>(row.integer(9)),
                        static_cast<std::int32_t>(row.integer(10)), row.number(11), row.number(12)};
  return execution;
}

LayerRow layerIn(const Statement& row) {
  LayerRow layer;
  layer.layer = static_cast<std::int32_t>(row.integer(0));
  layer.began_s = row.optionalNumber(1);
  layer.ended_s = row.optionalNumber(2);
  layer.expected_mm = row.optionalNumber(3);
  layer.mean_mm = row.optionalNumber(4);
  layer.rms_mm = row.optionalNumber(5);
  layer.flatness_mm = row.optionalNumber(6);
  layer.worst_mm = row.optionalNumber(7);
  layer.coverage = row.optionalNumber(8);
  layer.gain = row.optionalNumber(9);
  layer.nozzle_c = row.optionalNumber(10);
  layer.bed_c = row.optionalNumber(11);
  if (!row.isNull(12)) layer.correction = row.text(12);
  return layer;
}

}  // namespace

std::optional<ExecutionRow> ExecutionLog::ofJob(std::int64_t job) const {
  Statement row =
      store_.database.prepare(std::string(kExecutionColumns) + "WHERE e.job = ? ORDER BY e.id DESC LIMIT 1");
  if (!row.bind(job).step()) return std::nullopt;
  return executionIn(row);
}

ExecutionRow ExecutionLog::execution(std::int64_t id) const {
  Statement row = store_.database.prepare(std::string(kExecutionColumns) + "WHERE e.id = ?");
  if (!row.bind(id).step()) throw InvalidInput("execution " + std::to_string(id) + " is not known");
  return executionIn(row);
}

std::optional<ExecutionRow> ExecutionLog::lastWithoutPart() const {
  Statement row = store_.database.prepare(std::string(kExecutionColumns) +
                                          "WHERE e.ended IS NOT NULL AND e.id > (SELECT "
                                          "COALESCE(MAX(execution), 0) FROM part) ORDER BY e.id DESC "
                                          "LIMIT 1");
  if (!row.step()) return std::nullopt;
  return executionIn(row);
}

void ExecutionLog::setLayer(std::int64_t execution, const LayerRow& row) {
  Statement statement = store_.database.prepare(
      "INSERT INTO layer (execution, layer, began, ended, expected_mm, mean_mm, rms_mm, flatness_mm, "
      "worst_mm, "
      "coverage, gain, nozzle_c, bed_c, correction) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
      "ON CONFLICT (execution, layer) DO UPDATE SET began = COALESCE(began, excluded.began), "
      "ended = COALESCE(excluded.ended, ended), expected_mm = COALESCE(excluded.expected_mm, expected_mm), "
      "mean_mm = COALESCE(excluded.mean_mm, mean_mm), rms_mm = COALESCE(excluded.rms_mm, rms_mm), "
      "flatness_mm = COALESCE(excluded.flatness_mm, flatness_mm), worst_mm = COALESCE(excluded.worst_mm, "
      "worst_mm), coverage = COALESCE(excluded.coverage, coverage), gain = COALESCE(excluded.gain, gain), "
      "nozzle_c = COALESCE(excluded.nozzle_c, nozzle_c), bed_c = COALESCE(excluded.bed_c, bed_c), "
      "correction = COALESCE(excluded.correction, correction)");
  statement.bind(execution).bind(std::int64_t{row.layer});
  for (const auto& value : {row.began_s, row.ended_s, row.expected_mm, row.mean_mm, row.rms_mm,
                            row.flatness_mm, row.worst_mm, row.coverage, row.gain, row.nozzle_c, row.bed_c})
    statement.bind(value);
  statement.bind(row.correction).run();
}

std::vector<LayerRow> ExecutionLog::layers(std::int64_t execution) const {
  Statement rows = store_.database.prepare(
      "SELECT layer, began, ended, expected_mm, mean_mm, rms_mm, flatness_mm, worst_mm, coverage, gain, "
      "nozzle_c, bed_c, correction FROM layer WHERE execution = ? ORDER BY layer");
  rows.bind(execution);
  std::vector<LayerRow> layers;
  while (rows.step()) layers.push_back(layerIn(rows));
  return layers;
}

void ExecutionLog::add(std::int64_t execution, const SetpointRow& row) {
  store_.database.prepare("INSERT INTO setpoint (execution, time, key, value, source) VALUES (?, ?, ?, ?, ?)")
      .bind(execution)
      .bind(row.time_s)
      .bind(row.key)
      .bind(row.value)
      .bind(row.source)
      .run();
}

std::vector<SetpointRow> ExecutionLog::setpoints(std::int64_t execution) const {
  Statement rows = store_.database.prepare(
      "SELECT time, key, value, source FROM setpoint WHERE execution = ? ORDER BY time, id");
  rows.bind(execution);
  std::vector<SetpointRow> found;
  while (rows.step()) found.push_back({rows.number(0), rows.text(1), rows.number(2), rows.text(3)});
  return found;
}

std::vector<GapRow> ExecutionLog::gaps(std::int64_t execution) const {
  Statement rows = store_.database.prepare(
      "SELECT began, ended, line, reason FROM gap WHERE execution = ? ORDER BY began, id");
  rows.bind(execution);
  std::vector<GapRow> gaps;
  while (rows.step())
    gaps.push_back(
        {rows.number(0), rows.optionalNumber(1), static_cast<std::uint64_t>(rows.integer(2)), rows.text(3)});
  return gaps;
}

std::vector<TransitionRow> ExecutionLog::transitions(std::int64_t execution) const {
  // The change to Starting is written before the execution that it begins.
  Statement rows = store_.database.prepare(
      "SELECT time, mode, from_state, to_state, command, source, reason FROM transition WHERE execution = ?1 "
      "OR id = (SELECT MAX(id) FROM transition WHERE to_state = 3 AND execution IS NULL AND id < (SELECT "
      "MIN(id) FROM transition WHERE execution = ?1)) ORDER BY id");
  rows.bind(execution);
  std::vector<TransitionRow> found;
  while (rows.step())
    found.push_back({rows.number(0), static_cast<int>(rows.integer(1)), static_cast<int>(rows.integer(2)),
                     static_cast<int>(rows.integer(3)), static_cast<int>(rows.integer(4)), rows.text(5),
                     rows.text(6)});
  return found;
}

std::vector<AlarmRecord> ExecutionLog::alarms(std::int64_t execution) const {
  Statement rows = store_.database.prepare(
      "SELECT time, alarm, value, category, message, acknowledged, acknowledged_by, gone FROM alarm WHERE "
      "execution = ? ORDER BY time, id");
  rows.bind(execution);
  std::vector<AlarmRecord> found;
  while (rows.step())
    found.push_back({{rows.number(0), static_cast<int>(rows.integer(1)), rows.number(2), rows.text(3).at(0),
                      rows.text(4)},
                     rows.optionalNumber(5),
                     rows.text(6),
                     rows.optionalNumber(7)});
  return found;
}

void ExecutionLog::setPart(std::int64_t execution, const PartRow& part, double time_s) {
  Transaction transaction(store_.database);
  store_.keepArtefact(part.record, time_s);
  store_.database
      .prepare(
          "INSERT INTO part (execution, serial, verdict, verdict_by, removed, removed_by, record) VALUES (?, "
          "?, "
          "?, ?, ?, ?, ?) ON CONFLICT (execution) DO UPDATE SET verdict = excluded.verdict, verdict_by = "
          "excluded.verdict_by, record = excluded.record")
      .bind(execution)
      .bind(part.serial)
      .bind(part.verdict)
      .bind(part.verdict_by)
      .bind(part.removed_s)
      .bind(part.removed_by)
      .bind(part.record.sha256)
      .run();
  transaction.commit();
}

std::vector<std::int64_t> ExecutionLog::withPart(std::size_t most) const {
  Statement row = store_.database.prepare("SELECT execution FROM part ORDER BY execution DESC LIMIT ?");
  row.bind(static_cast<std::int64_t>(most));
  std::vector<std::int64_t> executions;
  while (row.step()) executions.push_back(row.integer(0));
  return executions;
}

std::optional<PartRow> ExecutionLog::part(std::int64_t execution) const {
  Statement row = store_.database.prepare(
      "SELECT p.serial, p.verdict, p.verdict_by, p.removed, p.removed_by, p.record, a.bytes, a.kind, a.name "
      "FROM "
      "part p JOIN artefact a ON a.sha256 = p.record WHERE p.execution = ?");
  if (!row.bind(execution).step()) return std::nullopt;
  return PartRow{
      row.text(0), row.text(1),
      row.text(2), row.optionalNumber(3),
      row.text(4), {row.text(5), static_cast<std::uint64_t>(row.integer(6)), row.text(7), row.text(8)}};
}

void ExecutionLog::removePart(const std::string& by, double time_s) {
  store_.database
      .prepare(
          "UPDATE part SET removed = ?, removed_by = ? WHERE removed IS NULL AND execution = (SELECT "
          "MAX(execution) FROM part)")
      .bind(time_s)
      .bind(by)
      .run();
}

}  // namespace lamina
