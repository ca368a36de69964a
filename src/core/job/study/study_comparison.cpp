// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "job/study/study_comparison.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

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

 private:
  const Study& study_;
  const StudyMeasurement& measurement_;
  Evaluator& in_full_;
  Progress& progress_;
  StudyComparison found_;
};

}  // namespace

StudyComparison comparisonOf(const Study& study, const StudyMeasurement& measurement, Evaluator& in_full,
                             const StudyOutcome& outcome, Progress& progress) {
  Comparing comparing(study, measurement, in_full, progress);
  if (outcome.chosen) comparing.addPoint("chosen", outcome.front_response_names, *outcome.chosen);
  for (const PublishedRow& row : study.published) comparing.addPublished(row);
  if (study.slice)
    for (const Baseline& baseline : study.slice->baselines) comparing.addBaseline(baseline);
  return std::move(comparing).found();
}

}  // namespace lamina
