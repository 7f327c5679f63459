#!/usr/bin/env python3
"""The pages: links lead somewhere, headings included; docs/README.md lists all of docs/; a page that a source
names exists; each picture is shown; and all pages together are no longer than a person reads."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOST_WORDS = 30000
SOURCES = {'.cpp', '.hpp', '.glsl', '.py', '.cmake', '.sh', ''}


def files():
    """Of the repository, or of an archive of it."""
    run = subprocess.run(['git', '-C', ROOT, 'ls-files', '-co', '--exclude-standard'], capture_output=True,
                         text=True)
    if run.returncode == 0:
        return [ROOT / name for name in run.stdout.splitlines() if (ROOT / name).is_file()]
    return [path for path in ROOT.rglob('*') if path.is_file() and 'build' not in path.parts]


def anchors(page):
    """As GitHub makes them of the headings."""
    text = re.sub(r'^```.*?^```', '', page.read_text(), flags=re.M | re.S)
    headings = re.findall(r'^#+ (.*)$', text, re.M)
    plain = (re.sub(r'\[(.*?)\]\(.*?\)', r'\1', heading).lower() for heading in headings)
    return {re.sub(r'[^\w\- ]', '', heading).replace(' ', '-') for heading in plain}


def links(page):
    text = re.sub(r'`[^`\n]*`|^    .*$', '', page.read_text(), flags=re.M)
    return [link for link in re.findall(r'\]\(([^)\s]+)\)', text) if '://' not in link]


def broken(page):
    for link in links(page):
        name, _, anchor = link.partition('#')
        target = (page.parent / name).resolve() if name else page
        if not target.exists():
            yield f'{page.relative_to(ROOT)}: {link} is not there'
        elif anchor and anchor not in anchors(target):
            yield f'{page.relative_to(ROOT)}: {link} is no heading'


def named_and_missing(path):
    if path.suffix in SOURCES:
        text = path.read_text(errors='replace')
        for name in re.findall(r'\b(?:docs|passes|scenes|tests|pipeline)/[\w/]+\.md\b', text):
            if not (ROOT / name).exists():
                yield f'{path.relative_to(ROOT)} names {name}, which is not there'


def main():
    all_files = files()
    pages = [path for path in all_files if path.suffix == '.md']
    wrong = [each for page in pages for each in broken(page)]
    wrong += [each for path in all_files for each in named_and_missing(path)]
    listed = links(ROOT / 'docs/README.md')
    shown = {(page.parent / link).resolve() for page in pages for link in links(page)}
    for path in all_files:
        if path.parent == ROOT / 'docs' and path.name not in listed + ['README.md']:
            wrong.append(f'docs/README.md does not list {path.name}')
        if path.suffix == '.png' and path.parts[len(ROOT.parts)] in ('docs', 'passes') and path not in shown:
            wrong.append(f'no page shows {path.relative_to(ROOT)}')
    words = sum(len(page.read_text().split()) for page in pages)
    if words > MOST_WORDS:
        wrong.append(f'the pages have {words} words; {MOST_WORDS} are allowed: tell a thing once')
    print('\n'.join(wrong) or f'{len(pages)} pages, {words} words')
    return 1 if wrong or len(pages) < 20 else 0


sys.exit(main())
