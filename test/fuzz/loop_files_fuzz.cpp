// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/control/correction_map.hpp"
#include "lamina/control/feeder_lead.hpp"
#include "lamina/control/height_loop.hpp"
#include "lamina/control/part_learning.hpp"
#include "lamina/control/program/correction_files.hpp"
#include "lamina/control/run/loop_memory.hpp"
#include "support/control_layers.hpp"

namespace lamina {
namespace {

/// What is read of any bytes; nothing where they are refused as input. What else is thrown ends the fuzzer.
template <class Read>
auto readOrRefused(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

void require(bool holds) {
  if (!holds) std::abort();
}

/// The text with the digest that its map has, so that what lies behind the digest is reached.
std::string withItsDigest(std::string text) {
  try {
    readCorrectionMap(text, "fuzz");
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    const std::size_t at = message.find("the map's is ");
    const std::size_t digest = text.find("# digest ");
    if (at == std::string::npos || digest == std::string::npos) return text;
    const std::size_t word = digest + 9;
    const std::size_t end = text.find_first_of(" \n", word);
    text.replace(word, end == std::string::npos ? end : end - word, message.substr(at + 13));
  }
  return text;
}

// What was read is used without a look at exceptions: a refusal from here on is a defect, and ends the
// fuzzer.

void useMap(const CorrectionMap& map) {
  require(digestOf(readCorrectionMap(correctionMapCsv(map), "fuzz")) == digestOf(map));
  for (const PathCorrection& path : map.paths) require(std::isfinite(correctionAt(path, 10.0).amount));
  const CorrectionMap led = ledMap(map, test::straightBeadLayer({0.0, 3.0}, 5.0), {0.5, 0.1}, LoopSettings());
  validate(led);
}

void usePartMap(const PartMap& map) {
  const std::string csv = partMapCsv(map);
  require(partMapCsv(readPartMap(csv, "fuzz")) == csv);
}

void useToolpath(const ProgrammedToolpath& planned) {
  const std::string csv = programmedToolpathCsv(planned);
  require(programmedToolpathCsv(readProgrammedToolpath(csv, "fuzz")) == csv);
}

/// What was kept is gone on with for a layer of as many cells.
void useMemory(const LoopMemory& memory) {
  require(toYaml(memoryFromYaml(toYaml(memory), "fuzz")) == toYaml(memory));
  HeightLoop loop{LoopSettings()};
  const LayerCells cells = test::straightBeads({0.0}, 4.0, 1.0);
  const StoredHeights& kept = memory.heights;
  bool fits = true;
  for (const std::size_t count : {kept.estimates.size(), kept.deficit.size(), kept.before_deficit.size(),
                                  kept.before_clouds.error_mm.size(), kept.before_clouds.gain.size()})
    fits = fits && count == cells.size();
  const auto is_resumed = readOrRefused([&] {
    loop.resume(cells, kept);
    return true;
  });
  require(is_resumed.has_value() == fits);
  if (!fits) return;
  loop.beginLayer(cells);
  const LoopSettings limits;
  const LayerCorrection correction = loop.correction(LoopState::Active);
  for (const double amount : correction.amount)
    require(amount >= limits.least_amount && amount <= limits.greatest_amount);
  loop.lay(correction);
  loop.see(0, {0.1, 3, 0.02});
  loop.endCloud();
  loop.endLayer();
}

}  // namespace
}  // namespace lamina

/// Any bytes are read as what the loop keeps in files (maps, learnt parts, toolpaths of maps, its memory), or
/// refused; what is read once is read again to the same, and used. Memories lead to no amount beyond its
/// limits, and are refused for layers of other cells alone; a led map is valid as its map is.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  const auto map = [&] { return lamina::readCorrectionMap(lamina::withItsDigest(text), "fuzz"); };
  if (const auto read = lamina::readOrRefused(map)) lamina::useMap(*read);
  const auto learnt = [&] { return lamina::readPartMap(text, "fuzz"); };
  if (const auto read = lamina::readOrRefused(learnt)) lamina::usePartMap(*read);
  const auto planned = [&] { return lamina::readProgrammedToolpath(text, "fuzz"); };
  if (const auto read = lamina::readOrRefused(planned)) lamina::useToolpath(*read);
  const auto memory = [&] { return lamina::memoryFromYaml(text, "fuzz"); };
  if (const auto read = lamina::readOrRefused(memory)) lamina::useMemory(*read);
  return 0;
}
