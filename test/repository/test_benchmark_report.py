#!/usr/bin/python3
"""docs/benchmarks.md shows what is in docs/benchmarks/, and has a place for every table."""

import importlib.machinery
import importlib.util
import json
import pathlib
import unittest

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


def load_script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(REPOSITORY / "scripts" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


benchmark_report = load_script("benchmark_report")


def run(name, cpu, real):
    return {"name": name, "run_type": "iteration", "cpu_time": cpu, "real_time": real}


class BenchmarkReportTest(unittest.TestCase):
    def test_numbers_have_three_significant_digits(self):
        for value, text in ((0.028751, "0.0288"), (1.0, "1"), (12.345, "12.3"), (186.4, "186"), (16468.4, "16,500"),
                            (0, "0"), (None, "")):
            self.assertEqual(benchmark_report.number(value), text)

    def test_the_fastest_repetition_comes_first_by_the_time_that_matters(self):
        raw = {"benchmarks": [
            run("lives/a/avx2/iterations:1", 2.0, 1.0), run("lives/a/avx2/iterations:1", 1.0, 9.0),
            run("experiments/b/threads:2/iterations:1/process_time/real_time", 1.0, 9.0),
            run("experiments/b/threads:2/iterations:1/process_time/real_time", 2.0, 1.0),
            {"name": "lives/a/avx2/iterations:1_mean", "run_type": "aggregate", "cpu_time": 0.5, "real_time": 0.5}]}
        found = benchmark_report.repetitions(raw)
        self.assertEqual({name: [each["cpu_time"] for each in of_one] for name, of_one in found.items()},
                         {"lives/a/avx2": [1.0, 2.0], "experiments/b/threads:2": [2.0, 1.0]})

    def test_unrest_is_how_much_longer_the_middle_repetition_of_a_whole_life_takes_than_its_fastest_slices(self):
        raw = {"benchmarks": [{**run(f"{name}/iterations:1/manual_time", 0.0, slices_ms), "whole_s": whole}
                              for name, slices_ms, wholes in (("lives/a", 1000.0, (1.2, 1.1, 9.0)),
                                                              ("lives/b", 2000.0, (2.0, 2.0, 2.0)),
                                                              ("lives/c", 4000.0, (5.0, 7.0, 6.0))) for whole in wholes]}
        raw["benchmarks"].append(run("limits/d", 1.0, 8.0))
        self.assertAlmostEqual(benchmark_report.unrest(benchmark_report.repetitions(raw)), 0.2)

    def test_processors_are_compared_at_the_rate_of_the_targets_core(self):
        lives = {f"lives/{scene}/avx512": {"s_per_evaluation": time}
                 for scene, time in (("evo_devo_paper", 0.05), ("evo_devo_released_code", 0.03))}
        # 16 operations in 0.2 ns are 80 GFLOP/s, of the 108 of the targets' core: 0.04 s x 80 / 108.
        limit = {"limits/avx512/multiply_add/independent": {"lanes": 8, "ns_per_operation": 0.2}}
        report = benchmark_report.Report({"processor": "P", "devo_evo": "0.1.0 (abc)", "benchmarks": {**lives, **limit}})
        self.assertEqual(list(report.of_processor()),
                         [["P", "abc", "avx512", "80", "0.04", "0.0296", "at most 0.036"]])

    def test_tables_are_put_in_their_places(self):
        page = "a\n<!-- table x -->\nold\n<!-- end -->\nb\n<!-- table y -->\n<!-- end -->\n"
        self.assertEqual(benchmark_report.replace_tables(page, {"x": "new", "y": "1\n2"}),
                         "a\n<!-- table x -->\nnew\n<!-- end -->\nb\n<!-- table y -->\n1\n2\n<!-- end -->\n")

    def test_a_table_without_a_place_is_an_error(self):
        with self.assertRaises(SystemExit):
            benchmark_report.replace_tables("nothing", {"x": "new"})

    def test_the_page_shows_the_results_of_one_of_the_machines(self):
        page = benchmark_report.PAGE.read_text(encoding="utf-8")
        files = sorted(benchmark_report.FOLDER.glob("*.json"))
        if not files:
            self.skipTest("nothing has been measured yet")
        reports = [benchmark_report.Report(json.loads(file.read_text(encoding="utf-8"))) for file in files]
        self.assertIn(page, [benchmark_report.replace_tables(page, report.tables()) for report in reports])


if __name__ == "__main__":
    unittest.main()
