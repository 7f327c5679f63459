#!/usr/bin/env python3
"""reach_of.py TEST.py LOG: runs the methods of a file of tests against a planted program, and writes a line
for each: its name, the seconds it took, 1 where it passed, and the places that it reached, as reach.cpp
does for Catch2's."""
import importlib.util
import os
import pathlib
import sys
import tempfile
import time
import unittest

PLACES = 1 << 16  # kFaultPlaces of fault.hpp
SCRIPT = 'return typeof caustics_reached === "undefined" ? [] : [...caustics_reached]'


class Marks:
    """What the programs and pages have marked since the last `take`."""

    def __init__(self):
        self.file = tempfile.NamedTemporaryFile()
        self.file.write(bytes(PLACES))
        self.file.flush()
        self.of_pages = set()
        os.environ['CAUSTICS_REACHED'] = self.file.name

    def read_page(self, browser):
        try:
            self.of_pages.update(number % PLACES for number in browser.execute_script(SCRIPT))
        except Exception:  # no page yet, or one that is not ours
            pass

    def watch_pages(self):
        """A page that is left takes its marks with it."""
        try:
            from selenium.webdriver.remote.webdriver import WebDriver
        except ImportError:
            return
        get, marks = WebDriver.get, self

        def read_and_get(self, address):
            marks.read_page(self)
            get(self, address)

        WebDriver.get = read_and_get

    def take(self):
        self.file.seek(0)
        places = {i for i, mark in enumerate(self.file.read()) if mark} | self.of_pages
        self.file.seek(0)
        self.file.write(bytes(PLACES))
        self.file.flush()
        self.of_pages = set()
        return places


class Result(unittest.TestResult):
    def __init__(self, marks, log):
        super().__init__()
        self.marks, self.log, self.of_class, self.last_class = marks, log, set(), None

    def startTest(self, test):
        super().startTest(test)
        before = self.marks.take()  # of setUpClass, where one ran
        if type(test) is not self.last_class:
            self.of_class, self.last_class = before, type(test)
        self.begun, self.bad = time.monotonic(), len(self.failures) + len(self.errors) + len(self.skipped)

    def stopTest(self, test):
        if hasattr(test, 'browser'):
            self.marks.read_page(test.browser)
        taken = time.monotonic() - self.begun
        passed = self.bad == len(self.failures) + len(self.errors) + len(self.skipped)
        places = ' '.join(map(str, sorted(self.marks.take() | self.of_class)))
        name = test.id().split('.', 1)[1]
        print(f'{name}\t{taken:.4f}\t{int(passed)}\t{places}', file=self.log, flush=True)
        super().stopTest(test)


def main():
    path = pathlib.Path(sys.argv[1]).resolve()
    sys.path.insert(0, str(path.parent))
    marks = Marks()
    marks.watch_pages()
    specification = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(specification)
    sys.modules[path.stem] = module
    specification.loader.exec_module(module)
    with open(sys.argv[2], 'w', encoding='utf-8') as log:
        result = Result(marks, log)
        unittest.defaultTestLoader.loadTestsFromModule(module).run(result)
    for test, trace in result.failures + result.errors:
        print(f'{test.id()}\n{trace}')


if __name__ == '__main__':
    main()
