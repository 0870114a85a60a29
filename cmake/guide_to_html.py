"""Makes the pages of ParaView's help from the user guide: guide_to_html.py GUIDE OUTPUT

GUIDE is the folder of the Markdown files and their pictures. Links to pages of the guide lead to their HTML; links out of the
guide become their text, since the help has nothing else.
"""
import re
import shutil
import sys
from pathlib import Path

import markdown

PAGE = """<!DOCTYPE html>
<html><head><meta charset="utf-8"><title>{title}</title></head>
<body>
{body}
</body></html>
"""
LINK = re.compile(r'<a href="(?P<target>[^"]*)">(?P<text>.*?)</a>', re.DOTALL)


def page_name(source):
    """The help opens with the page that is named index."""
    return "index.html" if source.stem == "README" else source.stem + ".html"


def relinked(match, pages):
    target, _, anchor = match["target"].partition("#")
    if "://" in target:
        return match[0]
    if target and target not in pages:
        return match["text"]
    return f'<a href="{pages.get(target, "")}{"#" + anchor if anchor else ""}">{match["text"]}</a>'


def main():
    guide, output = map(Path, sys.argv[1:])
    output.mkdir(parents=True, exist_ok=True)
    sources = sorted(guide.glob("*.md"))
    pages = {source.name: page_name(source) for source in sources}
    for source in sources:
        text = source.read_text(encoding="utf-8")
        body = markdown.markdown(text, extensions=["tables", "fenced_code", "toc"])
        title = re.search(r"^# (.*)", text, re.MULTILINE)[1]
        body = LINK.sub(lambda match: relinked(match, pages), body)
        (output / pages[source.name]).write_text(PAGE.format(title="Guide: " + title, body=body), encoding="utf-8")
    for picture in guide.glob("*.png"):
        shutil.copyfile(picture, output / picture.name)


main()
