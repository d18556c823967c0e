"""README.md states no measured number: the tables have them. It states the sizes of the draws and the required scores."""

GIVEN = ["a sample of 100 mutants (seed 2007)", "The required score is 95 % in the modules that compute, and 90 % in the others",
         "further draws of 40 (seed 11), 20 (seed 23) and 24 (seed 29) mutants in each module", "tests of more than 20 s", "those of more than 10 s"]


def stated():
    return ()
