// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Searches: fronts, surrogates and what fits them.
#include <cmath>

#include "job/settings/setting_probe.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/study/study_job.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/optimisation/evaluation.hpp"
#include "lamina/optimisation/nsga2.hpp"
#include "lamina/optimisation/surrogate_search.hpp"
#include "lamina/study/search_settings.hpp"
#include "lamina/study/study_reader.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

struct AllSearchSettings {
  SearchSettings search;
  KrigingSettings kriging;
};

void describe(SettingsSchema& schema, AllSearchSettings& settings) {
  lamina::describe(schema, settings.search);
  lamina::describe(schema, settings.kriging);
}

DesignSpace room() {
  return {{"x", VariableKind::Continuous, -1.0, 3.0, {}, {}},
          {"y", VariableKind::Continuous, -2.0, 2.0, {}, {}},
          {"z", VariableKind::Continuous, 0.0, 1.0, {}, {}}};
}

std::string pointsText(const std::vector<Evaluation>& evaluations) {
  std::string text;
  for (const Evaluation& evaluation : evaluations) text += numbersText(evaluation.point);
  return text;
}

/// Two hills apart; of `hills` some points cannot be tried.
std::vector<double> calmHills(const DesignPoint& point, Progress& /*progress*/) {
  return {1.0 + std::pow(point[0] - 1.5, 2) + std::pow(std::sin(point[1]), 2) + 0.1 * point[2],
          1.0 + std::pow(point[0], 2) + std::pow(point[1] - 1.0, 2)};
}

std::vector<double> hills(const DesignPoint& point, Progress& progress) {
  if (point[0] > 1.2 && point[0] < 1.8) throw InvalidInput("cannot be tried");
  return calmHills(point, progress);
}

std::string front(const SettingTexts& set) {
  ParallelEvaluator evaluator({"f", "g"}, hills);
  NoProgress nobody;
  const Goals goals{{{"f", Sense::Minimise, 1.0}, {"g", Sense::Minimise, 1.0}}, {}};
  return pointsText(
      searchFront({room(), goals, evaluator}, settingsWith<SearchSettings>(set).nsga2, {}, nobody)
          .evaluations);
}

std::string learntOf(const PointMeasurement& measure, const SettingTexts& set) {
  const AllSearchSettings settings = settingsWith<AllSearchSettings>(set);
  ParallelEvaluator evaluator({"f", "g"}, measure);
  NoProgress nobody;
  const Goals goals{{{"f", Sense::Minimise, 1.0}}, {{"g", 0.0, 5.0}}};
  const SurrogateSearch search = searchBySurrogate(
      {room(), goals, evaluator}, {krigingFit(settings.kriging), {}}, settings.search.surrogate, {}, nobody);
  return pointsText(search.evaluations) + toString(search.end);
}

/// How a table ends whose row of the first iteration is not quite what is proposed.
std::string answered(const SettingTexts& set) {
  const ScratchFolder folder;
  writeFile(folder.file("made.csv"),
            "x,iteration,y\n-1,,7.25\n0,,3.25\n0.9,,1.36\n2,,1.25\n3,,3.25\n1.45,1,1.0025\n");
  std::string yaml = "method: surrogate\nvariables: {x: [-1, 3]}\ntable: " + folder.file("made.csv") +
                     "\nobjectives: {y: minimise}\nsearch:\n";
  yaml += "  " + set.back().key + ": " + set.back().text + "\n";
  NoProgress nobody;
  const StudyOutcome outcome = runStudy({readStudy(yaml, "study", ""), folder.file("out")},
                                        krigingFit(KrigingSettings()), nullptr, {}, nobody);
  return numbersText({double(outcome.surrogate->iterations.size())}) + toString(outcome.surrogate->end);
}

SettingProbe frontProbe() {
  return {"a front",
          "nsga2.population=12;nsga2.generations=4",
          front,
          {{"nsga2.variation=sbx"},
           {"nsga2.population=16"},
           {"nsga2.generations=3"},
           {"nsga2.seed=2"},
           {"nsga2.corners=true"},
           {"nsga2.crossover_share=0.5"},
           {"nsga2.mutation_share=0.8"},
           {"nsga2.mutation_rate=1"},
           {"nsga2.mutation_step=0.3"},
           {"nsga2.crossover_probability=0.3", "nsga2.variation=sbx"},
           {"nsga2.crossover_index=2", "nsga2.variation=sbx"},
           {"nsga2.mutation_probability=0.5", "nsga2.variation=sbx"},
           {"nsga2.mutation_index=5", "nsga2.variation=sbx;nsga2.mutation_probability=0.5"}}};
}

SettingProbe surrogateProbe() {
  return {"a search by surrogates",
          "surrogate.samples=10;surrogate.iterations=3;surrogate.most_iterations=4;genetic.individuals=20;"
          "genetic.generations=10",
          [](const SettingTexts& set) { return learntOf(hills, set); },
          {{"surrogate.design=full_factorial"},
           {"surrogate.levels=3", "surrogate.design=full_factorial"},
           {"surrogate.generators=c=-ab", "surrogate.design=fractional_factorial;surrogate.generators=c=ab"},
           {"surrogate.samples=14"},
           {"surrogate.proposal=expected_improvement"},

           {"surrogate.most_iterations=3"},

           {"surrogate.least_improvement_percent=100", "surrogate.proposal=expected_improvement"},
           {"surrogate.nearness=0.1", "surrogate.most_iterations=20;surrogate.iterations=20"},
           {"surrogate.failed_proposal=stop"},
           {"surrogate.seed=2"},
           {"genetic.individuals=10"},
           {"genetic.generations=3"},
           {"genetic.mutation_probability=0.1"},
           {"genetic.mutation_step=0.1"},
           {"kriging.correlation=exponential"},
           {"kriging.regression_order=0"},
           {"kriging.range=fixed"},
           {"kriging.fixed_range=0.2", "kriging.range=fixed"}}};
}

}  // namespace

std::vector<SettingProbe> searchProbes() {
  return {
      frontProbe(),
      surrogateProbe(),
      {"a search that may stop",
       "surrogate.samples=12;surrogate.iterations=2;surrogate.most_iterations=4;genetic.individuals=20;"
       "genetic.generations=10;surrogate.accepted_mape_percent=100",
       [](const SettingTexts& set) { return learntOf(calmHills, set); },
       {{"surrogate.iterations=1"}, {"surrogate.accepted_mape_percent=0.000001"}}},
      {"a table that answers", "surrogate.answer_nearness=0", answered, {{"surrogate.answer_nearness=0.1"}}}};
}

}  // namespace lamina::test
