// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "correction_settings.hpp"
#include "lamina/control/program/corrected_program.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "lamina/streaming/job/program_revision.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// What became of a layer.
struct LayerDecision {
  std::size_t layer = 0;
  std::uint64_t sequence = 0;
  std::string digest;     ///< of the map that was applied; empty if none was
  std::string refusal;    ///< why a map that was there was not; empty if none was there in time
  double waited_s = 0.0;  ///< in vain
};

/// Corrects the program of a toolpath on its way, by the maps that come while it is printed. Above the first
/// layer, which nothing can be known of, each layer waits for its map. Maps may come from any thread; the
/// latest that is there when a layer is decided holds.
class LayerCorrector final : public ProgramRevision {
 public:
  /// Reads the program once, so that what cannot be corrected is refused before it begins.
  /// @throws InvalidProgram as `ProgramCorrector`; if none of what it deposits lies on the toolpath
  /// @throws FileError if the program is gone, or nothing can be written to the folder of the record
  LayerCorrector(const StreamableProgram& program, ProgrammedToolpath toolpath,
                 StreamCorrectionSettings settings);

  /// @return why the map is not used, in words; empty if it is kept for its layer
  std::string hear(CorrectionMap map);

  bool isKnown(std::int32_t layer) override;
  void decide(std::int32_t layer) override;
  double waitTime() const override { return settings_.loop.wait_s; }
  std::string revised(std::string_view line, std::uint64_t number) override;

  /// As maps name it.
  const std::string& plannedId() const { return toolpath_.id; }
  /// Of the layers decided so far, in order.
  std::vector<LayerDecision> decisions() const;
  /// Why the record is not kept; empty while all is well.
  std::string recordFailure() const;

 private:
  void apply(LayerDecision decision, const CorrectionMap* map);
  void keepRecord(const CorrectionMap* map);

  const ProgrammedToolpath toolpath_;
  const StreamCorrectionSettings settings_;
  std::string program_sha256_;
  std::string programmed_id_;  ///< of the toolpath in coordinates of the program
  ProgramCorrector corrector_;

  mutable std::mutex mutex_;                    ///< of what is below
  std::map<std::size_t, CorrectionMap> heard_;  ///< by layer, not applied yet
  std::vector<LayerDecision> decisions_;
  std::string record_failure_;
};

}  // namespace lamina
