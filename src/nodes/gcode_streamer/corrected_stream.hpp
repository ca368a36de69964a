// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/program/program_settings.hpp"
#include "layer_corrector.hpp"

namespace lamina {

/// Outcome of a layer of a toolpath.
struct StreamDecision {
  std::string toolpath_id;
  LayerDecision decision;
};

/// The remaining layers, replanned, as a program that continues where another one rests.
struct PlannedProgram {
  StreamableProgram program;
  std::shared_ptr<LayerCorrector> corrector;
};

/// A program that is corrected while it is sent, and the plans that replace its remaining layers. Maps and
/// plans may come from any thread.
class CorrectedStream final : public ProgramRevision {
 public:
  /// Converts a plan to a program that begins where the corrector's program rests, in front of that layer.
  using PlanWriter = std::function<PlannedProgram(const LayerCorrector& present, std::size_t layer)>;

  /// Whether plans are followed. A job that follows plans cannot be reproduced from one record.
  enum class Plans { Refused, Followed };

  explicit CorrectedStream(std::shared_ptr<LayerCorrector> corrector, Plans plans = Plans::Refused)
      : corrector_(std::move(corrector)), plans_(plans) {}

  /// @return why the map is not used, in words; empty if it is kept for its layer
  std::string hear(CorrectionMap map);

  /// Makes the machine change to a plan, from the layer in front of which it rests. The layer waits until the
  /// plan's program is written.
  /// @return why not, in words; empty if it does
  /// @throws as `write`; the layer then keeps waiting until `dropPlan`
  std::string goOverTo(const std::string& plan_id, const PlanWriter& write);
  /// Drops a plan that could not be written: its layer is waited for as before.
  void dropPlan() { corrector()->dropPlan(); }
  /// Whether the machine deposits that toolpath, or changes to it.
  bool isFollowing(const std::string& toolpath_id) const;
  /// Identity of the deposited toolpath, as in its maps.
  std::string toolpathId() const { return corrector()->plannedId(); }

  bool isKnown(std::int32_t layer) override { return corrector()->isKnown(layer); }
  void decide(std::int32_t layer) override { corrector()->decide(layer); }
  std::optional<StreamableProgram> successor(std::int32_t layer) override;
  double waitTime() const override { return corrector()->waitTime(); }
  std::string revised(std::string_view line, std::uint64_t number) override {
    return corrector()->revised(line, number);
  }

  /// Decisions since the last call, in order.
  std::vector<StreamDecision> takeDecisions();
  std::optional<RevisionRecord> record() const override {
    return plans_ == Plans::Refused ? corrector()->record() : std::nullopt;
  }
  std::string recordFailure() const override { return corrector()->recordFailure(); }
  /// Failure of a record, returned once for each record; otherwise empty.
  std::string takeRecordFailure();

 private:
  std::shared_ptr<LayerCorrector> corrector() const;
  void collectDecisions();

  mutable std::mutex mutex_;  ///< guards everything below
  std::shared_ptr<LayerCorrector> corrector_;
  const Plans plans_;
  std::optional<PlannedProgram> next_;
  std::vector<StreamDecision> decisions_;
  std::size_t collected_ = 0;  ///< of the corrector's
  std::string failure_taken_;  ///< of a record
};

/// Settings for the program of a plan that begins where another one rests, hot and homed: without the start
/// code. Filament retracted for the travel to the layer is pushed forward first.
/// @throws InvalidInput if the remaining toolpath uses other tools than the first
ProgramSettings settingsToGoOn(ProgramSettings settings, const Toolpath& left, std::size_t layer);

}  // namespace lamina
