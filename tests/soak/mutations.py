# SPDX-License-Identifier: GPL-2.0-or-later
"""Seeded operators that damage a parameter file and options of --set.

Each takes the chance (random.Random) and lines, and changes the lines.
"""
import re

NUMBER = re.compile(r"(?<![\w.])[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w.])")
EXTREMES = ["0", "-1", "1", "1e300", "-1e300", "1e-300", "nan", "inf", "-inf",
            "", "1e400", "0.5", "2147483648", "99999999999999999999", "-0",
            "1/0", "0/0", "sqrt(-1)", "exp(1e9)", "true", "x", "t", "1e", "1.2.3",
            "1,5", "0x10"]
PUNCTUATION = ":;,=()#*/-+ \t\"'"
ENTRY = re.compile(r"^(\s*set\s+)([^=#]+?)(\s*=\s*)([^#]*?)(\s*(?:#.*)?)$")


def entries(lines):
    """Indices of lines that set something."""
    return [index for index, line in enumerate(lines) if ENTRY.match(line)]


def any_entry(chance, lines, with_number=False):
    found = [index for index in entries(lines) if not with_number
             or NUMBER.search(ENTRY.match(lines[index]).group(4))]
    return chance.choice(found) if found else None


def with_value(line, value):
    found = ENTRY.match(line)
    return found.group(1) + found.group(2) + found.group(3) + value + found.group(5)


def damaged_number(chance, text):
    numbers = list(NUMBER.finditer(text))
    if not numbers:
        return chance.choice(EXTREMES)
    one = chance.choice(numbers)
    new = chance.choice(EXTREMES)
    kind = chance.random()
    if kind < 0.45:
        new = "%.3g" % (float(one.group()) * 10. ** chance.randint(-4, 2))
    elif kind < 0.55:
        new = "-" + one.group()
    return text[:one.start()] + new + text[one.end():]


def misspelt(chance, word):
    if len(word) < 2:
        return word + word
    at = chance.randrange(len(word) - 1)
    return chance.choice([word[:at] + word[at + 1:],
                          word[:at] + word[at + 1] + word[at] + word[at + 2:],
                          word[:at] + word[at] + word[at:],
                          word.upper(), word.lower(), word + "s"])


def other_number(chance, lines):
    index = any_entry(chance, lines, with_number=True)
    if index is not None:
        value = ENTRY.match(lines[index]).group(4)
        lines[index] = with_value(lines[index], damaged_number(chance, value))


def empty_value(chance, lines):
    index = any_entry(chance, lines)
    if index is not None:
        lines[index] = with_value(lines[index], "")


def duplicate_entry(chance, lines):
    index = any_entry(chance, lines)
    if index is not None:
        lines.insert(chance.choice([index, chance.randrange(len(lines))]),
                     lines[index])


def remove_line(chance, lines):
    if lines:
        del lines[chance.randrange(len(lines))]


def misspell_name(chance, lines):
    index = any_entry(chance, lines)
    if index is not None:
        found = ENTRY.match(lines[index])
        lines[index] = found.group(1) + misspelt(chance, found.group(2)) + \
            found.group(3) + found.group(4)


def swap_values(chance, lines):
    one, other = any_entry(chance, lines), any_entry(chance, lines)
    if one is not None:
        a, b = (ENTRY.match(lines[index]).group(4) for index in (one, other))
        lines[one], lines[other] = with_value(lines[one], b), \
            with_value(lines[other], a)


def truncate_line(chance, lines):
    index = any_entry(chance, lines)
    if index is not None:
        lines[index] = lines[index][:chance.randrange(len(lines[index]) + 1)]


def truncate_file(chance, lines):
    del lines[chance.randrange(len(lines) // 2, len(lines) + 1):]


def flip_byte(chance, lines):
    index = chance.randrange(len(lines)) if lines else None
    if index is not None and lines[index]:
        at = chance.randrange(len(lines[index]))
        flipped = chr(ord(lines[index][at]) ^ (1 << chance.randrange(8)))
        lines[index] = lines[index][:at] + flipped + lines[index][at + 1:]


def break_subsection(chance, lines):
    found = [index for index, line in enumerate(lines)
             if re.match(r"^\s*(subsection|end)\b", line)]
    if not found:
        return
    index = chance.choice(found)
    lines[index:index + 1] = chance.choice([
        [], [lines[index]] * 2, [misspelt(chance, lines[index])],
        ["subsection"], ["end"], ["subsection Nowhere", "end", lines[index]]])


def punctuation(chance, lines):
    index = any_entry(chance, lines)
    if index is not None:
        value = ENTRY.match(lines[index]).group(4)
        at = chance.randrange(len(value) + 1)
        if chance.random() < 0.5:
            value = value[:at] + chance.choice(PUNCTUATION) + value[at:]
        else:
            value = value[:at] + value[at + 1:]
        lines[index] = with_value(lines[index], value)


def other_word(chance, lines):
    """A value that is right for another entry, or a part of one."""
    index, other = any_entry(chance, lines), any_entry(chance, lines)
    if index is not None:
        words = ENTRY.match(lines[other]).group(4).split() or ["none"]
        lines[index] = with_value(lines[index], chance.choice(words))


# numbers more often than the rest: what is no longer a parameter file is
# refused at once
OPERATORS = [other_number] * 24 + [
    empty_value, duplicate_entry, remove_line, misspell_name, swap_values,
    truncate_line, truncate_file, flip_byte, break_subsection, punctuation,
    punctuation, other_word]


def mutate(chance, text):
    """(damaged text, names of the operators)."""
    lines = text.split("\n")
    chosen = [chance.choice(OPERATORS) for _ in range(chance.choice([1, 1, 2]))]
    for operator in chosen:
        operator(chance, lines)
    return "\n".join(lines), [operator.__name__ for operator in chosen]


def entry_paths(text):
    """[(Subsection/Entry, value)] of a parameter file."""
    found, inside = [], []
    for line in text.split("\n"):
        begin = re.match(r"^\s*subsection\s+(.*?)\s*$", line)
        entry = ENTRY.match(line)
        if begin:
            inside.append(begin.group(1))
        elif re.match(r"^\s*end\s*$", line) and inside:
            inside.pop()
        elif entry:
            found.append(("/".join(inside + [entry.group(2)]), entry.group(4)))
    return found


def damaged_option(chance, text):
    """A value for --set, made of an entry of the file."""
    path, value = chance.choice(entry_paths(text))
    return chance.choice([
        lambda: "%s=%s" % (path, damaged_number(chance, value)),
        lambda: "%s=%s" % (path, damaged_number(chance, value)),
        lambda: "%s=%s" % (misspelt(chance, path), value),
        lambda: "%s=%s" % (path.replace("/", chance.choice(["", "//", "."])), value),
        lambda: path, lambda: "=" + value, lambda: "%s=" % path,
        lambda: "%s==%s" % (path, value)])()
