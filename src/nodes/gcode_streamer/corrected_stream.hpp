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

/// What became of a layer of a toolpath.
struct StreamDecision {
  std::string toolpath_id;
  LayerDecision decision;
};

/// The layers left, planned anew, as a program that goes on where another one rests.
struct PlannedProgram {
  StreamableProgram program;
  std::shared_ptr<LayerCorrector> corrector;
};

/// A program that is corrected on its way, and the plans that take the place of what is left of it. Maps and
/// plans may come from any thread.
class CorrectedStream final : public ProgramRevision {
 public:
  /// Makes a plan a program that begins where the corrector's rests, in front of that layer.
  using PlanWriter = std::function<PlannedProgram(const LayerCorrector& present, std::size_t layer)>;

  /// What a job does that may go over to plans cannot be made again from one record.
  enum class Plans { Refused, Followed };

  explicit CorrectedStream(std::shared_ptr<LayerCorrector> corrector, Plans plans = Plans::Refused)
      : corrector_(std::move(corrector)), plans_(plans) {}

  /// @return why the map is not used, in words; empty if it is kept for its layer
  std::string hear(CorrectionMap map);

  /// The machine goes over to a plan from the layer on in front of which it rests, which waits until the
  /// plan's program is written.
  /// @return why not, in words; empty if it does
  /// @throws as `write`; the layer then waits on, until `dropPlan`
  std::string goOverTo(const std::string& plan_id, const PlanWriter& write);
  /// Of a plan that could not be written: its layer is waited for as before.
  void dropPlan() { corrector()->dropPlan(); }
  /// Whether the machine lays that toolpath, or goes over to it.
  bool isFollowing(const std::string& toolpath_id) const;
  /// As maps name what is deposited.
  std::string toolpathId() const { return corrector()->plannedId(); }

  bool isKnown(std::int32_t layer) override { return corrector()->isKnown(layer); }
  void decide(std::int32_t layer) override { corrector()->decide(layer); }
  std::optional<StreamableProgram> successor(std::int32_t layer) override;
  double waitTime() const override { return corrector()->waitTime(); }
  std::string revised(std::string_view line, std::uint64_t number) override {
    return corrector()->revised(line, number);
  }

  /// Those since the last call, in order.
  std::vector<StreamDecision> takeDecisions();
  std::optional<RevisionRecord> record() const override {
    return plans_ == Plans::Refused ? corrector()->record() : std::nullopt;
  }
  std::string recordFailure() const override { return corrector()->recordFailure(); }
  /// The same, of each record once; then empty.
  std::string takeRecordFailure();

 private:
  std::shared_ptr<LayerCorrector> corrector() const;
  void collectDecisions();

  mutable std::mutex mutex_;  ///< of what is below
  std::shared_ptr<LayerCorrector> corrector_;
  const Plans plans_;
  std::optional<PlannedProgram> next_;
  std::vector<StreamDecision> decisions_;
  std::size_t collected_ = 0;  ///< of the corrector's
  std::string failure_taken_;  ///< of a record
};

/// How the program of a plan is written that begins where another one rests, hot and homed: without the start
/// code. What was pulled back for the travel to the layer is pushed forth first.
/// @throws InvalidInput if the toolpath that is left uses other tools than the first
ProgramSettings settingsToGoOn(ProgramSettings settings, const Toolpath& left, std::size_t layer);

}  // namespace lamina
