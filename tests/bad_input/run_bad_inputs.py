#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Gives the program bad input and looks at what it says.

    run_bad_inputs.py EXECUTABLE MPIRUN RANKS [part of a case's name]

Whatever is wrong, the program has to leave within a minute with the right
exit status, say so once (on one rank) on the error stream in words that name
what was found and what is allowed, without traces of the inside, and leave no
files. The cases are in bad_inputs.py and bad_inputs_*.py. Prints every offence; exit
status 1 when there is one.

Every eighth case starts the program; the others do not wait for its libraries
(program.runner()). What is found when the case is read and checked is so before any
rank has done anything of its own: of such cases every 32nd is tried on several ranks,
and all that are marked as found later.
"""
import concurrent.futures
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir))
import program  # noqa: E402
from bad_inputs import BASE, CASES as CASES_2D  # noqa: E402
from bad_inputs_3d import CASES as CASES_3D  # noqa: E402
from bad_inputs_finite import CASES as CASES_FINITE  # noqa: E402
from bad_inputs_periodic import CASES as CASES_PERIODIC  # noqa: E402

CASES = CASES_2D + CASES_3D + CASES_FINITE + CASES_PERIODIC

TIME_LIMIT = 60  # s; a run takes one, more where the machine has much to do
MESSAGE = "mixed-cracks: error: "
# what a user must never see
INSIDE = re.compile(r"terminate called|MPI_ABORT|MPI_Abort|Stacktrace|#\d+ +/"
                    r"|An error occurred in line|dealii::|std::|exception"
                    r"|internal error|Assert|Segmentation|assignment of", re.I)


def parameter_file(case):
    """Bytes of case.prm, or None."""
    if "file" in case:
        return case["file"]
    text = BASE
    for old, new in case.get("change", []):
        if text.count(old) != 1:
            raise ValueError("%s: '%s' is not once in BASE" % (case["name"], old))
        text = text.replace(old, new)
    return text.encode()


def prepare(case, folder):
    """Write the files of a case."""
    files = dict(case.get("files", {}))
    if parameter_file(case) is not None:
        files["case.prm"] = parameter_file(case)
    for name in case.get("folders", []):
        os.makedirs(os.path.join(folder, name))
    for name, content in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "wb") as stream:
            stream.write(content)


def content(folder):
    """{path: bytes, or None for a folder} of all below a folder."""
    found = {}
    for parent, folders, files in os.walk(folder):
        for name in folders:
            found[os.path.relpath(os.path.join(parent, name), folder)] = None
        for name in files:
            path = os.path.join(parent, name)
            with open(path, "rb") as stream:
                found[os.path.relpath(path, folder)] = stream.read()
    return found


def arguments(case):
    if "arguments" in case:
        return case["arguments"]
    return [word for text in case.get("set", []) for word in ("--set", text)] \
        + ["case.prm"]


def run(command, folder):
    """(exit status or None when it took too long, stdout, stderr)."""
    # Open MPI waits a second or two after a program that failed
    environment = dict(os.environ, OMPI_MCA_odls_base_sigkill_timeout="0")
    process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL,
                               env=environment,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                               start_new_session=True)
    try:
        out, err = process.communicate(timeout=TIME_LIMIT)
        status = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGTERM)  # mpirun passes it on
        out, err = process.communicate()
        status = None
    return status, out.decode(errors="replace"), err.decode(errors="replace")


def message_of(err):
    """The program's message, without what mpirun adds to it."""
    begin = err.find(MESSAGE)
    if begin < 0:
        return ""
    return re.split(r"\n-{20,}", err[begin:])[0]


def left_behind(case, before, after):
    """What a refused run may not change."""
    changed = [path for path in after
               if path not in before or after[path] != before[path]]
    changed += [path for path in before if path not in after]
    allowed = case.get("leaves", [])
    return [path for path in sorted(changed) if path.split(os.sep)[0] not in allowed]


def check_output(status, out, err, expected):
    if status is None:
        yield "still running after %d s" % TIME_LIMIT
    elif status != expected:
        yield "exit status %d, expected %d" % (status, expected)
    if err.count(MESSAGE) != 1:
        yield "%d messages on the error stream, expected 1" % err.count(MESSAGE)
    if MESSAGE in out:
        yield "the message is in the output"
    for text in INSIDE.findall(out + err):
        yield "a user sees '%s'" % text


def check_message(case, message):
    for pattern in case["says"]:
        if not re.search(pattern, message):
            yield "the message of '%s' does not contain /%s/" % (case["name"], pattern)


def offences(group, command, folder):
    """Of one run with the mistakes of all cases of a group."""
    case = group[0]
    prepare(case, folder)
    before = content(folder)
    words = arguments(case) if len(group) == 1 else \
        [word for each in group for word in ("--set", each["set"][0])] + ["case.prm"]
    status, out, err = run(command + words, folder) if isinstance(command, list) \
        else command.run(words, folder)
    yield from check_output(status, out, err, case.get("status", 2))
    message = message_of(err)
    if len(group) == 1:
        yield from check_message(case, message)
    else:
        for each in group:
            lines = [line for line in message.splitlines()
                     if "--set '%s'" % each["set"][0] in line]
            yield from check_message(each, "\n".join(lines))
    for path in left_behind(case, before, content(folder)):
        yield "changed or left behind: " + path
    yield "| " + (message or err[:2000]).strip().replace("\n", "\n      | ")


def groups(cases):
    """Lists of cases to be tried in one run: mostly one each, and up to ten
    values that are refused when the file is read."""
    largest = 10  # the program shows no more mistakes at once
    result, open_groups = [], []
    for case in cases:
        if not case.get("at_once"):
            result.append([case])
            continue
        name = case["set"][0].split("=")[0]
        for group in open_groups:
            taken = [each["set"][0].split("=")[0] for each in group]
            if name not in taken and len(group) < largest:
                group.append(case)
                break
        else:
            open_groups.append([case])
            result.append(open_groups[-1])
    return result


def runs(cases, in_full, tried, on_ranks, runner):
    """[(cases that are tried at once, the command or what runs them)]; of the cases one
    of so many is run by the command, and one of so many of those that are found when
    the case is read is tried at all."""
    result = []
    for n, group in enumerate(groups(cases)):
        if "later" in group[0] or n % tried == 0:
            is_full = "arguments" in group[0] or n % in_full == 0
            result.append((group, on_ranks if is_full else runner))
    return result


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    executable, launcher, ranks = sys.argv[1:4]
    wanted = sys.argv[4] if len(sys.argv) > 4 else ""
    executable = os.path.abspath(executable)
    on_ranks = [executable] if ranks == "1" else [launcher, "-n", ranks, executable]
    runner = program.runner(executable, launcher, int(ranks))
    names = [case["name"] for case in CASES]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        sys.exit("two cases of one name: %s" % ", ".join(sorted(twice)))
    n_failed, n_cases, start = 0, 0, time.time()
    cases = [case for case in CASES if wanted in case["name"]]

    def examine(task):
        with tempfile.TemporaryDirectory() as folder:
            return task[0], list(offences(*task, folder))

    # two at a time: most of a run is the loading of libraries
    pool = concurrent.futures.ThreadPoolExecutor(max_workers=2)
    in_full, tried = (1, 1) if wanted else (8, 1 if ranks == "1" else 32)
    for group, found in pool.map(examine, runs(cases, in_full, tried, on_ranks, runner)):
        failed = len(found) > 1
        n_failed += failed
        n_cases += len(group)
        if failed or wanted:
            print("%s: %s" % ("FAILED" if failed else "passed",
                              "; ".join(case["name"] for case in group)))
            for text in found:
                print("      " + text)
            sys.stdout.flush()
    print("%d bad inputs, %d runs failed, %.0f s"
          % (n_cases, n_failed, time.time() - start))
    return 1 if n_failed or not n_cases else 0


if __name__ == "__main__":
    sys.exit(main())
