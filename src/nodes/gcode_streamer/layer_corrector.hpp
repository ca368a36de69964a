// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "correction_record.hpp"
#include "correction_settings.hpp"
#include "lamina/control/program/corrected_program.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "lamina/streaming/job/program_revision.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// What became of a layer, or of a later map of it.
struct LayerDecision {
  std::size_t layer = 0;
  std::uint64_t sequence = 0;
  std::string digest;           ///< of the map that was applied; empty if none was
  std::string refusal;          ///< why a map that was there was not; empty if none was there in time
  double waited_s = 0.0;        ///< in vain
  std::uint64_t from_line = 0;  ///< of the program, from 1
  bool is_later = false;        ///< a map took the place of the one that the layer began with
  bool is_coasting = false;     ///< its own map did not come in time: the one applied is the coasting map
};

/// Whether the first layer of a program waits for its map, too: of a part that begins nothing can be known.
enum class FirstMap { AsPlanned, Awaited };

/// Corrects the program of a toolpath on its way, by the maps that come while it is printed. Above the first
/// layer each waits for its map; one that begins without takes its coasting map, to which the amount of the
/// layer before goes over, and where there is none that amount fades to 0. Maps
/// may come from any thread; the latest that is there when a layer is decided holds, and later ones of a
/// layer that is deposited by a map from the next line of the program on.
class LayerCorrector final : public ProgramRevision {
 public:
  /// Reads the program once, so that what cannot be corrected is refused before it begins.
  /// @throws InvalidProgram as `ProgramCorrector`; if none of what it deposits lies on the toolpath
  /// @throws FileError if the program is gone, or nothing can be written to the folder of the record
  LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                 StreamCorrectionSettings settings, FirstMap first = FirstMap::AsPlanned);

  /// The record of a job before gives way to this one's: now, or else with the first line.
  /// @throws FileError if it cannot be written
  void beginRecord() { record_.begin(toolpath_); }

  /// @return why the map is not used, in words; empty if it is kept for its layer
  std::string hear(CorrectionMap map);

  /// Lets the layer that is waited for wait on, for a plan of the layers left, until `dropPlan`.
  /// @return why not, in words; empty if it does
  std::string awaitPlan(const std::string& plan_id);
  void dropPlan();
  /// In front of which the program rests; nothing while none is waited for.
  std::optional<std::size_t> awaitedLayer() const;

  bool isKnown(std::int32_t layer) override;
  void decide(std::int32_t layer) override;
  double waitTime() const override { return settings_.loop.wait_s; }
  std::string revised(std::string_view line, std::uint64_t number) override;

  /// As maps name it.
  const std::string& plannedId() const { return toolpath_.id; }
  /// In coordinates of the program.
  const Toolpath& toolpath() const { return toolpath_.toolpath; }
  /// Of the layers decided so far, in order.
  std::vector<LayerDecision> decisions() const;
  std::optional<RevisionRecord> record() const override;
  std::string recordFailure() const override { return record_.failure(); }

 private:
  /// A later map, and how the program has it.
  struct Trim {
    CorrectionMap map;
    CorrectionMap led;
  };

  CorrectionMap led(const CorrectionMap& map) const;
  bool trims(const CorrectionMap& map) const;
  std::string hearTrim(CorrectionMap map);
  void takeTrim(std::uint64_t line);
  void apply(LayerDecision decision, const CorrectionMap* map);
  void use(const CorrectionMap& map, const CorrectionMap& ready);
  std::string fade(std::size_t layer);
  std::string coast(LayerDecision& decision);

  const ProgrammedToolpath toolpath_;
  const StreamCorrectionSettings settings_;
  const FirstMap first_;
  std::string programmed_id_;  ///< of the toolpath in coordinates of the program
  ProgramCorrector corrector_;
  CorrectionRecord record_;

  mutable std::mutex mutex_;                       ///< of what is below
  std::map<std::size_t, CorrectionMap> heard_;     ///< by layer, not applied yet
  std::map<std::size_t, CorrectionMap> coasting_;  ///< the same of coasting maps
  std::optional<Trim> trim_;                       ///< of the layer under way, not applied yet
  std::vector<LayerDecision> decisions_;
  std::uint64_t next_line_ = 1;         ///< to be revised
  double last_amount_ = 0.0;            ///< by which the layers decided so far end
  double station_mm_ = 1.0;             ///< greatest distance of stations in the last map
  std::optional<std::size_t> awaited_;  ///< layer
  bool is_planning_ = false;
};

}  // namespace lamina
