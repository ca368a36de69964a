// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lamina/control/cell_estimate.hpp"
#include "lamina/control/layer_law.hpp"
#include "lamina/control/loop_state.hpp"

namespace lamina {

/// The result of a layer by the estimates of its cells. Shares are of its cells unless stated otherwise.
struct LayerFigures {
  std::size_t layer = 0;
  double height_mm = 0.0;  ///< mean planned height
  double mean_error_mm = 0.0;
  double rmse_mm = 0.0;
  double flatness_mm = 0.0;      ///< standard deviation of the error about its mean
  double coverage = 0.0;         ///< share of cells seen
  bool is_measured = false;      ///< coverage is at least `min_coverage`
  double contested_share = 0.0;  ///< of the cells read, those contested and not believed
  double limited_share = 0.0;    ///< of the length, where the correction deposited was limited
  double deviating_share = 0.0;  ///< of cells off by more than `alarm_layers` heights
  double gain_mean = 1.0;
  double gain_least = 1.0;
  double gain_greatest = 1.0;
  double gain_ratio = 1.0;  ///< measured growth over that expected by the gain learnt; 1 if none was measured
  /// Means of squared innovations over their expected variances; 1 without readings. `consistency` is that of
  /// the first reading of each cell and depends on growth, `repeatability` that of further readings and
  /// depends on the sensor.
  double consistency = 1.0;
  double repeatability = 1.0;
  double spread = 0.0;  ///< relative standard deviation of growth, as learnt
};

/// The state of a `HeightLoop` after a layer, for storage. Vectors have one value per cell.
struct StoredHeights {
  std::vector<StoredEstimate> estimates;
  std::vector<double> deficit;         ///< of cross-section, as in `SectionKnowledge`
  LayerKnowledge before_clouds;        ///< as if no cloud had seen the layer
  std::vector<double> before_deficit;  ///< likewise
  double spread = 0.0;                 ///< relative standard deviation of growth
  std::size_t layers_begun = 0;
  std::size_t clouds = 0;  ///< number that saw the layer
};

/// The layer-to-layer loop of one print: it estimates the height of each cell, learns the gain (actual over
/// commanded growth) and computes the correction of each layer. Calls of a layer come in this order:
/// `beginLayer`, `correction`, `lay`, for each cloud `see` and `endCloud`, `endLayer`. The same calls give
/// the same bits.
///
/// No single cloud changes a correction by more than a tenth of the range of amounts.
class HeightLoop {
 public:
  static constexpr double kCloudShare = 0.1;  ///< greatest change of an amount by one cloud, over their range

  /// @param normal  of the layers, along which they grow
  explicit HeightLoop(const LoopSettings& settings, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

  /// Begins a layer. Its cells take over what is known of the cells below them. A cell with none below takes
  /// the mean height of the layer below and the mean gain of its region. The first layer lies on the bed,
  /// whose height is known.
  void beginLayer(LayerCells cells);
  /// The same with relative amounts learnt from previous parts, one per cell. They make up for the gain of
  /// the process; the gain learnt on this part then states how far growth is off them. Such a layer is
  /// corrected even if it is one of the first ones.
  /// @throws InvalidInput if there is not one value per cell
  void beginLayer(LayerCells cells, std::vector<double> learnt);

  /// The correction of the layer in that state: of an active loop by the law, of a coasting one of a free
  /// process by the gain learnt, of any other none. The first layers get none.
  LayerCorrection correction(LoopState state) const;

  /// States the correction that the layer is deposited with.
  /// @throws InvalidInput if there is not one value per cell
  void lay(const LayerCorrection& correction);
  /// The same with the distance of the nozzle below the plan at each cell [mm], which is the height error of
  /// a pressed process.
  void lay(const LayerCorrection& correction, const std::vector<double>& nozzle_error_mm);
  /// States that the layer was deposited with another correction than `lay` was given.
  /// @throws InvalidInput if there is not one value per cell
  void relay(const LayerCorrection& correction);

  /// Updates a cell of the layer by a reading.
  /// @throws InvalidInput if the layer has no such cell
  ReadingOutcome see(std::size_t cell, const CellReading& reading);
  /// States the relative lack of cross-section measured at a cell, of a pressed process.
  void seeDeficit(std::size_t cell, double share);
  /// Ends a cloud, to which all readings since the last call belong. Contested readings that agree over a
  /// patch as wide as a bead are believed.
  void endCloud();

  /// Ends the layer and learns from it.
  LayerFigures endLayer();

  /// Takes over a new plan of the layers to come, which is higher by `raised_mm` and whose beads have `flow`
  /// times the volume.
  void replan(double raised_mm, double flow);

  /// The state after the layer that is done.
  StoredHeights stored() const;
  /// Restores the state after the layer of these cells. The next `beginLayer` is that of the layer above.
  /// @throws InvalidInput if the state is that of another number of cells
  void resume(LayerCells cells, const StoredHeights& stored) { resume(std::move(cells), stored, {}); }
  /// The same for a layer that was deposited with amounts learnt from previous parts.
  /// @param learnt  relative amounts, one per cell or none
  void resume(LayerCells cells, const StoredHeights& stored, std::vector<double> learnt);

  const LayerCells& cells() const { return cells_; }
  const std::vector<CellEstimate>& estimates() const { return estimates_; }
  /// The input of the law: what is known of the cells, the unknown ones filled in from their neighbours.
  LayerKnowledge knowledge() const;

 private:
  void takeGainsOver(const std::vector<double>& learnt_below);
  LayerKnowledge filled(std::vector<double> error_mm, std::vector<double> gain) const;
  /// By the law of the process, in that state, from that knowledge.
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
  LayerFigures figures() const;

  LoopSettings settings_;
  Eigen::Vector3d normal_;
  LayerCells cells_;
  std::vector<CellEstimate> estimates_;
  std::vector<double> learnt_;   ///< amounts from parts before; empty if there are none
  std::vector<double> deficit_;  ///< of cross-section, of a pressed process
  std::vector<bool> is_section_seen_;
  std::vector<double> applied_;         ///< correction of the layer
  double cloud_sigma_mm_ = 0.0;         ///< greatest of the cloud's readings
  LayerKnowledge before_clouds_;        ///< as if nothing had been seen of the layer below
  std::vector<double> before_deficit_;  ///< likewise
  std::size_t clouds_below_ = 0;        ///< that saw the layer below
  std::size_t layers_begun_ = 0;
  double spread_;
  double limited_share_ = 0.0;
  double gain_ratio_ = 1.0;
  std::size_t clouds_ = 0;
  double surprise_ = 0.0;  ///< sum over readings used
  double excess_ = 0.0;    ///< of squared innovations over noise and prior, in squared growths
  std::size_t surprises_ = 0;
  double repeat_surprise_ = 0.0;
  std::size_t repeats_ = 0;
};

}  // namespace lamina
