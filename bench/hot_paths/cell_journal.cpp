// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A journal of ten thousand jobs and a million alarms: how large it is, how long a cell takes to open it,
// check its audit and list its queue.
#include <benchmark/benchmark.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "lamina/base/scratch_folder.hpp"
#include "lamina/journal/cell_journal.hpp"

namespace {

using namespace lamina;

constexpr const char* kYears = R"sql(
BEGIN;
WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 10000)
INSERT INTO job (digest, name, part, machine, state, position, created, created_by)
SELECT hex(randomblob(32)), 'bracket ' || i, 'bracket.stl', 'gantry', CASE WHEN i > 9950 THEN 1 ELSE 5 END, i, i, 'anna' FROM n;
INSERT INTO execution (job, attempt, started, ended, outcome, operator) SELECT id, 1, id, id + 1, 5, 'anna' FROM job WHERE state = 5;
WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 1000000)
INSERT INTO alarm (execution, time, alarm, value, category, message, gone)
SELECT 1 + i % 9950, i, 8003, 0.006, 'W', 'the clock of the sensor is off by 6 ms; expected at most 5 ms', i FROM n;
COMMIT;
)sql";

struct OldJournal {
  ScratchFolder folder;
  std::string path = folder.path() + "/cell.db";

  OldJournal() {
    { const CellJournal journal(path); }
    sqlite3* database = nullptr;
    sqlite3_open(path.c_str(), &database);
    const int result = sqlite3_exec(database, kYears, nullptr, nullptr, nullptr);
    const std::string reason = sqlite3_errmsg(database);
    sqlite3_close(database);
    if (result != SQLITE_OK) throw std::runtime_error(reason);
  }
};

const OldJournal& oldJournal() {
  static const OldJournal journal;
  return journal;
}

void opens(benchmark::State& state) {
  const OldJournal& old = oldJournal();
  for (auto _ : state) {
    const CellJournal journal(old.path);
    benchmark::DoNotOptimize(journal.firstBadAudit());
  }
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(old.path)) / 1e6;
}
BENCHMARK(opens)->Unit(benchmark::kMillisecond);

void listsItsQueue(benchmark::State& state) {
  const CellJournal journal(oldJournal().path);
  for (auto _ : state) benchmark::DoNotOptimize(journal.queue());
  state.counters["jobs"] = static_cast<double>(journal.queue().size());
}
BENCHMARK(listsItsQueue)->Unit(benchmark::kMillisecond);

void addsAnAlarm(benchmark::State& state) {
  CellJournal journal(oldJournal().path);
  for (auto _ : state) {
    journal.add(AlarmRow{1.0, 3202, 20.0, 'H', "vacuum is 20 kPa"});
    journal.acknowledgeAlarm(3202, "anna", 2.0);
    journal.endAlarm(3202, 2.0);
  }
}
BENCHMARK(addsAnAlarm)->Unit(benchmark::kMillisecond);

/// A commit of the progress ten times a second, as a cell makes them of a job that runs: how long each takes.
void commitsProgress(benchmark::State& state) {
  CellJournal journal(oldJournal().path);
  const std::int64_t job = journal.queue().front().id;
  journal.release(job, "anna", 1.0);
  const std::int64_t execution = journal.begin(job, "anna", 1.0);
  std::vector<double> taken_ms;
  ExecutionProgress progress;
  for (auto _ : state) {
    ++progress.taken_through;
    const auto began = std::chrono::steady_clock::now();
    journal.setProgress(execution, progress, 2.0);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - began;
    taken_ms.push_back(taken.count());
    state.SetIterationTime(taken.count() * 1e-3);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  journal.end(execution, JobState::Ended, "", 3.0);
  std::sort(taken_ms.begin(), taken_ms.end());
  const auto at = [&taken_ms](double share) {
    return taken_ms[static_cast<std::size_t>(share * static_cast<double>(taken_ms.size() - 1))];
  };
  state.counters["median_ms"] = at(0.5);
  state.counters["p99_ms"] = at(0.99);
  state.counters["worst_ms"] = at(1.0);
}
BENCHMARK(commitsProgress)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(600);

}  // namespace

BENCHMARK_MAIN();
