# SPDX-License-Identifier: GPL-2.0-or-later
"""Advances a case by one start of the program: from nothing, or from its checkpoint.
Whatever drives a sweep goes through here: `run`, `task`, and what is built on them.
"""
import contextlib
import os
import pathlib
import signal
import socket
import time

from report_parts import safe

from . import cases, lock

LOOK = 1.  # s; a look at the state of a case takes its lock for an instant
PATIENCE = 10.  # s, in a job: the program of its last start may need a moment to go
GIVE_UP_AFTER = 2  # pieces in a row without a new step
# signals after which a job is to go on: none, as with Output/Wall time limit, or the
# one that tells that its time is over
OF_ITSELF = (None, int(signal.SIGUSR1))
# a program that is asked to stop while it is being loaded; from a launcher, or not
KILLED_BY_A_REQUEST = (129, 130, 138, 143, -1, -2, -10, -15)
DONE, REFUSED, FAILED, FILES, STOPPED, TOO_EARLY = 0, 2, 3, 4, 5, 6


class Piece:
    """One start. command(case, resume): the words; starter(command, screen): starts
    them, waits, and returns (exit status, number of the signal that it was stopped
    by, or None); job: {"job", "restart"} of the queue, may be empty."""

    def __init__(self, case, program, ranks, job):
        self.case, self.program, self.ranks, self.job = case, program, ranks, job
        self.patience = PATIENCE if job else LOOK

    def advance(self, command, starter):
        """(exit status, why, in words). 0: the case is complete, or was. Others are
        those of the program; 3 also when it does not get on. Raises lock.InUse and
        OSError."""
        with contextlib.closing(self.case.lock(self.patience)):
            return self.advance_locked(command, starter)

    def advance_locked(self, command, starter):
        case = self.case
        record = case.record()
        if record.get("complete"):
            cases.make_read_only(case.directory)  # if the last one came no further
            case.make_link()
            return DONE, ""
        os.makedirs(case.directory, exist_ok=True)
        wait_until_free(case.directory, self.patience)
        if has_ended_alone(record, case):
            return self.end(record, DONE, None)
        if self.is_hopeless(record):
            reason = no_new_step(record["pieces"])
            record["pieces"][-1].update(exit_status=FAILED, given_up=True,
                                        reason=reason)
            case.write_record(record)
            return FAILED, reason
        # an old summary must not pass for that of a run that is killed
        pathlib.Path(case.path("summary.json")).unlink(missing_ok=True)
        record = self.begin(record)
        case.write_record(record)
        case.make_link()
        with open(case.path(cases.SCREEN), "ab") as screen:
            outcome = starter(command(case, record["pieces"][-1]["resumed"]), screen)
        return self.end(record, *outcome)

    def is_hopeless(self, record):
        """Whether this is the same job again, started anew by the queue after pieces
        that were killed without a new step."""
        return bool(record) and self.job.get("job") and self.job.get("restart") \
            and record["pieces"][-1].get("job") == self.job["job"] \
            and "exit_status" not in record["pieces"][-1] \
            and without_new_step(record["pieces"]) >= GIVE_UP_AFTER

    def begin(self, record):
        """The record with a new piece."""
        case = self.case
        record = record or {"format": 1, "id": case.id, "names": [], "pieces": []}
        if case.name not in record["names"]:
            record["names"].append(case.name)
        record.update(base=case.base, settings=dict(case.settings))
        resumed, screen = case.has_checkpoint(), case.path(cases.SCREEN)
        record["pieces"].append(dict(
            host=socket.gethostname(), process=os.getpid(), started=lock.now(),
            program=self.program.path, revision=self.program.revision,
            checksum=self.program.checksum, ranks=self.ranks,
            settings=record["settings"], base_checksum=safe.checksum_of(case.base),
            resumed=resumed,
            from_step=case.last_step() if resumed else -1,
            screen_from=os.path.getsize(screen) if os.path.exists(screen) else 0,
            **self.job))
        return record

    def end(self, record, status, asked):
        """Notes how the piece has ended; what advance() returns. asked: the number of
        the signal that was to end it, or None."""
        case, piece = self.case, record["pieces"][-1]
        summary = case.summary()
        told = summary.get("exit_status")
        # mpirun makes 1 of most failures
        if told or (told is None and status == 0):
            status = told or FILES
        # killed on its way out, when all was written
        if is_signal(status) and told == 0:
            status = DONE
        if asked is not None and status in KILLED_BY_A_REQUEST:
            status = STOPPED if case.has_checkpoint() else TOO_EARLY
        piece.update(exit_status=status, ended=lock.now(), to_step=case.last_step())
        if asked is not None:
            piece["signal"] = asked
        if status == 0:
            record["complete"] = True
        else:
            piece["reason"] = reason_of(case, piece, summary)
        if status in (STOPPED, TOO_EARLY) and asked in OF_ITSELF \
                and without_new_step(record["pieces"]) >= GIVE_UP_AFTER:
            piece.update(given_up=True, reason=no_new_step(record["pieces"]))
            status = FAILED
        case.write_record(record)
        if record.get("complete"):
            cases.make_read_only(case.directory)
        return status, piece.get("reason", "")


def is_signal(status):
    """Whether a process of this exit status was killed; a launcher adds 128."""
    return status < 0 or status > 128


def has_ended_alone(record, case):
    """Whether the program has come to its end after its starter was killed."""
    return bool(record) and "exit_status" not in record["pieces"][-1] \
        and case.summary().get("exit_status") == 0


def without_new_step(pieces):
    """How many of the last pieces have brought no step that was not there before, up
    to the last one after which somebody has tried again. Those that somebody has
    ended do not count, but SIGUSR1 does: it comes when the time of a job is over."""
    count, reached = 0, -1
    for piece in pieces:
        end = piece.get("to_step", piece.get("from_step", -1))
        if piece.get("given_up") or end > reached:
            count = 0
        elif piece.get("signal") in OF_ITSELF:
            count += 1
        reached = max(reached, end)
    return count


def no_new_step(pieces):
    last = max([piece.get("to_step", -1) for piece in pieces])
    return "given up: %d starts in a row without a new step%s" % (
        GIVE_UP_AFTER, "" if last < 0 else " after step %d" % last)


def reason_of(case, piece, summary):
    """Why a piece did not come to its end: its error message, the reason in its
    summary, or what it wrote last."""
    lines = said_by(case, piece)
    own = [line for line in lines if "mixed-cracks: error:" in line]
    # a launcher reports every status that is not 0 as an error of its own
    others = [line for line in lines if "error:" in line]
    reason = summary.get("exit_reason")
    last = own[-1] if own else str(reason) if reason else (others or lines or [""])[-1]
    status = piece["exit_status"]
    if is_signal(status):
        last = "killed by signal %d%s" % (-status if status < 0 else status - 128,
                                          "; " + last if last else "")
    return last


def said_by(case, piece):
    """Lines of the screen of a piece, without blank ones."""
    try:
        with open(case.path(cases.SCREEN), "rb") as stream:
            stream.seek(piece.get("screen_from", 0))
            text = stream.read().decode("utf-8", "replace")
    except OSError:
        return []
    return [line.strip() for line in text.splitlines() if line.strip()]


def wait_until_free(directory, seconds):
    """Until the program of an earlier start is gone. Raises lock.InUse."""
    deadline = time.monotonic() + seconds
    while True:
        try:
            return lock.require_free(directory)
        except lock.InUse:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.2)
