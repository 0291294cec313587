import numpy as np
import pytest
import torch

from iconnet import curves, icons, render, views, wires
from iconnet.errors import DataError

RING = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><circle cx="12" cy="12" r="9" fill="none" stroke="currentColor" stroke-width="2"/></svg>'
TWO = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="M3 4h18M3 20h18" stroke="#000" stroke-width="2"/></svg>'
DISC = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><circle cx="12" cy="12" r="9"/></svg>'


def test_ink_is_dark_on_white_and_in_the_middle():
    ink = render.ink(RING)
    assert ink.shape == (render.SIDE, render.SIDE) and ink.dtype == np.uint8
    assert ink[0, 0] == 0 and ink.max() > 250 and ink[48, 48] == 0
    assert np.abs(ink.astype(int) - ink[::-1, ::-1]).max() < 40


def test_what_is_no_svg_is_named():
    with pytest.raises(DataError, match="cannot be drawn"):
        render.ink("<svg")


def test_a_ring_gives_one_line_and_a_disc_its_outline():
    (ring,) = wires.lines(render.ink(RING))
    (disc,) = wires.lines(render.ink(DISC))
    for line, radius in ((ring, 9 / 24 * render.BOX), (disc, 9 / 24 * render.BOX)):
        away = np.linalg.norm(line - 47.5, axis=1)
        assert np.abs(away - radius).max() < 2
        assert np.linalg.norm(line[0] - line[-1]) < 3


def test_joined_goes_through_all_strokes_once():
    strokes = wires.lines(render.ink(TWO))
    assert len(strokes) == 2
    path = wires.joined(strokes, np.random.default_rng(0))
    assert len(path) == sum(map(len, strokes))
    assert len(np.unique(path, axis=0)) == len(path)


def test_a_wire_links_what_the_icon_does_not():
    ink = render.ink(TWO)
    wire = wires.wire(wires.lines(ink), np.random.default_rng(1))
    between = slice(35, 60)
    assert ink[between].max() == 0 and wire[between].max() > 100


@pytest.mark.parametrize(
    "source, variant, name",
    [("ph", "traffic-signal-bold", "traffic signal"), ("lucide", "traffic-light", "traffic light"), ("mdi", "cat-outline", "cat")],
)
def test_names_lose_their_own_sets_styles_only(source, variant, name):
    assert icons.words(icons.base(source, variant)) == name


def test_views_differ_and_stay_ink():
    pictures = torch.from_numpy(np.stack([render.ink(RING)] * 8))
    found = views.views(pictures, torch.Generator().manual_seed(0))
    assert found.shape == (8, 1, 64, 64) and 0 <= found.min() and found.max() <= 1
    assert (found[0] - found[1]).abs().max() > 0.3
    assert torch.equal(found, views.views(pictures, torch.Generator().manual_seed(0)))


def test_a_curves_ink_has_the_gradient_of_finite_differences():
    random = torch.Generator().manual_seed(0)
    controls = curves.random_controls(1, 20, random).double().requires_grad_(True)
    basis, weight = curves.basis(20, 200).double(), torch.rand(1, 1, 64, 64, generator=random).double()
    value = lambda c: (curves.draw(basis @ c, torch.tensor([2.0])) * weight).sum()
    (slope,) = torch.autograd.grad(value(controls), controls)
    for k in (0, 7, 19):
        step = torch.zeros_like(controls)
        step[0, k, 1] = 1e-4
        with torch.no_grad():
            wanted = (value(controls + step) - value(controls - step)) / 2e-4
        assert abs(float(wanted - slope[0, k, 1])) < 1e-3 * max(1, abs(float(wanted)))


def test_a_line_is_as_dark_however_densely_it_is_sampled():
    ring = curves.ring_controls(1, 32, torch.Generator().manual_seed(0), noise=0)
    coarse, fine = (curves.draw(curves.basis(32, n) @ ring, torch.tensor([2.0])) for n in (256, 1024))
    assert 0.8 < coarse.max() < 0.98
    assert (coarse - fine).abs().max() < 0.03
