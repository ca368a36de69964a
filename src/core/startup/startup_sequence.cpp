// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/startup/startup_sequence.hpp"

#include <algorithm>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

using Step = StartupStep;

struct Rule {
  Step first;
  Step then;
  const char* because;
  OnLoss on_loss;
};

/// What holds on every machine, as far as both steps are in its sequence.
const std::vector<Rule>& rules() {
  static const std::vector<Rule> kRules = {
      {Step::PowerOn, Step::HeatBed, "without power nothing heats", OnLoss::Spreads},
      {Step::PowerOn, Step::HomeX, "without power no axis moves", OnLoss::Spreads},
      {Step::PowerOn, Step::HomeY, "without power no axis moves", OnLoss::Spreads},
      {Step::PowerOn, Step::HomeZ, "without power no axis moves", OnLoss::Spreads},
      {Step::HomeX, Step::PlaceSheet, "the axes are homed over the bare bed", OnLoss::Spreads},
      {Step::HomeY, Step::PlaceSheet, "the axes are homed over the bare bed", OnLoss::Spreads},
      {Step::HomeZ, Step::PlaceSheet, "Z cannot be moved out of the way of the sheet before it was homed",
       OnLoss::Spreads},
      {Step::PlaceSheet, Step::DrawVacuum, "the vacuum needs a sheet over the grooves", OnLoss::Spreads},
      {Step::HomeZ, Step::HomeZAgain, "Z cannot move before it was homed once", OnLoss::Spreads},
      {Step::PlaceSheet, Step::HomeZAgain, "Z is homed again over the sheet", OnLoss::Spreads},
      {Step::DrawVacuum, Step::HomeZAgain, "the sheet lies still only while it is held", OnLoss::Spreads},
      {Step::HeatBed, Step::MapHeights, "the bed's expansion depends on its temperature", OnLoss::Spreads},
      {Step::HomeX, Step::MapHeights, "heights are measured at known places", OnLoss::Stays},
      {Step::HomeY, Step::MapHeights, "heights are measured at known places", OnLoss::Stays},
      {Step::HomeZ, Step::MapHeights, "heights are measured from Z's home", OnLoss::Stays},
      {Step::DrawVacuum, Step::MapHeights, "the sheet lies flat only while it is held", OnLoss::Stays},
      {Step::HomeZAgain, Step::MapHeights, "heights are measured from Z's home", OnLoss::Stays},
  };
  return kRules;
}

std::vector<Step> stepsFromText(const std::string& key, const std::string& text) {
  std::vector<Step> steps;
  for (const std::string& name : splitIntoWords(text)) {
    const auto step = startupStepFromText(name);
    if (!step) {
      std::string known;
      for (const Step each : allStartupSteps())
        known += std::string(known.empty() ? "" : ", ") + toString(each);
      throw InvalidConfig(key + " has '" + name + "', which is no step; expected some of " + known);
    }
    if (std::find(steps.begin(), steps.end(), *step) != steps.end())
      throw InvalidConfig(key + " has " + name + " twice; expected each step once");
    steps.push_back(*step);
  }
  return steps;
}

bool has(const std::vector<Step>& steps, Step step) {
  return std::find(steps.begin(), steps.end(), step) != steps.end();
}

bool isBefore(const std::vector<Step>& order, Step a, Step b) {
  return std::find(order.begin(), order.end(), a) < std::find(order.begin(), order.end(), b);
}

void addRules(SequencedStep& sequenced, const std::vector<Step>& order) {
  for (const Rule& rule : rules()) {
    if (rule.then != sequenced.step || !has(order, rule.first)) continue;
    if (!isBefore(order, rule.first, rule.then))
      throw InvalidConfig(std::string("startup.sequence has ") + toString(rule.first) + " after " +
                          toString(rule.then) + "; expected it before: " + rule.because);
    sequenced.after.push_back({rule.first, rule.because, rule.on_loss});
  }
}

