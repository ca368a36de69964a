// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/program/planned_correction.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_writer.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

Toolpath plannedPart() { return test::stackedBeads(3); }

std::string plannedText(const Toolpath& part) {
  std::string text;
  writeGcode(part, Eigen::Isometry3d::Identity(), {}, [&](std::string_view piece) { text += piece; });
  return text;
}

/// All beads of a layer by one amount, as the folder of a job has it.
FiledMap evenFiledMap(std::size_t layer, double amount) {
  const LayerCells cells = layerCells(plannedPart().layers[layer], layer, 0.5);
  return {"layer_" + std::to_string(layer) + ".csv",
          correctionMap(cells, {std::vector<double>(cells.size(), amount), {}, {}}, "planned", 1)};
}

PlannedCorrection correctedBy(std::vector<FiledMap> maps) {
  return {{"planned", plannedPart()}, std::move(maps), {}};
}

std::string refusalToCorrect(const std::string& program, const PlannedCorrection& correction) {
  try {
    correctedByMaps("part.gcode", program, correction);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(PlannedCorrection, LaysEachLayerAsItsMapSays) {
  const std::string program = plannedText(plannedPart());
  const CorrectedProgram corrected =
      correctedByMaps("part.gcode", program, correctedBy({evenFiledMap(1, 0.1), evenFiledMap(2, -0.2)}));
  // Two beads of 40 mm in each layer take the same filament: a third of the part each.
  const CorrectionReport one =
      correctedByMaps("part.gcode", program, correctedBy({evenFiledMap(1, 0.1)})).report;
  EXPECT_EQ(one.corrected_lines, 2U);
  EXPECT_NEAR(one.corrected_mm, 1.1 * one.planned_mm, 1e-4);
  EXPECT_NEAR(corrected.report.planned_mm, 2.0 * one.planned_mm, 1e-4);
  EXPECT_NEAR(corrected.report.corrected_mm, (1.1 + 0.8) * one.planned_mm, 1e-4);
}

TEST(PlannedCorrection, MapsOfNothingChangeNoByte) {
  const std::string program = plannedText(plannedPart());
  EXPECT_EQ(
      correctedByMaps("part.gcode", program, correctedBy({evenFiledMap(1, 0.0), evenFiledMap(2, 0.0)})).text,
      program);
  EXPECT_EQ(correctedByMaps("part.gcode", program, correctedBy({})).text, program);
}

TEST(PlannedCorrection, LeadsTheFeeder) {
  FiledMap ramp = evenFiledMap(1, 0.0);
  for (std::size_t i = 0; i < ramp.map.paths[0].stations.size(); ++i)
    ramp.map.paths[0].stations[i].amount = 0.005 * (0.5 * static_cast<double>(i) + 0.25);
  PlannedCorrection correction = correctedBy({ramp});
  correction.feeding.dead_time_s = 1.0;
  const std::vector<CorrectionMap> led = ledMaps(correction);
  ASSERT_EQ(led.size(), 1U);
  EXPECT_NEAR(correctionAt(led[0].paths[0], 20.0).amount, 0.15, 1e-9) << "10 mm ahead at 10 mm/s";
}

TEST(PlannedCorrection, RefusesWhatDoesNotBelongTogether) {
  const std::string program = plannedText(plannedPart());
  FiledMap other = evenFiledMap(2, 0.1);
  other.map.toolpath_id = "other";
  EXPECT_EQ(refusalToCorrect(program, correctedBy({evenFiledMap(1, 0.1), other})),
            "layer_2.csv: the map is of toolpath other; expected toolpath planned");
  EXPECT_NE(refusalToCorrect("G28\nM83\n;LAYER:0\nG1 X90 Y90 Z1 F600\nG1 X95 E1\n",
                             correctedBy({evenFiledMap(1, 0.1)}))
                .find("part.gcode deposits nothing on the toolpath"),
            std::string::npos);
}

}  // namespace
}  // namespace lamina
