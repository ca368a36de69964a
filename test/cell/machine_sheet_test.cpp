// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/machine_sheet.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "lamina/base/scratch_folder.hpp"

namespace lamina {
namespace {

TEST(MachineSheet, NamesEachValueThatDiffers) {
  const ScratchFolder folder;
  ArtefactStore artefacts(folder.path());
  QueuedJob job;
  job.machine = "gantry";
  EXPECT_TRUE(machineDifferences(job, {"gantry", "a: 1\n"}, artefacts).empty()) << "it has no sheet";
  job.artefacts = {artefacts.keepText("a: 1\nb: 2\n", kMachineSheet, "machine.txt")};
  EXPECT_TRUE(machineDifferences(job, {"gantry", "a: 1\nb: 2\n"}, artefacts).empty());
  EXPECT_TRUE(machineDifferences(job, {"gantry", ""}, artefacts).empty()) << "only the name is known";
  EXPECT_EQ(machineDifferences(job, {"arm", "a: 1\nb: 2\n"}, artefacts),
            std::vector<std::string>{"the machine is 'arm'; expected 'gantry'"});
  EXPECT_EQ(machineDifferences(job, {"gantry", "b: 3\nc: 4\n"}, artefacts),
            (std::vector<std::string>{"a is not stated; expected 1", "b is 3; expected 2",
                                      "c is 4; expected not stated"}));
  EXPECT_EQ(machineDifferences(job, {"gantry", "b: 2\na: 1\n"}, artefacts),
            std::vector<std::string>{"its description differs"});
  std::filesystem::remove(artefacts.pathOf(job.artefacts.front()));
  EXPECT_EQ(machineDifferences(job, {"gantry", "a: 2\n"}, artefacts),
            std::vector<std::string>{"a is 2; expected not stated"});
}

}  // namespace
}  // namespace lamina
