// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/resume/rest_offer.hpp"

#include "lamina/base/error.hpp"
#include "streaming/job/decimal.hpp"
#include "streaming/resume/program_state.hpp"

namespace lamina {

RestOffer offerRest(const StreamableProgram& program, std::uint64_t taken_through) {
  if (taken_through >= program.lines())
    throw InvalidInput("all " + std::to_string(program.lines()) + " lines of " + program.name() +
                       " were taken: there is nothing to go on with");
  ProgramCursor cursor = program.open();
  ProgramState state;
  RestOffer offer;
  std::int32_t layer = -1;
  for (offer.line = 1;; ++offer.line) {
    const auto line = cursor.next();
    if (!line) throw InvalidProgram(program.name() + " was changed while it was read");
    if (line->layer != layer) {
      layer = line->layer;
      offer.layer_line = offer.line;
    }
    if (offer.line > taken_through) break;
    state.run(line->command);
  }
  if (layer >= 0) offer.layer = layer;
  offer.height_mm = state.position.z() - state.shift.z();
  return offer;
}

std::string describeOffer(const RestOffer& offer) {
  std::string text =
      "Where the last bead ends, somebody has to see. By what is known, lamina resume could go on from:\n";
  text += "--from-line " + std::to_string(offer.line) + "  the first line that was not certainly taken\n";
  if (offer.layer)
    text += "--from-layer " + std::to_string(*offer.layer) + "  which begins at line " +
            std::to_string(offer.layer_line) + "\n";
  return text + "--from-height " + decimal(offer.height_mm) + "  where that line begins [mm]\n";
}

}  // namespace lamina
