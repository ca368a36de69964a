// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "lamina/study/evaluations_csv.hpp"
#include "lamina/study/study_reader.hpp"

namespace lamina {
namespace {

const Study& study() {
  static const Study kStudy = readStudy(R"(name: "<script>alert(1)</script>"
about: cheap & strong
variables:
  width: [0, 1]
  kind: {choices: [round, "<b>square</b>"]}
commands:
  only: [tool, "{width}", "{kind}"]
responses:
  cost: {command: only, pointer: /cost}
  strength: {command: only, pointer: /strength}
objectives: {cost: minimise, strength: maximise}
constraints: {cost: {high: 5}}
seed: 11
published: {source: Table 9, rows: {theirs: {width: 0.25, cost: 3.5}}}
)",
                                        "s.yaml", "");
  return kStudy;
}

StudyOutcome outcome() {
  StudyOutcome outcome;
  outcome.response_names = {"cost", "strength"};
  outcome.front_response_names = outcome.response_names;
  outcome.evaluations = {{{0.5, 0}, {2, 10}, ""},
                         {{0.75, 1}, {4, 20}, ""},
                         {{1, 1}, {8, 5}, ""},
                         {{0, 0}, {}, "tool <burst>"},
                         {{0.1, 0}, {}, "tool <burst>"}};
  outcome.front = {outcome.evaluations[0], outcome.evaluations[1]};
  outcome.decision_indices = {0.3, 0.6};
  outcome.chosen = outcome.front[1];
  outcome.generations = {{0, 3, 1, 10.0, {outcome.front[0]}}, {1, 5, 2, 20.0, outcome.front}};
  outcome.compared = {{"chosen", {{"width", "0.75"}, {"cost", "4"}}},
                      {"theirs", study().published[0].values}};
  outcome.notes = {"mind the gap"};
  outcome.search = {{"nsga2.population", "50"}};
  outcome.seed = 11;
  outcome.version = "1.2.3";
  return outcome;
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) ++found;
  return found;
}

TEST(StudyReport, HasWhatAReaderNeeds) {
  const std::string report = studyReport(study(), outcome());
  for (const char* piece :
       {"cheap &amp; strong", "mind the gap", "Table 9", "theirs", "3.5", "large, weight 1",
        "small, weight 1; at most 5", "0.75", "Front: 2 configurations", "Failed evaluations: 2 of 5",
        "<td class=\"number\">2</td><td>tool &lt;burst&gt;</td>", "NSGA-II", "linmap", "nsga2.population",
        "Lamina 1.2.3", "<td>seed</td><td class=\"number\">11</td>", "round, &lt;b&gt;square&lt;/b&gt;"})
    EXPECT_NE(report.find(piece), std::string::npos) << piece;
  EXPECT_EQ(count(report, "<img "), 4U);  // a pair of objectives, hypervolume, the best of each
}

TEST(StudyReport, EscapesAllText) {
  const std::string report = studyReport(study(), outcome());
  EXPECT_EQ(report.find("<script"), std::string::npos);
  EXPECT_EQ(report.find("<burst>"), std::string::npos);
  EXPECT_EQ(report.find("<b>"), std::string::npos);
  EXPECT_NE(report.find("<h1>&lt;script&gt;"), std::string::npos);
}

TEST(StudyReport, SaysThatNothingHoldsTheConstraints) {
  StudyOutcome nothing = outcome();
  nothing.front.clear();
  nothing.chosen.reset();
  EXPECT_NE(studyReport(study(), nothing).find("Nothing that was tried keeps to all constraints"),
            std::string::npos);
}

TEST(StudyReport, LaysPredictionsBesideMeasurements) {
  StudyOutcome searched = outcome();
  searched.front.clear();
  searched.generations.clear();
  SurrogateSearch search;
  SurrogateIteration iteration;
  iteration.index = 1;
  iteration.proposed = {0.75, 1};
  iteration.predictions = {{4.25, 0.1}, {19.5, 0.2}};
  iteration.measured = {{0.75, 1}, {4, 20}, ""};
  iteration.is_feasible = iteration.is_accepted = true;
  iteration.mape_percent = 4.375;
  iteration.surrogates = {"kriging of cost", "kriging of strength"};
  search.iterations = {iteration};
  search.end = SurrogateEnd::Accepted;
  searched.surrogate = search;
  const std::string report = studyReport(study(), searched);
  for (const char* piece : {"4.25", "19.5", "4.375", "accepted", "kriging of strength"})
    EXPECT_NE(report.find(piece), std::string::npos) << piece;
  EXPECT_EQ(count(report, "<img "), 4U);  // a pair of objectives, errors, a response each
  searched.surrogate->iterations[0].measured = {{0.75, 1}, {}, "nobody measured it"};
  EXPECT_NE(studyReport(study(), searched).find("not measured"), std::string::npos);
}

TEST(EvaluationsCsv, HasVariablesResponsesAndErrors) {
  std::vector<Evaluation> evaluations = outcome().evaluations;
  evaluations.push_back({{0.1, 1}, {}, "a \"bad\",\nend"});
  const std::string csv = evaluationsCsv(study().variables, {"cost", "strength"}, evaluations);
  EXPECT_EQ(csv,
            "width,kind,cost,strength,error\n0.5,round,2,10,\n0.75,<b>square</b>,4,20,\n"
            "1,<b>square</b>,8,5,\n0,round,,,tool <burst>\n0.1,round,,,tool <burst>\n"
            "0.1,<b>square</b>,,,\"a \"\"bad\"\",\nend\"\n");
}

}  // namespace
}  // namespace lamina
