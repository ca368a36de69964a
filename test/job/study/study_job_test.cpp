// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/study/study_job.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/csv_table.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/study/study_measurement.hpp"
#include "lamina/kinematics/cartesian/cartesian_machine.hpp"
#include "lamina/kriging/kriging.hpp"
#include "lamina/metrics/toolpath_metrics.hpp"
#include "lamina/optimisation/criteria.hpp"
#include "lamina/optimisation/front_csv.hpp"
#include "lamina/study/study_reader.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

const std::string kPart = R"(name: small box
variables:
  infill.pitch_mm: [0.3, 1]
  walls.count: {low: 1, high: 2, whole: true}
slice:
  part: box
  parameters: {x_mm: 6, y_mm: 5, z_mm: 2}
  settings: {slicing.layer_height_mm: 0.5, slicing.first_layer_height_mm: 0.5, skirt.count: 0}
  front_metrics: [print_time_s, material_mm, under_fill_mm2, volume_error_mm3]
  baselines: {dense: {infill.pitch_mm: 0.4}}
objectives: {under_fill_mm2: minimise, material_mm: minimise}
search: {nsga2.population: 8, nsga2.generations: 2}
decision: {weights: {under_fill_mm2: 3}}
published: {rows: {theirs: {infill.pitch_mm: 0.5, walls.count: 1, material_mm: 100}}}
)";

const std::string kParabola = R"(name: parabola
method: surrogate
variables: {x: [-1, 3]}
commands:
  only: [awk, 'BEGIN {x = {x}; printf "{\"y\": %.9g, \"z\": %.9g}", (x - 1.5) * (x - 1.5) + 1, x}']
responses:
  y: {command: only, pointer: /y}
  z: {command: only, pointer: /z}
objectives: {y: minimise}
constraints: {z: {high: 1}}
search: {surrogate.samples: 8, surrogate.iterations: 2}
seed: 3
)";

/// Cancelled after so many questions.
class CancelledLater final : public Progress {
 public:
  explicit CancelledLater(int questions) : left_(questions) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override { return --left_ < 0; }

 private:
  mutable std::atomic<int> left_;
};

StudyOutcome ran(const std::string& yaml, const std::string& folder,
                 EarlierJournal earlier = EarlierJournal::GoOn) {
  NoProgress progress;
  return runStudy({readStudy(yaml, "study", ""), folder, earlier}, krigingFit(KrigingSettings()), nullptr, {},
                  progress);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(StudyJob, SearchesAFrontOfAPartAndWritesWhatItFound) {
  const test::ScratchFolder folder;
  const StudyOutcome outcome = ran(kPart, folder.file("out"));
  EXPECT_EQ(failedCount(outcome.evaluations), 0U);
  EXPECT_GT(outcome.front.size(), 1U);
  ASSERT_TRUE(outcome.chosen);
  EXPECT_EQ(outcome.front_response_names.size(), 4U);
  EXPECT_EQ(outcome.decision_indices.size(), outcome.front.size());
  ASSERT_EQ(outcome.compared.size(), 4U);
  EXPECT_EQ(outcome.compared[2].name, "theirs, measured here");
  EXPECT_EQ(outcome.compared[3].name, "dense, measured here");
  EXPECT_EQ(outcome.compared[3].values.size(), 4U);

  const StudyFiles files = studyFilesIn(folder.file("out"));
  const JobSettings chosen = loadJobSettings(files.chosen, {});
  EXPECT_EQ(chosen.planning.infill.pitch_mm, outcome.chosen->point[0]);
  EXPECT_EQ(chosen.slicing.layer_height_mm, 0.5);
  for (const std::string& file : {files.front, files.evaluations, files.picture, files.report, files.journal})
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(readCsvTable(files.front).rows.size(), outcome.front.size());
}

/// Variables of the study first, then what they measured.
double responseOf(const StudyOutcome& outcome, const Evaluation& evaluation, const std::string& name) {
  return evaluation.responses.at(responseIndex(outcome.front_response_names, name));
}

TEST(StudyJob, BeginsWithDefaultsBaselinesAndWhatWasPublished) {
  const test::ScratchFolder folder;
  const std::string own = changed(kPart, "skirt.count: 0}", "skirt.count: 0, infill.pitch_mm: 0.6}");
  const StudyOutcome outcome = ran(own, folder.file("out"));
  const int walls = JobSettings().planning.walls.count;
  ASSERT_GE(outcome.evaluations.size(), 3U);
  EXPECT_EQ(outcome.evaluations[0].point, (DesignPoint{0.6, static_cast<double>(walls)})) << "defaults";
  EXPECT_EQ(outcome.evaluations[1].point, (DesignPoint{0.4, static_cast<double>(walls)})) << "dense";
  EXPECT_EQ(outcome.evaluations[2].point, (DesignPoint{0.5, 1.0})) << "theirs";
}

TEST(StudyJob, SaysWhichBaselinesAreNoPointsOfTheSearch) {
  const test::ScratchFolder folder;
  const std::string other =
      changed(kPart, "dense: {infill.pitch_mm: 0.4}", "spiral: {infill.strategy: spiral}");
  const StudyOutcome outcome = ran(other, folder.file("out"));
  const auto isOfTheBaseline = [](const std::string& note) {
    return note == "not among the first points: spiral: sets infill.strategy, no variable of the search";
  };
  EXPECT_TRUE(std::any_of(outcome.notes.begin(), outcome.notes.end(), isOfTheBaseline));
}

/// With any weights: those of material alone would choose the sparsest.
TEST(StudyJob, ChoosesNothingThatAKnownPointIsBetterThanInEveryGoal) {
  for (const char* weights : {"under_fill_mm2: 3", "material_mm: 100", "print_time_s: 50"}) {
    const test::ScratchFolder folder;
    const StudyOutcome outcome = ran(changed(kPart, "under_fill_mm2: 3", weights), folder.file("out"));
    ASSERT_TRUE(outcome.chosen);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::vector<double>& known = outcome.evaluations[i].responses;
      EXPECT_FALSE(responseOf(outcome, *outcome.chosen, "under_fill_mm2") > known[0] &&
                   responseOf(outcome, *outcome.chosen, "material_mm") > known[1])
          << weights << ", " << i;
    }
  }
}

