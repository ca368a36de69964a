// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/picture/html.hpp"

namespace lamina {
namespace {

using Row = std::vector<std::string>;

std::string rangeOf(const Variable& variable) {
  if (variable.kind == VariableKind::Categorical) return listed(variable.choices);
  if (variable.kind == VariableKind::Levels) {
    Row levels;
    for (const double level : variable.levels) levels.push_back(numberText(level));
    return listed(levels);
  }
  return numberText(variable.low) + " to " + numberText(variable.high) +
         (variable.kind == VariableKind::Integer ? ", whole" : "");
}

std::string intervalOf(const Constraint& constraint) {
  if (std::isinf(constraint.low)) return "at most " + numberText(constraint.high);
  if (std::isinf(constraint.high)) return "at least " + numberText(constraint.low);
  return numberText(constraint.low) + " to " + numberText(constraint.high);
}

/// What is wanted of a response, as a person says it; empty if nothing is.
std::string goalOf(const Goals& goals, const std::string& response) {
  Row wanted;
  for (const Objective& objective : goals.objectives) {
    if (objective.response != response) continue;
    if (objective.weight == 0.0)
      wanted.emplace_back("predicted only");
    else
      wanted.push_back(std::string(objective.sense == Sense::Minimise ? "small" : "large") + ", weight " +
                       numberText(objective.weight));
  }
  for (const Constraint& constraint : goals.constraints)
    if (constraint.response == response) wanted.push_back(intervalOf(constraint));
  return listed(wanted, "; ");
}

/// Cells under a head of names; empty where a row has none.
Row cellsUnder(const Row& names, const std::vector<SettingText>& values) {
  std::map<std::string, std::string> found;
  for (const SettingText& value : values) found[value.key] = value.text;
  Row cells;
  for (const std::string& name : names) cells.push_back(found[name]);
  return cells;
}

/// Variables, then responses.
Row columnsOf(const Study& study, const Row& response_names) {
  Row columns;
  for (const Variable& variable : study.variables) columns.push_back(variable.name);
  columns.insert(columns.end(), response_names.begin(), response_names.end());
  return columns;
}

void addChosen(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  page.heading("Chosen configuration");
  if (!outcome.chosen) {
    page.paragraph(outcome.front.empty() ? "Nothing that was tried keeps to all constraints."
                                         : "Nothing is chosen from the front; see the notes.");
    return;
  }
  HtmlTable variables{{"variable", "chosen", "allowed"}, {}, 0};
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const Variable& variable = study.variables[i];
    const double value = outcome.chosen->point.at(i);
    const bool is_text = variable.kind == VariableKind::Categorical;
    variables.rows.push_back(
        {variable.name, is_text ? textOf(variable, value) : numberText(value), rangeOf(variable)});
  }
  page.table(variables);
  HtmlTable responses{{"response", "measured", "goal"}, {}, 0};
  for (std::size_t i = 0; i < outcome.front_response_names.size(); ++i)
    responses.rows.push_back({outcome.front_response_names[i], numberText(outcome.chosen->responses.at(i)),
                              goalOf(study.goals, outcome.front_response_names[i])});
  page.table(responses);
}

void addPictures(HtmlPage& page, const std::string& heading, const std::vector<ReportPicture>& pictures) {
  if (pictures.empty()) return;
  page.heading(heading);
  std::vector<std::string> pngs;
  Row descriptions;
  for (const ReportPicture& picture : pictures) {
    pngs.push_back(picture.png);
    descriptions.push_back(picture.description);
  }
  page.pictures(pngs, descriptions);
}

void addCompared(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  if (outcome.compared.size() < 2) return;
  page.heading("Beside what was published");
  if (!study.published_source.empty()) page.paragraph(study.published_source);
  // One column for each row: there are few of them, and many variables and responses.
  HtmlTable table{{""}, {}, 0};
  for (const ComparedRow& row : outcome.compared) table.head.push_back(row.name);
  for (const std::string& name : columnsOf(study, outcome.front_response_names)) {
    Row cells = {name};
    for (const ComparedRow& row : outcome.compared) cells.push_back(cellsUnder({name}, row.values).front());
    table.rows.push_back(cells);
  }
  page.table(table);
}

void addFront(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  if (outcome.front.empty()) return;
  page.heading("Front: " + std::to_string(outcome.front.size()) +
               " configurations, none better in everything");
  HtmlTable table{columnsOf(study, outcome.front_response_names), {}, 0};
  table.head.emplace_back("index of decision");
  std::vector<std::size_t> order(outcome.front.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto isChosen = [&](std::size_t i) {
    return outcome.chosen && outcome.front[i].point == outcome.chosen->point;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return isChosen(a) && !isChosen(b); });
  if (outcome.chosen) table.marked_rows = 1;
  const Row columns = columnsOf(study, outcome.front_response_names);
  for (const std::size_t i : order) {
    table.rows.push_back(
        cellsUnder(columns, valuesOf(study.variables, outcome.front_response_names, outcome.front[i])));
    table.rows.back().push_back(i < outcome.decision_indices.size() ? numberText(outcome.decision_indices[i])
                                                                    : "");
  }
  page.table(table);
}

void addIterations(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  if (!outcome.surrogate || outcome.surrogate->iterations.empty()) return;
  page.heading("Proposed points");
  page.paragraph("Ended: " + std::string(toString(outcome.surrogate->end)) + ".");
  HtmlTable table{{"iteration"}, {}, 0};
  for (const Variable& variable : study.variables) table.head.push_back(variable.name);
  for (const std::string& name : outcome.response_names) {
    table.head.push_back(name + " predicted");
    table.head.push_back(name + " measured");
  }
  table.head.insert(table.head.end(), {"MAPE [%]", "verdict"});
  for (const SurrogateIteration& iteration : outcome.surrogate->iterations) {
    Row row = {std::to_string(iteration.index)};
    for (std::size_t i = 0; i < study.variables.size(); ++i) {
      const bool is_text = study.variables[i].kind == VariableKind::Categorical;
      row.push_back(is_text ? textOf(study.variables[i], iteration.proposed[i])
                            : numberText(iteration.proposed[i]));
    }
    const bool is_measured = isEvaluated(iteration.measured);
    for (std::size_t i = 0; i < outcome.response_names.size(); ++i) {
      row.push_back(numberText(iteration.predictions.at(i).value));
      row.push_back(is_measured ? numberText(iteration.measured.responses.at(i)) : "");
    }
    row.push_back(is_measured ? numberText(iteration.mape_percent) : "");
    row.emplace_back(!is_measured             ? "not measured"
                     : iteration.is_sample    ? "a sample already"
                     : !iteration.is_feasible ? "outside constraints"
                     : iteration.is_accepted  ? "accepted"
                                              : "predicted too badly");
    table.rows.push_back(row);
  }
  page.table(table);
  if (outcome.surrogate->iterations.back().surrogates.empty()) return;
  HtmlTable surrogates{{"response", "surrogate of the last iteration"}, {}, 0};
  for (std::size_t i = 0; i < outcome.response_names.size(); ++i)
    surrogates.rows.push_back(
        {outcome.response_names[i], outcome.surrogate->iterations.back().surrogates.at(i)});
  page.table(surrogates);
}

void addFailures(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  page.heading("Failed evaluations: " + std::to_string(failedCount(outcome.evaluations)) + " of " +
               std::to_string(outcome.evaluations.size()));
  std::map<std::string, std::size_t> counts;
  for (const Evaluation& evaluation : outcome.evaluations)
    if (!isEvaluated(evaluation)) ++counts[evaluation.error];
  HtmlTable reasons{{"times", "error"}, {}, 0};
  for (const auto& [error, count] : counts) reasons.rows.push_back({std::to_string(count), error});
  page.table(reasons);
  HtmlTable points{columnsOf(study, {}), {}, 0};
  points.head.emplace_back("error");
  for (const Evaluation& evaluation : outcome.evaluations) {
    if (isEvaluated(evaluation)) continue;
    points.rows.push_back(cellsUnder(columnsOf(study, {}), valuesOf(study.variables, {}, evaluation)));
    points.rows.back().push_back(evaluation.error);
  }
  page.table(points);
}

std::string measureOf(const Study& study) {
  if (study.slice) return "slices of " + study.slice->part;
  if (study.commands) {
    Row names;
    for (const StudyCommand& command : study.commands->commands) names.push_back(command.name);
    return "commands: " + listed(names);
  }
  return "the table " + study.table;
}

void addMaking(HtmlPage& page, const Study& study, const StudyOutcome& outcome) {
  page.heading("How this was made");
  HtmlTable table{{"", ""}, {}, 0};
  table.rows = {{"method", study.method == SearchMethod::Nsga2 ? "NSGA-II" : "surrogate"},
                {"measured by", measureOf(study)},
                {"evaluations", std::to_string(outcome.evaluations.size())},
                {"seed", std::to_string(outcome.seed)},
                {"time [s]", numberText(outcome.wall_s)},
                {"version", "Lamina " + outcome.version}};
  if (study.method == SearchMethod::Nsga2) table.rows.push_back({"decision", study.decision.method});
  for (const SettingText& weight : outcome.weights)
    table.rows.push_back({"weight of " + weight.key, weight.text});
  for (const SettingText& setting : outcome.search) table.rows.push_back({setting.key, setting.text});
  page.table(table);
}

}  // namespace

std::string studyReport(const Study& study, const StudyOutcome& outcome) {
  HtmlPage page(study.name);
  if (!study.about.empty()) page.paragraph(study.about);
  for (const std::string& note : outcome.notes) page.paragraph("Note: " + note);
  addChosen(page, study, outcome);
  addCompared(page, study, outcome);
  addPictures(page, "Objectives against each other", frontPictures(study, outcome));
  addPictures(page, "How the search went", progressPictures(study, outcome));
  addIterations(page, study, outcome);
  addFront(page, study, outcome);
  addFailures(page, study, outcome);
  addMaking(page, study, outcome);
  return page.text();
}

}  // namespace lamina
