// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/study/study_job.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/base/version.hpp"
#include "lamina/job/output_files.hpp"
#include "lamina/job/study/known_points.hpp"
#include "lamina/job/study/study_measurement.hpp"
#include "lamina/optimisation/criteria.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/evaluation_journal.hpp"
#include "lamina/optimisation/experiment_table.hpp"
#include "lamina/optimisation/front_csv.hpp"
#include "lamina/study/evaluations_csv.hpp"
#include "lamina/study/report.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/study/study.hpp"
#include "lamina/study/study_outcome.hpp"

namespace lamina {
namespace {

constexpr std::size_t kManyPoints = 100;

/// A choice, if one can be made, and what a reader has to know of it.
struct FrontDecision {
  std::optional<Decision> decision;
  std::vector<std::string> notes;
};

bool weighs(const Criterion& criterion) { return criterion.weight > 0.0; }

bool isKnownEverywhere(const std::vector<Evaluation>& front, std::size_t response) {
  return std::all_of(front.begin(), front.end(), [&](const Evaluation& evaluation) {
    return std::isfinite(evaluation.responses.at(response));
  });
}

/// What a point of the study's front is chosen by: all metrics of a part; else the objectives.
/// @param front_response_names  what is measured of a front
/// @throws InvalidConfig as `criteriaOf`; if no weight is greater than 0
std::vector<Criterion> decisionCriteria(const Study& study,
                                        const std::vector<std::string>& front_response_names) {
  std::vector<std::string> objectives;
  std::vector<std::string> maximised;
  for (const Objective& objective : study.goals.objectives) {
    objectives.push_back(objective.response);
    if (objective.sense == Sense::Maximise) maximised.push_back(objective.response);
  }
  std::vector<Criterion> criteria =
      criteriaOf(study.slice ? front_response_names : objectives, study.decision.weights, maximised);
  if (std::none_of(criteria.begin(), criteria.end(), weighs))
    throw InvalidConfig("all weights of the decision are 0; expected one that is greater");
  return criteria;
}

/// Decides by those criteria that are among the responses, and numbers at every point of the front; the
/// others that weigh something become notes. Without any that weighs something nothing is chosen.
/// @param front  not empty
FrontDecision decideAmong(const std::vector<Evaluation>& front,
                          const std::vector<std::string>& response_names,
                          const std::vector<Criterion>& criteria, DecisionMethod method) {
  FrontDecision found;
  std::vector<Criterion> used;
  std::vector<std::vector<double>> responses(front.size());
  for (const Criterion& criterion : criteria) {
    const auto name = std::find(response_names.begin(), response_names.end(), criterion.response);
    if (!weighs(criterion) || name == response_names.end()) continue;
    const auto response = static_cast<std::size_t>(name - response_names.begin());
    if (!isKnownEverywhere(front, response)) {
      found.notes.push_back("decided without " + criterion.response + ", which is no number somewhere");
      continue;
    }
    used.push_back(criterion);
    for (std::size_t i = 0; i < front.size(); ++i) responses[i].push_back(front[i].responses[response]);
  }
  if (used.empty())
    found.notes.push_back("nothing is chosen: no response that has a weight is a number everywhere");
  else
    found.decision = decide(used, responses, method);
  return found;
}

/// Rows to be shown side by side, and what could not be measured.
struct StudyComparison {
  std::vector<ComparedRow> rows;
  std::vector<std::string> notes;
};

/// The point that a published row names; nothing if it leaves a variable out.
std::optional<DesignPoint> pointOf(const DesignSpace& space, const PublishedRow& row) {
  DesignPoint point;
  for (const Variable& variable : space) {
    const auto found = std::find_if(row.values.begin(), row.values.end(),
                                    [&](const SettingText& value) { return value.key == variable.name; });
    if (found == row.values.end()) return std::nullopt;
    point.push_back(valueOf(variable, found->text));
  }
  return point;
}

class Comparing {
 public:
  Comparing(const Study& study, const StudyMeasurement& measurement, Evaluator& in_full, Progress& progress)
      : study_(study), measurement_(measurement), in_full_(in_full), progress_(progress) {}

  void addPoint(const std::string& name, const std::vector<std::string>& response_names,
                const Evaluation& evaluation) {
    found_.rows.push_back({name, valuesOf(study_.variables, response_names, evaluation)});
  }

