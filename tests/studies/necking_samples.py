"""What the tests of the necking study share: the shipped bar, made curves, a scene of one coarse run."""

import numpy as np
from lxml import etree

from studies.necking.bar_necking import NeckingHistory
from studies.necking.reader import CHECKS, necking_scenes, read_necking_scene

SIMO = read_necking_scene("necking-simo")


def history(elongation, force, **columns):
    """A history with these columns, the others 0."""
    columns |= {"elongation": elongation, "force": force}
    rows = np.zeros((len(elongation), len(NeckingHistory.COLUMNS)))
    for name, values in columns.items():
        rows[:, NeckingHistory.COLUMNS.index(name)] = values
    return NeckingHistory(rows.tolist())


def small(name):
    """The shipped bar with one coarse run and one check that it does not meet."""
    root = etree.parse(necking_scenes()["necking-simo"]).getroot()
    for tag in ("run", "curve", *CHECKS):
        for element in root.findall(tag):
            root.remove(element)
    root.set("name", name)
    run = {
        "name": "one",
        "method": "fem-implicit",
        "across": "2",
        "along": "4",
        "increments": "3",
        "quick": "yes",
    }
    etree.SubElement(root, "run", run)
    etree.SubElement(root, "expect", run="one", quantity="peak_force", low="1", high="2")
    return etree.tostring(root, encoding="unicode")
