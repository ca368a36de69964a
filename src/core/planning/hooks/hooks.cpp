// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/hooks/hooks.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/decimals.hpp"
#include "lamina/base/one_line.hpp"
#include "lamina/toolpath/timing.hpp"
#include "planning/hooks/hook_code.hpp"
#include "planning/hooks/layer_places.hpp"

namespace lamina {
namespace {

std::string decimal(double value) { return trimmedDecimals(value, 3); }

/// When the nozzle begins a path, or has ended it.
struct Moment {
  std::size_t layer = 0;
  std::size_t path = 0;
  bool is_end = false;
};

/// A place where the tool changes.
struct ToolChange {
  std::size_t layer = 0;
  std::size_t path = 0;
  std::uint32_t tool = 0;
};

class Hooks {
 public:
  Hooks(Toolpath& toolpath, const HookSettings& settings, const HookSite& site)
      : toolpath_(toolpath), settings_(settings), site_(site), places_(toolpath, site) {
    for (const HookCode& hook : hookCodes(settings))
      if (times_.start_s.empty() && holdsAny(hook.code, {"time_s", "left_s", "share"}))
        times_ = estimatePathTimes(toolpath, site.limits);
    std::uint32_t tool = 0;
    for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
      for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
        const std::uint32_t next = toolpath.layers[l].paths[p].tool;
        if (std::exchange(tool, next) != next) changes_.push_back({l, p, next});
      }
    for (const auto& [number, hook] : layerHooks(settings))
      at_[places_.layer(number, hook.key)].push_back(hook);
    for (const auto& [height_mm, hook] : heightHooks(settings))
      for (const std::size_t layer : places_.above(height_mm, hook.key)) at_[layer].push_back(hook);
  }

  void add() {
    PathRole role = PathRole::Travel;
    std::uint32_t tool = 0;
    bool has_begun = false;
    std::optional<Moment> last_bead;
    std::optional<Moment> last;
    for (std::size_t l = 0; l < toolpath_.layers.size(); ++l) {
      std::vector<Path>& paths = toolpath_.layers[l].paths;
      const std::size_t bead = firstBead(toolpath_.layers[l]);
      for (std::size_t p = 0; p < paths.size(); ++p) {
        const Moment begin{l, p, false};
        if (!std::exchange(has_begun, true)) put({"hooks.part_start", settings_.part_start}, begin);
        if (std::exchange(tool, paths[p].tool) != paths[p].tool)
          put({"hooks.tool_change", settings_.tool_change}, begin);
        if (p == bead) beginLayer(begin);
        if (paths[p].role != PathRole::Travel) {
          changeRole(std::exchange(role, paths[p].role), paths[p].role, last_bead, begin);
          last_bead = Moment{l, p, true};
        }
        announcePauses(begin);
        last = Moment{l, p, true};
      }
      if (!paths.empty()) put({"hooks.layer_end", settings_.layer_end}, *last);
    }
    if (last_bead) changeRole(role, PathRole::Travel, last_bead, *last_bead);
    if (last) endPart(*last);
    insert();
  }

 private:
  const Path& pathAt(const Moment& moment) const { return toolpath_.layers[moment.layer].paths[moment.path]; }

  void beginLayer(const Moment& begin) {
    put({"hooks.layer_start", settings_.layer_start}, begin);
    const auto found = at_.find(begin.layer);
    if (found == at_.end()) return;
    for (const HookCode& hook : found->second) put(hook, begin);
  }

  /// @param ended  the last bead of the role before; none if there was none
  void changeRole(PathRole from, PathRole to, const std::optional<Moment>& ended, const Moment& begin) {
    if (from == to) return;
    const auto code = [](const SettingTable& table, PathRole role) {
      const auto found = table.find(toString(role));
      return found == table.end() ? std::string() : found->second;
    };
    if (ended) put({"hooks.after_role", code(settings_.after_role, from)}, *ended);
    if (to != PathRole::Travel) put({"hooks.before_role", code(settings_.before_role, to)}, begin);
  }

  void announcePauses(const Moment& begin) {
    if (settings_.pause.empty()) return;
    for (const PathEvent& placed : pathAt(begin).events)
      if (std::holds_alternative<OperatorPause>(placed.event))
        putAt({"hooks.pause", settings_.pause}, begin, placed.motion);
  }

  void endPart(const Moment& last) {
    if (auto event = eventOf({"hooks.part_end", settings_.part_end}, last))
      toolpath_.events_at_end.insert(toolpath_.events_at_end.begin(), std::move(*event));
  }

