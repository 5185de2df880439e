#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The pages: every relative link, heading and picture there is, every page can be reached from
# docs/README.md and begins with for whom it is, every picture is shown somewhere, and every file that
# they name and every page that the sources name is there. Their commands write into results, if anywhere.
# Usage: run_links.sh SOURCE_FOLDER
set -euo pipefail
exec python3 - "$1" <<'PYTHON'
import os, re, sys

os.chdir(sys.argv[1])
pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] + sorted(
    os.path.join(folder, name) for folder, _, names in os.walk("docs") for name in names
    if name.endswith(".md"))
text = {page: open(page, encoding="utf-8").read() for page in pages}
faults = []


def anchors(page):
    """Headings as GitHub names them, and anchors of one's own."""
    names = set(re.findall(r'<a id="([^"]+)">', text[page]))
    for heading in re.findall(r"^#+ (.*)$", text[page], re.M):
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
        names.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return names


links = {page: set() for page in pages}
for page in pages:
    prose = re.sub(r"```.*?```", "", text[page], flags=re.S)
    prose = re.sub(r"^    .*$|`[^`\n]*`", "", prose, flags=re.M)
    for target in re.findall(r"\]\(([^)\s]+)\)", prose):
        if re.match(r"https?://", target):
            continue
        path, _, anchor = target.partition("#")
        file = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not os.path.exists(file):
            faults.append(f"{page}: there is no {target}")
        elif anchor and anchor not in anchors(file):
            faults.append(f"{page}: {file} has no heading #{anchor}")
        links[page].add(file)
    for file in re.findall(r"`((?:\.ci|generator|runtime|tools|tests|docs)/[\w./-]+)`", text[page]):
        if not os.path.exists(file) and "NAME" not in file:
            faults.append(f"{page}: there is no {file}")
    for command in re.findall(r"^    (?:(?:build/bin|tools/scripts)/|cat |sed |gnuplot ).*$", text[page], re.M):
        for place in re.findall(r"(?: --out | --plot | [0-9]?>+ *|\.gp )([\w./-]+)", command):
            if not re.match(r"(results|docs/images)\b|/dev/null", place) and not os.path.isfile(place):
                faults.append(f"{page}: its command writes {place}")

reached, ahead = set(), ["docs/README.md"]
while ahead:
    page = ahead.pop()
    if page not in reached:
        reached.add(page)
        ahead += [target for target in links[page] if target in text]
for page in pages:
    if page.startswith("docs/"):
        if page not in reached:
            faults.append(f"{page} cannot be reached from docs/README.md")
        if not re.match(r"# .*\n\nFor whom: \w", text[page]):
            faults.append(f"{page} does not begin with a title and 'For whom: ..'")
for folder in ("generator", "runtime", "tools", "tests"):
    for place, _, names in os.walk(folder):
        for file in (os.path.join(place, name) for name in names):
            for page in re.findall(rb"docs/[\w/-]+\.md", open(file, "rb").read()):
                if not os.path.exists(page):
                    faults.append(f"{file}: there is no {page.decode()}")
shown = set().union(*links.values())
for folder, _, names in os.walk("docs/images"):
    faults += [f"{folder}/{name} is shown nowhere" for name in names
               if name.endswith((".svg", ".png")) and os.path.join(folder, name) not in shown]
print("\n".join(faults) or f"{len(pages)} pages, all links resolve")
sys.exit(bool(faults))
PYTHON
