"""Calls actions on their subjects, in turn or on all processors, and collects the problems."""

import multiprocessing
import os

from fingerprint import Stale

waiting = []  # actions of the running pool; its processes are forks and read them here


def problem(action, subject):
    """Calls an action. Returns the problem that it raises as Stale, or None."""
    try:
        action(subject)
    except Stale as stale:
        return str(stale)
    return None


def gather(actions):
    """Calls each action on its subject. Returns the problems."""
    return [c for action, subject in actions if (c := problem(action, subject)) is not None]


def problem_of(index):
    return problem(*waiting[index])


def gather_at_once(actions, processes=None):
    """The same in one process per processor. Actions start in order, and problems are returned in that order. An action must write its
    results to files, because its process ends."""
    waiting[:] = actions
    processes = min(processes or os.cpu_count() or 1, len(waiting))
    if processes <= 1:
        return gather(actions)
    with multiprocessing.get_context("fork").Pool(processes) as pool:
        found = pool.map(problem_of, range(len(waiting)), chunksize=1)
    waiting.clear()
    return [c for c in found if c is not None]
