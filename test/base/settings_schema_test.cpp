// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/settings_schema.hpp"
#include "lamina/base/settings_yaml.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

enum class Colour { Red, Green };

struct Lamp {
  double power_w = 40.0;
  int count = 2;
  bool is_on = false;
  std::string name = "desk";
  std::string shape = "round";
  Colour colour = Colour::Red;
};

void describe(SettingsSchema& schema, Lamp& lamp) {
  schema.number("lamp.power_w", lamp.power_w, Bounds::above(0.0, 100.0), "Power.");
  schema.integer("lamp.count", lamp.count, {0, 10}, "How many.");
  schema.flag("lamp.is_on", lamp.is_on, "Whether it shines.");
  schema.text("lamp.name", lamp.name, "Its name.");
  schema.choice("shade.shape", lamp.shape, std::vector<std::string>{"round", "square"}, "Form of the shade.");
  schema.choice<Colour>("shade.colour", lamp.colour, {{"red", Colour::Red}, {"green", Colour::Green}},
                        "Its colour.");
}

class Settings : public testing::Test {
 protected:
  Settings() { describe(schema_, lamp_); }

  std::string refusalOf(const std::string& key, const std::string& text) {
    try {
      schema_.set(key, text);
      return {};
    } catch (const InvalidConfig& error) {
      return error.what();
    }
  }

  Lamp lamp_;
  SettingsSchema schema_;
};

TEST_F(Settings, ReachTheFields) {
  schema_.set("lamp.power_w", "12.5");
  schema_.set("lamp.count", "7");
  schema_.set("lamp.is_on", "true");
  schema_.set("lamp.name", "a: b # c");
  schema_.set("shade.shape", "square");
  schema_.set("shade.colour", "green");
  EXPECT_EQ(lamp_.power_w, 12.5);
  EXPECT_EQ(lamp_.count, 7);
  EXPECT_TRUE(lamp_.is_on);
  EXPECT_EQ(lamp_.name, "a: b # c");
  EXPECT_EQ(lamp_.shape, "square");
  EXPECT_EQ(lamp_.colour, Colour::Green);
}