TEST(StudyJob, ReportsAllWeightsItDecidedBy) {
  const test::ScratchFolder folder;
  const StudyOutcome outcome = ran(kPart, folder.file("out"));
  ASSERT_EQ(outcome.weights.size(), 4U);
  const std::string report = readFile(studyFilesIn(folder.file("out")).report);
  // Named in the study; the usual one of volume error; the usual one of all others.
  for (const char* row : {"weight of under_fill_mm2</td><td class=\"number\">3<",
                          "weight of volume_error_mm3</td><td class=\"number\">3<",
                          "weight of print_time_s</td><td class=\"number\">1<",
                          "weight of material_mm</td><td class=\"number\">1<"})
    EXPECT_NE(report.find(row), std::string::npos) << row;
}

TEST(StudyJob, ReportsEachGeneration) {
  const test::ScratchFolder folder;
  std::vector<StudyState> states;
  NoProgress progress;
  const StudyOutcome outcome = runStudy(
      {readStudy(kPart, "study", ""), folder.file("out"), {}}, {}, nullptr,
      [&](const StudyState& state) { states.push_back(state); }, progress);
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states.back().index, 2);
  EXPECT_EQ(static_cast<std::size_t>(states.back().evaluations), outcome.evaluations.size());
  ASSERT_EQ(states.back().best.size(), 2U);
  for (const Evaluation& evaluation : outcome.evaluations)
    EXPECT_GE(evaluation.responses[0], states.back().best[0]);
}

TEST(StudyJob, GoesOnAfterACancelAsIfItHadNotStopped) {
  const test::ScratchFolder folder;
  ran(kPart, folder.file("whole"));
  CancelledLater progress(60);
  const StudyJob job{readStudy(kPart, "study", ""), folder.file("stopped"), {}};
  EXPECT_THROW(runStudy(job, {}, nullptr, {}, progress), Cancelled);
  const StudyFiles whole = studyFilesIn(folder.file("whole"));
  const StudyFiles stopped = studyFilesIn(folder.file("stopped"));
  EXPECT_TRUE(std::filesystem::exists(stopped.journal));
  EXPECT_FALSE(std::filesystem::exists(stopped.report));
  ran(kPart, folder.file("stopped"));
  EXPECT_EQ(readFile(stopped.front), readFile(whole.front));
  EXPECT_EQ(readFile(stopped.evaluations), readFile(whole.evaluations));
  EXPECT_EQ(readFile(stopped.chosen), readFile(whole.chosen));
}

