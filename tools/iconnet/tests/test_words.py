import numpy as np
import pytest

from iconnet import split, table
from iconnet.data import Icons
from iconnet.errors import DataError, WordError
from iconnet.words import EMBED, NOTHING, Space, pairs, unit


def test_pairs_never_hold_a_held_out_word_nor_openmoji():
    names = [f"name {i}" for i in range(200)]
    icons = [("lucide", name, names) for name in names] + [("openmoji", "only there", ["tag"])]
    found = pairs(icons)
    assert 0 < len(found) < 200
    assert "only there" not in found
    everything = set(found).union(*found.values())
    assert not any(split.held_out(word) for word in everything)


def test_all_variants_of_an_icon_have_one_reader_and_both_readers_have_icons():
    readers = {name: split.reader("ph", name) for name in map(str, range(100))}
    assert set(readers.values()) == {"guide", "judge"}
    assert readers == {name: split.reader("ph", name) for name in map(str, range(100))}


def test_space_brings_names_near_their_tags():
    random = np.random.default_rng(0)
    meaning = random.normal(size=(300, 20))
    mix, noise = random.normal(size=(20, 384)), random.normal(size=(30, 384)) * 3
    said = lambda: (meaning @ mix + random.normal(size=(300, 30)) @ noise).astype(np.float32)
    rows = {f"n{i}": row for i, row in enumerate(said())}
    for k in range(3):
        rows |= {f"t{i}-{k}": row for i, row in enumerate(said())}
    space = Space.fit(rows, {f"n{i}": {f"t{i}-{k}" for k in range(3)} for i in range(300)})
    names = np.stack([rows[f"n{i}"] for i in range(300)])
    tags = np.stack([rows[f"t{i}-0"] for i in range(300)])
    hits = lambda a, b: float(((a @ b.T).argmax(1) == np.arange(300)).mean())
    assert hits(space(names), space(tags)) > hits(unit(names), unit(tags)) + 0.2
    assert np.allclose(np.linalg.norm(space(names), axis=1), 1, atol=1e-5)
    assert np.abs(space(names) @ NOTHING).max() == 0


def rows_of(words):
    random = np.random.default_rng(0)
    return {word: unit(random.normal(size=EMBED)).astype(np.float32) for word in words}


def test_table_gives_back_what_was_written(tmp_path):
    words = rows_of(["sail boat", "ant", "zebra"])
    size = table.write(words, tmp_path, "none")
    assert size == sum(file.stat().st_size for file in tmp_path.iterdir())
    found = table.Table(tmp_path)
    assert found.words == ["ant", "sail boat", "zebra"]
    for word, row in words.items():
        assert found[word] @ row > 0.999
        assert abs(np.linalg.norm(found[word]) - 1) < 1e-6


def test_table_names_the_word_it_lacks_and_refuses_other_bytes(tmp_path):
    table.write(rows_of(["ant"]), tmp_path, "none")
    with pytest.raises(WordError, match="'bee'"):
        table.Table(tmp_path)["bee"]
    (tmp_path / "words.bin").write_bytes(bytes(EMBED))
    with pytest.raises(DataError, match="words.bin"):
        table.Table(tmp_path)


def test_table_holds_every_tested_name_and_no_tag_of_openmoji():
    held = next(f"word {i}" for i in range(999) if split.held_out(f"word {i}"))
    icons = Icons(["lucide", "bi", "openmoji"], ["v", "v", "v"], [held, "cat", "whale"], [[], ["pet"], ["sea"]], None, None)
    assert table.chosen(icons, 3) == sorted([held, "whale", "cat"])
    assert "sea" not in table.chosen(icons, 9)
