// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_law.hpp"
#include "lamina/control/loop_state.hpp"

namespace lamina {

/// The length of a layer on which the surface lies below the range in which points are assigned to cells.
struct FallenLength {
  double share = 0.0;     ///< of the layer's length
  double depth_mm = 0.0;  ///< mean distance of the surface below the planned top on that length
};

/// Figures of a layer from the estimates of its cells. Shares and means are over the cells, weighted by
/// length, unless stated otherwise. Errors and `deviating_share` are those of the cells seen if the layer is
/// measured, else of all cells, as predicted.
struct LayerFigures {
  std::size_t layer = 0;
  double height_mm = 0.0;  ///< mean planned height
  double mean_error_mm = 0.0;
  double rmse_mm = 0.0;          ///< root of the mean squared height error
  double flatness_mm = 0.0;      ///< standard deviation of the error about its mean
  double coverage = 0.0;         ///< share of cells seen
  FallenLength fallen;           ///< not among the errors; from `FallenWatch`
  bool is_measured = false;      ///< coverage is at least `min_coverage`
  double contested_share = 0.0;  ///< share of the cells read whose readings were all contested
  /// Share of the length on which the correction deposited was limited in value or volume.
  double limited_share = 0.0;
  double deviating_share = 0.0;  ///< share of cells whose error is above `alarm_layers` times their height
  double gain_mean = 1.0;
  double gain_least = 1.0;
  double gain_greatest = 1.0;
  /// Quotient of measured growth and the growth expected by the gain, after learning from this layer.
  double gain_ratio = 1.0;  ///< 1 if no growth was measured
  /// Means of squared innovations over their expected variances; 1 without readings. `consistency` is the
  /// mean over the first readings of cells: it shows whether the spread of growth is right. `repeatability`
  /// is the mean over further readings: it shows whether the noise of the sensor is right.
  double consistency = 1.0;
  double repeatability = 1.0;
  double spread = 0.0;  ///< relative standard deviation of growth, as learnt
};

/// The state of a `HeightLoop` after a layer, for storage. Vectors have one value per cell.
struct StoredHeights {
  std::vector<StoredEstimate> estimates;
  std::vector<double> deficit;         ///< missing cross-section, as in `SectionKnowledge`
  LayerKnowledge before_clouds;        ///< the knowledge without the clouds of the layer
  std::vector<double> before_deficit;  ///< `deficit` without the clouds of the layer
  double spread = 0.0;                 ///< relative standard deviation of growth
  std::size_t layers_begun = 0;
  std::size_t clouds = 0;  ///< number of clouds that showed the layer
};

/// The layer-to-layer loop of one print. It estimates the height of each cell, learns the gain (actual over
/// commanded growth) and computes the correction of each layer. The calls of a layer come in this order:
/// `beginLayer`, `correction`, `lay`, for each cloud `see` (for each reading) and `endCloud`, `endLayer`. The
/// same calls give the same results to the bit.
///
/// A single cloud changes no amount by more than a tenth of the range of amounts (`kCloudShare`).
class HeightLoop {
 public:
  /// Greatest change of an amount by one cloud, relative to the range of amounts.
  static constexpr double kCloudShare = 0.1;

