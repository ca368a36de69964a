// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
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

/// Whatever is refused is refused as input.
template <class Read>
void tryReading(Read read) {
  try {
    read();
  } catch (const InvalidInput&) {
  } catch (const InvalidConfig&) {
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

void useMap(const std::string& text) {
  const CorrectionMap map = readCorrectionMap(text, "fuzz");
  require(digestOf(readCorrectionMap(correctionMapCsv(map), "fuzz")) == digestOf(map));
  for (const PathCorrection& path : map.paths) require(std::isfinite(correctionAt(path, 10.0).amount));
  const CorrectionMap led = ledMap(map, test::straightBeadLayer({0.0, 3.0}, 5.0), {0.5, 0.1}, LoopSettings());
  validate(led);
}

/// What was kept is gone on with for a layer of as many cells.
void useMemory(const std::string& text) {
  const LoopMemory memory = memoryFromYaml(text, "fuzz");
  require(toYaml(memoryFromYaml(toYaml(memory), "fuzz")) == toYaml(memory));
  HeightLoop loop{LoopSettings()};
  const LayerCells cells = test::straightBeads({0.0}, 4.0, 1.0);
  loop.resume(cells, memory.heights);
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
/// refused; what is read is used. Memories lead to no amount beyond its limits; a led map may be refused.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  lamina::tryReading([&] { lamina::useMap(lamina::withItsDigest(text)); });
  lamina::tryReading([&] { lamina::partMapCsv(lamina::readPartMap(text, "fuzz")); });
  lamina::tryReading([&] { lamina::readProgrammedToolpath(text, "fuzz"); });
  lamina::tryReading([&] { lamina::useMemory(text); });
  return 0;
}