TEST_F(Settings, SuggestTheNearestKeyForAnUnknownOne) {
  const std::string refusal = refusalOf("lamp.powr_w", "3");
  EXPECT_NE(refusal.find("'lamp.powr_w'"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("'lamp.power_w'"), std::string::npos) << refusal;
}

TEST_F(Settings, QuoteNoFileOfWhichNoKeyIsKnown) {
  const test::ScratchFolder folder;
  const auto refusalOfFile = [&](const std::string& yaml) -> std::string {
    writeFile(folder.file("a.yaml"), yaml);
    try {
      applySettings(schema_, folder.file("a.yaml"), {});
    } catch (const InvalidConfig& error) {
      return error.what();
    }
    return "";
  };
  const std::string foreign = refusalOfFile("lamp: {powr_w: 3}\nwifi: {key: 4}\n");
  EXPECT_EQ(foreign.find("powr_w"), std::string::npos) << foreign;
  EXPECT_NE(foreign.find("did you mean 'lamp.power_w'"), std::string::npos) << foreign;
  EXPECT_NE(refusalOfFile("lamp: {count: 3, powr_w: 3}\n").find("'lamp.powr_w'"), std::string::npos);
  EXPECT_EQ(refusalOfFile(""), "");
}

TEST_F(Settings, KeepToTheirBounds) {
  EXPECT_EQ(refusalOf("lamp.power_w", "100"), "");
  EXPECT_EQ(refusalOf("lamp.count", "0"), "");
  for (const char* bad : {"0", "-1", "100.001", "nan", "inf", "1e999"})
    EXPECT_NE(refusalOf("lamp.power_w", bad), "");
  const std::string refusal = refusalOf("lamp.power_w", "0");
  for (const char* part : {"lamp.power_w", "'0'", "(0, 100]"})
    EXPECT_NE(refusal.find(part), std::string::npos) << refusal;
  EXPECT_EQ(lamp_.power_w, 100.0);
}

TEST_F(Settings, RefuseWhatIsOfAnotherType) {
  for (const char* bad : {"", " 3", "3 ", "3mm", "0x10", "three", "1,5"})
    EXPECT_NE(refusalOf("lamp.power_w", bad), "");
  for (const char* bad : {"1.5", "", "99999999999"}) EXPECT_NE(refusalOf("lamp.count", bad), "");
  for (const char* bad : {"1", "True", "yes", ""}) EXPECT_NE(refusalOf("lamp.is_on", bad), "");
  EXPECT_NE(refusalOf("shade.colour", "blue").find("red | green"), std::string::npos);
  EXPECT_NE(refusalOf("shade.shape", "Round"), "");
}

TEST_F(Settings, AreCheckedHoweverTheFieldsWereFilled) {
  EXPECT_NO_THROW(schema_.validate());
  lamp_.power_w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(schema_.validate(), InvalidConfig);
  lamp_ = {};
  lamp_.shape = "oval";
  EXPECT_THROW(schema_.validate(), InvalidConfig);
  lamp_ = {};
  lamp_.colour = static_cast<Colour>(7);
  EXPECT_THROW(schema_.validate(), InvalidConfig);
}

TEST_F(Settings, ComeBackFromTheirYaml) {
  lamp_ = {0.1 + 0.2, 9, true, "quotes \" and\nlines: yes", "square", Colour::Green};
  const std::string yaml = settingsToYaml(schema_);
  Lamp copy;
  SettingsSchema schema_of_copy;
  describe(schema_of_copy, copy);
  for (const SettingText& setting : settingsFromYaml(yaml, "own"))
    schema_of_copy.set(setting.key, setting.text);
  EXPECT_EQ(copy.power_w, lamp_.power_w);
  EXPECT_EQ(copy.count, 9);
  EXPECT_TRUE(copy.is_on);
  EXPECT_EQ(copy.name, lamp_.name);
  EXPECT_EQ(copy.shape, "square");
  EXPECT_EQ(copy.colour, Colour::Green);
  EXPECT_EQ(settingsToYaml(schema_of_copy), yaml);
}

/// YAML 1.1, which rosparam reads, takes 1e-06 for text.
TEST_F(Settings, ReportSmallNumbersWithADotBeforeTheExponent) {
  lamp_.power_w = 1e-6;
  EXPECT_NE(settingsToYaml(schema_).find("power_w: 1.0e-06\n"), std::string::npos) << settingsToYaml(schema_);
  lamp_.power_w = 2.5e-7;
  EXPECT_NE(settingsToYaml(schema_).find("power_w: 2.5e-07\n"), std::string::npos) << settingsToYaml(schema_);
}

TEST(SettingsFromYaml, FlattensMapsIntoDottedKeysInOrder) {
  const auto settings = settingsFromYaml("b:\n  y: 1\n  x: {z: two}\na.c: 3.50\n", "file");
  ASSERT_EQ(settings.size(), 3U);
  EXPECT_EQ(settings[0].key, "b.y");
  EXPECT_EQ(settings[1].key, "b.x.z");
  EXPECT_EQ(settings[1].text, "two");
  EXPECT_EQ(settings[2].key, "a.c");
  EXPECT_EQ(settings[2].text, "3.50");
}

TEST(SettingsFromYaml, TakesListsOfValuesForOneTextAndNumbersOtherEntries) {
  const auto settings = settingsFromYaml("a: [1, 2.5]\nb: [{c: x}, {c: y, d: [0, 1]}]\ne: []\n", "file");
  std::vector<std::string> read;
  for (const SettingText& setting : settings) read.push_back(setting.key + "=" + setting.text);
  EXPECT_EQ(read, (std::vector<std::string>{"a=1,2.5", "b.0.c=x", "b.1.c=y", "b.1.d=0,1", "e="}));
}

class SettingTables : public testing::Test {
 protected:
  SettingTables() {
    schema_.table("hooks.at", table_, "Code by layer.");
    schema_.list("hooks.layers", list_, {0.0, 10.0}, "Layers.");
  }

  SettingTable table_;
  std::vector<double> list_;
  SettingsSchema schema_;
};

TEST_F(SettingTables, TakeEntriesByTheirNames) {
  for (const SettingText& setting :
       settingsFromYaml("hooks:\n  at: {12: M117 nuts, 20.5: \"a\\nb\"}\n", "file"))
    schema_.set(setting.key, setting.text);
  EXPECT_EQ(table_, (SettingTable{{"12", "M117 nuts"}, {"20.5", "a\nb"}}));
}

TEST_F(SettingTables, TakeAMapOrAListInOneLine) {
  schema_.set("hooks.at", "{12: M117 nuts, 3: \"x: y\"}");
  EXPECT_EQ(table_, (SettingTable{{"12", "M117 nuts"}, {"3", "x: y"}}));
  schema_.set("hooks.at", "[{name: a}, {name: b, at: [1, 2]}]");
  EXPECT_EQ(table_, (SettingTable{{"0.name", "a"}, {"1.name", "b"}, {"1.at", "1,2"}}));
  schema_.set("hooks.at", "");
  EXPECT_TRUE(table_.empty());
}

TEST_F(SettingTables, ReadBackFromTheirText) {
  const SettingTable table = {{"12", "M117 \"nuts\"\\\nG4 P5"}, {"0.name", "{layer}"}, {"7", ""}};
  table_ = table;
  schema_.validate();
  EXPECT_EQ(table_, table);
  for (const SettingText& setting : settingsFromYaml(settingsToYaml(schema_), "own"))
    schema_.set(setting.key, setting.text);
  EXPECT_EQ(table_, table);
}

TEST_F(SettingTables, KeepNumbersOfListsWithinBounds) {
  schema_.set("hooks.layers", "1,2.5,10");
  EXPECT_EQ(list_, (std::vector<double>{1.0, 2.5, 10.0}));
  schema_.set("hooks.layers", "");
  EXPECT_TRUE(list_.empty());
  EXPECT_THROW(schema_.set("hooks.layers", "1,11"), InvalidConfig);
  EXPECT_THROW(schema_.set("hooks.layers", "1,"), InvalidConfig);
  EXPECT_THROW(schema_.set("hooks.layers", "one"), InvalidConfig);
}

TEST(SettingsFromYaml, OfAnEmptyDocumentIsEmpty) {
  EXPECT_TRUE(settingsFromYaml("", "file").empty());
  EXPECT_TRUE(settingsFromYaml("# nothing\n", "file").empty());
}

TEST(SettingsFromYaml, ReadsBackWhatWasWrittenOfSettings) {
  const std::vector<SettingText> settings = {{"b.y", "1"},       {"a", "null"},     {"b.x.z", "two: 3"},
                                             {"c.d", ""},        {"b.y", "1e-06"},  {"c", "0,1"},
                                             {"e.f", "#quoted"}, {"e.g", "a\nb\""}, {"e.h", "~"}};
  const std::string yaml = settingsToYaml(settings);
  std::vector<std::string> read;
  for (const SettingText& setting : settingsFromYaml(yaml, "own"))
    read.push_back(setting.key + "=" + setting.text);
  const std::vector<std::string> expected = {
      "b.y=1e-06", "b.x.z=two: 3", "a=null", "c.d=", "c=0,1", "e.f=#quoted", "e.g=a\nb\"", "e.h=~"};
  EXPECT_EQ(read, expected) << yaml;
  EXPECT_TRUE(settingsFromYaml(settingsToYaml(std::vector<SettingText>{}), "own").empty());
}

TEST(SettingsFromYaml, RefusesWhatIsNoMapOfValuesNamingTheLine) {
  for (const char* bad : {"- 1\n- 2\n", "just text", "a: [1, {b: 2}]", "a:\n", "a: {b: 1\n", "a: 1\na: 2\n",
                          "a:\n  b: 1\na.b: 2\n", "a: &again {b: *again}"}) {
    try {
      settingsFromYaml(bad, "some.yaml");
      ADD_FAILURE() << "accepted: " << bad;
    } catch (const InvalidConfig& error) {
      EXPECT_EQ(std::string(error.what()).find("some.yaml:"), 0U) << error.what();
    }
  }
}

TEST(SettingsFromYaml, QuotesNothingOfWhatIsNoYaml) {
  for (const std::string bad :
       {"a: \"\\secret\"\n", "{\"secret\" b: 1", "a: 1\n- secret: \x80\n", "!<tag:secret a: 1"}) {
    try {
      settingsFromYaml(bad, "some.yaml");
      ADD_FAILURE() << "accepted: " << bad;
    } catch (const InvalidConfig& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find("secret"), std::string::npos) << what;
      EXPECT_EQ(what.find("some.yaml:"), 0U) << what;
      EXPECT_LT(what.size(), 120U) << what;
    }
  }
}