  /// @param normal  of the layers, the direction in which they grow; unit
  explicit HeightLoop(const LoopSettings& settings, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

  /// Begins a layer. Each cell starts from the estimate of the cell below. A cell with none below is unknown
  /// until it is seen: it has the mean gain of its region of the layer below, and `knowledge` fills in its
  /// error. The first layer lies on the bed, whose height is known.
  void beginLayer(LayerCells cells);
  /// Begins a layer with relative amounts learnt from previous parts, one per cell. They compensate for the
  /// gain of the process; the gain learnt on this part then states how far growth differs from that expected
  /// with these amounts. Such a layer is corrected by its gains even if it is one of the first ones.
  /// @throws InvalidInput if there is not one value per cell
  void beginLayer(LayerCells cells, std::vector<double> learnt);

  /// The correction of the layer, by the state of the loop. Active: by the law of the process. Coasting, in a
  /// free process: by the gain learnt alone. In any other state, and in the first layers (`first_layers`):
  /// none.
  LayerCorrection correction(LoopState state) const;

  /// States the correction by which the layer is deposited.
  /// @throws InvalidInput if there is not one value per cell
  void lay(const LayerCorrection& correction);
  /// States also the distance of the nozzle below the plan at each cell [mm], which is the height error of a
  /// pressed process.
  /// @throws InvalidInput if there is not one value of each per cell
  void lay(const LayerCorrection& correction, const std::vector<double>& nozzle_error_mm);
  /// States that the layer was deposited with another correction than that given to `lay`.
  /// @throws InvalidInput if there is not one value per cell
  void relay(const LayerCorrection& correction);

  /// Updates a cell of the layer by a reading.
  /// @throws InvalidInput if the layer has no such cell
  ReadingOutcome see(std::size_t cell, const CellReading& reading);
  /// Whether amounts are corrected by the lack of cross-section: in a pressed process.
  bool readsSections() const { return settings_.process == LoopProcess::Pressed; }
  /// States the lack of cross-section measured at a cell, relative to the planned one; for a pressed process.
  /// Of several values in a layer the last one counts. A value that is not finite has no effect.
  /// @throws InvalidInput if the layer has no such cell
  void seeDeficit(std::size_t cell, double share);
  /// Ends a cloud: all readings since the last call belong to it. Contested readings that agree over a length
  /// of at least a bead's width are believed.
  void endCloud();

  /// Takes back what the clouds showed of the layer since `lay`, as they turned out to be wrong: its cells
  /// are as predicted and not seen, and the layer is not measured unless further clouds show it.
  void forgetClouds();

  /// Ends the layer, and learns the gain from it if it was measured.
  LayerFigures endLayer();

  /// Refers all estimates to a new plan of the layers to come, which is higher by `raised_mm` and whose beads
  /// have `flow` times the volume.
  void replan(double raised_mm, double flow);

  /// The state after the layer that was ended last.
  StoredHeights stored() const;
  /// Restores the state after the layer of these cells. The next `beginLayer` is that of the layer above.
  /// @throws InvalidInput if the state has another number of cells
  void resume(LayerCells cells, const StoredHeights& stored) { resume(std::move(cells), stored, {}); }
  /// Restores the state after a layer that was deposited with amounts learnt from previous parts.
  /// @param learnt  relative amounts, one per cell or none
  /// @throws InvalidInput if the state has another number of cells
  void resume(LayerCells cells, const StoredHeights& stored, std::vector<double> learnt);

  const LayerCells& cells() const { return cells_; }
  const std::vector<CellEstimate>& estimates() const { return estimates_; }
  /// Planned less expected height of each cell [mm], before any cloud of the layer.
  const std::vector<double>& errorsBeforeClouds() const { return before_clouds_.error_mm; }
  /// The input of the law: error and gain of each cell. Unknown cells have those of the nearest known cell of
  /// their path within two standard deviations of the low-pass, or else the mean known error.
  LayerKnowledge knowledge() const;
  /// Mean error of the cells that were seen since they were deposited; before the layer is deposited, of the
  /// cells below it. Nothing if they are less than `min_coverage` of the length.
  std::optional<double> seenError() const;

 private:
  void takeGainsOver(const std::vector<double>& learnt_below);
  LayerKnowledge filled(std::vector<double> error_mm, std::vector<double> gain) const;
  /// The correction by the law of the process, in a state of the loop, from what is known.
  LayerCorrection asked(LoopState state, const LayerKnowledge& known,
                        const std::vector<double>& deficit) const;
  void boundByClouds(LayerCorrection& correction, LoopState state) const;
  void requireCell(std::size_t cell) const;
  void requireOnePerCell(const std::string& what, std::size_t count) const;
  void believePatches();
  std::vector<MeasuredGain> heightGains();
  std::vector<MeasuredGain> sectionGains() const;
  void learn(const std::vector<MeasuredGain>& measured);
  void learnSpread();
  void judgeErrors(LayerFigures& figures, const std::vector<double>& seen) const;
  LayerFigures figures() const;

  LoopSettings settings_;
  Eigen::Vector3d normal_;
  LayerCells cells_;
  std::vector<CellEstimate> estimates_;
  std::vector<double> learnt_;          ///< amounts learnt from previous parts; empty if there are none
  std::vector<double> deficit_;         ///< lack of cross-section, of a pressed process
  std::vector<bool> is_section_seen_;   ///< whether the value of `deficit_` is of the layer
  std::vector<double> applied_;         ///< correction of the layer
  std::vector<std::size_t> contested_;  ///< cells whose last reading is contested; others may be among them
  double cloud_sigma_mm_ = 0.0;         ///< greatest standard deviation of the cloud's readings
  LayerKnowledge before_clouds_;        ///< what would be known if no cloud had shown the layer below
  std::vector<double> before_deficit_;  ///< `deficit_` if no cloud had shown the layer below
  std::size_t clouds_below_ = 0;        ///< number of clouds that showed the layer below
  std::size_t layers_begun_ = 0;
  double spread_;
  double limited_share_ = 0.0;
  double gain_ratio_ = 1.0;
  std::size_t clouds_ = 0;
  double surprise_ = 0.0;  ///< sum of the surprises of readings used, first of their cells
  double excess_ = 0.0;    ///< sum of squared innovations beyond noise and prior, in squared growths
  std::size_t surprises_ = 0;
  double repeat_surprise_ = 0.0;
  std::size_t repeats_ = 0;
};

}  // namespace lamina
