"""No two types of one name in one namespace: outside anonymous namespaces of src, a struct, class or enum is defined once."""

import collections
import re

import sources

OPENING = re.compile(
    r"\bnamespace(?P<namespace>(?:\s+[\w:]+)?)\s*\{"
    r"|\b(?:struct|class|union|enum(?:\s+(?:class|struct))?)\s+(?P<type>\w+)(?:\s+final)?(?:\s*:(?!:)[^;{}()]*)?\s*\{"
    r"|(?P<open>\{)|(?P<close>\})")


def definitions(text):
    """(line, qualified name) of every type that the text defines at namespace scope, none of them anonymous."""
    code = sources.without_comments(text)
    scopes, found = [], []  # a scope is a namespace's name, or None: a body or an anonymous namespace
    for match in OPENING.finditer(code):
        if match["close"]:
            if scopes:
                scopes.pop()
            continue
        if match["type"] and None not in scopes:
            found.append((code.count("\n", 0, match.start("type")) + 1, "::".join([*scopes, match["type"]])))
        name = (match["namespace"] or "").strip()
        scopes.append(name or None)
    return found


def check_texts(texts):
    """`texts`: path and content of every file."""
    places = collections.defaultdict(list)
    for path, text in texts:
        for line, name in definitions(text):
            places[name].append(f"{path}:{line}")
    return [f"{where[0]}: {name} is defined here and at {', '.join(where[1:])}: one of them needs another name"
            for name, where in sorted(places.items()) if len(where) > 1]


def check_all():
    texts = [(f, sources.read(f)) for f in sources.tracked("src")]
    if sum(len(definitions(text)) for _, text in texts) < 100:
        return ["src: found hardly any type: the rule no longer reads the sources"]
    return check_texts(texts)


def self_test():
    first = "namespace tdbd::bit {\nstruct Reach {\n  enum class Side { left };\n};\n}\n"
    for second in ("namespace tdbd::bit {\nclass Reach final : Base<int> {};\n}\n",
                   "namespace tdbd {\nnamespace bit {\nenum class Reach : int { a };\n}\n}\n",
                   "namespace tdbd::bit {\nint f() { if (a) { b(); } return 1; }\nstruct Reach {};\n}\n"):
        problems = check_texts([("src/a.hpp", first), ("src/b.hpp", second)])
        assert len(problems) == 1 and "src/a.hpp:2: tdbd::bit::Reach" in problems[0], (second, problems)
    for second in ("namespace tdbd::rock {\nstruct Reach {};\n}\n",  # another namespace
                   "namespace tdbd::bit {\nnamespace {\nstruct Reach {};\n}\n}\n",  # of one file alone
                   "namespace tdbd::bit {\nstruct Reach;\nvoid f() {\n  struct Reach {};\n}\n}\n",  # declared; local
                   "namespace tdbd::bit {\nstruct Other {\n  struct Reach {};\n};\n}\n",  # a member
                   "namespace tdbd::bit {\nstruct Reach::Side {};\n}\n",  # a member, defined outside
                   "namespace tdbd::bit {\n// struct Reach {};\nconst char* a = \"struct Reach {\";\n}\n"):
        assert not check_texts([("src/a.hpp", first), ("src/b.hpp", second)]), second


if __name__ == "__main__":
    sources.main(check_all, self_test)
