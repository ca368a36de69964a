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

/// Outcome of a layer, or of a later map of the layer.
struct LayerDecision {
  std::size_t layer = 0;
  std::uint64_t sequence = 0;
  std::string digest;           ///< of the map that was applied; empty if none was
  std::string refusal;          ///< why an available map was not applied; empty if none was available in time
  double waited_s = 0.0;        ///< wait without result
  std::uint64_t from_line = 0;  ///< of the program, from 1
  bool is_later = false;        ///< a map has replaced the layer's first map
  bool is_coasting = false;     ///< the layer's own map did not come in time: the coasting map is applied
};

/// Whether the first layer of a program waits for its map, too. At the beginning of a part there are no
/// measurements.
enum class FirstMap { AsPlanned, Awaited };

/// Corrects the program of a toolpath while it is sent, by the maps that arrive during the print. Each layer
/// above the first waits for its map. A layer that begins without its map uses its coasting map, to which the
/// amount of the previous layer changes gradually; without a coasting map that amount fades to 0. Maps may
/// come from any thread. The latest map holds when a layer is decided; later maps of a layer that is
/// deposited by a map hold from the next line of the program on.
class LayerCorrector final : public ProgramRevision {
 public:
  /// Reads the program once: a program that cannot be corrected is refused before it begins.
  /// @throws InvalidProgram as `ProgramCorrector`; if none of its deposits lies on the toolpath
  /// @throws FileError if the program is gone, or nothing can be written to the folder of the record
  LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                 StreamCorrectionSettings settings, FirstMap first = FirstMap::AsPlanned);

  /// Replaces a previous job's record by this job's: now, or otherwise with the first line.
  /// @throws FileError if it cannot be written
  void beginRecord() { record_.begin(toolpath_); }

  /// @return why the map is not used, in words; empty if it is kept for its layer
  std::string hear(CorrectionMap map);

  /// Makes the awaited layer wait for a plan of the remaining layers, until `dropPlan`.
  /// @return why not, in words; empty if it does
  std::string awaitPlan(const std::string& plan_id);
  void dropPlan();
  /// The layer in front of which the program rests; nothing if none is awaited.
  std::optional<std::size_t> awaitedLayer() const;

  bool isKnown(std::int32_t layer) override;
  void decide(std::int32_t layer) override;
  double waitTime() const override { return settings_.loop.wait_s; }
  std::string revised(std::string_view line, std::uint64_t number) override;

  /// Identity of the toolpath in its maps.
  const std::string& plannedId() const { return toolpath_.id; }
  /// The toolpath in coordinates of the program.
  const Toolpath& toolpath() const { return toolpath_.toolpath; }
  /// The decisions on layers so far, in order.
  std::vector<LayerDecision> decisions() const;
  std::optional<RevisionRecord> record() const override;
  std::string recordFailure() const override { return record_.failure(); }

 private:
  /// A later map, and its form for the program.
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

  mutable std::mutex mutex_;                       ///< guards everything below
  std::map<std::size_t, CorrectionMap> heard_;     ///< by layer, not applied yet
  std::map<std::size_t, CorrectionMap> coasting_;  ///< the same of coasting maps
  std::optional<Trim> trim_;                       ///< of the layer under way, not applied yet
  std::vector<LayerDecision> decisions_;
  std::uint64_t next_line_ = 1;         ///< number of the next line to be revised
  double last_amount_ = 0.0;            ///< last amount of the layers decided so far
  double station_mm_ = 1.0;             ///< greatest distance of stations in the last map
  std::optional<std::size_t> awaited_;  ///< layer
  bool is_planning_ = false;
};

}  // namespace lamina
