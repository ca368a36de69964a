// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/study_reader.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/study/search_settings.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

const std::string kSliced = R"(name: Box
about: smallest possible
method: nsga2
variables:
  infill.pitch_mm: [0.3, 2.5]
  infill.link: {choices: [tangential, average]}
  infill.perimeters: {low: 1, high: 3, whole: true}
  slicing.layer_height_mm: {levels: [0.15, 0.3]}
slice:
  part: box
  parameters: {x_mm: 10, y_mm: 5}
  config: base.yaml
  settings: {infill: {strategy: zigzag}, skirt.count: 0}
  metrics: [under_fill_mm2, material_mm, print_time_s]
  baselines:
    lines: {infill.strategy: raster}
objectives:
  under_fill_mm2: minimise
  material_mm: {sense: minimise, weight: 0.5}
constraints:
  print_time_s: {high: 100}
search: {nsga2.population: 8}
seed: 7
decision: {method: topsis, weights: {under_fill_mm2: 3}}
published:
  source: Table 1
  rows:
    theirs: {infill.pitch_mm: 0.4, under_fill_mm2: 12}
)";

const std::string kCommanded = R"(method: surrogate
variables:
  a: [0, 1]
commands:
  first: [lamina, scaffold, sinusoidal, --set, "scaffold.amplitude_mm={a}", -o, "{folder}/p.csv"]
  second: [lamina, pores, "{folder}/p.csv", --json]
responses:
  porosity_percent: {command: second, pointer: /porosity_percent}
  pore_um: {command: second, pointer: /pore_um}
time_limit_s: 60
table: made.csv
objectives:
  porosity_percent: maximise
constraints:
  pore_um: [300, 700]
)";

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("nothing to change: " + from);
  return text.replace(at, from.size(), to);
}

std::string studyReaderRefusalOf(const std::string& yaml) {
  try {
    readStudy(yaml, "s.yaml", "");
  } catch (const InvalidConfig& error) {
    return error.what();
  }
  return "nothing refused";
}

TEST(StudyReader, ReadsAStudyOfAPart) {
  const Study study = readStudy(kSliced, "s.yaml", "folder");
  EXPECT_EQ(study.name, "Box");
  EXPECT_EQ(study.about, "smallest possible");
  EXPECT_EQ(study.method, SearchMethod::Nsga2);
  ASSERT_EQ(study.variables.size(), 4U);
  EXPECT_EQ(study.variables[0].kind, VariableKind::Continuous);
  EXPECT_EQ(study.variables[0].high, 2.5);
  EXPECT_EQ(study.variables[1].choices, (std::vector<std::string>{"tangential", "average"}));
  EXPECT_EQ(study.variables[2].kind, VariableKind::Integer);
  EXPECT_EQ(study.variables[3].levels, (std::vector<double>{0.15, 0.3}));
  ASSERT_TRUE(study.slice);
  EXPECT_EQ(study.slice->part, "box");
  EXPECT_EQ(study.slice->parameters.at(1).key, "y_mm");
  EXPECT_EQ(study.slice->config, "folder/base.yaml");
  EXPECT_EQ(study.slice->settings.at(0).key, "infill.strategy");
  EXPECT_EQ(study.slice->baselines.at(0).settings.at(0).text, "raster");
  EXPECT_EQ(study.goals.objectives.at(1).weight, 0.5);
  EXPECT_EQ(study.goals.constraints.at(0).high, 100.0);
  EXPECT_EQ(study.search.back().key, "nsga2.population");
  EXPECT_EQ(searchSettingsOf(study).nsga2.population, 8);
  EXPECT_EQ(searchSettingsOf(study).nsga2.seed, 7);
  EXPECT_EQ(study.decision.method, "topsis");
  EXPECT_EQ(study.decision.weights.at(0).text, "3");
  EXPECT_EQ(study.published.at(0).values.at(1).text, "12");
  EXPECT_EQ(responseNames(study), study.slice->metrics);
}

