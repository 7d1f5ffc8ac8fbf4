# SPDX-License-Identifier: GPL-2.0-or-later
"""Keeps other processes out of a directory, as mixed-cracks does: by a lock of the
operating system on the file .lock in it, or another one, which is gone with its
process."""
import errno
import os
import socket
import time

from report_parts import safe

try:
    import fcntl
except ImportError:  # no locks on this system
    fcntl = None

NAME = ".lock"
# what says that there are no locks, rather than that it is taken
NO_LOCKS = (errno.ENOLCK, errno.ENOSYS, errno.EINVAL, errno.EOPNOTSUPP)


class InUse(Exception):
    """The message names directory and holder; holder: in words."""

    def __init__(self, path):
        self.holder = holder_of(path)
        named = os.path.dirname(path) if os.path.basename(path) == NAME \
            else path[:-len(".lock")]
        super().__init__("'%s' is in use by %s" % (named, self.holder))


def holder_of(path):
    """In words, from the contents of a lock file."""
    known = dict(line.strip().partition(" ")[::2]
                 for line in (safe.read_text(path) or "").splitlines())
    return "process %(process)s on host %(host)s since %(since)s" % known \
        if all(known.get(word) for word in ("host", "process", "since")) \
        else "another process"


class Lock:
    """Of a directory that exists; held until release() or the end of the process.
    Raises InUse when it is not free within `wait` seconds. `warning` tells when the
    file system has no locks."""

    def __init__(self, directory, name=NAME, wait=0.):
        self.path = os.path.join(directory, name)
        self.stream, self.warning = None, ""
        deadline = time.monotonic() + wait
        while self.stream is None:
            # inherited by nobody: Python opens files so
            stream = open(self.path, "a+", encoding="utf-8")
            try:
                if fcntl is None:
                    raise OSError(errno.ENOSYS, "no locks")
                fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                if error.errno not in NO_LOCKS:
                    stream.close()
                    if time.monotonic() >= deadline:
                        raise InUse(self.path) from None
                    time.sleep(0.1)
                    continue
                self.warning = "the file system of '%s' has no locks: see to it that " \
                    "there is one sweep at a time" % directory
            # its last holder may have removed it meanwhile
            if self.warning or is_at(self.path, stream):
                self.stream = stream
            else:
                stream.close()
        self.stream.truncate(0)
        self.stream.write("host %s\nprocess %d\nsince %s\n" % (
            socket.gethostname(), os.getpid(), now()))
        self.stream.flush()

    def release(self):
        if is_at(self.path, self.stream):
            os.remove(self.path)
        self.stream.close()

    close = release  # for contextlib.closing


def now():
    return time.strftime("%Y-%m-%d %H:%M:%S UTC", time.gmtime())


def is_at(path, stream):
    """Whether a name still leads to an open file."""
    try:
        return os.path.samestat(os.stat(path), os.fstat(stream.fileno()))
    except OSError:
        return False


def require_free(directory, name=NAME):
    """Raises InUse when a process has the directory; touches nothing."""
    path = os.path.join(directory, name)
    try:
        stream = open(path, encoding="utf-8")
    except OSError:
        return
    with stream:
        try:
            if fcntl is not None:
                fcntl.flock(stream, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError as error:
            if error.errno not in NO_LOCKS:
                raise InUse(path) from None
