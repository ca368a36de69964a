// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cstdio>

#include "lamina/base/error.hpp"
#include "lamina/job/study/study_job.hpp"
#include "lamina/job/study/study_measurement.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/study/study_reader.hpp"
#include "mpi_evaluator.hpp"
#include "output/terminal_progress.hpp"

namespace lamina {
namespace {

/// The command line as it was typed.
struct Arguments {
  std::string study;
  std::string output;
  std::vector<std::string> assignments;
  EarlierJournal earlier = EarlierJournal::GoOn;
};

StudyJob jobOf(const Arguments& arguments) {
  StudyJob job;
  job.study = readStudyFile(arguments.study);
  for (const std::string& assignment : arguments.assignments)
    job.study.search.push_back(settingFromAssignment(assignment));
  job.output = arguments.output;
  job.earlier = arguments.earlier;
  return job;
}

PointMeasurement measurementOf(const Study& study) {
  const auto measurement = std::make_shared<const StudyMeasurement>(study);
  return [measurement](const DesignPoint& point, Progress& progress) {
    return measurement->at(point, progress);
  };
}

void lead(const MpiSession& session, const StudyJob& job) {
  const SurrogateFit fit = krigingFit(surrogateFitSettingsOf(job.study));
  cli::TerminalProgress progress;
  const auto report = [](const StudyState& state) {
    std::fprintf(stderr, "%d: %d evaluations, %d failed, hypervolume %g\n", state.index, state.evaluations,
                 state.failed, state.hypervolume);
  };
  MpiEvaluator evaluator(session, responseNames(job.study), measurementOf(job.study));
  const StudyOutcome outcome = runStudy(job, fit, &evaluator, report, progress);
  std::printf("%s: %zu evaluations in %d processes, %.1f s\nreport: %s\n", job.study.name.c_str(),
              outcome.evaluations.size(), session.size(), outcome.wall_s,
              studyFilesIn(job.output).report.c_str());
}

int run(const Arguments& arguments) {
  const MpiSession session;
  if (!session.isLeader()) {
    servePoints([&] { return measurementOf(jobOf(arguments).study); });
    return 0;
  }
  try {
    const StudyJob job = jobOf(arguments);
    lead(session, job);
    return 0;
  } catch (...) {
    const Failure failure = currentFailure();
    std::fprintf(stderr, "optimise_over_mpi: %s: %s\n", toString(failure.code), failure.message.c_str());
    return 1;
  }
}

int runCommandLine(int argc, char** argv) {
  CLI::App app{"Run a study on all processes that mpirun started", "optimise_over_mpi"};
  Arguments arguments;
  app.add_option("study", arguments.study, "What is searched for, how, and what measures it (.yaml)")
      ->required();
  app.add_option("-o,--output", arguments.output,
                 "Folder for journal, front, chosen configuration and report")
      ->required();
  app.add_option("--set", arguments.assignments, "One setting of the search as key=value; may be repeated")
      ->allow_extra_args(false);
  CLI::Option* fresh = app.add_flag_callback(
      "--fresh", [&] { arguments.earlier = EarlierJournal::BeginAnew; },
      "Begin anew instead of going on with the journal");
  app.add_flag_callback(
         "--retry-failed", [&] { arguments.earlier = EarlierJournal::RetryFailed; },
         "Go on with the journal, but try again what failed")
      ->excludes(fresh);
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
}

}  // namespace
}  // namespace lamina

int main(int argc, char** argv) {
  try {
    return lamina::runCommandLine(argc, argv);
  } catch (...) {
    std::fputs("optimise_over_mpi: cannot start; out of memory?\n", stderr);
    return 1;
  }
}
