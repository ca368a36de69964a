// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// The loop over layers that are not plane: rings on spheres, measured by profiles across them.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/control/height_loop.hpp"
#include "support/measured_layers.hpp"

namespace lamina {
namespace {

constexpr Bead kRingBead{3.0, 1.5};
constexpr std::size_t kRings = 3;
constexpr std::size_t kPlaces = 900;  // around each ring, which has 810 cells at most
constexpr std::size_t kSpheres = 12;
constexpr double kRingNoise = 0.02;  // mm

/// A process that lays between four fifths and all of what it is commanded, by the place on the ring, and
/// elsewhere on each ring.
double growthAt(std::size_t ring, double way) {
  return 0.9 + 0.1 * std::cos(4.0 * M_PI * way + 0.25 * M_PI * static_cast<double>(ring));
}

double wayOf(std::size_t place) { return (static_cast<double>(place) + 0.5) / static_cast<double>(kPlaces); }

class CurvedPrint {
 public:
  /// @param from_deg  of the rings, off the pole of their spheres
  CurvedPrint(LoopState state, double from_deg)
      : state_(state), from_deg_(from_deg), error_mm_(kRings * kPlaces, 0.0) {}

  /// Root of the mean square of the true errors of the last layer.
  double print() {
    for (std::size_t k = 0; k < kSpheres; ++k) printLayer(k);
    double squares = 0.0;
    for (const double error : error_mm_) squares += error * error;
    return std::sqrt(squares / static_cast<double>(error_mm_.size()));
  }

  /// Share of the cells of the last layer that profiles have shown.
  double coverage() const { return coverage_; }

 private:
  void printLayer(std::size_t k) {
    const test::MeasuredLayer measured = test::sphericalLayer(kRings, kRingBead, k, from_deg_);
    const auto cells = std::make_shared<const LayerCells>(test::cellsOf(measured, k));
    loop_.beginLayer(*cells);
    const LayerCorrection correction = loop_.correction(state_);
    loop_.lay(correction);
    for (std::size_t i = 0; i < error_mm_.size(); ++i) {
      const CellRun& run = cells->runs[i / kPlaces];
      const double way = wayOf(i % kPlaces);
      const auto cell = run.first + static_cast<std::size_t>(way * static_cast<double>(run.count));
      error_mm_[i] +=
          kRingBead.height_mm * (1.0 - growthAt(i / kPlaces, way) * (1.0 + correction.amount[cell]));
    }
    CellAtlas atlas;
    atlas.add(cells);
    for (std::size_t place = 0; place < kPlaces; ++place) measure(measured, atlas, place);
    coverage_ = loop_.endLayer().coverage;
  }

  /// A profile across all rings, each point 0.1 mm from the next.
  void measure(const test::MeasuredLayer& measured, const CellAtlas& atlas, std::size_t place) {
    SensorProfile profile;
    profile.toolpath_from_sensor = test::sensorOver(measured, kRings / 2, wayOf(place));
    const Eigen::Isometry3d sensor_from_toolpath = profile.toolpath_from_sensor.inverse();
    for (std::size_t ring = 0; ring < kRings; ++ring)
      for (int i = -14; i <= 14; ++i) {
        const double error = error_mm_[ring * kPlaces + place] + random_.normal(0.0, kRingNoise);
        profile.points.emplace_back(sensor_from_toolpath *
                                    measured.place(ring, wayOf(place), 0.1 * i, error));
      }
    const std::size_t layer = atlas.layers().front();
    const ProfileReadings read = readProfile(profile, atlas, {{layer, &loop_.estimates()}}, {});
    for (const LayerReading& one : read.readings) loop_.see(one.cell, one.reading);
    loop_.endCloud();
  }

  LoopState state_;
  double from_deg_;
  HeightLoop loop_{LoopSettings()};
  Random random_{1};
  std::vector<double> error_mm_;  ///< planned less true height along growth, ring by ring
  double coverage_ = 0.0;
};

/// Near the pole, and where layers grow nearly square to what is their normal as a whole.
TEST(CurvedPrint, IsCorrectedByPlaceAlongItsGrowth) {
  for (const double from_deg : {20.0, 75.0}) {
    const double open_mm = CurvedPrint(LoopState::Identifying, from_deg).print();
    // A tenth of each layer on average, and a wave of a tenth about it.
    EXPECT_NEAR(open_mm, kSpheres * kRingBead.height_mm * std::sqrt(0.01 + 0.005), 0.01) << from_deg;
    CurvedPrint closed(LoopState::Active, from_deg);
    EXPECT_LT(closed.print(), 0.4 * open_mm) << from_deg << ": six tenths less at least";
    EXPECT_GT(closed.coverage(), 0.95) << from_deg;
  }
}

}  // namespace
}  // namespace lamina
