#!/usr/bin/env python3
"""Tokens of the operator's page: `lamina token`."""
import os
import re
import tempfile
import unittest

from lamina_command import lamina


class Tokens(unittest.TestCase):
    def test_a_token_is_made_listed_and_removed(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = os.path.join(scratch, "cell")
            made = lamina("token", "add", "--role", "operator", "--name", "anna", "--days", "30", folder)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertRegex(made.stdout, r"^[0-9a-f]{64}\n$")
            self.assertEqual(os.stat(os.path.join(folder, "page.db")).st_mode & 0o777, 0o600)
            listed = lamina("token", "list", folder).stdout
            self.assertTrue(re.fullmatch(r"anna: operator, expires \d{4}-\d\d-\d\d, last used never\n", listed), listed)
            self.assertEqual(lamina("token", "remove", "--name", "anna", folder).returncode, 0)
            self.assertEqual(lamina("token", "list", folder).stdout, "")

    def test_what_cannot_be_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            missing = lamina("token", "list", folder)
            self.assertIn("page.db: is not there", missing.stderr)
            king = lamina("token", "add", "--role", "king", "--name", "anna", folder)
            self.assertNotEqual(king.returncode, 0)
            self.assertIn("expected viewer, sender, operator or maintenance", king.stderr)
            self.assertEqual(lamina("token", "add", "--role", "viewer", "--name", "anna", folder).returncode, 0)
            self.assertIn("there is a token named 'anna'", lamina("token", "add", "--role", "viewer", "--name", "anna", folder).stderr)
            self.assertIn("no token named 'otto'", lamina("token", "remove", "--name", "otto", folder).stderr)


if __name__ == "__main__":
    unittest.main()
