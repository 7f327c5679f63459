#!/usr/bin/env python3
"""Makes the pictures of inspect's page, with Debian's chromium, chromium-driver and python3-selenium.

    /usr/bin/python3 docs/images/inspect_pages.py [PROGRAM]

PROGRAM: build/release/caustics unless given."""
import pathlib
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

HERE = pathlib.Path(__file__).resolve().parent
SHOTS = {'inspect': 'pick=pixel:300,118', 'inspect_path': 'panel=path'}  # name: the page's address behind #


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else HERE.parents[1] / 'build/release/caustics'
    options = webdriver.ChromeOptions()
    for argument in ('--headless=new', '--no-sandbox', '--window-size=1200,800', '--hide-scrollbars'):
        options.add_argument(argument)
    browser = webdriver.Chrome(options=options, service=Service('/usr/bin/chromedriver'))
    with tempfile.TemporaryDirectory() as folder:
        page = pathlib.Path(folder) / 'page.html'
        scene = HERE.parents[1] / 'scenes/glass_sphere.glb'
        subprocess.run([program, 'inspect', scene, '-o', page, '--quiet'], check=True)
        for name, address in SHOTS.items():
            browser.get('about:blank')
            browser.get(f'{page.as_uri()}#{address}')
            time.sleep(3)  # arrays are unpacked when they are first shown
            browser.save_screenshot(str(HERE / f'{name}.png'))
    browser.quit()


if __name__ == '__main__':
    main()
