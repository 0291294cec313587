"""Writes the wires of this folder that are made by formula. Usage: make.py, in this folder."""

import json
from math import cos, pi, sin


def write(name, points, knots, closed=False, form="spline"):
    wire = {"format": "wire4d", "version": 1, "form": form, "closed": closed, "knots": knots}
    wire["control_points"] = [[round(x, 5) for x in point] for point in points]
    with open(f"{name}.json", "w") as file:
        file.write(json.dumps(wire, separators=(",", ":")) + "\n")


def clamped(count, repeated=1):
    """Knots of an open wire: every inner one so many times."""
    inner = [k for k in range(1, (count - 4) // repeated + 1) for _ in range(repeated)]
    end = (inner[-1] if inner else 0) + 1
    return [0] * 4 + inner + [end] * 4


def periodic(spans):
    """Knots of a closed wire with spans of these lengths."""
    knots = [0]
    for span in spans:
        knots.append(knots[-1] + span)
    end = knots[-1]
    return [x - end for x in knots[-4:-1]] + knots + [x + end for x in knots[1:4]]


def smooth():
    count = 40
    turn = lambda i: 2 * pi * i / count
    points = [[0.6 * cos(turn(i)), 0.4 * sin(2 * turn(i)), 0.3 * cos(3 * turn(i) + 0.7), 0.012] for i in range(count)]
    write("smooth", points, periodic([1 + i % 3 for i in range(count)]), closed=True)


def kinked():
    corners = [[0.7 * cos(4 * pi * i / 7), 0.7 * sin(4 * pi * i / 7), 0.02 * i, 0.01] for i in range(8)]
    points = []
    for a, b in zip(corners, corners[1:]):
        points += [a, a, a] + [[x + (y - x) * k / 4 for x, y in zip(a, b)] for k in (1, 2, 3)]
    points += [corners[-1]] * 3
    write("kinked", points, clamped(len(points)))


def coil():
    count = 120
    points = [[0.4 * cos(pi * i / 10), 0.0004 * i - 0.03, 0.4 * sin(pi * i / 10), 0.007] for i in range(count)]
    points += [[0.4 + 0.08 * k, 0.018, -0.01 * k * k, 0.007] for k in range(1, 6)]
    write("coil", points, clamped(len(points)))


def knot():
    count = 60
    def point(i):
        a = 2 * pi * i / count
        return [0.2 * (sin(a) + 2 * sin(2 * a)), 0.2 * (cos(a) - 2 * cos(2 * a)), -0.015 * sin(3 * a), 0.06 + 0.04 * cos(a)]
    write("knot", [point(i) for i in range(count)], periodic([1] * count), closed=True)


def chain():
    points = [[0.05 * i - 0.6, 0.25 * sin(1.9 * i), 0.25 * cos(2.3 * i), 0.02 + 0.01 * sin(i)] for i in range(25)]
    write("chain", points, clamped(25, repeated=3), form="chain")


def bag():
    points = [[0.5 * sin(1.7 * i), 0.5 * cos(2.9 * i), 0.3 * sin(0.8 * i), 0.03] for i in range(24)]
    write("bag", points, clamped(24, repeated=4), form="bag")


for make in (smooth, kinked, coil, knot, chain, bag):
    make()
