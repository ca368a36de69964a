// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

#include "job/plate/plate_toolpath.hpp"

namespace lamina {
namespace {

/// Klipper takes a name up to the next space, and hosts take it for an identifier.
std::string identifier(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

std::string coordinates(const Point2& point) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f,%.3f", point.x(), point.y());
  return text;
}

/// What a firmware's dialect says of parts.
class Labels {
 public:
  Labels(const std::vector<LabelledPart>& parts, ObjectLabels dialect) : parts_(parts), dialect_(dialect) {}

  std::string definitions() const {
    if (dialect_ == ObjectLabels::M486) return "M486 T" + std::to_string(parts_.size());
    std::string text;
    for (const LabelledPart& part : parts_) {
      text += text.empty() ? "" : "\n";
      text += "EXCLUDE_OBJECT_DEFINE NAME=" + identifier(part.name) +
              " CENTER=" + coordinates(boundingBox({part.outline}).centre()) + " POLYGON=[";
      for (const Point2& corner : part.outline)
        text += (&corner == &part.outline.front() ? "[" : ",[") + coordinates(corner) + "]";
      text += "]";
    }
    return text;
  }

  /// From the part before, if there is one, to the next.
  std::string change(const std::string& before, const std::string& next) const {
    if (dialect_ == ObjectLabels::M486) return "M486 S" + indexOf(next);
    std::string text = before.empty() ? "" : "EXCLUDE_OBJECT_END NAME=" + identifier(before);
    if (!next.empty()) text += (text.empty() ? "" : "\n") + ("EXCLUDE_OBJECT_START NAME=" + identifier(next));
    return text;
  }

 private:
  std::string indexOf(const std::string& name) const {
    const auto part =
        std::find_if(parts_.begin(), parts_.end(), [&](const LabelledPart& p) { return p.name == name; });
    return part == parts_.end() ? "-1" : std::to_string(part - parts_.begin());
  }

  const std::vector<LabelledPart>& parts_;
  ObjectLabels dialect_;
};

ToolpathEvent codeOf(const std::string& text) {
  ToolpathEvent event;
  event.emplace<MachineCode>(MachineCode{text, false});
  return event;
}

void labelMarks(Path& path, const Labels& labels, std::string& part) {
  for (std::size_t i = 0; i < path.events.size(); ++i) {
    const auto* const mark = std::get_if<PartMark>(&path.events[i].event);
    if (mark == nullptr) continue;
    const std::string next = mark->name;
    const PathEvent label{path.events[i].motion, codeOf(labels.change(std::exchange(part, next), next))};
    path.events.insert(path.events.begin() + static_cast<std::ptrdiff_t>(++i), label);
  }
}

}  // namespace

void addLabels(Toolpath& plate, const std::vector<LabelledPart>& parts, ObjectLabels dialect) {
  if (dialect == ObjectLabels::None) return;
  const Labels labels(parts, dialect);
  std::string part;
  bool is_first = true;
  for (ToolpathLayer& layer : plate.layers)
    for (Path& path : layer.paths) {
      labelMarks(path, labels, part);
      if (std::exchange(is_first, false))
        path.events.insert(path.events.begin(), PathEvent{0, codeOf(labels.definitions())});
    }
  plate.events_at_end.push_back(codeOf(labels.change(part, "")));
}

}  // namespace lamina
