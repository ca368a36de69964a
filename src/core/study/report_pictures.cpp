// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "lamina/picture/chart.hpp"
#include "lamina/study/report.hpp"

namespace lamina {
namespace {

constexpr Colour kTried{0.74, 0.76, 0.79};
constexpr Colour kInfeasible{0.93, 0.76, 0.72};
constexpr Colour kFront{0.13, 0.42, 0.70};
constexpr Colour kChosen{0.85, 0.37, 0.05};
constexpr int kWidth = 800;
constexpr int kHeight = 590;
constexpr std::size_t kMostPictures = 10;

std::string drawn(const Chart& chart) { return chartPng(chart, kWidth, kHeight); }

/// The same response of each evaluation against another one.
std::vector<Point2> pairs(const std::vector<Evaluation>& evaluations, std::size_t x, std::size_t y) {
  std::vector<Point2> points;
  for (const Evaluation& evaluation : evaluations)
    if (isEvaluated(evaluation)) points.emplace_back(evaluation.responses.at(x), evaluation.responses.at(y));
  return points;
}

/// Evaluations that hold all constraints, or those that do not.
enum class Kept { Holding, Breaking };

std::vector<Evaluation> only(Kept kept, const Study& study, const StudyOutcome& outcome) {
  std::vector<Evaluation> found;
  for (const Evaluation& evaluation : outcome.evaluations) {
    if (!isEvaluated(evaluation)) continue;
    const bool holds = violationOf(study.goals, outcome.response_names, evaluation.responses) == 0.0;
    if (holds == (kept == Kept::Holding)) found.push_back(evaluation);
  }
  return found;
}

std::vector<Evaluation> proposedIn(const StudyOutcome& outcome) {
  std::vector<Evaluation> proposed;
  if (outcome.surrogate)
    for (const SurrogateIteration& iteration : outcome.surrogate->iterations)
      proposed.push_back(iteration.measured);
  return proposed;
}

ReportPicture frontPicture(const Study& study, const StudyOutcome& outcome, const std::string& x_name,
                           const std::string& y_name) {
  const std::size_t x = responseIndex(outcome.response_names, x_name);
  const std::size_t y = responseIndex(outcome.response_names, y_name);
  Chart chart{y_name + " over " + x_name, x_name, y_name, {}};
  const auto breaking = pairs(only(Kept::Breaking, study, outcome), x, y);
  if (!breaking.empty()) chart.series.push_back({"outside constraints", breaking, kInfeasible, 3.5, 0.0});
  chart.series.push_back({"tried", pairs(only(Kept::Holding, study, outcome), x, y), kTried, 3.5, 0.0});
  if (outcome.surrogate)
    chart.series.push_back({"proposed", pairs(proposedIn(outcome), x, y), kFront, 5.5, 0.0});
  else
    chart.series.push_back({"front",
                            pairs(outcome.front, responseIndex(outcome.front_response_names, x_name),
                                  responseIndex(outcome.front_response_names, y_name)),
                            kFront, 5.5, 0.0});
  if (outcome.chosen)
    chart.series.push_back({"chosen",
                            pairs({*outcome.chosen}, responseIndex(outcome.front_response_names, x_name),
                                  responseIndex(outcome.front_response_names, y_name)),
                            kChosen, 9.0, 0.0});
  return {drawn(chart), chart.title};
}

ReportPicture overGenerations(const StudyOutcome& outcome, const std::string& name,
                              const std::function<double(const Generation&)>& value) {
  ChartSeries series{"", {}, kFront, 4.0, 2.5};
  for (const Generation& generation : outcome.generations)
    series.points.emplace_back(generation.index, value(generation));
  const Chart chart{name + " over generations", "generation", name, {series}};
  return {drawn(chart), chart.title};
}

double bestOf(const Generation& generation, std::size_t response, Sense sense) {
  double best = std::nan("");
  for (const Evaluation& evaluation : generation.front) {
    const double value = evaluation.responses.at(response);
    const bool is_better = sense == Sense::Minimise ? value < best : value > best;
    if (std::isnan(best) || is_better) best = value;
  }
  return best;
}

ReportPicture mapePicture(const StudyOutcome& outcome) {
  ChartSeries series{"", {}, kFront, 5.0, 2.5};
  for (const SurrogateIteration& iteration : outcome.surrogate->iterations)
    series.points.emplace_back(static_cast<double>(iteration.index), iteration.mape_percent);
  const Chart chart{"Error of prediction over iterations", "iteration", "MAPE [%]", {series}};
  return {drawn(chart), chart.title};
}

ReportPicture predictedPicture(const StudyOutcome& outcome, std::size_t response) {
  ChartSeries points{"proposed", {}, kFront, 6.0, 0.0};
  ChartSeries diagonal{"as predicted", {}, kTried, 0.0, 2.0};
  for (const SurrogateIteration& iteration : outcome.surrogate->iterations) {
    if (!isEvaluated(iteration.measured)) continue;
    const double measured = iteration.measured.responses.at(response);
    const double predicted = iteration.predictions.at(response).value;
    points.points.emplace_back(measured, predicted);
    for (const double value : {measured, predicted})
      if (std::isfinite(value)) diagonal.points.emplace_back(value, value);
  }
  std::sort(diagonal.points.begin(), diagonal.points.end(),
            [](const Point2& a, const Point2& b) { return a.x() < b.x(); });
  const std::string& name = outcome.response_names.at(response);
  const Chart chart{name + ": predicted over measured", "measured", "predicted", {diagonal, points}};
  return {drawn(chart), chart.title};
}

}  // namespace

std::vector<ReportPicture> frontPictures(const Study& study, const StudyOutcome& outcome) {
  std::vector<ReportPicture> pictures;
  const auto& objectives = study.goals.objectives;
  for (std::size_t i = 0; i < objectives.size(); ++i)
    for (std::size_t j = i + 1; j < objectives.size() && pictures.size() < kMostPictures; ++j)
      pictures.push_back(frontPicture(study, outcome, objectives[i].response, objectives[j].response));
  return pictures;
}

std::vector<ReportPicture> progressPictures(const Study& study, const StudyOutcome& outcome) {
  std::vector<ReportPicture> pictures;
  if (!outcome.generations.empty()) {
    pictures.push_back(overGenerations(outcome, "hypervolume",
                                       [](const Generation& generation) { return generation.hypervolume; }));
    for (const Objective& objective : study.goals.objectives) {
      if (pictures.size() == kMostPictures) break;
      const std::size_t response = responseIndex(outcome.response_names, objective.response);
      pictures.push_back(overGenerations(
          outcome, "best " + objective.response,
          [&](const Generation& generation) { return bestOf(generation, response, objective.sense); }));
    }
  }
  const auto measured = proposedIn(outcome);
  if (!measured.empty() && failedCount(measured) < measured.size()) {
    pictures.push_back(mapePicture(outcome));
    for (std::size_t i = 0; i < outcome.response_names.size() && pictures.size() < kMostPictures; ++i)
      pictures.push_back(predictedPicture(outcome, i));
  }
  return pictures;
}

}  // namespace lamina
