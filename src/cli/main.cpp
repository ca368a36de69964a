// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "lamina/base/error.hpp"
#include "separate_command.hpp"

int main(int argc, char** argv) {
  using namespace lamina::cli;
  try {
    std::vector<std::string> arguments = withHelpAsOption({argv, argv + argc});
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (std::string& argument : arguments) words.push_back(argument.data());
    const auto count = static_cast<int>(words.size());
    words.push_back(nullptr);
    runSeparateCommand(count, words.data());
    return runCommandLine(count, words.data(),
                          {{"calibrate", addCalibrate},
                           {"check", addCheck},
                           {"compare", addCompare},
                           {"coordinates", addCoordinates},
                           {"correct", addCorrect},
                           {"deposit", addDeposit},
                           {"emulate", addEmulate},
                           {"expand", addExpand},
                           {"fill-voids", addFillVoids},
                           {"film", addFilm},
                           {"heights", addHeights},
                           {"incline", addIncline},
                           {"info", addInfo},
                           {"lay", addLay},
                           {"metrics", addMetrics},
                           {"overhang", addOverhang},
                           {"part", addPart},
                           {"pores", addPores},
                           {"preview", addPreview},
                           {"profiles", addProfiles},
                           {"replan", addReplan},
                           {"resume", addResume},
                           {"robot", addRobot},
                           {"rotate", addRotate},
                           {"scaffold", addScaffold},
                           {"slice", addSlice},
                           {"statistics", addStatistics},
                           {"stiffness", addStiffness},
                           {"stream", addStream},
                           {"sweep", addSweep},
                           {"track", addTrack},
                           {"voids", addVoids},
                           {"", addSeparateCommands}});
  } catch (const lamina::Error& error) {
    std::fprintf(stderr, "lamina: %s\n", error.what());
    return 1;
  } catch (...) {
    std::fputs("lamina: cannot start; out of memory?\n", stderr);
    return 1;
  }
}
