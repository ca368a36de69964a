// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Run by mpirun with different numbers of processes; the exit code reports.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include "lamina/base/error.hpp"
#include "lamina/optimisation/nsga2.hpp"
#include "mpi_evaluator.hpp"
#include "optimisation/test_problems.hpp"

namespace lamina {
namespace {

int faults = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  ++faults;
  std::fprintf(stderr, "fault: %s\n", what);
}

/// Fails above a pitch of 2; a pitch of exactly 0.3 takes until it is cancelled.
std::vector<double> measured(const DesignPoint& point, Progress& progress) {
  while (point[0] == 0.3) {
    throwIfCancelled(progress, "measure");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  if (point[0] > 2.0) throw InvalidInput("too wide");
  return {(10.0 + point[1]) / (point[0] * point[2]) + point[3],
          (1.0 + point[0]) * (1.0 + point[2]) / point[1] + 0.1 * (1.0 - point[3])};
}

/// Cancels once a point was reported.
class CancelledSoon final : public Progress {
 public:
  explicit CancelledSoon(const std::atomic<int>& reported) : reported_(reported) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return reported_ > 0; }

 private:
  const std::atomic<int>& reported_;
};

template <class ErrorType>
bool throws(MpiEvaluator& evaluator, const EvaluationListener& done, Progress& progress) {
  try {
    evaluator.evaluate({{0.5, 1.0, 0.2, 0.0}, {0.3, 1.0, 0.2, 0.0}, {0.7, 1.0, 0.2, 0.0}}, done, progress);
  } catch (const ErrorType&) {
    return true;
  }
  return false;
}

void lead(const MpiSession& session) {
  const std::vector<std::string> names = {"time_s", "error_mm3"};
  MpiEvaluator evaluator(session, names, measured);
  NoProgress progress;
  Nsga2Settings settings;
  settings.population = 20;
  settings.generations = 10;
  ParallelEvaluator threads(names, measured);
  const SearchProblem here{mixedSpace(), timeAndError(), threads};
  const SearchProblem over_mpi{mixedSpace(), timeAndError(), evaluator};
  const FrontSearch expected = searchFront(here, settings, {}, progress);
  const FrontSearch found = searchFront(over_mpi, settings, {}, progress);
  expect(textOf(found.evaluations) == textOf(expected.evaluations), "same evaluations as by threads");
  expect(textOf(found.front) == textOf(expected.front), "same front as by threads");
  expect(found.generations.back().failed > 0, "failures are passed on");

  std::atomic<int> reported{0};
  CancelledSoon soon(reported);
  expect(throws<Cancelled>(
             evaluator, [&](const Evaluation&) { ++reported; }, soon),
         "cancelling is passed on");
  expect(reported >= 1, "what was done before it was cancelled is reported");
  const auto refuse = [](const Evaluation&) { throw FileError("disk full"); };
  if (session.size() > 1)
    expect(throws<FileError>(evaluator, refuse, progress), "what the listener throws is passed on");
  const auto after = evaluator.evaluate({{0.5, 2.0, 0.2, 1.0}}, {}, progress);
  expect(after[0].responses == measured({0.5, 2.0, 0.2, 1.0}, progress), "goes on after it was cancelled");
}

/// Where the last process cannot measure.
void leadInVain(const MpiSession& session) {
  MpiEvaluator evaluator(session, {"time_s", "error_mm3"}, measured);
  NoProgress progress;
  int failed = 0;
  std::string message;
  try {
    const std::vector<DesignPoint> points(20, {0.5, 1.0, 0.2, 0.0});
    evaluator.evaluate(
        points, [&](const Evaluation& one) { failed += isEvaluated(one) ? 0 : 1; }, progress);
  } catch (const InvalidInput& error) {
    message = error.what();
  }
  const std::string expected = "process " + std::to_string(session.size() - 1) + " cannot measure: no part";
  expect(message == expected, "a process that cannot measure ends the run");
  expect(failed == 0, "no point counts as failed by a process that cannot measure");
}

PointMeasurement unmade() { throw FileError("no part"); }

}  // namespace
}  // namespace lamina

int main(int argc, char**) {
  try {
    const lamina::MpiSession session;
    const bool is_last_unable = argc > 1;
    const bool is_last = session.rank() == session.size() - 1;
    if (session.isLeader())
      is_last_unable ? lamina::leadInVain(session) : lamina::lead(session);
    else
      lamina::servePoints([&] { return is_last && is_last_unable ? lamina::unmade() : lamina::measured; });
    return lamina::faults == 0 ? 0 : 1;
  } catch (...) {
    std::fputs("an exception left the test\n", stderr);
    return 1;
  }
}