TEST(SettingFromAssignment, SplitsAtTheFirstEquals) {
  EXPECT_EQ(settingFromAssignment("a.b=c=d").key, "a.b");
  EXPECT_EQ(settingFromAssignment("a.b=c=d").text, "c=d");
  EXPECT_EQ(settingFromAssignment("a=").text, "");
  EXPECT_THROW(settingFromAssignment("a.b"), InvalidConfig);
  EXPECT_THROW(settingFromAssignment("=3"), InvalidConfig);
}

TEST(SettingsSchema, TakesAFormerNameOfAKeyAndOfAChoice) {
  enum class Way { Near, Far };
  double width = 0.0;
  Way way = Way::Near;
  SettingsSchema schema;
  schema.number("bead.width_mm", width, {0.0, 10.0}, "Width.");
  schema.choice<Way>("bead.way", way, {{"near", Way::Near}, {"far", Way::Far}}, "Way.");
  schema.renamed("bead.breadth_mm", "bead.width_mm");
  schema.renamedChoice("bead.way", "distant", "far");
  schema.set("bead.breadth_mm", "2.5");
  schema.set("bead.way", "distant");
  EXPECT_DOUBLE_EQ(width, 2.5);
  EXPECT_EQ(way, Way::Far);
  EXPECT_EQ(schema.settings().size(), 2U);
  EXPECT_THROW(schema.set("bead.breadth_mm", "11"), InvalidConfig);
}

}  // namespace
}  // namespace lamina