  void addPublished(const PublishedRow& row) {
    found_.rows.push_back({row.name, row.values});
    const bool is_measured = study_.slice || study_.commands;
    if (!is_measured) return;
    const std::string name = row.name + ", measured here";
    try {
      const auto point = pointOf(study_.variables, row);
      if (!point) return;
      const Evaluation evaluation = in_full_.evaluate({*point}, {}, progress_).front();
      if (!isEvaluated(evaluation)) throw InvalidInput(evaluation.error);
      addPoint(name, measurement_.frontResponseNames(), evaluation);
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      found_.notes.push_back(name + ": " + error.what());
    }
  }

  void addBaseline(const Baseline& baseline) {
    try {
      const Evaluation evaluation{{}, measurement_.ofBaseline(baseline, progress_), {}};
      if (chosen_ != nullptr && isWorseInAll(*chosen_, evaluation))
        found_.notes.push_back("what is chosen is worse in every goal than " + baseline.name +
                               ", which the search cannot lay");
      ComparedRow row{baseline.name + ", measured here",
                      valuesOf({}, measurement_.frontResponseNames(), evaluation)};
      found_.rows.push_back(std::move(row));
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      found_.notes.push_back(baseline.name + ": " + error.what());
    }
  }

  StudyComparison found() && { return std::move(found_); }

  /// What is chosen, with the measurement's `frontResponseNames`; null for nothing.
  void compareWith(const Evaluation* chosen) { chosen_ = chosen; }

 private:
  bool isWorseInAll(const Evaluation& one, const Evaluation& other) const {
    const std::vector<std::string>& names = measurement_.frontResponseNames();
    const auto isWorse = [&](const Objective& objective) {
      const std::size_t i = responseIndex(names, objective.response);
      const double more = one.responses.at(i) - other.responses.at(i);
      return objective.sense == Sense::Minimise ? more > 0.0 : more < 0.0;
    };
    return std::all_of(study_.goals.objectives.begin(), study_.goals.objectives.end(), isWorse);
  }

  const Study& study_;
  const Evaluation* chosen_ = nullptr;
  const StudyMeasurement& measurement_;
  Evaluator& in_full_;
  Progress& progress_;
  StudyComparison found_;
};

/// What was chosen (if anything), each published row and, where it names all variables, what is measured at
/// its point, then the baselines.
/// @param in_full  tries points with the measurement's `frontResponseNames`
/// @throws Cancelled
StudyComparison comparisonOf(const Study& study, const StudyMeasurement& measurement, Evaluator& in_full,
                             const StudyOutcome& outcome, Progress& progress) {
  Comparing comparing(study, measurement, in_full, progress);
  if (outcome.chosen) comparing.addPoint("chosen", outcome.front_response_names, *outcome.chosen);
  if (outcome.chosen && outcome.front_response_names == measurement.frontResponseNames())
    comparing.compareWith(&*outcome.chosen);
  for (const PublishedRow& row : study.published) comparing.addPublished(row);
  if (study.slice)
    for (const Baseline& baseline : study.slice->baselines) comparing.addBaseline(baseline);
  return std::move(comparing).found();
}

using Clock = std::chrono::steady_clock;

/// Feasible values of the objectives so far, the best of each.
std::vector<double> bestValues(const Goals& goals, const std::vector<std::string>& names,
                               const std::vector<Evaluation>& feasible) {
  std::vector<double> best;
  if (feasible.empty()) return best;
  for (const Objective& objective : goals.objectives) {
    const std::size_t response = responseIndex(names, objective.response);
    double value = feasible.front().responses.at(response);
    for (const Evaluation& evaluation : feasible) {
      const double other = evaluation.responses.at(response);
      value = objective.sense == Sense::Minimise ? std::min(value, other) : std::max(value, other);
    }
    best.push_back(value);
  }
  return best;
}

/// Remembers what was tried.
class RecordingEvaluator final : public Evaluator {
 public:
  explicit RecordingEvaluator(Evaluator& inner) : inner_(inner) {}

