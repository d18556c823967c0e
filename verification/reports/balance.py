"""Whether a page's HTML is well nested."""

import html.parser

EMPTY = ("meta", "link", "input", "img", "br", "hr", "wbr")


class Balance(html.parser.HTMLParser):
    """Asserts that every tag that opens closes, in order."""

    def __init__(self):
        super().__init__()
        self.open_tags = []

    def handle_starttag(self, tag, attrs):
        if tag not in EMPTY:
            self.open_tags.append(tag)

    def handle_endtag(self, tag):
        assert self.open_tags.pop() == tag, f"{tag} at {self.getpos()}"


def check(page):
    balance = Balance()
    balance.feed(page)
    assert not balance.open_tags, balance.open_tags
