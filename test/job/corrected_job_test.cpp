// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/corrected_job.hpp"

#include <gtest/gtest.h>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "lamina/streaming/journal/job_journal.hpp"
#include "support/control_layers.hpp"
#include "support/corrected_programs.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::string beadText() {
  std::string text;
  writeGcode(test::stackedBeads(3), Eigen::Isometry3d::Identity(), {},
             [&](std::string_view piece) { text += piece; });
  return text;
}

CorrectionMap evenMap(std::size_t layer, double amount) {
  const Toolpath part = test::stackedBeads(3);
  const LayerCells cells = layerCells(part.layers[layer], layer, 0.5);
  return correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, toolpathId(part), 1);
}

/// A folder as the streamer leaves it whose second layer was deposited by a map.
std::string recordOf(const StreamableProgram& program, const test::ScratchFolder& folder) {
  const std::string id = toolpathId(test::stackedBeads(3));
  const CorrectionMap map = evenMap(1, 0.2);
  const AppliedRow row{1, 1, digestOf(map), 1};
  writeFile(folder.file("toolpath.csv"), programmedToolpathCsv({id, test::stackedBeads(3)}));
  writeFile(folder.file(appliedMapFile(row)), correctionMapCsv(map));
  writeFile(folder.file("record.csv"), appliedRecordCsv({sha256Of(program), id, "the job"}, {row}));
  return folder.file("");
}

TEST(CorrectedJob, IsTheProgramOfItsRecord) {
  const test::ScratchFolder folder;
  const auto planned = StreamableProgram::fromText("beads", beadText());
  const CorrectionFiles files{recordOf(planned, folder), {}};
  const PlannedCorrection correction = correctionFrom(files, {}, sha256Of(planned));
  EXPECT_TRUE(correction.is_recorded_program);
  const StreamableProgram made = programByMaps(planned, files, correction, {});
  EXPECT_EQ(made.name(), "beads");
  const std::string expected = correctedByMaps("beads", beadText(), test::recordedIn(files.maps)).text;
  EXPECT_EQ(sha256Of(made), sha256Of(StreamableProgram::fromText("beads", expected)));
  ASSERT_TRUE(made.origin() && made.origin()->record);
  EXPECT_EQ(made.origin()->program_sha256, sha256Of(planned));
  EXPECT_EQ(made.origin()->record->job, "the job");
  ASSERT_EQ(made.origin()->maps.size(), 1U);
  EXPECT_EQ(made.origin()->maps[0].digest, digestOf(evenMap(1, 0.2)));
}

TEST(CorrectedJob, IsRefusedByMapsOfAnotherToolpath) {
  const test::ScratchFolder folder;
  const auto planned = StreamableProgram::fromText("beads", beadText());
  const CorrectionFiles files{recordOf(planned, folder), {}};
  writeFile(folder.file("toolpath.csv"), programmedToolpathCsv({"another", test::stackedBeads(3)}));
  EXPECT_THROW(correctionFrom(files, {}, sha256Of(planned)), InvalidInput);
  EXPECT_THROW(correctionFrom({folder.file("nowhere"), {}}, {}, ""), FileError);
}

}  // namespace
}  // namespace lamina