TEST(StudyJob, RefusesTheJournalOfAnotherStudyUnlessItBeginsAnew) {
  const test::ScratchFolder folder;
  ran(kPart, folder.file("out"));
  const std::string other = changed(kPart, "x_mm: 6", "x_mm: 7");
  EXPECT_THROW(ran(other, folder.file("out")), InvalidInput);
  const std::string journal = studyFilesIn(folder.file("out")).journal;
  const std::string before = readFile(journal);
  const std::string unusable =
      changed(other, "nsga2.generations: 2",
              "nsga2.generations: 2, nsga2.crossover_share: 0, nsga2.mutation_share: 0");
  EXPECT_THROW(ran(unusable, folder.file("out"), EarlierJournal::BeginAnew), InvalidConfig);
  EXPECT_EQ(readFile(journal), before);
  EXPECT_NO_THROW(ran(other, folder.file("out"), EarlierJournal::BeginAnew));
}

TEST(StudyJob, LearnsFromCommandsAndKeepsToConstraints) {
  const test::ScratchFolder folder;
  std::vector<StudyState> states;
  NoProgress progress;
  const StudyOutcome outcome = runStudy(
      {readStudy(kParabola, "study", ""), folder.file("out"), {}}, krigingFit(KrigingSettings()), nullptr,
      [&](const StudyState& state) { states.push_back(state); }, progress);
  ASSERT_TRUE(outcome.surrogate);
  ASSERT_EQ(states.size(), outcome.surrogate->iterations.size());
  EXPECT_EQ(static_cast<std::size_t>(states.back().evaluations), outcome.evaluations.size());
  EXPECT_EQ(states.back().best, std::vector<double>{outcome.chosen->responses[0]});
  ASSERT_TRUE(outcome.chosen);
  EXPECT_NEAR(outcome.chosen->point[0], 1.0, 0.02);
  EXPECT_LE(outcome.chosen->responses[1], 1.0);
  EXPECT_EQ(readFile(studyFilesIn(folder.file("out")).chosen).rfind("x: ", 0), 0U);
}

TEST(StudyJob, RecordsWhatCannotBeTried) {
  const test::ScratchFolder folder;
  const std::string failing = changed(changed(changed(kParabola, "method: surrogate", "method: nsga2"),
                                              "{surrogate.samples: 8, surrogate.iterations: 2}",
                                              "{nsga2.population: 8, nsga2.generations: 1}"),
                                      "BEGIN {x = {x};", "BEGIN {x = {x}; if (x < 0) exit 7;");
  const StudyOutcome outcome = ran(failing, folder.file("out"));
  ASSERT_GT(failedCount(outcome.evaluations), 0U);
  ASSERT_LT(failedCount(outcome.evaluations), outcome.evaluations.size());
  for (const Evaluation& evaluation : outcome.evaluations) {
    EXPECT_EQ(isEvaluated(evaluation), evaluation.point[0] >= 0.0);
    EXPECT_EQ(evaluation.error.find("exit code 7") != std::string::npos, evaluation.point[0] < 0.0);
  }
  const std::string report = readFile(studyFilesIn(folder.file("out")).report);
  EXPECT_NE(report.find("exit code 7"), std::string::npos);
}

TEST(StudyJob, WaitsForSomebodyToMeasureWhatATableProposes) {
  const test::ScratchFolder folder;
  writeFile(folder.file("made.csv"), "x,y\n-1,7.25\n0,3.25\n1,1.25\n3,3.25\n");
  const std::string yaml = "method: surrogate\nvariables: {x: [-1, 3]}\ntable: " + folder.file("made.csv") +
                           "\nobjectives: {y: minimise}\n";
  const StudyOutcome outcome = ran(yaml, folder.file("out"));
  ASSERT_TRUE(outcome.surrogate);
  EXPECT_EQ(outcome.surrogate->end, SurrogateEnd::NotMeasured);
  ASSERT_EQ(outcome.notes.size(), 1U);
  EXPECT_EQ(outcome.notes[0].rfind("next to be measured: x ", 0), 0U);
  ASSERT_TRUE(outcome.chosen);
  EXPECT_EQ(outcome.chosen->point[0], 1.0);
}