  const std::vector<std::string>& responseNames() const override { return inner_.responseNames(); }
  std::vector<Evaluation> evaluate(const std::vector<DesignPoint>& points, const EvaluationListener& done,
                                   Progress& progress) override {
    std::vector<Evaluation> found = inner_.evaluate(points, done, progress);
    tried_.insert(tried_.end(), found.begin(), found.end());
    return found;
  }

  /// These, then what was tried.
  std::vector<Evaluation> after(std::vector<Evaluation> samples) const {
    samples.insert(samples.end(), tried_.begin(), tried_.end());
    return samples;
  }

 private:
  Evaluator& inner_;
  std::vector<Evaluation> tried_;
};

std::vector<std::string> outputsOf(const StudyFiles& files) {
  return {files.journal, files.front_journal, files.front, files.evaluations,
          files.chosen,  files.picture,       files.report};
}

std::vector<std::string> inputsOf(const Study& study) {
  std::vector<std::string> inputs = {study.file, study.table};
  if (study.slice) inputs.insert(inputs.end(), {study.slice->part, study.slice->config});
  return inputs;
}

class StudyRun {
 public:
  StudyRun(const StudyJob& job, Evaluator* outer, const StudyListener& listener, Progress& progress)
      : study_(job.study),
        files_(studyFilesIn(job.output)),
        listener_(listener),
        progress_(progress),
        settings_(searchSettingsOf(study_)),
        measurement_(study_),
        criteria_(decisionCriteria(study_, measurement_.frontResponseNames())) {
    requireApart(outputsOf(files_), inputsOf(study_));
    if (!study_.table.empty())
      table_ = readExperimentTable(study_.table, study_.variables, measurement_.responseNames());
    prepareFolder(job);
    prepareEvaluators(outer, job.earlier);
  }

  StudyOutcome run(const SurrogateFit& fit) {
    const Clock::time_point start = Clock::now();
    outcome_.response_names = measurement_.responseNames();
    outcome_.front_response_names = outcome_.response_names;
    outcome_.version = laminaVersion();
    study_.method == SearchMethod::Nsga2 ? searchForFront() : searchWith(fit);
    writeSettings();
    StudyComparison comparison = comparisonOf(study_, measurement_, *in_full_, outcome_, progress_);
    outcome_.compared = std::move(comparison.rows);
    outcome_.notes.insert(outcome_.notes.end(), comparison.notes.begin(), comparison.notes.end());
    outcome_.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
    write();
    return std::move(outcome_);
  }

 private:
  void prepareFolder(const StudyJob& job) const {
    if (job.output.empty()) throw InvalidConfig("no folder for the output is named");
    std::error_code failed;
    std::filesystem::create_directories(job.output, failed);
    if (failed || !std::filesystem::is_directory(job.output, failed))
      throw FileError("cannot make the folder '" + job.output + "'");
  }

  bool isTableAlone() const { return !study_.slice && !study_.commands; }

  /// Before the journal of an earlier run is emptied.
  void requireSearchable(Evaluator& evaluator) const {
    const SearchProblem problem{study_.variables, study_.goals, evaluator};
    study_.method == SearchMethod::Nsga2 ? validate(problem, settings_.nsga2) : validate(problem);
  }

  void prepareEvaluators(Evaluator* outer, EarlierJournal earlier) {
    const auto& names = measurement_.responseNames();
    const std::string fingerprint = measurement_.fingerprint();
    // A table answers with the points it has, and somebody may have typed more into it since: no journal.
    if (isTableAlone())
      searched_ = std::make_unique<TableEvaluator>(study_.variables, names, table_.proposed,
                                                   settings_.surrogate.answer_nearness);
    if (!isTableAlone() && outer == nullptr)
      measured_ = std::make_unique<ParallelEvaluator>(
          names,
          [this](const DesignPoint& point, Progress& progress) { return measurement_.at(point, progress); });
    if (!isTableAlone()) {
      Evaluator& inner = outer != nullptr ? *outer : *measured_;
      requireSearchable(inner);
      searched_ = std::make_unique<JournalledEvaluator>(
          inner, study_.variables, JournalSettings{files_.journal, fingerprint, earlier});
    }
    const bool is_measured_more = measurement_.frontResponseNames() != names;
    measured_in_full_ = std::make_unique<ParallelEvaluator>(
        measurement_.frontResponseNames(), [this](const DesignPoint& point, Progress& progress) {
          return measurement_.inFull(point, progress);
        });
    in_full_ = std::make_unique<JournalledEvaluator>(
        is_measured_more ? *measured_in_full_ : *searched_, study_.variables,
        JournalSettings{is_measured_more ? files_.front_journal : "", fingerprint, earlier});
  }

