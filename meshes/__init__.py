"""Meshes of axisymmetric bodies: parametrised geometries, quality figures, reading and writing files.

A mesh lies in the (r, z) plane: the radius r is x, the axial coordinate z is y, lengths are in metres.
"""

DISTRIBUTION = "matpoint"
