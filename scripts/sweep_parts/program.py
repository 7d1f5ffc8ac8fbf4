# SPDX-License-Identifier: GPL-2.0-or-later
"""The program that a sweep runs: where it is, which revision, and what it says of
the identity of a case."""
import functools
import os
import re
import shutil
import subprocess

from report_parts import safe

from .errors import SweepError

# One thread per rank; no binding, for several runs share the cores. Open MPI
# refuses root, the usual user of a container, unless told.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
               "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "OMPI_MCA_hwloc_base_binding_policy": "none",
               "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
               "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
               "DEAL_II_NUM_THREADS": "1"}
ID = re.compile(r"[0-9a-f]{8,128}$")
# of a process that is no step of the job it is started in
OF_A_QUEUE = ("SLURM_", "PMI", "PBS_", "SGE_", "OMPI_COMM_WORLD")


def environment():
    """For a run; what the user has set counts."""
    return dict(ENVIRONMENT, **os.environ)


def found():
    """The program of this source tree, beside this installation, or on the PATH."""
    scripts = os.path.dirname(os.path.dirname(os.path.realpath(__file__)))
    for place in ("../build/mixed-cracks", "../../../bin/mixed-cracks"):
        path = os.path.normpath(os.path.join(scripts, place))
        if os.access(path, os.X_OK):
            return path
    return shutil.which("mixed-cracks")


class Program:
    """path: absolute; None looks for it. Raises SweepError."""

    def __init__(self, path=None):
        path = path or found()
        if path is None:
            raise SweepError("mixed-cracks is neither in build/ nor on the PATH; "
                             "name it with --program")
        if os.sep not in path:
            path = shutil.which(path) or path
        self.path = os.path.abspath(path)
        if not os.path.isfile(self.path) or not os.access(self.path, os.X_OK):
            raise SweepError("--program: '%s' cannot be run" % self.path)

    def said(self, *words):
        """(exit status, what it says on stdout, on stderr)."""
        surroundings = {name: value for name, value in environment().items()
                        if not name.startswith(OF_A_QUEUE)}
        try:
            process = subprocess.run([self.path, *words], stdin=subprocess.DEVNULL,
                                     capture_output=True, encoding="utf-8",
                                     errors="replace", env=surroundings, check=False)
        except OSError as error:
            raise SweepError("'%s' cannot be run: %s" % (self.path, error))
        return process.returncode, process.stdout, process.stderr

    def expect(self, checksum, revision):
        """Spares asking for the revision of a file of this checksum."""
        if self.checksum == checksum:
            self.revision = revision

    @functools.cached_property
    def revision(self):
        match = re.search(r"revision ([^\s()]+)", self.said("--version")[1])
        return match.group(1) if match else "unknown"

    @functools.cached_property
    def checksum(self):
        return safe.checksum_of(self.path)

    def case_id(self, base, options, full=False):
        """What a case is, as `mixed-cracks --case-id` says: the same for the same
        parameters and files read, whatever they are written like; full: entries count
        as well that may change when a run goes on. Raises SweepError with the message
        of the program for wrong input."""
        status, output, errors = self.said(base, *options,
                                           "--case-id=full" if full else "--case-id")
        lines = output.split("\n")
        if status == 0 and len(lines) == 2 and ID.match(lines[0]):
            return lines[0]
        said = [line for line in (errors + output).splitlines() if "error" in line]
        words = (said or (errors + output).split("\n"))[0].strip()
        if status == 0 or "--case-id" in words:
            raise SweepError("'%s' has no --case-id: it is older than this script (it "
                             "said '%s')" % (self.path, words))
        raise SweepError("%s is refused: %s" % (base, words))