TEST(StudyReader, ReadsAStudyOfCommands) {
  const Study study = readStudy(kCommanded, "path/s.yaml", "");
  EXPECT_EQ(study.name, "s");
  EXPECT_EQ(study.method, SearchMethod::Surrogate);
  ASSERT_TRUE(study.commands);
  EXPECT_EQ(study.commands->commands.at(0).arguments.at(1), "scaffold");
  EXPECT_EQ(study.commands->time_limit_s, 60.0);
  EXPECT_EQ(study.table, "made.csv");
  EXPECT_EQ(responseNames(study), (std::vector<std::string>{"porosity_percent", "pore_um"}));
  EXPECT_EQ(study.goals.objectives.at(0).sense, Sense::Maximise);
  EXPECT_EQ(study.goals.constraints.at(0).low, 300.0);
}

TEST(StudyReader, LetsItsSeedWinOverWhatIsUsualButNotOverWhatIsNamed) {
  const auto seedOf = [](const std::string& yaml) {
    Study study = readStudy(yaml, "s.yaml", "");
    study.search.insert(study.search.begin(), {"nsga2.seed", "5"});
    return searchSettingsOf(study).nsga2.seed;
  };
  EXPECT_EQ(seedOf(kSliced), 7);
  EXPECT_EQ(seedOf(changed(kSliced, "seed: 7\n", "")), 5);
  EXPECT_EQ(seedOf(changed(kSliced, "population: 8", "population: 8, nsga2.seed: 9")), 9);
}

TEST(StudyReader, RefusesNamesThatTablesHaveTwice) {
  const auto expectRefused = [](const std::string& yaml, const std::string& what) {
    EXPECT_NE(studyReaderRefusalOf(yaml).find(what), std::string::npos) << studyReaderRefusalOf(yaml);
  };
  const std::string table =
      "method: surrogate\ntable: t.csv\nvariables: {a: [0, 1]}\nobjectives: {y: minimise}\n";
  EXPECT_EQ(studyReaderRefusalOf(table), "nothing refused");
  expectRefused(changed(table, "y:", "a:"), "response a");
  expectRefused(changed(table, "y:", "error:"), "response error");
  expectRefused(changed(table, "a:", "iteration:"), "variables: iteration");
  expectRefused(table + "search: {surrogate.iterations: 5, surrogate.most_iterations: 4}\n",
                "surrogate.iterations is 5");
}

TEST(StudyReader, FindsFilesBesideTheStudy) {
  const test::ScratchFolder folder;
  writeFile(folder.file("box"), "a mesh");
  writeFile(folder.file("s.yaml"), kSliced);
  EXPECT_EQ(readStudyFile(folder.file("s.yaml")).slice->part, folder.file("box"));
  EXPECT_THROW(readStudyFile(folder.file("none.yaml")), FileError);
}

TEST(StudyReader, NamesLineAndKeyOfWhatItRefuses) {
  const auto expectRefused = [](const std::string& yaml, const std::string& line, const std::string& what) {
    const std::string refusal = studyReaderRefusalOf(yaml);
    EXPECT_NE(refusal.find("s.yaml:" + line + ": "), std::string::npos) << refusal;
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
  };
  expectRefused(changed(kSliced, "about:", "abuot:"), "1", "unknown key 'abuot'");
  expectRefused(changed(kSliced, "about: smallest possible", "name: again"), "1", "'name' stands twice");
  expectRefused(changed(kSliced, "nsga2\n", "best\n"), "3", "method: 'best'");
  expectRefused(changed(kSliced, "[0.3, 2.5]", "[0.3]"), "5", "two bounds");
  expectRefused(changed(kSliced, "[0.3, 2.5]", "[2.5, 0.3]"), "5", "infill.pitch_mm");
  expectRefused(changed(kSliced, "[0.3, 2.5]", "[0.3, wide]"), "5", "'wide'");
  expectRefused(changed(kSliced, "[0.3, 2.5]", "[0.3, .inf]"), "5", "finite");
  expectRefused(changed(kSliced, "{choices: [tangential, average]}", "{choices: [one]}"), "6", "choices");
  expectRefused(changed(kSliced, "{choices:", "{low: 1, choices:"), "6", "expected [low, high]");
  expectRefused(changed(kSliced, "whole: true", "whole: maybe"), "7", "true or false");
  expectRefused(changed(kSliced, "high: 3, whole", "high: 2.5, whole"), "7", "whole numbers");
  expectRefused(changed(kSliced, "[0.15, 0.3]", "[0.3, 0.15]"), "8", "ascending");
  expectRefused(changed(kSliced, "  part: box\n", ""), "10", "'part'");
  expectRefused(changed(kSliced, "metrics: [under_fill_mm2,", "metrics: ["), "1", "under_fill_mm2");
  expectRefused(changed(kSliced, "under_fill_mm2: minimise", "under_fill_mm2: smallest"), "18", "smallest");
  expectRefused(changed(kSliced, "weight: 0.5", "weight: -1"), "19", "at least 0");
  expectRefused(changed(kSliced, "{high: 100}", "{low: 200, high: 100}"), "21", "between");
  expectRefused(changed(kSliced, "nsga2.population", "nsga2.popluation"), "22",
                "did you mean 'nsga2.population'");
  expectRefused(changed(kSliced, "population: 8", "population: 1"), "22", "nsga2.population is '1'");
  expectRefused(changed(kSliced, "seed: 7", "seed: 1.5"), "23", "whole number");
  expectRefused(changed(kSliced, "topsis", "guess"), "24", "linmap or topsis");
  expectRefused(changed(kSliced, "under_fill_mm2: 3", "under_fill_mm2: -3"), "24", "at least 0");
  expectRefused("- a list", "1", "map");
  expectRefused("name: [", "1", "");
  expectRefused("name: x", "1", "'variables'");
}

