# SPDX-License-Identifier: GPL-2.0-or-later
"""What is wrong with the input of a script."""


class InputError(Exception):
    """The text is one line for a person: where, what was found, what is allowed."""


def listed(words):
    """'a', 'b' and 'c'"""
    words = ["'%s'" % word for word in words]
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1]))) \
        if words else "nothing"
