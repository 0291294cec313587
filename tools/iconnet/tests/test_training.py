import dataclasses

import numpy as np
import pytest
import torch
from torch.nn import functional as F

from iconnet import curves, data, evaluate, export, guide, networks, split, train
from iconnet.adversaries import Adversaries
from iconnet.errors import MissingStep, WordError
from iconnet.places import Places
from iconnet.words import EMBED, NOTHING


def test_a_step_that_is_missing_is_named(tmp_path):
    with pytest.raises(MissingStep, match="iconnet prepare"):
        data.icons(Places(tmp_path))
    with pytest.raises(MissingStep, match="iconnet train b"):
        export.trained(Places(tmp_path), "b")


def test_lessons_share_no_icon_and_hold_no_tested_one(places):
    icons, words = data.icons(places), data.texts(places)
    guides, judges = (data.lesson(icons, words, reader) for reader in ("guide", "judge"))
    assert not set(guides.rows) & set(judges.rows)
    for lesson in (guides, judges):
        assert not any(split.held_out(icons.names[i]) or icons.sources[i] == "openmoji" for i in lesson.rows)
        assert np.array_equal(lesson.vocabulary[-1], NOTHING)
        assert lesson.odds.sum() == pytest.approx(1)


def test_an_answer_is_nearest_to_its_own_name(places):
    icons, words = data.icons(places), data.texts(places)
    lesson = data.lesson(icons, words, "guide")
    for row, answer in zip(lesson.rows, lesson.answer):
        assert (lesson.vocabulary @ answer).argmax() == (lesson.vocabulary @ torch.from_numpy(words[icons.names[row]])).argmax()


@pytest.mark.parametrize("name", networks.FORMS)
def test_networks_are_small_and_smooth(name):
    network = networks.seeded(name, 0).double().eval()
    assert sum(p.numel() for p in network.parameters()) < 1.1e6
    ink = torch.rand(2, 1, 64, 64, dtype=torch.float64, generator=torch.Generator().manual_seed(0)).requires_grad_(True)
    value = lambda x: network(x).square().sum()
    (slope,) = torch.autograd.grad(value(ink), ink)
    step = torch.zeros_like(ink)
    step[0, 0, 30, 31] = 1e-4
    with torch.no_grad():
        wanted = (value(ink + step) - value(ink - step)) / 2e-4
    assert slope[0, 0, 30, 31].item() == pytest.approx(wanted.item(), rel=1e-4)


@pytest.fixture(scope="module")
def learnt(places):
    """Network `a` after a short training on the made-up icons."""
    plan = dataclasses.replace(train.PLANS["a"], wires=0.3, hurt=0.5)
    with pytest.MonkeyPatch.context() as patch:
        for name, value in {"BATCH": 24, "AGAIN": 8, "POOL": 8, "FOES": 4}.items():
            patch.setattr(train, name, value)
        train.train(places, "a", 120, plan=plan, say=lambda *_: None)
    return export.trained(places, "a").requires_grad_(False)


def test_training_learns_what_is_shown_and_that_tangles_are_nothing(places, learnt):
    icons, words = data.icons(places), data.texts(places)
    which = evaluate.rows(icons, "openmoji")
    names = [icons.names[i] for i in which]
    shown = evaluate.embeddings(learnt, icons.pictures[which])
    assert evaluate.recall(evaluate.ranks(shown, names, words), len(names)).first >= 0.6
    tangles = curves.basis(40, 384) @ curves.random_controls(32, 40, torch.Generator().manual_seed(9))
    with torch.no_grad():
        nothing = F.normalize(learnt(curves.draw(tangles, torch.full((32,), 2.0))), dim=1)[:, -1].mean()
    assert nothing > shown[:, -1].mean() + 0.2


def test_training_is_seeded(places):
    runs = []
    for _ in range(2):
        train.train(places, "b", 3, say=lambda *_: None)
        runs.append(export.trained(places, "b").state_dict())
    assert all(torch.equal(runs[0][key], runs[1][key]) for key in runs[0])


def test_adversaries_climb_and_start_again(places, learnt):
    words = torch.from_numpy(np.stack(list(data.texts(places).values())))
    foes = Adversaries(4, words, torch.Generator().manual_seed(0))
    foes.age[:] = 0
    reached = [foes.turn(learnt, 4)[1] for _ in range(20)]
    assert np.mean(reached[-3:]) > np.mean(reached[:3]) + 0.05
    foes.age[:] = 99
    ink, _ = foes.turn(learnt, 4)
    assert foes.age.max() == 1 and ink.shape == (4, 1, 64, 64)


def test_guide_raises_the_cosine_and_stays_in_the_picture(places, learnt):
    row = list(data.texts(places).values())[1]  # not the ring, which the curve starts as
    settings = guide.Settings(steps=25, views=2, controls=24)
    ink, cosine = guide.guide([learnt], row, settings)
    _, before = guide.guide([learnt], row, dataclasses.replace(settings, steps=0))
    assert cosine > before + 0.05
    assert ink.shape == (1, 1, 64, 64) and ink[..., 0, :].max() < 0.5


def test_a_judge_ranks_what_is_shown_first_and_names_an_unknown_word(places, learnt):
    icons, words = data.icons(places), data.texts(places)
    judge = guide.Judge(learnt, icons, words)
    which = evaluate.rows(icons, "openmoji")
    ranks = [judge(torch.from_numpy(icons.pictures[i][None, 16:80, 16:80] / np.float32(255))[None], icons.names[i])[0] for i in which]
    assert np.median(ranks) <= 2
    with pytest.raises(WordError, match="'gnu'"):
        guide.trial([learnt], judge, ["gnu"], words, guide.Settings(steps=1))