TEST(StudyJob, TakesWhatWasMeasuredNearAProposalForItsAnswer) {
  const test::ScratchFolder folder;
  writeFile(folder.file("made.csv"),
            "x,iteration,y\n-1,,7.25\n0,,3.25\n0.9,,1.36\n2,,1.25\n3,,3.25\n1.45,1,1.0025\n");
  const std::string yaml = "method: surrogate\nvariables: {x: [-1, 3]}\ntable: " + folder.file("made.csv") +
                           "\nobjectives: {y: minimise}\nsearch: {surrogate.answer_nearness: 0.1}\n";
  const StudyOutcome outcome = ran(yaml, folder.file("out"));
  ASSERT_TRUE(outcome.surrogate);
  ASSERT_FALSE(outcome.surrogate->iterations.empty());
  EXPECT_TRUE(isEvaluated(outcome.surrogate->iterations.front().measured));
  ASSERT_TRUE(outcome.chosen);
  EXPECT_EQ(outcome.chosen->point[0], 1.45);
}

TEST(StudyJob, RefusesBeforeAnythingIsTried) {
  const auto expectRefused = [](const std::string& from, const std::string& to, const std::string& what) {
    const test::ScratchFolder folder;
    try {
      ran(changed(kPart, from, to), folder.file("out"));
      ADD_FAILURE() << to << " is not refused";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
    EXPECT_TRUE(folder.isEmpty());
  };
  expectRefused("infill.pitch_mm: [0.3, 1]", "infill.pitsch_mm: [0.3, 1]", "did you mean 'infill.pitch_mm'");
  expectRefused("[0.3, 1]", "[-0.3, 1]", "variable infill.pitch_mm");
  expectRefused("{low: 1, high: 2, whole: true}", "[1, 2.5]", "variable walls.count");
  expectRefused("dense: {infill.pitch_mm: 0.4}", "dense: {infill.pitch: 0.4}", "baseline dense");
  expectRefused("{under_fill_mm2: minimise, material_mm", "{under_fil_mm2: minimise, material_mm",
                "under_fil_mm2");
  expectRefused("front_metrics: [print_time_s,", "front_metrics: [print_time,", "'print_time'");
  expectRefused("weights: {under_fill_mm2", "weights: {over", "'over'");
  expectRefused("weights: {under_fill_mm2: 3",
                "weights: {print_time_s: 0, material_mm: 0, volume_error_mm3: 0, under_fill_mm2: 0",
                "all weights of the decision are 0");
  expectRefused("part: box", "part: bocks", "bocks");
  expectRefused("x_mm: 6", "x: 6", "'x'");
}

TEST(StudyJob, LabelsWhatWasChosenByWhatWasMeasuredOfIt) {
  const test::ScratchFolder folder;
  const std::string unreachable =
      changed(changed(kPart, "skirt.count: 0", "skirt.count: 0, metrics.platform_middle_mm: '5000,0'"),
              "[print_time_s,", "[control_energy_nm2_s,");
  const StudyOutcome outcome = ran(unreachable, folder.file("out"));
  ASSERT_TRUE(outcome.chosen);
  EXPECT_EQ(outcome.front_response_names, outcome.response_names);
  ASSERT_FALSE(outcome.compared.empty());
  EXPECT_EQ(outcome.compared[0].name, "chosen");
  const std::vector<SettingText>& values = outcome.compared[0].values;
  ASSERT_EQ(values.size(), 4U);
  EXPECT_EQ(values[2].key, outcome.response_names[0]);
  EXPECT_EQ(values[2].text, numberText(outcome.chosen->responses[0]));
}

TEST(StudyJob, ChoosesNothingIfNoWeightIsLeft) {
  const test::ScratchFolder folder;
  const std::string unmeasured = changed(
      changed(kPart, "volume_error_mm3]", "volume_error_mm3, control_energy_nm2_s]"), "{under_fill_mm2: 3}",
      "{print_time_s: 0, material_mm: 0, under_fill_mm2: 0, volume_error_mm3: 0, control_energy_nm2_s: 2}");
  const std::string unreachable =
      changed(unmeasured, "skirt.count: 0", "skirt.count: 0, metrics.platform_middle_mm: '5000,0'");
  const StudyFiles files = studyFilesIn(folder.file("out"));
  ran(kPart, folder.file("out"));
  EXPECT_TRUE(std::filesystem::exists(files.chosen));
  const StudyOutcome outcome = ran(unreachable, folder.file("out"), EarlierJournal::BeginAnew);
  EXPECT_FALSE(outcome.chosen);
  EXPECT_FALSE(outcome.front.empty());
  const auto isOfTheChoice = [](const std::string& note) { return note.rfind("nothing is chosen", 0) == 0; };
  EXPECT_TRUE(std::any_of(outcome.notes.begin(), outcome.notes.end(), isOfTheChoice));
  EXPECT_TRUE(std::filesystem::exists(files.front));
  EXPECT_FALSE(std::filesystem::exists(files.chosen));
  EXPECT_NE(readFile(files.report).find("Nothing is chosen from the front"), std::string::npos);
}

TEST(StudyJob, ChoosesAsTheFrontIsDecidedOnByItself) {
  const test::ScratchFolder folder;
  const StudyOutcome outcome =
      ran(changed(kPart, "decision: {weights: {under_fill_mm2: 3}}\n", ""), folder.file("out"));
  const FrontTable front = readFrontCsv(studyFilesIn(folder.file("out")).front);
  std::vector<std::vector<double>> responses;
  for (const FrontRow& row : front.rows) responses.push_back(row.responses);
  const Decision decision = decide(criteriaOf(front.responses, {}, {}), responses, DecisionMethod::Linmap);
  EXPECT_EQ(decision.indices, outcome.decision_indices);
  EXPECT_EQ(outcome.front[decision.chosen].point, outcome.chosen->point);
}

TEST(StudyJob, WritesOverNothingThatItReads) {
  const test::ScratchFolder folder;
  const auto refused = [&](const std::string& name, const std::string& yaml, const std::string& text) {
    writeFile(folder.file(name), text);
    Study study = readStudy(yaml, "study", folder.file(""));
    NoProgress progress;
    EXPECT_THROW(runStudy({study, folder.file(""), EarlierJournal::BeginAnew}, krigingFit(KrigingSettings()),
                          nullptr, {}, progress),
                 InvalidInput)
        << name;
    EXPECT_EQ(readFile(folder.file(name)), text);
    std::filesystem::remove(folder.file(name));
  };
  refused("chosen.yaml", changed(kPart, "part: box", "part: box\n  config: chosen.yaml"), "skirt.count: 0\n");
  refused("evaluations.csv",
          "method: surrogate\nvariables: {x: [-1, 3]}\ntable: evaluations.csv\nobjectives: {y: minimise}\n",
          "x,y\n-1,7.25\n0,3.25\n1,1.25\n3,3.25\n");
  writeFile(folder.file("chosen.yaml"), kParabola);
  NoProgress progress;
  EXPECT_THROW(runStudy({readStudyFile(folder.file("chosen.yaml")), folder.file(""), {}},
                        krigingFit(KrigingSettings()), nullptr, {}, progress),
               InvalidInput);
  EXPECT_EQ(readFile(folder.file("chosen.yaml")), kParabola);
}

TEST(StudyMeasurement, DependsOnAllThatIsMeasured) {
  const auto fingerprint = [](const std::string& yaml) {
    return StudyMeasurement(readStudy(yaml, "study", "")).fingerprint();
  };
  const std::string usual = fingerprint(kPart);
  EXPECT_EQ(usual.size(), 16U);
  EXPECT_EQ(fingerprint(changed(kPart, "small box", "another")), usual);
  EXPECT_NE(fingerprint(changed(kPart, "x_mm: 6", "x_mm: 7")), usual);
  EXPECT_NE(fingerprint(changed(kPart, "skirt.count: 0", "skirt.count: 1")), usual);
  EXPECT_NE(fingerprint(kParabola), fingerprint(changed(kParabola, "1.5", "1.6")));
  const std::string two = changed(kParabola, "  only:", "  before: [echo, a]\n  only:");
  EXPECT_NE(fingerprint(two),
            fingerprint(changed(two, "[echo, a]\n  only: [awk, ", "[echo]\n  only: [a, awk, ")));
  EXPECT_NE(fingerprint(two), fingerprint(changed(two, "before", "first")));
}

TEST(StudyMeasurement, DependsOnTheBaseThatIsLainOn) {
  const test::ScratchFolder folder;
  const auto fingerprint = [&](const Mesh& base) {
    writeStl(folder.file("base.stl"), base);
    const std::string yaml =
        changed(kPart, "skirt.count: 0", "skirt.count: 0, conformal.base: " + folder.file("base.stl"));
    return StudyMeasurement(readStudy(yaml, "study", "")).fingerprint();
  };
  const std::vector<SettingText> wide = {{"x_mm", "9"}};
  EXPECT_NE(fingerprint(makePart("box", {})), fingerprint(makePart("box", wide)));
}

/// Each file is written, and the study read with the settings; then another text is written, and the study
/// read again.
void expectDependsOn(const test::ScratchFolder& folder, const std::string& yaml, const std::string& file,
                     const std::pair<std::string, std::string>& texts) {
  const auto fingerprint = [&](const std::string& text) {
    writeFile(folder.file(file), text);
    return StudyMeasurement(readStudy(yaml, "study", "")).fingerprint();
  };
  const std::string usual = fingerprint(texts.first);
  EXPECT_NE(fingerprint(texts.second), usual) << file;
  EXPECT_EQ(fingerprint(texts.first), usual) << file;
}

TEST(StudyMeasurement, DependsOnTheContentsOfFilesThatSettingsName) {
  const test::ScratchFolder folder;
  const auto withSetting = [&](const std::string& setting) {
    return changed(kPart, "skirt.count: 0", "skirt.count: 0, " + setting);
  };
  const std::string heights =
      withSetting("slicing.heights: file, slicing.heights_file: " + folder.file("heights.csv"));
  expectDependsOn(folder, heights, "heights.csv", {"z_mm,height_mm\n0,0.5\n", "z_mm,height_mm\n0,0.4\n"});

  const std::string given = withSetting(
      "slicing.mode: volumetric, volumetric.target: given, volumetric.target_file: " + folder.file("up.csv"));
  expectDependsOn(folder, given, "up.csv",
                  {"x,y,z,nx,ny,nz\n0,0,0,0,0,1\n", "x,y,z,nx,ny,nz\n0,0,0,0,1,1\n"});

  const std::string urdf = std::string(machineByName("cartesian_gantry").urdf);
  const std::string machine = withSetting("machine.urdf: " + folder.file("machine.urdf"));
  expectDependsOn(folder, machine, "machine.urdf", {urdf, urdf + "<!-- rebuilt -->"});

  const std::string list = "modifiers:\n  - mesh: region.stl\n    settings: {walls.count: 3}\n";
  const std::string modified = withSetting("part.modifiers: " + folder.file("regions.yaml"));
  writeStl(folder.file("region.stl"), makePart("box", {{"x_mm", "2"}}));
  const std::string region = readFile(folder.file("region.stl"));
  expectDependsOn(folder, modified, "regions.yaml", {list, changed(list, "count: 3", "count: 4")});
  writeFile(folder.file("regions.yaml"), list);
  writeStl(folder.file("region.stl"), makePart("box", {{"x_mm", "3"}}));
  expectDependsOn(folder, modified, "region.stl", {region, readFile(folder.file("region.stl"))});
}

TEST(StudyMeasurement, DependsOnFilesThatVariablesAndBaselinesName) {
  const test::ScratchFolder folder;
  const std::string one = folder.file("one.csv");
  const std::string two = folder.file("two.csv");
  writeFile(one, "z_mm,height_mm\n0,0.5\n");
  writeFile(two, "z_mm,height_mm\n0,0.4\n");
  const std::string usual =
      changed(kPart, "skirt.count: 0", "skirt.count: 0, slicing.heights: file, slicing.heights_file: " + one);
  const std::string baseline =
      changed(usual, "{infill.pitch_mm: 0.4}", "{slicing.heights_file: " + two + "}");
  const std::string varied = changed(
      usual, "variables:\n", "variables:\n  slicing.heights_file: {choices: [" + one + ", " + two + "]}\n");
  for (const std::string& yaml : {baseline, varied})
    expectDependsOn(folder, yaml, "two.csv", {"z_mm,height_mm\n0,0.4\n", "z_mm,height_mm\n0,0.3\n"});
}

TEST(StudyMeasurement, ConfigurationsOfCommandsCanBeReadBack) {
  const Study study =
      readStudy(changed(kParabola, "{x: [-1, 3]}", "{x: {choices: ['a: b', 'no # c', '{d}']}}"), "study", "");
  const StudyMeasurement measurement(study);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto read = settingsFromYaml(measurement.configurationAt({static_cast<double>(i)}), "chosen");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].text, study.variables[0].choices[i]);
  }
}

}  // namespace
}  // namespace lamina
