// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/study/command_measurement.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

/// Cancelled once a file holds a whole line.
class CancelledByAFile final : public Progress {
 public:
  explicit CancelledByAFile(std::string file) : file_(std::move(file)) {}
  void report(const std::string&, double) override {}
  bool isCancelled() const override {
    return std::filesystem::exists(file_) && readFile(file_).find('\n') != std::string::npos;
  }

 private:
  std::string file_;
};

/// What the program of a process id was called with; empty once it has ended.
std::string callOf(const std::string& pid) {
  std::ifstream file("/proc/" + pid + "/cmdline");
  return {std::istreambuf_iterator<char>(file), {}};
}

Study studyOf(std::vector<std::string> arguments, const std::string& pointer = "/y") {
  Study study;
  study.variables = {{"x", VariableKind::Continuous, -10.0, 10.0, {}, {}}};
  study.commands = CommandMeasure{{{"only", std::move(arguments)}}, {{"y", "only", pointer}}, 60.0};
  return study;
}

double measured(const Study& study, double x) {
  NoProgress progress;
  return commandMeasurement(study)({x}, progress).at(0);
}

std::string refusalOf(const Study& study) {
  try {
    measured(study, 1.0);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(CommandMeasurement, PutsVariablesIntoArgumentsAndReadsTheNumber) {
  EXPECT_EQ(measured(studyOf({"printf", R"({"y": {x}})"}), 0.1), 0.1);
  EXPECT_EQ(measured(studyOf({"printf", R"({"a": [{"b": {x}}]})"}, "/a/0/b"), -2.5), -2.5);
}

TEST(CommandMeasurement, RunsCommandsInOrderInOneScratchFolderThatIsGoneAfterwards) {
  Study study = studyOf({"cp", "/dev/null", "{folder}/made"});
  study.variables.front().name = "unused";
  study.commands->commands.push_back({"list", {"ls", "{folder}"}});
  study.commands->commands.push_back({"tell", {"printf", R"({"path": "{folder}", "y": 1})"}});
  study.commands->responses = {{"y", "tell", "/y"}};
  EXPECT_EQ(measured(study, 1.0), 1.0);
  study.commands->responses = {{"y", "tell", "/path"}};
  const std::string reported = refusalOf(study);
  const std::size_t begin = reported.find('"') + 1;
  const std::string folder = reported.substr(begin, reported.find('"', begin) - begin);
  const test::ScratchFolder beside;
  EXPECT_EQ(std::filesystem::path(folder).parent_path(),
            std::filesystem::path(beside.file("")).parent_path().parent_path())
      << reported;
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(CommandMeasurement, RunsInTheFolderOfTheStudy) {
  const test::ScratchFolder folder;
  writeFile(folder.file("here.json"), R"({"y": 7})");
  Study study = studyOf({"cat", "here.json"});
  study.folder = std::filesystem::path(folder.file("")).parent_path().string();
  EXPECT_EQ(measured(study, 1.0), 7.0);
}

TEST(CommandMeasurement, NeedsNoShell) {
  const test::ScratchFolder folder;
  Study study = studyOf({"printf", "%s", R"({"y": 1, "text": "$(touch {out}) `touch {out}`; touch {out}"})"});
  study.variables.push_back({"out", VariableKind::Categorical, 0, 0, {}, {folder.file("bad"), "; false"}});
  NoProgress progress;
  for (const double choice : {0.0, 1.0})
    EXPECT_EQ(commandMeasurement(study)({1.0, choice}, progress).at(0), 1.0);
  EXPECT_TRUE(folder.isEmpty());
}

TEST(CommandMeasurement, ReportsWhatFailed) {
  EXPECT_NE(refusalOf(studyOf({"sh", "-c", "echo broken >&2; exit 3"})).find("exit code 3: broken"),
            std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"sh", "-c", "kill -9 $$"})).find("exit code 137"), std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"/no/such/program"})).find("cannot start '/no/such/program'"),
            std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"echo", "no json"})).find("no JSON: no json"), std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"echo", R"({"z": 1})"})).find("/y stands nothing"), std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"echo", R"({"y": "1"})"})).find("\"1\""), std::string::npos);
  EXPECT_NE(refusalOf(studyOf({"echo", R"({"y": null})"})).find("null"), std::string::npos);
}

TEST(CommandMeasurement, ReportsTheEndOfWhatIsLongInWholeCharacters) {
  const std::string shifts[] = {"", "x", "xx"};
  for (const std::string& shift : shifts) {
    std::string characters;
    for (int i = 0; i < 400; ++i) characters += "\xE2\x82\xAC";
    const std::string reported =
        refusalOf(studyOf({"sh", "-c", "echo '" + characters + shift + "' >&2; exit 1"}));
    EXPECT_NE(reported.find(": ...\xE2\x82\xAC"), std::string::npos) << reported;
    EXPECT_LT(reported.size(), 600U);
  }
  EXPECT_LT(refusalOf(studyOf({"echo", "{\"y\": \"" + std::string(5000, 'a') + "\"}"})).size(), 700U);
}

TEST(CommandMeasurement, EndsWhatRunsTooLong) {
  Study study = studyOf({"sleep", "1000"});
  study.commands->time_limit_s = 0.1;
  NoProgress progress;
  EXPECT_THROW(commandMeasurement(study)({1.0}, progress), TimedOut);
}

TEST(CommandMeasurement, EndsAllThatACommandStartedWhenItIsCancelled) {
  const test::ScratchFolder folder;
  const Study study = studyOf({"sh", "-c", "sleep 1000 & echo $! > " + folder.file("pid") + "; wait"});
  CancelledByAFile progress(folder.file("pid"));
  EXPECT_THROW(commandMeasurement(study)({1.0}, progress), Cancelled);
  const std::string line = readFile(folder.file("pid"));
  const std::string pid = line.substr(0, line.find('\n'));
  ASSERT_GT(std::stoi(pid), 0);
  // The kernel ends what was killed a moment later.
  const auto last = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (callOf(pid).find("sleep") != std::string::npos && std::chrono::steady_clock::now() < last)
    std::this_thread::yield();
  EXPECT_EQ(callOf(pid).find("sleep"), std::string::npos) << "process " << pid << " goes on";
}

TEST(CommandMeasurement, DoesNotWaitForWhatACommandLeavesRunning) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(measured(studyOf({"sh", "-c", "sleep 100 & echo '{\"y\": 4}'"}), 1.0), 4.0);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(50));
}

TEST(CommandMeasurement, TakesMuchOutputOnBothStreams) {
  EXPECT_EQ(measured(studyOf({"sh", "-c",
                              "head -c 3000000 /dev/zero >&2; echo '{\"y\": 4}'; "
                              "head -c 3000000 /dev/zero | tr '\\0' ' '"}),
                     1.0),
            4.0);
}

}  // namespace
}  // namespace lamina
