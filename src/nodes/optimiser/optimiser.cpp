// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "optimiser.hpp"

#include <ros/ros.h>

#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/study/study_reader.hpp"
#include "names.hpp"
#include "optimiser_settings.hpp"
#include "progress/action_end.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// A text of more than one line is no path.
Study studyFrom(const std::string& path_or_text) {
  const bool is_text = path_or_text.find('\n') != std::string::npos;
  return is_text ? readStudy(path_or_text, "study", "") : readStudyFile(path_or_text);
}

/// As logs name it: its path, or that it came as a text.
std::string studyName(const std::string& path_or_text) {
  return path_or_text.find('\n') != std::string::npos ? "given as a text" : path_or_text;
}

StudyJob jobFrom(const lamina_msgs::OptimiseGoal& goal, const std::vector<SettingText>& search) {
  StudyJob job;
  job.study = studyFrom(goal.study);
  job.study.search.insert(job.study.search.begin(), search.begin(), search.end());
  for (const lamina_msgs::Setting& setting : goal.settings)
    job.study.search.push_back({setting.key, setting.value});
  job.output = goal.output;
  job.earlier = goal.is_fresh ? EarlierJournal::BeginAnew : EarlierJournal::GoOn;
  return job;
}

}  // namespace

Optimiser::Optimiser(const ros::NodeHandle& node, std::vector<SettingText> search)
    : search_(std::move(search)),
      action_(
          node, names::kOptimise, [this](const lamina_msgs::OptimiseGoalConstPtr& goal) { onGoal(*goal); },
          false) {
  action_.start();
}

void Optimiser::onGoal(const Goal& goal) {
  StudyFeedback feedback(action_);
  Result result;
  try {
    result = run(goal, feedback);
  } catch (...) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"run the study", studyName(goal.study), goal.output}, failure));
    result = {};
    result.status = toMessage(failure);
  }
  endGoal(action_, result);
}

Optimiser::Result Optimiser::run(const Goal& goal, StudyFeedback& feedback) {
  const StudyJob job = jobFrom(goal, search_);
  ROS_INFO_STREAM("running the study '" << job.study.name << "' into " << job.output);
  const StudyOutcome outcome = runStudy(
      job, krigingFit(surrogateFitSettingsOf(job.study)), nullptr,
      [&](const StudyState& state) { feedback.send(state); }, feedback);
  const StudyFiles files = studyFilesIn(job.output);
  Result result;
  result.evaluations = static_cast<std::uint32_t>(outcome.evaluations.size());
  result.failed = static_cast<std::uint32_t>(failedCount(outcome.evaluations));
  result.front_size = static_cast<std::uint32_t>(outcome.front.size());
  if (outcome.chosen) result.chosen = readFile(files.chosen);
  result.report = files.report;
  ROS_INFO("'%s': %u evaluations, %u failed, in %.1f s; %s", job.study.name.c_str(), result.evaluations,
           result.failed, outcome.wall_s, files.report.c_str());
  return result;
}

}  // namespace lamina
