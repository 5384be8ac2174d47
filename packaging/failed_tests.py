#!/usr/bin/env python3
"""Prints the tests that did not pass in ctest's JUnit files, with the end of what each printed.

Usage: failed_tests.py FILE...   (a file is called after its stage: build/STAGE/test-results.xml)
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

LAST_LINES = 40

for name in sys.argv[1:]:
    path = pathlib.Path(name)
    for case in ElementTree.parse(path).iter("testcase"):
        if case.get("status") == "run":
            continue
        print(f"== {path.parent.name}: {case.get('name')}: {case.get('status')}")
        for line in (case.findtext("system-out") or "").splitlines()[-LAST_LINES:]:
            print(f"   {line}")
