// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/mesh_io/mesh_writer.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "lamina/job/modes/slicing_mode.hpp"
#include "lamina/job/slice_job.hpp"
#include "lamina/slicing/unsliceable.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

class AutomaticChoice : public ::testing::Test {
 protected:
  AutomaticChoice() {
    job_.settings.slicing.mode = "auto";
    job_.settings.slicing.layer_height_mm = 0.5;
    job_.settings.slicing.first_layer_height_mm = 0.5;
    job_.settings.planning.bead.width_mm = 0.8;
    job_.settings.planning.walls.count = 1;
    job_.settings.planning.infill.density = 1.0;
    job_.settings.machine.name = "five_axis_head_table";
  }

  void usePart(const std::string& name, const std::vector<SettingText>& parameters = {}) {
    job_.part = folder_.file(name + ".stl");
    writeStl(job_.part, makePart(name, parameters));
  }

  void usePartOffTheBed(const std::string& name, const std::vector<SettingText>& parameters = {}) {
    Mesh mesh = makePart(name, parameters);
    for (Point3& vertex : mesh.vertices) vertex.x() += 5000.0;
    job_.part = folder_.file(name + ".stl");
    writeStl(job_.part, mesh);
    job_.settings.placement = Placement::AsIs;
  }

  /// Its arms hang by 6 mm, over a stem 24 mm high.
  void useTee() {
    usePart("tee", {{"stem_mm", "10"},
                    {"stem_height_mm", "24"},
                    {"bar_mm", "22"},
                    {"bar_height_mm", "4"},
                    {"width_mm", "8"}});
  }

  SlicedPart slice() {
    NoProgress nobody;
    return runSliceJob(job_, nobody);
  }

  std::string program(const std::string& mode) {
    job_.settings.slicing.mode = mode;
    slice();
    return readFile(job_.output);
  }

  Failure failure(const std::string& mode) {
    job_.settings.slicing.mode = mode;
    try {
      slice();
      return {};
    } catch (const Error&) {
      return currentFailure();
    }
  }

  test::ScratchFolder folder_;
  SliceJob job_;
};