  void beginWithKnownPoints() {
    KnownPoints known = knownPointsOf(study_);
    for (KnownPoint& each : known.points) settings_.nsga2.first_points.push_back(std::move(each.point));
    for (const std::string& reason : known.left_out)
      outcome_.notes.push_back("not among the first points: " + reason);
  }

  /// Of goals that trade with each other alone nothing can be chosen but by weights.
  void noteHowMuchIsNotDominated() {
    std::size_t feasible = 0;
    for (const Evaluation& evaluation : outcome_.evaluations)
      if (isEvaluated(evaluation) &&
          violationOf(study_.goals, outcome_.response_names, evaluation.responses) == 0.0)
        ++feasible;
    if (feasible < kManyPoints || 2 * outcome_.front.size() <= feasible) return;
    outcome_.notes.push_back(
        std::to_string(outcome_.front.size()) + " of " + std::to_string(feasible) +
        " points are dominated by no other: the objectives hardly do but trade with each "
        "other, and the weights decide");
  }

  void noteWeights() {
    for (const Criterion& criterion : criteria_)
      outcome_.weights.push_back({criterion.response, numberText(criterion.weight)});
  }

  void searchForFront() {
    const auto hear = [this](const Generation& generation) {
      if (listener_)
        listener_({generation.index, generation.evaluations, generation.failed,
                   bestValues(study_.goals, measurement_.responseNames(), generation.front),
                   generation.hypervolume});
    };
    beginWithKnownPoints();
    FrontSearch search =
        searchFront({study_.variables, study_.goals, *searched_}, settings_.nsga2, hear, progress_);
    outcome_.seed = settings_.nsga2.seed;
    outcome_.evaluations = std::move(search.evaluations);
    outcome_.generations = std::move(search.generations);
    outcome_.front = std::move(search.front);
    noteWeights();
    if (outcome_.front.empty()) return;
    noteHowMuchIsNotDominated();
    measureFrontInFull();
    decideAmongFront();
  }

  void measureFrontInFull() {
    if (measurement_.frontResponseNames() == outcome_.response_names) return;
    std::vector<DesignPoint> points;
    for (const Evaluation& evaluation : outcome_.front) points.push_back(evaluation.point);
    std::vector<Evaluation> in_full = in_full_->evaluate(points, {}, progress_);
    const auto failed = std::find_if_not(in_full.begin(), in_full.end(), isEvaluated);
    if (failed != in_full.end()) {
      outcome_.notes.push_back("decided by what the search measured; other metrics cannot be measured: " +
                               failed->error);
      return;
    }
    outcome_.front = std::move(in_full);
    outcome_.front_response_names = measurement_.frontResponseNames();
  }

  void decideAmongFront() {
    FrontDecision found = decideAmong(outcome_.front, outcome_.front_response_names, criteria_,
                                      decisionMethodOf(study_.decision.method));
    outcome_.notes.insert(outcome_.notes.end(), found.notes.begin(), found.notes.end());
    if (!found.decision) return;
    outcome_.decision_indices = std::move(found.decision->indices);
    outcome_.chosen = outcome_.front.at(found.decision->chosen);
  }

  void searchWith(const SurrogateFit& fit) {
    if (!fit) throw InvalidConfig("the study asks for a surrogate, and nothing is there to fit it");
    std::vector<Evaluation> samples = table_.design;
    if (!isTableAlone()) samples.insert(samples.end(), table_.proposed.begin(), table_.proposed.end());
    RecordingEvaluator recording(*searched_);
    const auto hear = [&](const SurrogateIteration& iteration) {
      if (listener_) listener_(stateAfter(iteration, recording.after(samples)));
    };
    SurrogateSearch search = searchBySurrogate({study_.variables, study_.goals, recording}, {fit, samples},
                                               settings_.surrogate, hear, progress_);
    outcome_.seed = settings_.surrogate.seed;
    outcome_.evaluations = search.evaluations;
    if (search.best) {
      outcome_.chosen = search.evaluations.at(*search.best);
      chooseInFull();
    }
    if (search.end == SurrogateEnd::NotMeasured && !search.iterations.empty())
      outcome_.notes.push_back("next to be measured: " + pointText(search.iterations.back().proposed));
    outcome_.surrogate = std::move(search);
  }