  void put(const HookCode& hook, const Moment& moment) {
    putAt(hook, moment, moment.is_end ? pathAt(moment).motionCount() : 0);
  }

  void putAt(const HookCode& hook, const Moment& moment, std::size_t motion) {
    std::optional<ToolpathEvent> event = eventOf(hook, moment);
    if (event) events_[{moment.layer, moment.path}].push_back({motion, std::move(*event)});
  }

  /// None if nothing is left of the code.
  std::optional<ToolpathEvent> eventOf(const HookCode& hook, const Moment& moment) const {
    if (hook.code.empty()) return std::nullopt;
    std::string text = expandPlaceholders(hook.key, hook.code,
                                          [&](const std::string& name) { return valueOf(name, moment); });
    if (text.empty()) return std::nullopt;
    std::optional<ToolpathEvent> event;
    event.emplace(std::in_place_type<MachineCode>, MachineCode{std::move(text), settings_.moves_axes});
    return event;
  }

  std::string valueOf(const std::string& name, const Moment& moment) const {
    const ToolpathLayer& layer = toolpath_.layers[moment.layer];
    const Path& path = pathAt(moment);
    if (name == "layer") return std::to_string(moment.layer);
    if (name == "layers") return std::to_string(toolpath_.layers.size());
    if (name == "z_mm") return decimal(places_.topOf(moment.layer));
    if (name == "height_mm") return decimal(layer.height_mm);
    if (name == "role") return toString(path.role);
    if (name == "part") return oneLine(toolpath_.part_name);
    if (name == "tool") return std::to_string(path.tool);
    if (name == "next_tool") return nextTool(moment);
    if (name == "nozzle_temperature_c") return temperature(site_.nozzle_temperature_c);
    if (name == "bed_temperature_c") return temperature(site_.bed_temperature_c);
    if (name == "x_mm" || name == "y_mm") return decimal(placeOf(moment)[name == "x_mm" ? 0 : 1]);
    const double time_s = timeOf(moment);
    if (name == "time_s") return decimal(time_s);
    if (name == "left_s") return decimal(times_.total_s - time_s);
    return decimal(times_.total_s > 0.0 ? time_s / times_.total_s : 0.0);
  }

  static std::string temperature(double value_c) { return value_c > 0.0 ? decimal(value_c) : ""; }

  std::string nextTool(const Moment& moment) const {
    const auto next =
        std::upper_bound(changes_.begin(), changes_.end(), moment, [](const Moment& a, const ToolChange& b) {
          return std::tie(a.layer, a.path) < std::tie(b.layer, b.path);
        });
    return next == changes_.end() ? "" : std::to_string(next->tool);
  }

  Point3 placeOf(const Moment& moment) const {
    const Path& path = pathAt(moment);
    return site_.program_from_bed *
           (site_.bed_from_part * (moment.is_end ? path.lastPoint() : path.firstPoint()));
  }

  double timeOf(const Moment& moment) const {
    if (!moment.is_end) return times_.start_s[moment.layer][moment.path];
    std::size_t path = moment.path + 1;
    for (std::size_t l = moment.layer; l < times_.start_s.size(); ++l, path = 0)
      if (path < times_.start_s[l].size()) return times_.start_s[l][path];
    return times_.total_s;
  }

  /// Those of the toolpath first, but for pauses, which code comes before.
  void insert() {
    for (auto& [place, added] : events_) {
      std::vector<PathEvent>& events = toolpath_.layers[place.first].paths[place.second].events;
      for (PathEvent& each : added) {
        const auto at = std::find_if(events.begin(), events.end(), [&each](const PathEvent& other) {
          return other.motion > each.motion ||
                 (other.motion == each.motion && std::holds_alternative<OperatorPause>(other.event));
        });
        events.insert(at, std::move(each));
      }
    }
  }

  Toolpath& toolpath_;
  const HookSettings& settings_;
  const HookSite& site_;
  LayerPlaces places_;
  PathTimes times_;
  std::vector<ToolChange> changes_;
  std::map<std::size_t, std::vector<HookCode>> at_;                               ///< by layer
  std::map<std::pair<std::size_t, std::size_t>, std::vector<PathEvent>> events_;  ///< by layer and path
};

}  // namespace

void addHooks(Toolpath& toolpath, const HookSettings& settings, const HookSite& site) {
  requireConsistent(settings);
  if (!hookCodes(settings).empty()) Hooks(toolpath, settings, site).add();
}

}  // namespace lamina
