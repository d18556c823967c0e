"""Does what is stale, one after another or on all processors, and gathers the complaints."""

import multiprocessing
import os

from fingerprint import Stale

waiting = []  # actions of the pool at work: its processes are forks, and read them here


def complaint(action, subject):
    """The problem that the action reports for its subject, or None."""
    try:
        action(subject)
    except Stale as stale:
        return str(stale)
    return None


def gather(actions):
    """Calls each action on its subject; returns the complaints."""
    return [c for action, subject in actions if (c := complaint(action, subject)) is not None]


def complaint_of(index):
    return complaint(*waiting[index])


def gather_at_once(actions, processes=None):
    """The same in as many processes as there are processors: the first actions begin first, complaints keep their order.
    An action must leave its results in files, because its process ends."""
    waiting[:] = actions
    processes = min(processes or os.cpu_count() or 1, len(waiting))
    if processes <= 1:
        return gather(actions)
    with multiprocessing.get_context("fork").Pool(processes) as pool:
        found = pool.map(complaint_of, range(len(waiting)), chunksize=1)
    waiting.clear()
    return [c for c in found if c is not None]
