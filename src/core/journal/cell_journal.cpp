// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/journal/cell_journal.hpp"

#include <algorithm>
#include <utility>

#include "journal/audit_chain.hpp"
#include "journal/database.hpp"
#include "journal/journal_schema.hpp"
#include "journal/journal_store.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/sha256.hpp"

namespace lamina {
namespace {

constexpr const char* kJobColumns =
    "SELECT id, name, part, machine, digest, state, position, created_by, released_by, layers FROM job ";

Database openDatabase(const std::string& path) {
  Database database(path);
  database.run("PRAGMA journal_mode = WAL");
  database.run("PRAGMA synchronous = FULL");
  database.run("PRAGMA foreign_keys = ON");
  return database;
}

/// The database, with its tables; nothing if it is damaged.
std::optional<Database> openWhole(const std::string& path) {
  try {
    Database database = openDatabase(path);
    if (!isWhole(database)) return std::nullopt;
    return database;
  } catch (const DamagedDatabase&) {
    return std::nullopt;
  }
}

QueuedJob jobIn(const Statement& row) {
  QueuedJob job;
  job.id = row.integer(0);
  job.name = row.text(1);
  job.part = row.text(2);
  job.machine = row.text(3);
  job.digest = row.text(4);
  job.state = static_cast<JobState>(row.integer(5));
  job.position = row.integer(6);
  job.created_by = row.text(7);
  job.released_by = row.text(8);
  job.layers = static_cast<std::int32_t>(row.integer(9));
  return job;
}

}  // namespace

const char* toString(JobState state) {
  switch (state) {
    case JobState::NotAllowedToStart:
      return "NotAllowedToStart";
    case JobState::AllowedToStart:
      return "AllowedToStart";
    case JobState::Running:
      return "Running";
    case JobState::Interrupted:
      return "Interrupted";
    case JobState::Ended:
      return "Ended";
    case JobState::Aborted:
      return "Aborted";
  }
  return "Unknown";
}

std::string jobDigest(const std::vector<Artefact>& artefacts) {
  std::vector<std::string> lines;
  lines.reserve(artefacts.size());
  for (const Artefact& artefact : artefacts) lines.push_back(artefact.kind + ' ' + artefact.sha256 + '\n');
  std::sort(lines.begin(), lines.end());
  std::string text;
  for (const std::string& line : lines) text += line;
  return sha256Of(text);
}

CellJournal::CellJournal(const std::string& path) {
  auto database = openWhole(path);
  if (!database) {
    moved_aside_ = moveAside(path);
    database = openDatabase(path);
  }
  bringUpToDate(*database, path);
  store_ = std::make_unique<Store>(Store{std::move(*database)});
}

CellJournal CellJournal::read(const std::string& path) {
  Database database = Database::toRead(path);
  requireUpToDate(database, path);
  CellJournal journal;
  journal.store_ = std::make_unique<Store>(Store{std::move(database)});
  return journal;
}

CellJournal::CellJournal() = default;
CellJournal::~CellJournal() = default;
CellJournal::CellJournal(CellJournal&&) noexcept = default;
CellJournal& CellJournal::operator=(CellJournal&&) noexcept = default;

std::optional<std::int64_t> CellJournal::Store::openExecution() const {
  Statement row = database.prepare("SELECT id FROM execution WHERE ended IS NULL");
  if (!row.step()) return std::nullopt;
  return row.integer(0);
}

std::optional<JobState> CellJournal::Store::stateOf(std::int64_t id) const {
  Statement row = database.prepare("SELECT state FROM job WHERE id = ? AND is_removed = 0");
  if (!row.bind(id).step()) return std::nullopt;
  return static_cast<JobState>(row.integer(0));
}

void CellJournal::Store::requireState(std::int64_t id, JobState expected, const char* to_do) const {
  const auto found = stateOf(id);
  const std::string job = "job " + std::to_string(id);
  if (!found) throw InvalidInput(job + " is not in the queue");
  if (*found != expected)
    throw InvalidInput(job + " cannot be " + to_do + ": it is " + toString(*found) + "; expected " +
                       toString(expected));
}

void CellJournal::Store::setState(std::int64_t id, JobState state) {
  database.prepare("UPDATE job SET state = ? WHERE id = ?").bind(std::int64_t(state)).bind(id).run();
}

std::int64_t CellJournal::Store::jobOf(std::int64_t execution) const {
  Statement row = database.prepare("SELECT job FROM execution WHERE id = ? AND ended IS NULL");
  if (!row.bind(execution).step())
    throw InvalidInput("execution " + std::to_string(execution) + " is not under way");
  return row.integer(0);
}

void CellJournal::Store::keepArtefact(const Artefact& artefact, double time_s) {
  database
      .prepare("INSERT OR IGNORE INTO artefact (sha256, bytes, kind, name, created) VALUES (?, ?, ?, ?, ?)")
      .bind(artefact.sha256)
      .bind(static_cast<std::int64_t>(artefact.bytes))
      .bind(artefact.kind)
      .bind(artefact.name)
      .bind(time_s)
      .run();
}

void CellJournal::Store::addArtefacts(std::int64_t job, const std::vector<Artefact>& artefacts,
                                      double time_s) {
  for (const Artefact& artefact : artefacts) {
    keepArtefact(artefact, time_s);
    database
        .prepare(
            "INSERT INTO job_artefact (job, artefact, kind, name) SELECT ?, id, ?, ? FROM artefact WHERE "
            "sha256 = ?")
        .bind(job)
        .bind(artefact.kind)
        .bind(artefact.name)
        .bind(artefact.sha256)
        .run();
  }
}

std::vector<Artefact> CellJournal::Store::artefactsOf(std::int64_t job) const {
  Statement rows = database.prepare(
      "SELECT a.sha256, a.bytes, j.kind, j.name FROM job_artefact j JOIN artefact a ON a.id = j.artefact "
      "WHERE j.job = ? ORDER BY j.kind, j.name");
  rows.bind(job);
  std::vector<Artefact> artefacts;
  while (rows.step())
    artefacts.push_back(
        {rows.text(0), static_cast<std::uint64_t>(rows.integer(1)), rows.text(2), rows.text(3)});
  return artefacts;
}

void CellJournal::Store::addAudit(const AuditRow& row) { addAuditRow(database, row); }

std::int64_t CellJournal::addJob(const NewJob& job, double time_s) {
  Transaction transaction(store_->database);
  store_->database
      .prepare(
          "INSERT INTO job (digest, name, part, machine, state, position, created, created_by, layers) "
          "VALUES (?, ?, ?, ?, 1, (SELECT COALESCE(MAX(position), 0) + 1 FROM job), ?, ?, ?)")
      .bind(jobDigest(job.artefacts))
      .bind(job.name)
      .bind(job.part)
      .bind(job.machine)
      .bind(time_s)
      .bind(job.created_by)
      .bind(std::int64_t{job.layers})
      .run();
  const std::int64_t id = store_->database.lastId();
  store_->addArtefacts(id, job.artefacts, time_s);
  store_->addAudit({time_s, job.created_by, "", "add job " + std::to_string(id), "done"});
  transaction.commit();
  return id;
}

std::vector<QueuedJob> CellJournal::queue() const {
  Statement rows = store_->database.prepare(std::string(kJobColumns) +
                                            "WHERE is_removed = 0 AND state <= 4 ORDER BY position, id");
  std::vector<QueuedJob> jobs;
  while (rows.step()) jobs.push_back(jobIn(rows));
  for (QueuedJob& job : jobs) job.artefacts = store_->artefactsOf(job.id);
  return jobs;
}

QueuedJob CellJournal::job(std::int64_t id) const {
  Statement row = store_->database.prepare(std::string(kJobColumns) + "WHERE id = ?");
  if (!row.bind(id).step()) throw InvalidInput("job " + std::to_string(id) + " is not known");
  QueuedJob job = jobIn(row);
  job.artefacts = store_->artefactsOf(id);
  return job;
}

std::optional<QueuedJob> CellJournal::next() const {
  Statement row = store_->database.prepare(
      std::string(kJobColumns) + "WHERE is_removed = 0 AND state = 2 ORDER BY position, id LIMIT 1");
  if (!row.step()) return std::nullopt;
  return job(row.integer(0));
}

void CellJournal::release(std::int64_t id, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  store_->requireState(id, JobState::NotAllowedToStart, "released");
  store_->database.prepare("UPDATE job SET state = 2, released_by = ? WHERE id = ?").bind(by).bind(id).run();
  store_->addAudit({time_s, by, "", "release job " + std::to_string(id), "done"});
  transaction.commit();
}

void CellJournal::revoke(std::int64_t id, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  store_->requireState(id, JobState::AllowedToStart, "revoked");
  store_->database.prepare("UPDATE job SET state = 1, released_by = '' WHERE id = ?").bind(id).run();
  store_->addAudit({time_s, by, "", "revoke job " + std::to_string(id), "done"});
  transaction.commit();
}

void CellJournal::moveToFront(std::int64_t id, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  if (!store_->stateOf(id)) throw InvalidInput("job " + std::to_string(id) + " is not in the queue");
  store_->database.prepare("UPDATE job SET position = (SELECT MIN(position) - 1 FROM job) WHERE id = ?")
      .bind(id)
      .run();
  store_->addAudit({time_s, by, "", "move job " + std::to_string(id) + " to the front", "done"});
  transaction.commit();
}

void CellJournal::moveTo(std::int64_t id, std::int64_t place, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  std::vector<std::int64_t> ids;
  std::vector<std::int64_t> positions;
  const std::vector<QueuedJob> jobs = queue();
  ids.reserve(jobs.size());
  positions.reserve(jobs.size());
  for (const QueuedJob& job : jobs) {
    ids.push_back(job.id);
    positions.push_back(job.position);
  }
  const auto found = std::find(ids.begin(), ids.end(), id);
  if (found == ids.end()) throw InvalidInput("job " + std::to_string(id) + " is not in the queue");
  if (place < 1 || place > static_cast<std::int64_t>(ids.size()))
    throw InvalidInput("job " + std::to_string(id) + " cannot be moved to place " + std::to_string(place) +
                       "; expected 1 to " + std::to_string(ids.size()));
  ids.erase(found);
  ids.insert(ids.begin() + place - 1, id);
  for (std::size_t i = 0; i < ids.size(); ++i)
    store_->database.prepare("UPDATE job SET position = ? WHERE id = ?")
        .bind(positions[i])
        .bind(ids[i])
        .run();
  store_->addAudit(
      {time_s, by, "", "move job " + std::to_string(id) + " to place " + std::to_string(place), "done"});
  transaction.commit();
}

void CellJournal::remove(std::int64_t id, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  const auto state = store_->stateOf(id);
  if (!state) throw InvalidInput("job " + std::to_string(id) + " is not in the queue");
  if (*state == JobState::Running || *state == JobState::Interrupted)
    throw InvalidInput("job " + std::to_string(id) + " cannot be removed: it is " + toString(*state) +
                       "; stop it first");
  store_->database.prepare("UPDATE job SET is_removed = 1 WHERE id = ?").bind(id).run();
  store_->addAudit({time_s, by, "", "remove job " + std::to_string(id), "done"});
  transaction.commit();
}

std::int64_t CellJournal::begin(std::int64_t job, const std::string& by, double time_s) {
  Transaction transaction(store_->database);
  store_->requireState(job, JobState::AllowedToStart, "begun");
  if (const auto running = open())
    throw InvalidInput("job " + std::to_string(job) + " cannot be begun: job " +
                       std::to_string(running->job) + " has not ended");
  store_->database
      .prepare(
          "INSERT INTO execution (job, attempt, started, operator) "
          "VALUES (?, (SELECT COUNT(*) + 1 FROM execution WHERE job = ?), ?, ?)")
      .bind(job)
      .bind(job)
      .bind(time_s)
      .bind(by)
      .run();
  const std::int64_t id = store_->database.lastId();
  store_->setState(job, JobState::Running);
  store_->addAudit({time_s, by, "", "begin job " + std::to_string(job), "done"});
  transaction.commit();
  return id;
}

void CellJournal::setProgress(std::int64_t execution, const ExecutionProgress& progress, double time_s) {
  store_->database
      .prepare(
          "INSERT OR REPLACE INTO progress (execution, sent_through, taken_through, layer, path_mm, "
          "laid_mm3, "
          "updated) VALUES (?, ?, ?, ?, ?, ?, ?)")
      .bind(execution)
      .bind(static_cast<std::int64_t>(progress.sent_through))
      .bind(static_cast<std::int64_t>(progress.taken_through))
      .bind(std::int64_t{progress.layer})
      .bind(progress.path_mm)
      .bind(progress.deposited_mm3)
      .bind(time_s)
      .run();
}

void CellJournal::interrupt(std::int64_t execution, const std::string& reason, double time_s) {
  Transaction transaction(store_->database);
  store_->setState(store_->jobOf(execution), JobState::Interrupted);
  store_->database
      .prepare(
          "INSERT INTO gap (execution, began, line, reason) SELECT ?1, ?2, COALESCE((SELECT taken_through "
          "FROM progress WHERE execution = ?1), 0), ?3 "
          "WHERE NOT EXISTS (SELECT 1 FROM gap WHERE execution = ?1 AND ended IS NULL)")
      .bind(execution)
      .bind(time_s)
      .bind(reason)
      .run();
  store_->database.prepare("UPDATE execution SET reason = ? WHERE id = ?").bind(reason).bind(execution).run();
  store_->addAudit({time_s, "unit", "", "interrupt execution " + std::to_string(execution), reason});
  transaction.commit();
}

void CellJournal::goOn(std::int64_t execution, double time_s) {
  Transaction transaction(store_->database);
  store_->setState(store_->jobOf(execution), JobState::Running);
  // Whoever was killed has not said when the gap began: with the last progress.
  store_->database
      .prepare(
          "INSERT INTO gap (execution, began, line, reason) SELECT execution, updated, taken_through, 'cut "
          "off' "
          "FROM progress WHERE execution = ?1 AND NOT EXISTS (SELECT 1 FROM gap WHERE execution = ?1 AND "
          "ended "
          "IS NULL)")
      .bind(execution)
      .run();
  store_->database.prepare("UPDATE gap SET ended = ? WHERE execution = ? AND ended IS NULL")
      .bind(time_s)
      .bind(execution)
      .run();
  store_->addAudit({time_s, "unit", "", "go on with execution " + std::to_string(execution), "done"});
  transaction.commit();
}

void CellJournal::end(std::int64_t execution, JobState outcome, const std::string& reason, double time_s) {
  Transaction transaction(store_->database);
  store_->setState(store_->jobOf(execution), outcome);
  store_->database.prepare("UPDATE execution SET ended = ?, outcome = ?, reason = ? WHERE id = ?")
      .bind(time_s)
      .bind(std::int64_t(outcome))
      .bind(reason)
      .bind(execution)
      .run();
  store_->addAudit({time_s, "unit", "", "end execution " + std::to_string(execution), toString(outcome)});
  transaction.commit();
}

std::optional<OpenExecution> CellJournal::open() const {
  Statement row = store_->database.prepare(
      "SELECT e.id, e.job, e.attempt, e.started, p.sent_through, p.taken_through, p.layer, p.path_mm, "
      "p.laid_mm3 "
      "FROM execution e LEFT JOIN progress p ON p.execution = e.id WHERE e.ended IS NULL");
  if (!row.step()) return std::nullopt;
  OpenExecution execution{
      row.integer(0), row.integer(1), static_cast<int>(row.integer(2)), row.number(3), {}};
  if (!row.isNull(4))
    execution.progress = {static_cast<std::uint64_t>(row.integer(4)),
                          static_cast<std::uint64_t>(row.integer(5)),
                          static_cast<std::int32_t>(row.integer(6)), row.number(7), row.number(8)};
  return execution;
}

void CellJournal::add(const TransitionRow& row) {
  store_->database
      .prepare(
          "INSERT INTO transition (execution, time, mode, from_state, to_state, command, source, reason) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(store_->openExecution())
      .bind(row.time_s)
      .bind(std::int64_t{row.mode})
      .bind(std::int64_t{row.from})
      .bind(std::int64_t{row.to})
      .bind(std::int64_t{row.command})
      .bind(row.source)
      .bind(row.reason)
      .run();
}

void CellJournal::add(const AlarmRow& row) {
  store_->database
      .prepare(
          "INSERT INTO alarm (execution, time, alarm, value, category, message) VALUES (?, ?, ?, ?, ?, ?)")
      .bind(store_->openExecution())
      .bind(row.time_s)
      .bind(std::int64_t{row.alarm})
      .bind(row.value)
      .bind(std::string(1, row.category))
      .bind(row.message)
      .run();
}

void CellJournal::acknowledgeAlarm(int alarm, const std::string& by, double time_s) {
  store_->database
      .prepare(
          "UPDATE alarm SET acknowledged = ?, acknowledged_by = ? WHERE alarm = ? AND acknowledged IS NULL")
      .bind(time_s)
      .bind(by)
      .bind(std::int64_t{alarm})
      .run();
}

void CellJournal::endAlarm(int alarm, double time_s) {
  store_->database.prepare("UPDATE alarm SET gone = ? WHERE alarm = ? AND gone IS NULL")
      .bind(time_s)
      .bind(std::int64_t{alarm})
      .run();
}

std::optional<AlarmRow> CellJournal::unsettled(int alarm) const {
  // Two questions, each with an index of its own: a journal of years has a million alarms.
  Statement row = store_->database.prepare(
      "SELECT id, time, value, category, message, ifnull(execution, 0) FROM alarm "
      "WHERE alarm = ?1 AND acknowledged IS NULL UNION "
      "SELECT id, time, value, category, message, ifnull(execution, 0) FROM alarm "
      "WHERE alarm = ?1 AND gone IS NULL ORDER BY id DESC LIMIT 1");
  row.bind(std::int64_t{alarm});
  if (!row.step()) return std::nullopt;
  return AlarmRow{row.number(1), alarm, row.number(2), row.text(3).at(0), row.text(4), row.integer(5)};
}

std::vector<TransitionRow> CellJournal::transitions(std::size_t most) const {
  Statement rows = store_->database.prepare(
      "SELECT time, mode, from_state, to_state, command, source, reason FROM transition ORDER BY id DESC "
      "LIMIT ?");
  rows.bind(static_cast<std::int64_t>(most));
  std::vector<TransitionRow> found;
  while (rows.step())
    found.push_back({rows.number(0), static_cast<int>(rows.integer(1)), static_cast<int>(rows.integer(2)),
                     static_cast<int>(rows.integer(3)), static_cast<int>(rows.integer(4)), rows.text(5),
                     rows.text(6)});
  std::reverse(found.begin(), found.end());
  return found;
}

std::vector<AlarmRow> CellJournal::alarms(std::size_t most) const {
  Statement rows = store_->database.prepare(
      "SELECT time, alarm, value, category, message FROM alarm ORDER BY id DESC LIMIT ?");
  rows.bind(static_cast<std::int64_t>(most));
  std::vector<AlarmRow> found;
  while (rows.step())
    found.push_back({rows.number(0), static_cast<int>(rows.integer(1)), rows.number(2), rows.text(3).at(0),
                     rows.text(4)});
  std::reverse(found.begin(), found.end());
  return found;
}

void CellJournal::setCounters(const std::map<std::string, double>& counters) {
  Transaction transaction(store_->database);
  for (const auto& [name, value] : counters)
    store_->database.prepare("INSERT OR REPLACE INTO counter (name, value) VALUES (?, ?)")
        .bind(name)
        .bind(value)
        .run();
  transaction.commit();
}

std::map<std::string, double> CellJournal::counters() const {
  Statement rows = store_->database.prepare("SELECT name, value FROM counter");
  std::map<std::string, double> counters;
  while (rows.step()) counters[rows.text(0)] = rows.number(1);
  return counters;
}

void CellJournal::add(const AuditRow& row) {
  Transaction transaction(store_->database);
  store_->addAudit(row);
  transaction.commit();
}

std::optional<std::int64_t> CellJournal::firstBadAudit() const { return firstBadAuditRow(store_->database); }

void CellJournal::together(const std::function<void()>& changes) {
  Transaction transaction(store_->database);
  changes();
  transaction.commit();
}

void CellJournal::backUp(const std::string& path) const { store_->database.copyTo(path); }

}  // namespace lamina
