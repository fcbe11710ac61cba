#!/usr/bin/env python3
"""gather_pages.py ROOT PAGES [PLAYGROUND]: copies the repository's Markdown, and the files that it links to, to PAGES.

The folders stay as they are, so that relative links stay right. PLAYGROUND is the playground's page, a folder, which
becomes PAGES/play; then links of the gallery to scenes open them there. A row of pictures and the row of captions below
it become one, so that a caption stays with its picture on a narrow screen. GitHub begins a list without an empty line before it
and nests lists by two spaces; Python's Markdown wants the line, and four spaces. In tables GitHub wants a backslash
before a bar in code; Python's Markdown shows it.
"""
import pathlib
import re
import shutil
import sys
import urllib.parse

LINK = re.compile(r"\]\(([^)\s]+)\)")
LIST_ITEM = re.compile(r"( *)(?:[-*] |\d+\. )")
FENCE = re.compile(r" *```")
CODE = re.compile(r"`[^`]*`")
SCENE = re.compile(r"\]\(\.\./host-sim/scenes/([^)#]+)\)")


def is_source(path):
    """Whether a path, relative to the repository, is not of a build, of git or of pictures that a command left."""
    return not (path.parts[0].startswith((".", "build")) or path.parts[0] == "out")


def without_code(text):
    """The lines outside of blocks of code; words between back quotes are left out."""
    inside = False
    for line in text.splitlines():
        if FENCE.match(line):
            inside = not inside
        elif not inside:
            yield CODE.sub("", line)


def linked_files(page, text):
    """The files of the repository that a page links to; a folder or a missing file is left for mkdocs to report."""
    for line in without_code(text):
        for target in LINK.findall(line):
            parts = urllib.parse.urlsplit(target)
            if not parts.scheme and parts.path:
                yield (page.parent / urllib.parse.unquote(parts.path)).resolve()


def with_captions(lines):
    """Joins rows of tables: pictures, and what stands below them."""
    joined = []
    for line in lines:
        if line.startswith("|") and "![" not in line and joined and joined[-1].startswith("| !["):
            cells = zip(joined.pop().strip("| ").split(" | "), line.strip("| ").split(" | "))
            line = "| " + " | ".join(f"{picture}<br>{caption}" for picture, caption in cells) + " |"
        joined.append(line)
    return joined


def for_python_markdown(text):
    lines = []
    inside = False
    for line in with_captions(text.splitlines()):
        if FENCE.match(line):
            inside = not inside
        item = None if inside else LIST_ITEM.match(line)
        before = lines[-1] if lines else ""
        if item and not item[1] and before and not before.startswith(" ") and not LIST_ITEM.match(before):
            lines.append("")
        if not inside and line.startswith("|"):
            line = CODE.sub(lambda code: code[0].replace(r"\|", "|"), line)
        lines.append(("  " if item and item[1] == "  " else "") + line)
    return "\n".join(lines) + "\n"


def main():
    root, pages, *playground = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
    shutil.rmtree(pages, ignore_errors=True)
    if playground:
        shutil.copytree(playground[0], pages / "play")
    for page in sorted(root.rglob("*.md")):
        place = page.relative_to(root)
        if not is_source(place):
            continue
        text = page.read_text(encoding="utf-8")
        if playground and place.as_posix() == "docs/gallery.md":
            text = SCENE.sub(r"](../play/index.html#scene=\1)", text)
        copy = pages / place
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(for_python_markdown(text), encoding="utf-8")
        for linked in linked_files(page, text):
            if linked.is_file() and linked.suffix != ".md" and linked.is_relative_to(root):
                copy = pages / linked.relative_to(root)
                copy.parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(linked, copy)


main()
