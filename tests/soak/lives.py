# SPDX-License-Identifier: GPL-2.0-or-later
"""A run that is disturbed and resumed until it ends, and what must hold."""
import re

from compare import Difference, compare, strict_json
from disturbances import Offence, disturb
from processes import MESSAGE

STOPPED = 5  # exit status
# a stop before the state was back: nothing is new, and what stands in the files
# beyond the checkpoint is of a piece that was killed
CHECKPOINT_AS_IT_WAS = "while the checkpoint was read"


def last_step(directory):
    """Of the last row that is whole; -1 without one."""
    try:
        lines = (directory / "statistics.csv").read_text().split("\n")[1:-1]
        return int(lines[-1].split(",")[0])
    except (OSError, IndexError, ValueError):
        return -1


def has_checkpoint(directory):
    return any((directory / "checkpoint").glob("generation-*/seal.txt"))


def resumed_at(text):
    found = re.search(r"resumed at step (\d+)", text)
    return int(found.group(1)) if found else None


class Life:
    """One run in its directory, from its first start to its end."""

    def __init__(self, soak, directory):
        self.soak, self.directory = soak, directory
        self.safe = -1  # the step from which it must go on, or a later one
        self.stopped = False  # in good order: nothing may be lost

    def options(self):
        if has_checkpoint(self.directory):
            return ["--resume"]
        if self.safe > 0:
            raise Offence("no checkpoint is left, step %d was safe" % self.safe)
        return ["--overwrite"] if self.directory.exists() else []

    def check_start(self, text, options):
        """That a resumed piece goes on from where it has to."""
        step = resumed_at(text)
        if "--resume" not in options or step is None:
            return
        if step < self.safe or (self.stopped and step != self.safe):
            raise Offence("resumed at step %d, safe was %d" % (step, self.safe))
        self.safe = step

    def check_end(self, name, polite, status, text):
        """What a disturbed piece leaves; true when the run has ended."""
        if status == 0:
            return True
        if "internal error" in text or "Signal: Segmentation" in text:
            raise Offence("exit status %d:\n%s" % (status, text[-2000:]))
        if status == STOPPED and CHECKPOINT_AS_IT_WAS in text:
            return False
        self.stopped = status == STOPPED
        step = last_step(self.directory)
        if self.stopped:
            if strict_json(self.directory / "summary.json")["exit_status"] != 5:
                raise Offence("summary.json does not say that it was stopped")
            if step >= 0:
                self.safe = step
        elif polite:
            raise Offence("%s: exit status %d, expected 5:\n%s"
                          % (name, status, text[-2000:]))
        elif MESSAGE in text:
            raise Offence("%s: exit status %d:\n%s" % (name, status, text[-2000:]))
        else:
            every = self.soak.every
            self.safe = max(self.safe, step // every * every - every)
        return False

    def piece(self, ranks, disturbed):
        """One start; true when the run has come to its end."""
        soak, options = self.soak, self.options()
        at = last_step(self.directory) if "--resume" in options else -1
        run = soak.start(ranks, self.directory, *options)
        soak.counts["pieces"] += 1
        soak.history.append("%d ranks %s" % (ranks, " ".join(options)))
        name, polite = "undisturbed", False
        try:
            if disturbed:
                name, polite, status = disturb(soak, run, at,
                                               self.directory)
            else:
                status = soak.finish(run)
        finally:
            run.end()
        text = run.text()
        soak.history.append("%s: exit status %d, step %d"
                            % (name, status, last_step(self.directory)))
        self.check_start(text, options)
        if not disturbed and status != 0:
            raise Offence("exit status %d:\n%s" % (status, text[-2000:]))
        return self.check_end(name, polite, status, text)


def compare_life(soak, directory, whole, what):
    try:
        for column, value in compare(directory, whole).items():
            soak.largest[column] = max(soak.largest.get(column, 0.), value)
    except (Difference, OSError, ValueError, KeyError) as difference:
        raise Offence("%s: %s" % (what, difference)) from difference


def live(soak, directory, whole, n_left):
    """One life with at most n_left disturbances; how many it took."""
    life, n_disturbed, ranks = Life(soak, directory), 0, None
    ended = False
    while not ended:
        ranks = soak.random.choice(
            [each for each in soak.options.ranks if each != ranks]
            or soak.options.ranks)
        disturbed = n_disturbed < n_left
        n_disturbed += disturbed
        ended = life.piece(ranks, disturbed)
    compare_life(soak, directory, whole, "in pieces")
    # what has ended stays as it is
    life.stopped = False
    if has_checkpoint(directory):
        life.piece(soak.random.choice(soak.options.ranks), False)
        compare_life(soak, directory, whole, "resumed after its end")
    soak.counts["lives"] += 1
    return n_disturbed
