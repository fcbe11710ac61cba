#!/usr/bin/env python3
"""check_links.py SITE: every link of the built pages leads to a file of the site, and to a place that is in it.

Nothing is loaded from elsewhere: pictures, styles and scripts are files of the site. Every page is reached from the
first. Links to other sites are not followed; none leads to a server on the reader's machine.
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

# What a browser fetches by itself; with <a href> and <area href> it asks first.
FETCHED = {"img": "src", "script": "src", "link": "href", "iframe": "src", "source": "src"}
FETCHED_BY_STYLE = re.compile(r"""(?:url\(\s*|@import\s+)["']?((?:https?:)?//[^"')\s]+)""")


class Page(html.parser.HTMLParser):
    """What is looked at of a page: its links, what it fetches, and the places that links may name."""

    def __init__(self, text):
        super().__init__()
        self.links = []
        self.fetched = []
        self.places = set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(filter(None, (attributes.get("id"), attributes.get("name") if tag == "a" else None)))
        if tag in ("a", "area") and attributes.get("href") is not None:
            self.links.append(attributes["href"])
        # Not fetched: a page's address elsewhere.
        if tag in FETCHED and attributes.get(FETCHED[tag]) and attributes.get("rel") != "canonical":
            self.fetched.append(attributes[FETCHED[tag]])


def resolve(site, page, address):
    """The file that a relative address names, and the place in it."""
    parts = urllib.parse.urlsplit(address)
    path = urllib.parse.unquote(parts.path)
    file = (site / path.lstrip("/") if path.startswith("/") else page.parent / path) if path else page
    file = file.resolve()
    return file / "index.html" if file.is_dir() else file, urllib.parse.unquote(parts.fragment)


def is_elsewhere(address):
    parts = urllib.parse.urlsplit(address)
    return bool(parts.netloc) or parts.scheme not in ("", "file")


def problems_of(site, pages):
    """Lines that say what is wrong."""
    reached = {site / "index.html"}
    to_visit = list(reached)
    while to_visit:
        page = to_visit.pop()
        name = page.relative_to(site)
        for address in pages[page].fetched:
            if is_elsewhere(address):
                if not address.startswith(("data:", "javascript:")):
                    yield f"{name}: fetches {address}"
            elif not resolve(site, page, address)[0].is_file():
                yield f"{name}: {address} is not there"
        for address in pages[page].links:
            if is_elsewhere(address):
                if urllib.parse.urlsplit(address).netloc.split(":")[0] in ("localhost", "127.0.0.1"):
                    yield f"{name}: {address} is a server of the reader"
                continue
            file, place = resolve(site, page, address)
            if not file.is_file() or not file.is_relative_to(site):
                yield f"{name}: {address} leads nowhere"
            elif file in pages:
                # The playground's page reads "#scene=..." itself.
                if place and "=" not in place and place not in pages[file].places:
                    yield f"{name}: {address}: the page has no such place"
                if file not in reached:
                    reached.add(file)
                    to_visit.append(file)
    for page in sorted(pages.keys() - reached):
        # Doxygen reaches some of its own through menus that scripts make; not found is where no link leads.
        if page.relative_to(site).parts[0] != "api" and page.name != "404.html" and page.name != "search.html":
            yield f"{page.relative_to(site)}: no page leads here"
    for style in sorted(site.rglob("*.css")):
        for address in FETCHED_BY_STYLE.findall(style.read_text(encoding="utf-8")):
            yield f"{style.relative_to(site)}: fetches {address}"


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    pages = {page: Page(page.read_text(encoding="utf-8")) for page in site.rglob("*.html")}
    problems = sorted(set(problems_of(site, pages)))
    print("\n".join(problems + [f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links"]))
    sys.exit(bool(problems))


main()