/// The axes are homed in the order in which they stand.
void addHomingOrder(SequencedStep& sequenced, const std::vector<Step>& order) {
  if (!homedAxis(sequenced.step)) return;
  const Step* before = nullptr;
  for (const Step& step : order) {
    if (step == sequenced.step) break;
    if (homedAxis(step)) before = &step;
  }
  if (before != nullptr)
    sequenced.after.push_back({*before, "the axes are homed one after the other", OnLoss::Stays});
}

void addConfigured(SequencedStep& sequenced, const std::vector<Step>& order,
                   const StartupSettings& settings) {
  const std::string key = std::string("startup.after_") + toString(sequenced.step);
  for (const Step first : stepsFromText(key, settings.after[static_cast<std::size_t>(sequenced.step)])) {
    if (!has(order, first))
      throw InvalidConfig(key + " has " + toString(first) + ", which is not in startup.sequence");
    if (!isBefore(order, first, sequenced.step))
      throw InvalidConfig(key + " has " + toString(first) + ", which is not before " +
                          toString(sequenced.step) + " in startup.sequence: each would wait for the other");
    sequenced.after.push_back({first, key + " says so", OnLoss::Stays});
  }
}

void requireBounds(const StartupSettings& settings) {
  StartupSettings copy = settings;
  SettingsSchema schema;
  describe(schema, copy);
  schema.validate();
  if (settings.bed_rate_c_min <= settings.bed_max_rate_c_min) return;
  throw InvalidConfig("startup.bed_rate_c_min is " + numberText(settings.bed_rate_c_min) +
                      " K/min; must be at most startup.bed_max_rate_c_min, " +
                      numberText(settings.bed_max_rate_c_min) + " K/min");
}

void requireCheckable(const std::vector<Step>& order, const StartupSettings& settings) {
  if (!order.empty() && settings.check_code.empty())
    throw InvalidConfig(
        "startup.check_code is empty; expected a command that makes the machine report its state, since "
        "startup.sequence has steps");
  if (has(order, Step::HomeZAgain) && !has(order, Step::HomeZ))
    throw InvalidConfig(
        "startup.sequence has home_z_again without home_z; expected home_z before it: Z cannot "
        "move before it was homed once");
  if (!has(order, Step::DrawVacuum)) return;
  vacuumZones(settings);
  if (!settings.vacuum_on_code.empty() && settings.vacuum_label.empty())
    throw InvalidConfig(
        "startup.vacuum_label is empty; expected the text before a zone's pressure, since "
        "startup.vacuum_on_code switches zones whose vacuum must be checked");
  if (!settings.vacuum_label.empty() && settings.vacuum_label.find("{zone}") == std::string::npos)
    throw InvalidConfig("startup.vacuum_label is '" + settings.vacuum_label + "'; expected {zone} in it");
}

void requireUnused(const StartupSettings& settings, const std::vector<Step>& order) {
  for (const Step step : allStartupSteps())
    if (!has(order, step) && !splitIntoWords(settings.after[static_cast<std::size_t>(step)]).empty())
      throw InvalidConfig(std::string("startup.after_") + toString(step) +
                          " is given; expected that step in startup.sequence");
}

}  // namespace

std::vector<SequencedStep> makeStartupSequence(const StartupSettings& settings) {
  requireBounds(settings);
  const std::vector<Step> order = stepsFromText("startup.sequence", settings.sequence);
  const std::vector<Step> skipped = stepsFromText("startup.skip", settings.skip);
  for (const Step step : skipped)
    if (!has(order, step))
      throw InvalidConfig(std::string("startup.skip has ") + toString(step) +
                          ", which is not in startup.sequence");
  requireUnused(settings, order);
  requireCheckable(order, settings);
  std::vector<SequencedStep> sequence;
  for (const Step step : order) {
    SequencedStep sequenced{step, {}, has(skipped, step)};
    addRules(sequenced, order);
    addHomingOrder(sequenced, order);
    addConfigured(sequenced, order, settings);
    sequence.push_back(std::move(sequenced));
  }
  return sequence;
}

}  // namespace lamina