  StudyState stateAfter(const SurrogateIteration& iteration, const std::vector<Evaluation>& tried) const {
    std::vector<Evaluation> feasible;
    for (const Evaluation& evaluation : tried)
      if (isEvaluated(evaluation) &&
          violationOf(study_.goals, measurement_.responseNames(), evaluation.responses) == 0.0)
        feasible.push_back(evaluation);
    return {static_cast<int>(iteration.index), static_cast<int>(tried.size()),
            static_cast<int>(failedCount(tried)),
            bestValues(study_.goals, measurement_.responseNames(), feasible), 0.0};
  }

  void chooseInFull() {
    if (measurement_.frontResponseNames() == outcome_.response_names) return;
    const Evaluation in_full = in_full_->evaluate({outcome_.chosen->point}, {}, progress_).front();
    if (!isEvaluated(in_full)) {
      outcome_.notes.push_back("other metrics of what was chosen cannot be measured: " + in_full.error);
      return;
    }
    outcome_.chosen = in_full;
    outcome_.front_response_names = measurement_.frontResponseNames();
  }

  std::string pointText(const DesignPoint& point) const {
    std::string text;
    for (std::size_t i = 0; i < point.size(); ++i)
      text += (i == 0 ? "" : ", ") + study_.variables[i].name + " " + textOf(study_.variables[i], point[i]);
    return text;
  }

  void writeSettings() {
    SettingsSchema schema;
    study_.method == SearchMethod::Nsga2 ? describe(schema, settings_.nsga2)
                                         : describe(schema, settings_.surrogate);
    outcome_.search = settingTexts(schema);
    if (study_.method == SearchMethod::Surrogate)
      for (const SettingText& setting : surrogateFitSettingsOf(study_)) outcome_.search.push_back(setting);
  }

  /// What an earlier run wrote and this one does not is removed once the rest is there.
  void write() const {
    const DesignSpace& space = study_.variables;
    std::vector<std::string> stale;
    writeFile(files_.evaluations, evaluationsCsv(space, outcome_.response_names, outcome_.evaluations));
    if (study_.method == SearchMethod::Nsga2)
      writeFile(files_.front, frontCsv(space, outcome_.front_response_names, outcome_.front));
    else
      stale.push_back(files_.front);
    if (outcome_.chosen)
      writeFile(files_.chosen, measurement_.configurationAt(outcome_.chosen->point));
    else
      stale.push_back(files_.chosen);
    const auto pictures = frontPictures(study_, outcome_);
    if (!pictures.empty())
      writeFile(files_.picture, pictures.front().png);
    else
      stale.push_back(files_.picture);
    writeFile(files_.report, studyReport(study_, outcome_));
    std::error_code ignored;
    for (const std::string& file : stale) std::filesystem::remove(file, ignored);
  }

  const Study& study_;
  StudyFiles files_;
  const StudyListener& listener_;
  Progress& progress_;
  SearchSettings settings_;
  StudyMeasurement measurement_;
  std::vector<Criterion> criteria_;
  ExperimentTable table_;
  std::unique_ptr<Evaluator> measured_;
  std::unique_ptr<Evaluator> searched_;
  std::unique_ptr<Evaluator> measured_in_full_;
  std::unique_ptr<Evaluator> in_full_;
  StudyOutcome outcome_;
};

}  // namespace

StudyFiles studyFilesIn(const std::string& folder) {
  const auto in = [&](const char* name) { return (std::filesystem::path(folder) / name).string(); };
  return {in("journal.jsonl"), in("front.jsonl"), in("front.csv"),  in("evaluations.csv"),
          in("chosen.yaml"),   in("front.png"),   in("report.html")};
}

StudyOutcome runStudy(const StudyJob& job, const SurrogateFit& fit, Evaluator* outer,
                      const StudyListener& listener, Progress& progress) {
  StudyRun run(job, outer, listener, progress);
  return run.run(fit);
}

}  // namespace lamina
