# SPDX-License-Identifier: GPL-2.0-or-later
"""How far a study is and how long it will take: one line on a terminal, which is
written anew, and a line for every case that ends. Python's own library only."""
import os
import statistics
import sys
import threading
import time

from report_parts.parameters import read_parameters
from report_parts.safe import finite

from . import table

EVERY = 2.  # s between two looks
# share of a run's load from which on its own pace tells more than that of others
TELLING = 0.1


def share_done(directory):
    """Of the load of a run, from 0 to 1: its time over its end time; None when it is
    not known yet. Runs that end when the body is separated end sooner."""
    rows = table.statistics_of(directory)
    end = finite(read_parameters(os.path.join(directory, "parameters.prm")).get(
        "Load stepping/End time"))
    if not rows or not end or rows[-1].get("time_s") is None:
        return None
    return min(max(rows[-1]["time_s"] / end, 0.), 1.)


def left_of_one(elapsed, share, typical):
    """Seconds that a run has before it, from its pace, or from how long others took;
    None when nothing tells it."""
    if share is not None and share >= TELLING:
        own = elapsed * (1. - share) / share
        # others tell that runs end before their load does
        return own if typical is None else min(own, max(typical - elapsed, 0.1 * own))
    return None if typical is None else max(typical - elapsed, 0.)


def time_left(taken, running, n_waiting, at_once):
    """Seconds until a study is done, or None. taken: seconds of each run that has
    ended; running: [(seconds so far, share done or None)]; at_once: runs at a time."""
    typical = statistics.mean(taken) if taken else None
    left = [left_of_one(elapsed, share, typical) for elapsed, share in running]
    if None in left:
        return None
    if n_waiting and typical is None:
        if not running:
            return None
        typical = statistics.mean(elapsed + rest
                                  for (elapsed, _), rest in zip(running, left))
    total = sum(left) + n_waiting * (typical or 0.)
    # not sooner than the longest of those that run
    return max([total / max(at_once, 1)] + left)


def in_words(seconds):
    """'40 s', '12 min', '3 h 20 min'"""
    if seconds < 90.:
        return "%d s" % max(round(seconds), 1)
    minutes = round(seconds / 60.)
    return "%d min" % minutes if minutes < 90 else "%d h %d min" % divmod(minutes, 60)


class Progress:
    """Of the runs of a Runner. begin(case) and done(case, ...) are told by it; with a
    terminal, a line below tells what is going on."""

    def __init__(self, n_all, at_once, stream=None):
        self.n_all, self.at_once, self.n_done = n_all, at_once, 0
        self.stream = stream or sys.stdout
        self.taken, self.running = [], {}  # {case: when it was begun}
        self.lock, self.over = threading.RLock(), threading.Event()
        self.thread = None
        if self.stream.isatty():
            self.thread = threading.Thread(target=self.watch, daemon=True)
            self.thread.start()

    def begin(self, case):
        with self.lock:
            self.running[case] = time.monotonic()

    def done(self, case, status, reason, seconds):
        with self.lock:
            self.n_done += 1
            self.running.pop(case, None)
            if status == 0:
                self.taken.append(seconds)
            left = self.left() if self.n_done < self.n_all else None
            self.clear()
            print("[%d/%d] %s: exit status %d after %.0f s%s%s"
                  % (self.n_done, self.n_all, case.name, status, seconds,
                     "; " + reason if reason else "",
                     "" if left is None else "; about %s left" % in_words(left)),
                  file=self.stream, flush=True)

    def left(self):
        now = time.monotonic()
        running = [(now - since, share_done(case.directory))
                   for case, since in self.running.items()]
        return time_left(self.taken, running,
                         self.n_all - self.n_done - len(running), self.at_once)

    def line(self):
        with self.lock:
            parts = []
            for case in self.running:
                share = share_done(case.directory)
                parts.append(case.name + ("" if share is None
                                          else " %.0f %%" % (100. * share)))
            left = self.left()
            return "%d of %d done; %s; %s" % (
                self.n_done, self.n_all, ", ".join(parts) or "nothing runs",
                "time left not known yet" if left is None
                else "about %s left" % in_words(left))

    def watch(self):
        while not self.over.wait(EVERY):
            with self.lock:
                width = os.get_terminal_size(self.stream.fileno()).columns
                self.stream.write("\r\x1b[K" + self.line()[:max(width - 1, 20)])
                self.stream.flush()

    def clear(self):
        if self.thread:
            self.stream.write("\r\x1b[K")

    def end(self):
        self.over.set()
        if self.thread:
            self.thread.join()
            self.clear()
            self.stream.flush()
