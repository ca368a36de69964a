// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Corrections in programs as slicing writes them: hops, wipes, coasting, arcs.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "job/settings/setting_probe.hpp"
#include "lamina/base/atomic_file.hpp"
#include "lamina/control/program/corrected_program.hpp"
#include "lamina/job/slice_job.hpp"
#include "support/corrected_programs.hpp"
#include "support/scratch_folder.hpp"

namespace lamina::test {
namespace {

/// A wave of the amount along all paths of all layers.
std::vector<CorrectionMap> wavesOn(const Toolpath& toolpath, double amplitude) {
  std::vector<CorrectionMap> maps;
  for (std::size_t k = 0; k < toolpath.layers.size(); ++k) {
    const LayerCells cells = layerCells(toolpath.layers[k], k, 0.5);
    CellCorrections corrections;
    for (const double s : cells.along_mm)
      corrections.amount.push_back(amplitude * (1.0 + std::sin(s / 10.0)));
    maps.push_back(correctionMap(cells, corrections, toolpathId(toolpath), 1));
  }
  return maps;
}

struct SlicedProgram {
  std::string text;
  Toolpath toolpath;  ///< that it was written from, on the bed
};

SlicedProgram programAndToolpath(const char* settings) {
  const ScratchFolder folder;
  NoProgress nobody;
  const std::string file = folder.file("job.gcode");
  SlicedPart part = runSliceJob(
      {partFile("cylinder radius_mm=6 height_mm=1"), file, settingsWith<JobSettings>(settingTexts(settings))},
      nobody);
  for (ToolpathLayer& layer : part.toolpath.layers)
    for (Path& path : layer.paths)
      for (Point3& point : path.points) point = part.bed_from_part * point;
  return {readFile(file), std::move(part.toolpath)};
}

TEST(CorrectedSlice, PushesWhatTheMapsAskForAndElseIsTheSame) {
  for (const char* settings : {"", "program.arcs_tolerance_mm=0.02", "travel.wipe_mm=2;flow.coast_mm3=0.2"}) {
    const auto [program, toolpath] = programAndToolpath(settings);
    EXPECT_EQ(correctedProgram(program, toolpath, wavesOn(toolpath, 0.0), {}).text, program) << settings;
    const CorrectedProgram corrected = correctedProgram(program, toolpath, wavesOn(toolpath, 0.1), {});
    const double asked = corrected.report.corrected_mm - corrected.report.planned_mm;
    EXPECT_GT(asked, 0.05 * corrected.report.planned_mm);
    EXPECT_NEAR(filamentOf(corrected.text) - filamentOf(program), asked, 1e-4) << settings;
    EXPECT_EQ(corrected.report.off_path_lines, 0U) << settings;
  }
}

}  // namespace
}  // namespace lamina::test
