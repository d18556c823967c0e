"""README.md states no result: the table has them."""

GIVEN = ["allows at most 1e-12"]


def stated():
    return []
