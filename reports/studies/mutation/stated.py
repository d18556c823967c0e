"""README.md states no measured number: the tables have them. What it has is how many mutants were drawn, and what is wanted."""

GIVEN = ["a sample of 100 mutants (seed 2007)", "Wanted are 95 % in the rooms that compute, and 90 % in the others", "further draws of 40 (seed 11), 20 (seed 23) and 24 (seed 29) in each room",
         "tests of more than 20 s", "those of more than 10 s"]


def stated():
    return ()
