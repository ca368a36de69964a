// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/rapid/writer/rapid_notes.hpp"

#include "program/rapid/rapid_words.hpp"

namespace lamina {
namespace {

void appendLayer(const ToolpathLayer& layer, double rise_mm, std::string& text) {
  text.append(kRapidNote).append("layer ");
  appendShortest(text, layer.z_mm + rise_mm);
  text += ' ';
  appendShortest(text, layer.height_mm);
  text += '\n';
}

void appendBeads(const Path& path, std::string& text) {
  const std::size_t motions = path.motionCount();
  for (std::size_t begin = 0; begin < motions;) {
    const Bead& bead = path.bead.at(path.motionEnd(begin));
    std::size_t end = path.bead.isCommon() ? motions : begin + 1;
    while (end < motions && path.bead.at(path.motionEnd(end)) == bead) ++end;
    text.append(kRapidNote).append("bead ");
    appendShortest(text, bead.width_mm);
    text += ' ';
    appendShortest(text, bead.height_mm);
    text.append(" ").append(std::to_string(end - begin)).append("\n");
    begin = end;
  }
}

}  // namespace

void appendRapidNotes(const Toolpath& toolpath, const RapidPlan& plan, const RapidChunk& chunk,
                      double rise_mm, std::string& text) {
  for (std::size_t p = chunk.begin.path; p < plan.paths.size(); ++p) {
    const std::size_t first = p == chunk.begin.path ? chunk.begin.move : 0;
    const std::size_t last = p < chunk.end.path ? plan.paths[p].moveCount() : chunk.end.move;
    if (p > chunk.end.path || last <= first) break;
    const std::string count = std::to_string(last - first);
    if (first > 0) {
      text.append(kRapidNote).append("resumed ").append(count).append("\n");
      continue;
    }
    const RapidPath& path = plan.paths[p];
    if (p == 0 || plan.paths[p - 1].layer != path.layer)
      appendLayer(toolpath.layers[path.layer], rise_mm, text);
    text.append(kRapidNote).append("path ").append(toString(path.path->role));
    text += path.path->is_closed ? " closed" : " open";
    if (path.path->process.is_retracted) text += " retracted";
    if (path.is_turned) text += " turned";
    text.append(" ").append(count).append("\n");
    if (!path.deposits()) continue;
    appendBeads(*path.path, text);
    for (const ProcessValue& value : path.path->values)
      text.append(kRapidNote).append("value ").append(value.name).append("\n");
  }
}

}  // namespace lamina
