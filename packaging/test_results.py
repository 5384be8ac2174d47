#!/usr/bin/env python3
"""Counts the tests of CTest runs, and prints those that failed with the end of their output.

CTest writes one JUnit file a run. An entry that is a program of GoogleTests stands in it as one; its tests are in the file
that the program itself wrote. A test that was skipped has not passed.

Usage: test_results.py BUILD_FOLDER...   the last line is "PASSED FAILED"
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

LAST_LINES = 60


def report(stage, name, text):
    print(f"== {stage}: {name}")
    for line in text.splitlines()[-LAST_LINES:]:
        print(f"   {line}")


passed = failed = 0
for folder in map(pathlib.Path, sys.argv[1:]):
    for entry in ElementTree.parse(folder / "test-results.xml").iter("testcase"):
        output = entry.findtext("system-out") or ""
        tests = folder / "test-results" / f"{entry.get('name')}.xml"
        own_failures = 0
        if tests.exists():
            for test in ElementTree.parse(tests).iter("testcase"):
                name = f"{test.get('classname')}.{test.get('name')}"
                reason = test.find("failure") if test.find("failure") is not None else test.find("skipped")
                if test.get("status") == "notrun":
                    continue  # of another shard, or filtered out
                if reason is None:
                    passed += 1
                else:
                    own_failures += 1
                    report(folder.name, name, reason.get("message") or "")
            failed += own_failures
        if entry.get("status") == "run":
            passed += not tests.exists()
        elif own_failures == 0:  # it crashed, took too long, or is no program of GoogleTests
            failed += 1
            report(folder.name, f"{entry.get('name')}: {entry.get('status')}", output)
print(passed, failed)