TEST(StudyReader, RefusesAliasesOfThemselves) {
  EXPECT_NE(studyReaderRefusalOf("search: &again {x: *again}").find("nested too deep"), std::string::npos);
  EXPECT_NE(studyReaderRefusalOf("variables: &again {x: *again}").find("unknown key 'x'"), std::string::npos);
}

TEST(StudyReader, RefusesCommandsThatCannotWork) {
  const auto expectRefused = [](const std::string& from, const std::string& to, const std::string& what) {
    const std::string refusal = studyReaderRefusalOf(changed(kCommanded, from, to));
    EXPECT_NE(refusal.find(what), std::string::npos) << refusal;
  };
  expectRefused("={a}", "={b}", "'{b}' is no variable");
  expectRefused("={a}", "=1", "no command has '{a}'");
  expectRefused("  a: [0, 1]", "  folder: [0, 1]", "scratch folder");
  expectRefused("{command: second, pointer: /pore_um}", "{command: third, pointer: /pore_um}",
                "no command 'third'; there are first, second");
  expectRefused("pointer: /pore_um", "pointer: pore_um", "no JSON pointer");
  expectRefused("pointer: /pore_um", "pointer: ''", "pointer is empty");
  expectRefused("[lamina, pores, \"{folder}/p.csv\", --json]", "[]", "a program and its arguments");
  expectRefused("time_limit_s: 60", "time_limit_s: 0", "more than 0");
  expectRefused("pore_um: [300, 700]", "height: [300, 700]", "no response 'height'");
  expectRefused("method: surrogate", "method: nsga2", "starts a surrogate");
  expectRefused("table: made.csv", "slice: {part: box}", "'slice' and 'commands'");
  expectRefused("table: made.csv", "table: [made.csv]", "single value");
}

TEST(StudyReader, RefusesAStudyWithoutMeasure) {
  const std::string nothing = "variables: {a: [0, 1]}\nobjectives: {y: minimise}\n";
  EXPECT_NE(studyReaderRefusalOf(nothing).find("nothing measures"), std::string::npos);
  EXPECT_NE(studyReaderRefusalOf(nothing + "responses: {y: {command: c, pointer: /y}}").find("no commands"),
            std::string::npos);
  EXPECT_EQ(responseNames(readStudy(nothing + "method: surrogate\ntable: t.csv", "s.yaml", "")),
            std::vector<std::string>{"y"});
}

RC_GTEST_PROP(StudyReader, RefusesOrReadsWhateverTheTextBecomes, ()) {
  std::string yaml = *rc::gen::element(kSliced, kCommanded);
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    const auto at = *rc::gen::inRange<std::size_t>(0, yaml.size());
    const auto length = *rc::gen::inRange<std::size_t>(0, 12);
    const auto piece =
        *rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab01:{}[]-,.'\"\n #&*!|>%@\t~")));
    yaml.replace(at, std::min(length, yaml.size() - at), piece);
  }
  try {
    const Study study = readStudy(yaml, "s.yaml", "");
    validate(study.variables);
    validate(study.goals, responseNames(study));
  } catch (const InvalidConfig& error) {
    RC_ASSERT(std::string(error.what()).find("s.yaml:") != std::string::npos);
  }
}

}  // namespace
}  // namespace lamina
