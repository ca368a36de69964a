// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A wall whose top the nozzle makes: it settles after the nozzle has passed, and is fed too little.
#include <gtest/gtest.h>

#include <cmath>

#include "lamina/control/z_follow.hpp"
#include "support/printed_wall.hpp"

namespace lamina {
namespace {

constexpr double kLayer = 0.2;       // mm
constexpr double kFed = 0.85;        // of what is commanded
constexpr double kLayerTime = 60.0;  // s
constexpr double kNowhere = -1e9;    // mm: nothing is in the head's way

struct PressedFigures {
  double rmse_mm = 0.0;
  double open_share = 0.0;  ///< of the cross-section
};

LayerCells pressedCells(std::size_t layer) {
  Path path;
  path.role = PathRole::OuterWall;
  path.bead = Bead{0.4, kLayer};
  path.feed_mm_s = 30.0;
  const double z = kLayer * static_cast<double>(layer + 1);
  path.points = {{0, 0, z}, {100, 0, z}};
  return layerCells({z, kLayer, {path}}, layer, 0.5);
}

/// How far a layer settles, as the emulated process has it.
double settling(std::size_t layer) {
  PlantSettings settings;
  settings.thermal = 0.1;
  settings.cooling_s = 60.0;
  settings.slump_s = 20.0;
  PlantBead bead;
  bead.layer = layer;
  bead.layer_s = kLayerTime;
  bead.length_mm = 1.0;
  bead.along_mm = {0.5};
  bead.planned_mm = {kLayer};
  bead.correction = {-1.0};
  bead.nozzle_far_mm = {0.0};
  return -GrowthPlant(settings).afterBead(bead, {0.0})[0];
}

/// Figures of layers 20 to 40.
PressedFigures pressedWall(LoopState state) {
  LoopSettings settings;
  settings.process = LoopProcess::Pressed;
  settings.z = state == LoopState::Active ? NozzleHeight::Layer : NozzleHeight::Plan;
  HeightLoop loop(settings);
  Random random(1);
  double below_mm = 0.0;  // top of what is deposited
  double shift_mm = 0.0;
  double error_mm = 0.0;
  PressedFigures figures;
  for (std::size_t k = 0; k < 40; ++k) {
    loop.beginLayer(pressedCells(k));
    const LayerCells& cells = loop.cells();
    const LayerCorrection correction = loop.correction(state);
    const LayerKnowledge seen{std::vector<double>(cells.size(), error_mm), {}};
    shift_mm = meanOverCells(cells, nozzleShift(cells, seen, shift_mm, {kLayer, kNowhere, 0.0}, settings));
    loop.lay(correction, std::vector<double>(cells.size(), -shift_mm));
    const double planned_mm = kLayer * static_cast<double>(k + 1);
    const double room_mm = planned_mm + shift_mm - below_mm;
    below_mm = planned_mm + shift_mm - settling(k);
    const double open = std::max(0.0, 1.0 - kFed * (1.0 + correction.amount[100]) * kLayer / room_mm);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      loop.see(i, {planned_mm - below_mm + random.normal(0.0, 0.003), 6, 0.005});
      loop.seeDeficit(i, open + random.normal(0.0, 0.01));
    }
    loop.endCloud();
    error_mm = loop.endLayer().mean_error_mm;
    if (k < 20) continue;
    figures.rmse_mm += std::abs(planned_mm - below_mm) / 20.0;
    figures.open_share += open / 20.0;
  }
  return figures;
}

TEST(PressedWall, IsHigherAndCloser) {
  const PressedFigures open = pressedWall(LoopState::Identifying);
  const PressedFigures closed = pressedWall(LoopState::Active);
  EXPECT_GT(open.rmse_mm, 0.005);
  EXPECT_GT(open.open_share, 0.15);
  EXPECT_LT(closed.rmse_mm, 0.4 * open.rmse_mm) << "six tenths less at least";
  EXPECT_LT(closed.open_share, 0.4 * open.open_share);
}

/// Measured every fourth layer: those between keep the height that the last one showed to be right.
TEST(PressedWall, KeepsTheHeightOfItsNozzleWhereItIsNotMeasured) {
  LoopSettings settings;
  settings.process = LoopProcess::Pressed;
  settings.z = NozzleHeight::Layer;
  HeightLoop loop(settings);
  double shift_mm = 0.0;
  for (std::size_t k = 0; k < 120; ++k) {
    loop.beginLayer(pressedCells(k));
    const LayerCells& cells = loop.cells();
    EXPECT_EQ(loop.seenError().has_value(), k > 0 && k % 4 == 0) << k;
    const LayerKnowledge seen{std::vector<double>(cells.size(), loop.seenError().value_or(0.0)), {}};
    const double before_mm = shift_mm;
    shift_mm = meanOverCells(cells, nozzleShift(cells, seen, shift_mm, {kLayer, kNowhere, 0.0}, settings));
    const double most_mm = k % 4 == 0 ? kLayer : 1e-12;
    EXPECT_NEAR(shift_mm, before_mm, most_mm) << k;
    loop.lay(loop.correction(LoopState::Active), std::vector<double>(cells.size(), -shift_mm));
    if (k % 4 == 3) {
      for (std::size_t i = 0; i < cells.size(); ++i) loop.see(i, {settling(k) - shift_mm, 6, 0.005});
      loop.endCloud();
    }
    loop.endLayer();
  }
  EXPECT_GT(settling(119), 0.005);
  EXPECT_NEAR(shift_mm, settling(119), 0.1 * settling(119));
}

}  // namespace
}  // namespace lamina
