# SPDX-License-Identifier: GPL-2.0-or-later
"""sweep.py submit: what is missing, as an array of jobs of Slurm, and a job behind it
that writes the table."""
import collections
import contextlib
import os
import pathlib
import re
import sys
import uuid

from report_parts import safe

from . import jobs, manifest, resources, slurm
from .collect import shortened

HELP = "submit what is missing as an array of jobs, and the table behind it"
OPTIONS = resources.options() + [
    ("--dry-run", None, "show what would be submitted; change nothing"),
    ("--failed", None, "also what has failed and would fail again, as nothing has "
     "changed")]


def run(arguments, study):
    given = resources.resources_of(arguments)
    if not arguments.dry_run:
        slurm.require()
    try:
        with contextlib.nullcontext() if arguments.dry_run \
                else contextlib.closing(study.claim()):
            return submitted(arguments, study, given)
    except slurm.QueueError as error:
        print("sweep.py: %s" % error, file=sys.stderr)
        return 1


def submitted(arguments, study, given):
    queued = queue_of(study, arguments.dry_run)
    chosen = choice(study.chosen(arguments.only), queued, study, arguments.failed)
    for words, names in chosen.left.items():
        print("%s: %s" % (words, shortened(names)))
    if not chosen.cases:
        print("nothing is missing" if set(chosen.left) == {"complete"}
              else "nothing to submit")
        return 0
    frozen = freeze(study, chosen.cases, given)
    texts = [jobs.array_text(frozen, array, given)
             for array in frozen.content["arrays"]]
    behind = jobs.collect_text(frozen, given, study)
    for text in texts + [behind]:
        print(text)
    if arguments.dry_run:
        print("not submitted: %d cases" % len(chosen.cases))
        return 0
    if chosen.held:
        slurm.cancel(chosen.held)
    return hand_over(frozen, texts, behind)


def queue_of(study, dry_run):
    """What is in the queue; for a look at what would be, it need not answer."""
    try:
        return slurm.patiently(lambda: jobs.in_queue(study.output), not dry_run)
    except slurm.QueueError as error:
        if not dry_run:
            raise
        print("the queue does not answer: %s" % error, file=sys.stderr)
        return {}


# cases: to submit; left: {why: names} of the others; held: jobs that these replace
Choice = collections.namedtuple("Choice", "cases left held")


def choice(cases, queued, study, with_failed):
    chosen = Choice({}, {}, set())
    for case in cases:
        state, _ = case.state()
        task, queued_id = queued.get(case.name, (None, None))
        if state in ("complete", "running"):
            why = state
        elif task and queued_id == case.id and not slurm.is_held(task):
            why = "in the queue already"
        elif state == "failed" and not with_failed and is_hopeless(case, study):
            why = "failed, and nothing has changed (--failed tries again)"
        else:
            chosen.cases.setdefault(case.id, case)
            if task and slurm.is_held(task):
                chosen.held.add(task.job)
            continue
        chosen.left.setdefault(why, []).append(case.name)
    return Choice(list(chosen.cases.values()), chosen.left, chosen.held)


def is_hopeless(case, study):
    """Whether the program itself has ended it, and would again."""
    piece = case.record()["pieces"][-1]
    return piece.get("exit_status") in (2, 3) and not piece.get("given_up") \
        and piece.get("checksum") == study.program.checksum \
        and piece.get("base_checksum") == safe.checksum_of(study.sweep.base) \
        and piece.get("settings") == dict(case.settings)


def freeze(study, cases, given):
    """The Manifest of what is submitted; nothing is written."""
    stem = re.sub(r"[^A-Za-z0-9_.-]", "_", pathlib.Path(study.sweep.path).stem)
    token = "%s.%s" % (stem, uuid.uuid4().hex[:8])
    names = [case.name for case in cases]
    together = given["cases per job"]
    groups = [names[k:k + together] for k in range(0, len(names), together)]
    largest = slurm.max_array_size()
    arrays = [{"job_name": "%s.%d" % (token, number), "first": first,
               "count": min(largest, len(groups) - first), "job": None}
              for number, first in enumerate(range(0, len(groups), largest))]
    launcher = slurm.launcher() if given["launcher"] is None else given["launcher"]
    return manifest.frozen(study, cases, groups, arrays, token, launcher,
                           given["ranks"])


def hand_over(frozen, texts, behind):
    """To Slurm. What is written before can be found in the queue by its name, even
    when this process ends in the middle."""
    frozen.write()
    for text, array in zip(texts, frozen.content["arrays"]):
        path = written(frozen, array["job_name"] + ".sbatch", text)
        array["job"] = slurm.submit(path, array["job_name"])
        frozen.write()
    ids = [array["job"] for array in frozen.content["arrays"]]
    path = written(frozen, "collect.sbatch", behind)
    collecting = slurm.submit(path, frozen.content["token"] + ".collect",
                              "--dependency=afterany:" + ":".join(ids))
    print("submitted %d cases: %s; the table: job %s; texts and logs: %s" % (
        len(frozen.cases), ", ".join("job " + job for job in ids), collecting,
        frozen.folder))
    return 0


def written(frozen, name, text):
    path = os.path.join(frozen.folder, name)
    safe.write_whole(path, text)
    return path
