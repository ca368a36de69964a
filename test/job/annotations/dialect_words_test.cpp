// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/job/profiles/layered_settings.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

std::string dialectRefusal(const std::vector<SettingText>& set, const std::string& output = "box.gcode") {
  LayeredSettings layered;
  layered.settings = loadJobSettings("", set);
  try {
    validate(layered, output);
    return "";
  } catch (const InvalidConfig& error) {
    return error.what();
  }
}

const std::map<std::string, std::string> kAdvances = {{"marlin", "M900 K0.1"},
                                                      {"klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.1"},
                                                      {"reprapfirmware", "M572 D0 S0.1"}};

/// The lines of a program that set the pressure advance.
std::string advancesOf(const std::string& dialect, const std::string& word) {
  const test::ScratchFolder folder;
  std::vector<SettingText> set = {{"program.dialect", dialect}, {"flow.advance_s", "0.1"}};
  if (!word.empty()) set.push_back({"flow.advance_word", word});
  const std::string file = folder.file("box.gcode");
  NoProgress nobody;
  runSliceJob({"box", file, loadJobSettings("", set)}, nobody);
  const std::string program = readFile(file);
  std::string found;
  for (const auto& [name, line] : kAdvances)
    if (program.find("\n" + line + "\n") != std::string::npos) found += line;
  return found;
}

TEST(PressureAdvanceOfADialect, IsThatOfItsFirmware) {
  for (const auto& [dialect, line] : kAdvances) {
    EXPECT_EQ(advancesOf(dialect, ""), line) << dialect;
    EXPECT_EQ(advancesOf(dialect, "dialect"), line) << dialect;
    for (const auto& [word, asked] : kAdvances) EXPECT_EQ(advancesOf(dialect, word), asked) << dialect;
  }
}

TEST(PressureAdvanceOfADialect, IsRefusedWhereNothingIsExtruded) {
  for (const char* const word : {"dialect", "marlin", "klipper", "reprapfirmware"}) {
    const std::string refusal =
        dialectRefusal({{"program.dialect", "grbl"}, {"flow.advance_s", "0.1"}, {"flow.advance_word", word}});
    EXPECT_EQ(refusal,
              "flow.advance_s is 0.1 s with program.dialect 'grbl', which has no word for it; expected none");
  }
  EXPECT_EQ(dialectRefusal({{"program.dialect", "grbl"}}), "");
}

/// A table of the toolpath has no dialect; the note says what does not stand in it.
TEST(PressureAdvanceOfADialect, BindsNoOutputsButGcode) {
  const std::vector<SettingText> set = {{"program.dialect", "grbl"}, {"flow.advance_s", "0.1"}};
  EXPECT_EQ(dialectRefusal(set, "box.csv"), "");
  EXPECT_EQ(dialectRefusal(set, ""), "");
  EXPECT_NE(dialectRefusal(set, "box.GCODE"), "");
  const test::ScratchFolder folder;
  NoProgress nobody;
  const SlicedPart sliced = runSliceJob({"box", folder.file("box.csv"), loadJobSettings("", set)}, nobody);
  const std::vector<std::string>& notes = sliced.summary.notes;
  EXPECT_EQ(std::count(notes.begin(), notes.end(),
                       "flow.advance_s has no effect with program.dialect 'grbl', which has no word for it"),
            1);
  EXPECT_THROW(runSliceJob({"box", folder.file("box.gcode"), loadJobSettings("", set)}, nobody),
               InvalidConfig);
}

TEST(LabelsOfADialect, AreRefusedWhereItsFirmwareKnowsNone) {
  const std::map<std::string, std::string> known = {
      {"marlin", "m486"}, {"klipper", "exclude_object"}, {"reprapfirmware", "m486"}, {"grbl", ""}};
  for (const auto& [dialect, own] : known)
    for (const std::string labels : {"none", "m486", "exclude_object"}) {
      const std::string refusal = dialectRefusal({{"program.dialect", dialect}, {"plate.labels", labels}});
      const std::string expected = "plate.labels is '" + labels + "' with program.dialect '" + dialect +
                                   "', which does not know them; expected 'none'" +
                                   (own.empty() ? "" : " or '" + own + "'");
      EXPECT_EQ(refusal, labels == "none" || labels == own ? "" : expected) << dialect << ' ' << labels;
    }
}

}  // namespace
}  // namespace lamina