bool isNoted(const SliceSummary& summary, const std::string& text) {
  return std::any_of(summary.notes.begin(), summary.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

TEST_F(AutomaticChoice, APartThatLevelLayersHoldGetsThemToTheByte) {
  usePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4"}});
  for (const char* const file : {"box.csv", "box.gcode"}) {
    job_.output = folder_.file(file);
    EXPECT_TRUE(program("auto") == program("planar")) << file;
  }
  job_.settings.slicing.mode = "auto";
  const SliceSummary summary = slice().summary;
  EXPECT_EQ(summary.mode, "planar");
  ASSERT_EQ(summary.candidates.size(), 1U) << "nothing else has to be tried";
  EXPECT_EQ(summary.candidates.front().unsupported_percent, 0.0);
  EXPECT_EQ(summary.candidates.front().layers, summary.layers);
}

TEST_F(AutomaticChoice, AFirstLayerThatFollowsTheNozzleIsThatOfLevelLayers) {
  usePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4"}});
  job_.output = folder_.file("box.csv");
  const auto of_nozzle = [&](const std::string& mode) {
    job_.settings = loadJobSettings(
        "", {{"slicing.mode", mode}, {"machine.nozzle_mm", "0.6"}, {"slicing.layer_height_mm", "0.2"}});
    return program(mode);
  };
  EXPECT_TRUE(of_nozzle("auto") == of_nozzle("planar"));
  EXPECT_EQ(job_.settings.slicing.first_layer_height_mm, 0.3) << "half of the nozzle";
}

TEST_F(AutomaticChoice, ATeeIsPrintedInPieces) {
  useTee();
  const SlicedPart sliced = slice();
  EXPECT_EQ(sliced.summary.mode, "multi_direction") << sliced.summary.mode_reason;
  ASSERT_EQ(sliced.summary.candidates.size(), 2U);
  // Both arms' undersides, of the whole surface.
  const double surface = 2 * (10.0 * 24 + 22.0 * 4) + 8.0 * (10 + 2 * 24 + 12 + 2 * 4 + 22.0);
  EXPECT_NEAR(sliced.summary.candidates.front().unsupported_percent, 100.0 * 12.0 * 8.0 / surface, 1e-3);
  EXPECT_LE(sliced.summary.candidates.back().unsupported_percent, 1.0);
  EXPECT_GE(sliced.summary.candidates.back().steps, 2U);
  EXPECT_NE(sliced.summary.mode_reason.find("planar would leave"), std::string::npos);
  EXPECT_TRUE(isNoted(sliced.summary, "not planar: it would leave"));
  const std::string id = toolpathId(sliced.toolpath);
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(slice().toolpath), id);
}

TEST_F(AutomaticChoice, AHeadThatCannotTiltGetsLevelLayers) {
  useTee();
  job_.settings.machine.name = "cartesian_gantry";
  const SliceSummary summary = slice().summary;
  EXPECT_EQ(summary.mode, "planar");
  EXPECT_EQ(summary.candidates.size(), 1U);
  EXPECT_TRUE(isNoted(summary, "cartesian_gantry holds it as it is"));
}

/// A mode of a plug-in while it lives: level layers, said to leave nothing unsupported.
class SupportingMode {
 public:
  SupportingMode(std::string name, AutoTrial trial, int turn) : name_(std::move(name)) {
    SlicingMode mode = slicingModes().find("planar");
    mode.plan = [planar = mode.plan](SourcePart source, const PlanningRequest& request, Progress& progress) {
      PlannedPart planned = planar(std::move(source), request, progress);
      planned.support = SupportMeasures{};
      return planned;
    };
    mode.auto_trial = trial;
    mode.auto_turn = turn;
    slicingModes().add(name_, mode);
  }
  SupportingMode(const SupportingMode&) = delete;
  SupportingMode& operator=(const SupportingMode&) = delete;
  ~SupportingMode() { slicingModes().remove(name_); }

 private:
  std::string name_;
};

TEST_F(AutomaticChoice, TriesTheModesOfPlugInsInTheirTurn) {
  useTee();
  job_.settings.machine.name = "cartesian_gantry";
  const SupportingMode unasked("never_tried", AutoTrial::None, 0);
  const SupportingMode tilting("of_tilting_heads", AutoTrial::TiltingHead, 0);
  const SupportingMode later("a_later_one", AutoTrial::AnyHead, 9);
  const SupportingMode own("their_own", AutoTrial::AnyHead, 4);
  const SliceSummary summary = slice().summary;
  EXPECT_EQ(summary.mode, "their_own") << summary.mode_reason;
  ASSERT_EQ(summary.candidates.size(), 2U);
  EXPECT_EQ(summary.candidates.front().mode, "planar") << "its turn is the first";
  job_.settings.machine.name = "five_axis_head_table";
  EXPECT_EQ(slice().summary.mode, "of_tilting_heads") << "of one turn, in the order of their names";
}

TEST_F(AutomaticChoice, AnInclinedHeadGetsLayersAcrossIt) {
  usePart("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4"}});
  job_.settings.machine.name = "gantry_45";
  job_.output = folder_.file("box.gcode");
  const std::string chosen = program("auto");
  EXPECT_EQ(slice().summary.mode, "inclined");
  job_.settings.slicing.plane.angle_deg = 45.0;
  EXPECT_TRUE(chosen == program("inclined"));
}

TEST_F(AutomaticChoice, RefusalsAreReported) {
  usePart("cone", {{"radius_mm", "6"}, {"top_radius_mm", "13"}, {"height_mm", "4"}});
  job_.settings.directions.most_cuts = 0;
  job_.settings.adapted.max_lean_deg = 50.0;
  const SliceSummary summary = slice().summary;
  EXPECT_EQ(summary.mode, "volumetric") << summary.mode_reason;
  ASSERT_EQ(summary.candidates.size(), 4U);
  EXPECT_NE(summary.candidates[1].refusal.find("directions.largest_unsupported_percent"), std::string::npos);
  EXPECT_NE(summary.candidates[2].refusal.find("adapted.max_lean_deg"), std::string::npos);
  EXPECT_TRUE(isNoted(summary, "not multi_direction: "));
  EXPECT_TRUE(isNoted(summary, "not adapted: "));
}

