# SPDX-License-Identifier: GPL-2.0-or-later
"""Options of the scripts as tables. Python's own library only."""


def add(parser, table):
    """table: (name, METAVAR, help) each, and what else argparse is to know, as a
    dictionary. Without a METAVAR it is a switch."""
    for name, metavar, text, *more in table:
        kind = {"metavar": metavar} if metavar else {"action": "store_true"}
        parser.add_argument(name, help=text, **dict(kind, **(more[0] if more else {})))
