"""The test of likeness: choices between two, and of all."""

import numpy as np

from iconnet import pairs


def test_choices_are_counted():
    rows = np.eye(4, dtype=np.float32)
    right = pairs.choose(rows, rows)
    assert (right.pairs, right.of_two, right.first) == (4, 1.0, 1.0)
    # The last two are taken for each other: of twelve choices two are wrong, and two of four first places.
    swapped = pairs.choose(rows, rows[[0, 1, 3, 2]] + 0.1 * rows)
    assert (swapped.of_two, swapped.first) == (10 / 12, 0.5)


def test_pictures_are_seen_dark_on_white_at_the_files_size():
    given = []

    def run(feeds):
        given.append(feeds)
        return {"embedding": np.ones((len(feeds["image"]), 5), np.float32)}

    ink = np.zeros((3, 8, 8), np.uint8)
    ink[:, :, :4] = 255
    assert pairs.seen(run, 4, 5, ink, batch=2).shape == (3, 5)
    assert [len(feeds["image"]) for feeds in given] == [2, 1]
    image = given[0]["image"]
    assert image.shape == (2, 3, 4, 4) and image[0, 0, 0, 0] == 0 and image[0, 2, 3, 3] == 1
    assert given[0]["target"].shape == given[0]["source"].shape == (2, 5) and not given[0]["weight"].any()
