"""Work and a yardstick measured side by side, so that their ratio means something on a busy machine too."""

from __future__ import annotations

import time
from collections.abc import Callable

Work = Callable[[], object]


def fastest(
    *works: Work,
    rounds: int = 15,
    clock: Callable[[], float] = time.perf_counter,
    prepare: Work = lambda: None,
) -> list[float]:
    """Return the time of each work, the fastest of several rounds; in every round each has one turn.

    What each needs beforehand is prepared while nothing is measured.
    """
    times = [float("inf")] * len(works)
    for work in works:
        prepare()
        work()
    for _ in range(rounds):
        for i, work in enumerate(works):
            prepare()
            start = clock()
            work()
            times[i] = min(times[i], clock() - start)
    return times
