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

/// What a layer came to, by the estimates of its cells. Shares are of the cells.
struct LayerFigures {
  std::size_t layer = 0;
  double height_mm = 0.0;  ///< planned, in the mean
  double mean_error_mm = 0.0;
  double rmse_mm = 0.0;
  double flatness_mm = 0.0;      ///< the same without the mean
  double coverage = 0.0;         ///< seen
  bool is_measured = false;      ///< coverage is enough
  double contested_share = 0.0;  ///< contested and not believed, of those that were read
  double limited_share = 0.0;    ///< of the length, as laid
  double deviating_share = 0.0;  ///< off by more than the alarm
  double gain_mean = 1.0;
  double gain_least = 1.0;
  double gain_greatest = 1.0;
  double gain_ratio =
      1.0;  ///< growth as measured over growth as then learnt, of what was measured; 1 of none
  /// Means of innovations squared over what was expected of them; 1 if there were none: of the first reading
  /// of each cell, which tells of growth, and of further ones, which tell of the sensor.
  double consistency = 1.0;
  double repeatability = 1.0;
  double spread = 0.0;  ///< of growth, as learnt
};

/// All that a `HeightLoop` knows when a layer is done, to be kept; vectors have one value per cell.
struct StoredHeights {
  std::vector<StoredEstimate> estimates;
  std::vector<double> deficit;   ///< of cross-section
  LayerKnowledge before_clouds;  ///< as if nothing had been seen of the layer
  std::vector<double> before_deficit;
  double spread = 0.0;  ///< of growth
  std::size_t layers_begun = 0;
  std::size_t clouds = 0;  ///< that saw the layer
};

/// The loop over one print, from layer to layer: estimates the top of each cell, learns what grows of what is
/// commanded, and gives each layer its correction. For each layer in turn: `beginLayer`, `correction`,
/// `lay`, readings cloud by cloud, `endLayer`. The same calls give the same bits.
///
/// No single cloud moves a correction by more than a tenth of the range of amounts.
class HeightLoop {
 public:
  static constexpr double kCloudShare = 0.1;  ///< of the range of amounts, that a cloud moves one by at most

  /// @param normal  of the layers, along which they grow
  explicit HeightLoop(const LoopSettings& settings, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ());

  /// Takes over to the layer's cells what is known of those below. Cells above none take the mean height of
  /// the layer below and the mean gain of their region. The first layer lies on a bed that is known.
  void beginLayer(LayerCells cells);
  /// The same where parts before have told how such a layer is to be laid: relative amounts, one per cell.
  /// They stand for its gain, and what is learnt of this part for how far it is off that. Such a layer is
  /// corrected even among the first ones.
  /// @throws InvalidInput if there is not one value per cell
  void beginLayer(LayerCells cells, std::vector<double> learnt);

  /// How the layer is to be laid in that state: by the law where it is active, else by what is learnt or not
  /// at all; the first layers not at all.
  LayerCorrection correction(LoopState state) const;

  /// The layer is laid with that correction.
  /// @throws InvalidInput if there is not one value per cell
  void lay(const LayerCorrection& correction);
  /// The same, the nozzle running that far below the plan [mm]: of a pressed process this is the error.
  void lay(const LayerCorrection& correction, const std::vector<double>& nozzle_error_mm);
  /// The layer turned out to be laid with another correction.
  /// @throws InvalidInput if there is not one value per cell
  void relay(const LayerCorrection& correction);

  /// A reading of a cell of the layer.
  /// @throws InvalidInput if the layer has no such cell
  ReadingOutcome see(std::size_t cell, const CellReading& reading);
  /// A relative lack of cross-section at a cell, of a pressed process.
  void seeDeficit(std::size_t cell, double share);
  /// The readings since the last call were of one cloud: believes patches as wide as a bead whose contested
  /// readings agree.
  void endCloud();

  /// Learns from the layer.
  LayerFigures endLayer();

  /// The layers to come were planned anew: heights count from a plan that much higher, and beads have so many
  /// times the volume.
  void replan(double raised_mm, double flow);

  /// Of the layer that is done.
  StoredHeights stored() const;
  /// Goes on after the layer of these cells, as it was stored: the next `beginLayer` is that of the layer
  /// above.
  /// @throws InvalidInput if it was stored of another number of cells
  void resume(LayerCells cells, const StoredHeights& stored) { resume(std::move(cells), stored, {}); }
  /// The same of a layer that was laid by what parts before have told.
  /// @param learnt  one per cell, or none
  void resume(LayerCells cells, const StoredHeights& stored, std::vector<double> learnt);

  const LayerCells& cells() const { return cells_; }
  const std::vector<CellEstimate>& estimates() const { return estimates_; }
  /// What the law is given: unknown cells filled by their neighbours.
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
  std::vector<double> laid_;            ///< correction of the layer
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
