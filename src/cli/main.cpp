// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "command_line.hpp"
#include "lamina/base/error.hpp"
#include "separate_command.hpp"

int main(int argc, char** argv) {
  using namespace lamina::cli;
  try {
    runSeparateCommand(argc, argv);
    return runCommandLine(
        argc, argv,
        {addCalibrate,       addCheck,      addCoordinates, addCorrect, addDeposit, addEmulate,  addFillVoids,
         addHeights,         addIncline,    addInfo,        addLay,     addMetrics, addOverhang, addPart,
         addPores,           addPreview,    addProfiles,    addReplan,  addResume,  addRotate,   addScaffold,
         addSlice,           addStatistics, addStiffness,   addStream,  addSweep,   addTrack,    addVoids,
         addSeparateCommands});
  } catch (const lamina::Error& error) {
    std::fprintf(stderr, "lamina: %s\n", error.what());
    return 1;
  } catch (...) {
    std::fputs("lamina: cannot start; out of memory?\n", stderr);
    return 1;
  }
}
