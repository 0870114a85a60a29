"""Wall and processor times: where other programs share the cores, only the latter tells what a computation costs."""
import ctypes
import time
from dataclasses import dataclass

REPETITIONS = 5


@dataclass(order=True)
class Duration:
    """Of an action; the processor time is the sum over its threads."""

    processor: float
    wall: float

    @staticmethod
    def of(action):
        wall, processor = time.perf_counter(), time.process_time()
        action()
        return Duration(time.process_time() - processor, time.perf_counter() - wall)

    def __str__(self):
        return f"{1000.0 * self.wall:.3g} ({1000.0 * self.processor:.3g})"


def median(action, repetitions=REPETITIONS, before=lambda: None):
    """The medians of an action's times, each time after `before`."""
    found = []
    for _ in range(repetitions):
        before()
        found.append(Duration.of(action))
    middle = repetitions // 2
    return Duration(sorted(d.processor for d in found)[middle], sorted(d.wall for d in found)[middle])


def return_memory():
    """Gives memory that is not in use back to the system.

    A mesh of some MiB that has just been freed leaves pages that the next one takes over at once; a larger one is mapped
    anew, page by page, which takes several times as long. Without this the times depend on what was freed before.
    """
    ctypes.CDLL(None).malloc_trim(0)


def resident_mebibytes():
    """What the process holds at present."""
    return_memory()
    with open("/proc/self/status") as file:
        line = next(line for line in file if line.startswith("VmRSS"))
    return int(line.split()[1]) / 1024.0