TEST_F(AutomaticChoice, WhatOtherSettingsContradictIsRefused) {
  useTee();
  job_.settings.scan.every_layers = 3;
  const SliceSummary summary = slice().summary;
  EXPECT_EQ(summary.mode, "planar");
  ASSERT_EQ(summary.candidates.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_NE(summary.candidates[i].refusal.find("scan.every_layers"), std::string::npos) << i;
}

TEST_F(AutomaticChoice, APartThatNoModeTakesIsRefusedWithAllReasons) {
  usePart("box", {{"z_mm", "0.1"}});
  try {
    slice();
    FAIL() << "half of the first layer is higher than the part";
  } catch (const InvalidInput& refusal) {
    EXPECT_EQ(refusal.code(), ErrorCode::InvalidMesh);
    for (const char* const mode : {"planar", "multi_direction", "adapted", "volumetric"})
      EXPECT_NE(std::string(refusal.what()).find(std::string("not ") + mode + ": "), std::string::npos)
          << refusal.what();
  }
}

// Where nothing is to choose, the error is that of the mode.
TEST_F(AutomaticChoice, TheOnlyModeRefusesAPartByItsOwnError) {
  usePart("box", {{"z_mm", "0.1"}});
  job_.settings.machine.name = "cartesian_gantry";
  const Failure by_planar = failure("planar");
  EXPECT_EQ(by_planar.code, ErrorCode::InvalidInput) << by_planar.message;
  const Failure by_auto = failure("auto");
  EXPECT_EQ(by_auto.code, by_planar.code) << by_auto.message;
  EXPECT_EQ(by_auto.message, by_planar.message);
}

// Its sides lean by far more than adapted.max_lean_deg, and it is too low for a layer.
TEST_F(AutomaticChoice, ARefusalOfAllShowsWhatStandsInTheWay) {
  usePart("cone", {{"radius_mm", "20"}, {"top_radius_mm", "1"}, {"height_mm", "0.2"}});
  try {
    slice();
    FAIL() << "half of the first layer is higher than the part";
  } catch (const Unsliceable& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("not planar: "), std::string::npos) << refusal.what();
    EXPECT_FALSE(refusal.region().triangles.empty());
    EXPECT_FALSE(refusal.part().triangles.empty());
  }
}

// The joints of its head turn by 50 deg at most, the arms of the tee take more.
TEST_F(AutomaticChoice, WhatTheMachineCannotRunGivesWayToTheNextMode) {
  useTee();
  job_.settings.machine.name = "five_axis_head_ab";
  job_.output = folder_.file("tee.gcode");
  const Failure by_name = failure("multi_direction");
  ASSERT_EQ(by_name.code, ErrorCode::Unreachable) << by_name.message;
  job_.settings.slicing.mode = "auto";
  const SliceSummary summary = slice().summary;
  EXPECT_NE(summary.mode, "multi_direction");
  ASSERT_GE(summary.candidates.size(), 3U) << "those behind it are tried";
  const ModeCandidate& pieces = summary.candidates[1];
  EXPECT_EQ(pieces.mode, "multi_direction");
  EXPECT_EQ(pieces.refusal, by_name.message);
  EXPECT_LE(pieces.unsupported_percent, 1.0);
  EXPECT_GE(pieces.steps, 2U);
  EXPECT_NE(summary.mode_reason.find("; multi_direction would leave 0.00 % of the surface unsupported in "),
            std::string::npos)
      << summary.mode_reason;
  EXPECT_NE(summary.mode_reason.find("but the machine cannot run it: " + by_name.message), std::string::npos)
      << summary.mode_reason;
  const std::string program_of_auto = readFile(job_.output);
  EXPECT_TRUE(program_of_auto == program(summary.mode));
}

// Neither pieces nor adapted layers take its sides; of the others the machine reaches nothing.
TEST_F(AutomaticChoice, WhatTheMachineRunsInNoModeIsOutOfReachForAllReasons) {
  usePartOffTheBed("cone", {{"radius_mm", "6"}, {"top_radius_mm", "13"}, {"height_mm", "4"}});
  job_.settings.directions.most_cuts = 0;
  job_.settings.adapted.max_lean_deg = 50.0;
  job_.output = folder_.file("cone.gcode");
  const Failure by_auto = failure("auto");
  EXPECT_EQ(by_auto.code, ErrorCode::Unreachable) << by_auto.message;
  for (const char* const mode : {"planar", "multi_direction", "adapted", "volumetric"})
    EXPECT_NE(by_auto.message.find(std::string("not ") + mode + ": "), std::string::npos) << by_auto.message;
}

