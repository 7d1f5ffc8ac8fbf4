# SPDX-License-Identifier: GPL-2.0-or-later
"""What happened in a run, read from its curve: peak, separation, moments."""
import numpy as np

SEPARATED_FRACTION = 0.2  # of the peak force, when the run does not name its own


class Force:
    """The force that is drawn: its values, its name, its peak and its fall."""

    def __init__(self, results, component=None):
        """component: 'x', 'y' or 'z' to have that one, its sign turned where
        it presses; None: what fits the run."""
        self.values, self.label = chosen_force(results, component)
        self.peak = None
        self.separation = None
        self.fall_in_words = fall_in_words(results)
        if self.values is None or not np.isfinite(self.values).any():
            self.values = None
            return
        self.peak = peak_index(self.values, results)
        self.separation = separation_index(self.values, self.peak, results)
        self.threshold = separation_threshold(results)


def peak_index(values, results):
    """The largest one; where dead loads have torn the body apart, the last is
    a load that nothing carried."""
    reason = str(results.summary.get("exit_reason", ""))
    carried = values[:-1] if reason.startswith("no equilibrium") else values
    known = carried if np.isfinite(carried).any() else values
    return int(np.nanargmax(known))


def largest_size(values):
    """Largest modulus of the numbers that are known; 0 without any."""
    values = np.abs(values if values is not None else [])
    return float(values[np.isfinite(values)].max(initial=0.))


def chosen_force(results, component=None):
    """(values, label): the component along the load where the others are
    small, otherwise the magnitude."""
    names = [name for name in component or "xyz"
             if results.column("force_%s_N" % name) is not None]
    if not names:
        return None, ""
    table = np.array([results.column("force_%s_N" % name) for name in names])
    sizes = np.array([largest_size(values) for values in table])
    largest = int(sizes.argmax())
    if np.delete(sizes, largest).max(initial=0.) > 0.2 * sizes[largest]:
        return np.linalg.norm(table, axis=0), "Force, magnitude (N)"
    values, label = table[largest], "Force in %s (N)" % names[largest]
    if not np.isfinite(values).any():
        return values, label
    return (-values, label.replace("Force", "Compressive force")) \
        if abs(np.nanmin(values)) > np.nanmax(values) else (values, label)


def separation_threshold(results):
    fraction = results.number("Load stepping/Stop when force falls below", 0.)
    return fraction if fraction > 0. else SEPARATED_FRACTION


def fall_in_words(results):
    """What a force that is almost gone means: only the cracks tell whether the
    body is separated, and those of a run in 3-d or without a summary are not
    known."""
    return "separated" if results.summary.get("separated") is True else "force fell"


def separation_index(force, peak, results):
    """First step after the peak with almost no force left, or None."""
    summary = results.summary
    if summary.get("separated") is False and summary.get("force_fell") is not True:
        return None
    if not force[peak] > 0.:  # nothing has fallen
        return None
    below = np.nonzero(force[peak:] <= separation_threshold(results) * force[peak])[0]
    if len(below) and below[0] > 0:
        return peak + int(below[0])
    if (summary.get("separated") is True or summary.get("force_fell") is True) \
            and peak < len(force) - 1:
        return len(force) - 1
    return None


def imbalance(results):
    """External work minus stored elastic minus dissipated crack energy since the
    start (mJ). Crack energy of the first row belongs to the initial cracks, what
    is stored then to loads that are there from the start: nobody did work for
    them."""
    energies = [results.column(name) for name in (
        "external_work_mJ", "elastic_energy_mJ", "crack_energy_mJ")]
    if any(values is None for values in energies):
        return None
    work, elastic, crack = (values - values[0] for values in energies)
    return work - elastic - crack


def onset_index(results, force):
    """Last step before the crack grows: 2 % of the whole growth."""
    crack = results.column("crack_energy_mJ")
    if crack is None or not len(crack) or not np.isfinite(crack).all():
        return None
    growth = crack - crack[0]
    if growth.max() <= 1e-3 * max(abs(crack[0]), 1e-12):
        return len(crack) - 1
    return max(0, int(np.argmax(growth > 0.02 * growth.max())) - 1)


def nearest(times, time, allowed):
    """Index of the entry of times nearest to time among the allowed ones."""
    candidates = [i for i in range(len(times)) if allowed(times[i])]
    return min(candidates, key=lambda i: abs(times[i] - time)) if candidates else None


def chosen_moments(results, force, times):
    """[(index into times, words)], at most six, in order of time: before the
    onset, at the peak, while the crack runs, after separation."""
    if not times:
        return []
    steps = results.column("time_s")
    words = {}

    def choose(index, text):
        if index is not None and index not in words:
            words[index] = text

    last = len(times) - 1
    if steps is None or force.peak is None:
        for i in np.unique(np.linspace(0, last, min(4, last + 1)).astype(int)):
            choose(int(i), "")
        return sorted(words.items())
    small = 1e-6 * max(abs(times[-1]), 1e-12)
    peak_time = steps[force.peak]
    at_peak = nearest(times, peak_time, lambda t: True)
    separated = None
    if force.separation is not None:
        separation_time = steps[force.separation]
        separated = nearest(times, separation_time,
                            lambda t: t >= separation_time - small)
    onset = onset_index(results, force)
    if onset is not None and force.peak > 0:
        onset = min(onset, force.peak - 1)
        choose(nearest(times, steps[onset], lambda t: t <= steps[onset] + small),
               "before the crack grows")
    exact = abs(times[at_peak] - peak_time) <= small
    choose(at_peak, "at the peak" if exact else "near the peak")
    choose(separated, "after separation" if force.fall_in_words == "separated"
           else "after the fall of the force")
    for fraction in (0.5, 0.25, 0.75):  # of the crack that grows after the peak
        if len(words) < 6:
            choose(*while_running(results, force, times, fraction, small))
    choose(last, "at the end")
    while len(words) > 6:
        del words[sorted(words)[-2]]
    return sorted(words.items())


def while_running(results, force, times, fraction, small):
    """A field between peak and separation with that share of the growth."""
    steps = results.column("time_s")
    crack = results.column("crack_energy_mJ")
    end = force.separation if force.separation is not None else len(steps) - 1
    if crack is None or end <= force.peak:
        return None, ""
    wanted = crack[force.peak] + fraction * (crack[end] - crack[force.peak])
    step = force.peak + int(np.argmax(crack[force.peak:end + 1] >= wanted))
    index = nearest(times, steps[step],
                    lambda t: steps[force.peak] + small < t < steps[end] - small)
    return index, "while the crack runs"
