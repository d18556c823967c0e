"""README.md states no measured number: the table has them."""

GIVEN = ["(4.1.2.2); its figures 4.7 to 4.9 compare", "with edges of 3.5 mm", "quality is 1 for an equilateral triangle and 0 for"]


def stated():
    return ()
