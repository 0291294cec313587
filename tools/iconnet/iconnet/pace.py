"""A training from its first step to its last: by a number of steps or by the clock, with reports on the way."""

import itertools
import time


def to_the_end(trainer, name: str, steps: int, minutes: float, reports: int, say, more=lambda: None) -> None:
    """Calls `trainer.step(done)` with the share that is over, until `steps` are done or `minutes` over. At each of `reports` it says
    `trainer.progress()`, saves, and calls `more`."""
    began, done, report = time.monotonic(), 0.0, 1
    for step in itertools.count(1):
        trainer.step(done)
        passed = time.monotonic() - began
        done = max(step / steps, passed / 60 / minutes)
        if done >= report / reports:
            report += 1
            say(f"{name} step {step} ({done:.0%}, {passed:.0f} s) {trainer.progress()}")
            trainer.save()
            more()
        if done >= 1:
            return