TEST_F(AutomaticChoice, TheOnlyModeThatAMachineCannotRunIsRefusedByItsOwnError) {
  usePartOffTheBed("box", {{"x_mm", "8"}, {"y_mm", "6"}, {"z_mm", "4"}});
  job_.settings.machine.name = "cartesian_gantry";
  job_.output = folder_.file("box.gcode");
  const Failure by_planar = failure("planar");
  EXPECT_EQ(by_planar.code, ErrorCode::Unreachable) << by_planar.message;
  EXPECT_EQ(failure("auto").message, by_planar.message);
}

TEST_F(AutomaticChoice, ALaxerLimitTakesTheSimplerMode) {
  useTee();
  job_.settings.automatic.good_unsupported_percent = 20.0;
  EXPECT_EQ(slice().summary.mode, "planar");
}

TEST_F(AutomaticChoice, SkinsAreFollowedWhereThatIsAskedFor) {
  usePart("cone", {{"radius_mm", "20"}, {"top_radius_mm", "1"}, {"height_mm", "5"}});
  EXPECT_EQ(slice().summary.mode, "planar");
  job_.settings.automatic.follows_skins = true;
  const SliceSummary tilting = slice().summary;
  EXPECT_EQ(tilting.mode, "curved");
  EXPECT_NE(tilting.mode_reason.find("slopes gently"), std::string::npos);
  job_.settings.machine.name = "cartesian_gantry";
  EXPECT_EQ(slice().summary.mode, "heightfield") << "the head is fixed";
  usePart("box");
  EXPECT_EQ(slice().summary.mode, "planar");
}

TEST_F(AutomaticChoice, ABaseIsDepositedOn) {
  usePart("box");
  job_.settings.conformal.base = job_.part;
  Mesh plate = makePart("box", {{"z_mm", "2"}});
  for (Point3& vertex : plate.vertices) vertex.z() += 20.0;
  job_.part = folder_.file("plate.stl");
  writeStl(job_.part, plate);
  EXPECT_EQ(slice().summary.mode, "conformal");
}

class CancelledChoice final : public Progress {
 public:
  explicit CancelledChoice(int reports) : left_(reports) {}
  void report(const std::string&, double) override { --left_; }
  bool isCancelled() const override { return left_ <= 0; }

 private:
  std::atomic<int> left_;
};

TEST_F(AutomaticChoice, IsCancelledLikeAnyOther) {
  useTee();
  for (const int reports : {1, 5, 200}) {
    CancelledChoice progress(reports);
    EXPECT_THROW(runSliceJob(job_, progress), Cancelled) << reports;
  }
}

class CancelledInStage final : public Progress {
 public:
  explicit CancelledInStage(std::string stage) : stage_(std::move(stage)) {}
  void report(const std::string& stage, double) override {
    if (stage == stage_) is_cancelled_ = true;
  }
  bool isCancelled() const override { return is_cancelled_; }

 private:
  std::string stage_;
  std::atomic<bool> is_cancelled_{false};
};

// Of adapted layers it is measured after they are planned; pieces and planar ones leave too much.
TEST_F(AutomaticChoice, IsCancelledWhileSupportIsMeasured) {
  usePart("cone", {{"radius_mm", "6"}, {"top_radius_mm", "12"}, {"height_mm", "5"}});
  job_.settings.directions.most_cuts = 0;
  CancelledInStage progress("overhang");
  EXPECT_THROW(runSliceJob(job_, progress), Cancelled);
}

TEST(AutomaticSettings, OutOfBoundsAreRefused) {
  for (const auto& [key, value] :
       {std::pair("auto.good_unsupported_percent", "101"), std::pair("auto.good_unsupported_percent", "-1"),
        std::pair("auto.alike_percent", "-0.1"), std::pair("auto.longest_time", "0.9"),
        std::pair("auto.max_overhang_deg", "61"), std::pair("auto.follow_skins", "perhaps")})
    EXPECT_THROW(loadJobSettings("", {{key, value}}), InvalidConfig) << key << " = " << value;
}

}  // namespace
}  // namespace lamina
