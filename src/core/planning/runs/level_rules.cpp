// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/level_rules.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"
#include "lamina/toolpath/process_levels.hpp"

namespace lamina {
namespace {

constexpr double kMostLevel = 1e6;  // in the unit of any channel
constexpr double kNotGiven = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kMostRules = 1000;

/// A rule as it is written.
struct WrittenRule {
  LevelCondition when;
  std::string role;
  bool is_always = false;
  std::array<std::string, kProcessLevels> set, scale, law;
  double value = kNotGiven;
  double first = kNotGiven;
  double last = kNotGiven;
  double layers = kNotGiven;
  std::string over;
  SettingTable points;
};

double numberIn(const std::string& key, const std::string& text, Bounds bounds) {
  double number = 0.0;
  SettingsSchema schema;
  schema.number(key, number, bounds, "");
  schema.set(key, text);
  return number;
}

void describeChannel(SettingsSchema& schema, LevelChannel& channel) {
  const Bounds level{0.0, kMostLevel};
  schema.number("lower", channel.lower, level, "");
  schema.number("upper", channel.upper, level, "");
  schema.number("dead_time_s", channel.dead_time_s, {0.0, 60.0}, "");
  for (const auto& [name, end] : {std::pair{"start", &channel.start}, std::pair{"end", &channel.end}}) {
    const std::string prefix = name;
    schema.number(prefix + "_share", end->share, {0.0, 10.0}, "");
    schema.number(prefix + "_mm", end->over_mm, {0.0, 1000.0}, "");
    schema.number(prefix + "_hold_s", end->hold_s, {0.0, 60.0}, "");
  }
  if (channel.stated.name != nameOf(ProcessLevel::Powder)) return;
  schema.number("density_g_cm3", channel.density_g_cm3, Bounds::above(0.0, 30.0), "");
  schema.number("efficiency", channel.efficiency, Bounds::above(0.0, 1.0), "");
}

void describeRule(SettingsSchema& schema, WrittenRule& rule) {
  schema.text("when.role", rule.role, "");
  schema.numbers("when.layers", rule.when.layers, 2, "");
  schema.numbers("when.z_mm", rule.when.z_mm, 2, "");
  schema.number("when.corner_mm", rule.when.corner_mm, Bounds::above(0.0, 1000.0), "");
  schema.flag("when.always", rule.is_always, "");
  for (const ProcessLevel level : kAllProcessLevels) {
    const auto index = static_cast<std::size_t>(level);
    schema.text(std::string("set.") + nameOf(level), rule.set[index], "");
    schema.text(std::string("scale.") + nameOf(level), rule.scale[index], "");
    schema.text(std::string("law.") + nameOf(level), rule.law[index], "");
  }
  schema.number("law.value", rule.value, {0.0, kMostLevel}, "");
  schema.number("law.first", rule.first, {0.0, kMostLevel}, "");
  schema.number("law.last", rule.last, {0.0, kMostLevel}, "");
  schema.number("law.layers", rule.layers, Bounds::above(0.0, kMostLevel), "");
  schema.choice("law.over", rule.over, {"layer", "z_mm"}, "");
  schema.table("law.points", rule.points, "");
}

/// The law that a name states for a channel. J are of a laser alone.
LevelLaw namedLaw(const std::string& name, ProcessLevel channel, const WrittenRule& rule) {
  const bool is_power = channel == ProcessLevel::LaserPower;
  const std::string per_length = is_power ? "per_length_j_mm" : "per_length";
  const std::string per_volume = is_power ? "per_volume_j_mm3" : "per_volume";
  if (name == per_length) return LevelLaw::PerLength;
  if (name == per_volume) return LevelLaw::PerVolume;
  if (name == "approach") return LevelLaw::Approach;
  if (name == "table") return rule.over == "z_mm" ? LevelLaw::OverZ : LevelLaw::OverLayer;
  throw InvalidConfig(std::string("law.") + nameOf(channel) + " is '" + name + "'; expected " + per_length +
                      ", " + per_volume + ", table or approach");
}

/// Refuses a law without what it needs, or with what it does not read.
void requireGiven(const WrittenRule& rule, const std::string& name) {
  const bool is_table = name == "table";
  const bool is_approach = name == "approach";
  struct Parameter {
    const char* key;
    bool is_given;
    bool is_needed;
  };
  const std::array<Parameter, 6> parameters = {
      {{"law.value", !std::isnan(rule.value), !name.empty() && !is_table && !is_approach},
       {"law.first", !std::isnan(rule.first), is_approach},
       {"law.last", !std::isnan(rule.last), is_approach},
       {"law.layers", !std::isnan(rule.layers), is_approach},
       {"law.over", !rule.over.empty(), is_table},
       {"law.points", !rule.points.empty(), is_table}}};
  const std::string law = name.empty() ? "a rule without a law" : "the law '" + name + "'";
  for (const Parameter& parameter : parameters)
    if (parameter.is_given != parameter.is_needed)
      throw InvalidConfig(std::string(parameter.key) + (parameter.is_given ? " is given" : " is missing") +
                          "; " + law + (parameter.is_needed ? " needs it" : " does not read it"));
}

std::vector<std::pair<double, double>> pointsOf(const SettingTable& table) {
  std::vector<std::pair<double, double>> points;
  points.reserve(table.size());
  for (const auto& [at, value] : table)
    points.emplace_back(numberIn("law.points", at, {-kMostLevel, kMostLevel}),
                        numberIn("law.points." + at, value, {0.0, kMostLevel}));
  std::sort(points.begin(), points.end());
  return points;
}

ChannelChange changeByLaw(const WrittenRule& rule, ProcessLevel channel, const std::string& name) {
  ChannelChange change;
  change.channel = nameOf(channel);
  change.law = namedLaw(name, channel, rule);
  change.value = change.law == LevelLaw::Approach ? rule.first : rule.value;
  change.last = rule.last;
  change.layers = rule.layers;
  change.points = pointsOf(rule.points);
  return change;
}

ChannelChange changeBySet(ProcessLevel channel, const std::string& text) {
  ChannelChange change;
  change.channel = nameOf(channel);
  const std::string key = "set." + change.channel;
  const bool is_from_bead = text == "from_bead";
  if (is_from_bead && !canFollowBead(channel))
    throw InvalidConfig(key +
                        " is from_bead; expected a number: only wire_speed_mm_s and powder_g_min follow "
                        "from the bead");
  change.law = is_from_bead ? LevelLaw::FromBead : LevelLaw::Constant;
  if (!is_from_bead) change.value = numberIn(key, text, {0.0, kMostLevel});
  return change;
}

std::vector<ChannelChange> changesOf(const WrittenRule& rule) {
  std::vector<ChannelChange> changes;
  std::string law_name;
  for (const ProcessLevel level : kAllProcessLevels) {
    const auto index = static_cast<std::size_t>(level);
    if (!rule.set[index].empty()) changes.push_back(changeBySet(level, rule.set[index]));
    if (!rule.law[index].empty()) {
      if (!law_name.empty())
        throw InvalidConfig(std::string("law.") + nameOf(level) +
                            " is a second law; expected a rule for each");
      law_name = rule.law[index];
      changes.push_back(changeByLaw(rule, level, law_name));
    }
    if (!rule.scale[index].empty()) {
      const std::string key = std::string("scale.") + nameOf(level);
      ChannelChange scale;
      scale.channel = nameOf(level);
      scale.law = LevelLaw::Scale;
      scale.value = numberIn(key, rule.scale[index], {0.0, 100.0});
      changes.push_back(std::move(scale));
    }
  }
  requireGiven(rule, law_name);
  if (changes.empty()) throw InvalidConfig("nothing is changed; expected set, scale or law");
  return changes;
}

void requireRange(const std::string& key, const std::vector<double>& range) {
  if (!range.empty() && range[0] > range[1])
    throw InvalidConfig(key + " is " + numberText(range[0]) + ", " + numberText(range[1]) +
                        "; expected the lower number first");
}

LevelCondition conditionOf(const WrittenRule& rule) {
  LevelCondition when = rule.when;
  if (!rule.role.empty()) when.role = pathRoleFromString(rule.role);
  requireRange("when.layers", when.layers);
  requireRange("when.z_mm", when.z_mm);
  const bool has_condition = when.role || !when.layers.empty() || !when.z_mm.empty() || when.corner_mm > 0.0;
  if (has_condition == rule.is_always)
    throw InvalidConfig(std::string("when.always is ") + (rule.is_always ? "true" : "false") +
                        (has_condition ? " beside another condition" : " and there is no other condition") +
                        "; expected when.always: true, or one or more of role, layers, z_mm, corner_mm");
  return when;
}

/// The entries of a list of rules, by the number of the rule.
std::map<std::size_t, std::vector<SettingText>> entriesByRule(const SettingTable& table) {
  std::map<std::size_t, std::vector<SettingText>> entries;
  for (const auto& [name, text] : table) {
    std::size_t index = 0;
    const std::size_t dot = std::min(name.find('.'), name.size());
    const auto result = std::from_chars(name.data(), name.data() + dot, index);
    if (result.ec != std::errc{} || result.ptr != name.data() + dot || dot == name.size() ||
        index >= kMostRules)
      throw InvalidConfig("levels.rules." + name +
                          " is no rule's; expected a list of rules with when, and set, scale or law");
    entries[index].push_back({name.substr(dot + 1), text});
  }
  return entries;
}

LevelRule ruleOf(const std::vector<SettingText>& entries, const std::vector<StatedLevel>& stated) {
  WrittenRule written;
  SettingsSchema schema;
  describeRule(schema, written);
  for (const SettingText& entry : entries) schema.set(entry.key, entry.text);
  LevelRule rule{conditionOf(written), changesOf(written)};
  for (const ChannelChange& change : rule.changes)
    if (std::none_of(stated.begin(), stated.end(),
                     [&](const StatedLevel& level) { return level.name == change.channel; }))
      throw InvalidConfig(change.channel + " is changed but not stated; expected it in levels.values");
  return rule;
}

void requireChannel(const LevelChannel& channel) {
  const std::string key = "levels.channels." + channel.stated.name;
  const std::string unit = unitOfLevel(channel.stated.name);
  if (channel.lower > channel.upper)
    throw InvalidConfig(key + ".lower is " + numberText(channel.lower) + " " + unit + " and upper " +
                        numberText(channel.upper) + " " + unit +
                        "; expected the lower bound not to be greater");
  for (const auto& [end, name] :
       {std::pair{channel.start, std::string("start")}, std::pair{channel.end, std::string("end")}})
    if (end.share != 1.0 && end.over_mm == 0.0 && end.hold_s == 0.0)
      throw InvalidConfig(key + "." + name + "_share is " + numberText(end.share) +
                          " with neither a length nor a time; expected 1, or " + name + "_mm or " + name +
                          "_hold_s");
}

/// Refuses powder that follows from the bead without its density.
void requireDensity(const LevelChannel& channel, const std::vector<LevelRule>& rules) {
  if (channel.stated.name != nameOf(ProcessLevel::Powder) || channel.density_g_cm3 > 0.0) return;
  bool follows = channel.stated.is_from_bead;
  for (const LevelRule& rule : rules)
    for (const ChannelChange& change : rule.changes)
      follows |= change.channel == channel.stated.name && change.law == LevelLaw::FromBead;
  if (follows)
    throw InvalidConfig(
        "levels.channels.powder_g_min.density_g_cm3 is missing; expected the density of the bead: "
        "powder_g_min follows from it");
}

bool isWithin(const std::vector<double>& range, double value) {
  return range.empty() || (value >= range[0] && value <= range[1]);
}

bool isMet(const LevelCondition& when, const LevelPlace& place) {
  return (!when.role || *when.role == place.role) &&
         isWithin(when.layers, static_cast<double>(place.layer)) && isWithin(when.z_mm, place.z_mm) &&
         (when.corner_mm == 0.0 || place.corner_mm <= when.corner_mm);
}

/// Linear between the points, constant beyond them.
double tableAt(const std::vector<std::pair<double, double>>& points, double at) {
  const auto above = std::find_if(points.begin(), points.end(), [&](const auto& p) { return p.first >= at; });
  if (above == points.end()) return points.back().second;
  if (above == points.begin()) return above->second;
  const auto below = above - 1;
  const double share = (at - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

double levelFromBead(const LevelChannel& channel, const LevelPlace& place) {
  const double section_mm2 = crossSection(place.bead);
  if (channel.stated.name == nameOf(ProcessLevel::Powder))
    return section_mm2 * place.feed_mm_s * 1e-3 * channel.density_g_cm3 / channel.efficiency * 60.0;
  const double wire_mm2 = 0.25 * M_PI * place.wire_mm * place.wire_mm;
  return section_mm2 * place.feed_mm_s / wire_mm2;
}

double changed(const ChannelChange& change, const LevelChannel& channel, const LevelPlace& place,
               double before) {
  const auto layer = static_cast<double>(place.layer);
  switch (change.law) {
    case LevelLaw::FromBead:
      return levelFromBead(channel, place);
    case LevelLaw::Scale:
      return change.value * before;
    case LevelLaw::PerLength:
      return change.value * place.feed_mm_s;
    case LevelLaw::PerVolume:
      return change.value * place.feed_mm_s * crossSection(place.bead);
    case LevelLaw::OverLayer:
      return tableAt(change.points, layer);
    case LevelLaw::OverZ:
      return tableAt(change.points, place.z_mm);
    case LevelLaw::Approach:
      return change.value + (change.last - change.value) * (1.0 - std::exp(-layer / change.layers));
    default:
      return change.value;
  }
}

}  // namespace

std::string unitOfLevel(const std::string& channel) {
  static constexpr std::array<std::pair<ProcessLevel, const char*>, 5> kUnits = {
      {{ProcessLevel::LaserPower, "W"},
       {ProcessLevel::WireSpeed, "mm/s"},
       {ProcessLevel::ScrewSpeed, "rpm"},
       {ProcessLevel::Powder, "g/min"},
       {ProcessLevel::Gas, "l/min"}}};
  for (const auto& [level, unit] : kUnits)
    if (channel == nameOf(level)) return unit;
  return "1";
}

std::vector<LevelRule> levelRules(const LevelSettings& settings) {
  const std::vector<StatedLevel> stated = statedLevels(settings.values);
  const auto written = entriesByRule(settings.rules);
  std::vector<LevelRule> rules;
  rules.reserve(written.size());
  for (const auto& [index, entries] : written) {
    if (index != rules.size())
      throw InvalidConfig("levels.rules has no rule " + std::to_string(rules.size()) + ", but rule " +
                          std::to_string(index) + "; expected rules numbered from 0");
    try {
      rules.push_back(ruleOf(entries, stated));
    } catch (const Error& error) {
      throw InvalidConfig("levels.rules " + std::to_string(index) + ": " + error.what());
    }
  }
  return rules;
}

std::vector<LevelChannel> levelChannels(const LevelSettings& settings) {
  std::vector<StatedLevel> stated = statedLevels(settings.values);
  std::vector<LevelChannel> channels;
  channels.reserve(stated.size());
  for (StatedLevel& level : stated) {
    LevelChannel channel;
    channel.stated = std::move(level);
    channel.start = {settings.start_share, settings.start_mm, 0.0};
    channel.end = {settings.end_share, settings.end_mm, 0.0};
    channels.push_back(std::move(channel));
  }
  for (const auto& [name, text] : settings.channels) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    const std::string of = name.substr(0, dot);
    const auto named = std::find_if(channels.begin(), channels.end(),
                                    [&](const LevelChannel& channel) { return channel.stated.name == of; });
    if (named == channels.end())
      throw InvalidConfig("levels.channels holds '" + of + "'; expected a name that levels.values states");
    SettingsSchema schema;
    describeChannel(schema, *named);
    try {
      schema.set(name.substr(std::min(dot + 1, name.size())), text);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig("levels.channels." + named->stated.name + ": " + error.what());
    }
  }
  const std::vector<LevelRule> rules = levelRules(settings);
  for (const LevelChannel& channel : channels) {
    requireChannel(channel);
    requireDensity(channel, rules);
  }
  return channels;
}

RuledLevel ruledLevel(const LevelChannel& channel, const std::vector<LevelRule>& rules,
                      const LevelPlace& place) {
  RuledLevel level{channel.stated.is_from_bead ? levelFromBead(channel, place) : channel.stated.value,
                   "levels.values"};
  for (std::size_t i = 0; i < rules.size(); ++i) {
    if (!isMet(rules[i].when, place)) continue;
    for (const ChannelChange& change : rules[i].changes) {
      if (change.channel != channel.stated.name) continue;
      level.value = changed(change, channel, place, level.value);
      level.by = "levels.rules " + std::to_string(i);
    }
  }
  return level;
}

}  // namespace lamina
