"""list, describe, doctor, --help, --version."""
import json
import unittest

from program import Case


class Information(Case):
    def test_version_names_commit_and_build(self):
        self.assertRegex(self.run_gnomon("--version").stdout, r"^gnomon \d+\.\d+\.\d+ \(\S+, \w+\)\n$")

    def test_help_of_every_subcommand(self):
        text = self.run_gnomon("--help").stdout
        for subcommand in ["list", "describe", "render", "compare", "bench", "report", "doctor"]:
            self.assertIn(subcommand, text)
            self.assertIn("Usage: gnomon " + subcommand, self.run_gnomon(subcommand, "--help").stdout)

    def test_lists_as_text_and_json_agree(self):
        for what in ["techniques", "scenes", "presets", "suites", "metrics", "devices"]:
            with self.subTest(what=what):
                rows = json.loads(self.run_gnomon("list", what, "--json").stdout)
                text = self.run_gnomon("list", what).stdout
                self.assertGreater(len(rows), 0)
                self.assertEqual(len(text.splitlines()), len(rows))
                for row, line in zip(rows, text.splitlines()):
                    self.assertEqual(sorted(row), ["name", "summary"])
                    self.assertTrue(line.startswith(row["name"]))
                    self.assertIn(row["summary"], line)

    def test_every_technique_describes_itself(self):
        rows = json.loads(self.run_gnomon("list", "--json").stdout)
        names = [row["name"] for row in rows]
        self.assertEqual(len(names), len(set(names)))
        for row in rows:
            with self.subTest(technique=row["name"]):
                page = json.loads(self.run_gnomon("describe", row["name"], "--json").stdout)
                self.assertEqual(page["name"], row["name"])
                self.assertEqual(page["summary"], row["summary"])
                self.assertGreater(len(page["manual"]), 100)
                self.assertGreater(len(page["lights"]), 0)
                text = self.run_gnomon("describe", row["name"]).stdout
                self.assertIn(page["manual"], text)
                for id_, params in page["parameters"].items():
                    for param in params:
                        self.check_param(param)
                        self.assertIn(f"{id_}.{param['name']}", text)

    def check_param(self, param):
        self.assertGreater(len(param["help"]), 10)
        self.assertIn(param["update"], ["live", "rebuild"])
        if "choices" in param:
            self.assertIn(param["default"], param["choices"])
        elif not isinstance(param["default"], bool):
            self.assertLessEqual(param["min"], param["default"])
            self.assertLessEqual(param["default"], param["max"])

    def test_doctor(self):
        done = self.run_gnomon("doctor")
        self.assertIn("All required features are present.", done.stdout)
        for what in ["device", "driver", "timing", "reference"]:
            self.assertRegex(done.stdout, rf"(?m)^{what} +\S")


if __name__ == "__main__":
    unittest.main(verbosity=2)
