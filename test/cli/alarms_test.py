#!/usr/bin/env python3
"""The alarms of a cell as a list: `lamina alarms`."""
import csv
import json
import unittest

from lamina_command import lamina


class Alarms(unittest.TestCase):
    def test_a_plc_imports_each_with_its_text(self):
        rows = list(csv.DictReader(lamina("alarms", "--csv").stdout.splitlines()))
        self.assertEqual(list(rows[0]), ["id", "category", "title", "remedy"])
        heater = next(row for row in rows if row["id"] == "3104")
        self.assertEqual((heater["category"], heater["title"]), ("A", "heater fault"))
        self.assertTrue(all(row["remedy"] for row in rows))

    def test_all_are_listed_in_each_form(self):
        ids = [row["id"] for row in csv.DictReader(lamina("alarms", "--csv").stdout.splitlines())]
        listed = json.loads(lamina("alarms", "--json").stdout)["alarms"]
        self.assertEqual([str(alarm["id"]) for alarm in listed], ids)
        self.assertEqual([line.split()[0] for line in lamina("alarms").stdout.splitlines()], ids)
        self.assertTrue(next(alarm for alarm in listed if alarm["id"] == 2101)["lasts"], "a silent PLC")
        self.assertFalse(next(alarm for alarm in listed if alarm["id"] == 3104)["lasts"])

    def test_one_form_at_a_time(self):
        self.assertNotEqual(lamina("alarms", "--csv", "--json").returncode, 0)


if __name__ == "__main__":
    unittest.main()
