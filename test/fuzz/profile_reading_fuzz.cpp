// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "lamina/control/height_loop.hpp"
#include "lamina/control/profile_reading.hpp"
#include "support/measured_layers.hpp"

namespace {

using lamina::test::MeasuredLayer;

/// Reads any points over a layer, and takes what they say: nothing is lost, and no correction is off its
/// limits.
void read(const MeasuredLayer& measured, const lamina::SensorProfile& profile) {
  lamina::LoopSettings settings;
  settings.first_layers = 0;
  lamina::HeightLoop loop(settings, measured.normal);
  loop.beginLayer(lamina::test::cellsOf(measured));
  loop.lay(loop.correction(lamina::LoopState::Identifying));
  lamina::CellAtlas atlas;
  atlas.add(std::make_shared<const lamina::LayerCells>(loop.cells()));
  const auto said = lamina::readProfile(profile, atlas, {{0, &loop.estimates()}}, {});
  if (said.counts.accounted() != said.counts.received) std::abort();
  for (const lamina::LayerReading& one : said.readings) loop.see(one.cell, one.reading);
  loop.endCloud();
  for (const double amount : loop.correction(lamina::LoopState::Active).amount)
    if (!(amount >= settings.least_amount && amount <= settings.greatest_amount)) std::abort();
}

}  // namespace

/// Any bytes are the points of a profile, three floats each, over a plane layer and over a curved one; the
/// first byte says which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  static const MeasuredLayer kPlane = lamina::test::inclinedLayer(45.0, 2, {3.0, 1.5});
  static const MeasuredLayer kCurved = lamina::test::sphericalLayer(2, {3.0, 1.5});
  const MeasuredLayer& measured = bytes[0] % 2 == 0 ? kPlane : kCurved;
  lamina::SensorProfile profile;
  profile.toolpath_from_sensor = lamina::test::sensorOver(measured, 1, 0.5);
  for (std::size_t at = 1; at + 3 * sizeof(float) <= size; at += 3 * sizeof(float)) {
    float values[3];
    std::memcpy(values, bytes + at, sizeof values);
    profile.points.emplace_back(double(values[0]), double(values[1]), double(values[2]));
  }
  read(measured, profile);
  return 0;
}
