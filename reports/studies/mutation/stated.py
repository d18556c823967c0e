"""README.md states no measured number: the tables have them. What it has is how many mutants were drawn, and what is wanted."""

GIVEN = ["a sample of 100 mutants (seed 2007)", "Wanted are 95 % in the rooms that compute, and 90 % in the others", "another draw of 40 in each room (seed 11)",
         "tests of more than 20 s"]


def stated():
    return ()
