"""What a point contributes to forces and stiffness where a locking cure changes its volume.

With F the gradient of a point, C = cof F, J = det F, theta = P J as the cure projects it, s = (theta / J)^(1/3),
Fbar = s F, Pbar the first Piola stress there, pi = Pbar : Fbar / 3, p = pi / theta, the forces are those of

    A + (P p) C,     A = s Pbar - pi F^-T

in which A and p depend on the point's own F and theta only: dA = A_F dF + A_theta dtheta, dp = m dF + n dtheta.
"""

from core_models.compilation import beside_kernel
from core_models.tensors import THIRD

# Vectors of nine numbers: F, C, F^-T, A + (P p) C, A_theta, m, products of the tangent and Fbar.
GRADIENT, COFACTOR, INVERSE, FORCE, OWN, MEAN, _RIGHT, _LEFT = range(8)
VECTORS = 8


@beside_kernel
def put_cofactor(gradients, k, factor, vectors):
    """Write F = factor Fbar of point k and its cofactor to the vectors; det Fbar."""
    for row in range(9):
        vectors[GRADIENT, row] = factor * gradients[k, row // 3, row % 3]
    for i in range(3):
        for j in range(3):
            i1, i2, j1, j2 = (i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3
            vectors[COFACTOR, 3 * i + j] = (
                vectors[GRADIENT, 3 * i1 + j1] * vectors[GRADIENT, 3 * i2 + j2]
                - vectors[GRADIENT, 3 * i1 + j2] * vectors[GRADIENT, 3 * i2 + j1]
            )
    ratio = 0.0
    for j in range(3):
        ratio += vectors[GRADIENT, j] * vectors[COFACTOR, j]
    return ratio / (factor * factor * factor)


@beside_kernel
def linearise_point(v, b, gradients, s, stresses, tangents, k, pressure):
    """Write F, C, F^-T, A + (P p) C, A_theta and m of point k to the vectors v (VECTORS, 9).

    b (9, 9) : A_F + (P p) dC/dF, written. gradients (n, 3, 3) : Fbar. s : of the point. stresses (n, 3, 3),
    tangents (n, 9, 9) : Pbar and its derivative [Pa]. pressure : (P p) [Pa]. Returns n.
    """
    theta = put_cofactor(gradients, k, 1.0 / s, v)
    ratio = theta / (s * s * s)
    stress_work, tangent_work = 0.0, 0.0
    for i in range(9):
        v[INVERSE, i] = v[COFACTOR, i] / ratio
        v[_RIGHT, i], v[_LEFT, i] = 0.0, 0.0
        for j in range(9):
            v[_RIGHT, i] += tangents[k, i, j] * v[GRADIENT, j]
            v[_LEFT, i] += tangents[k, j, i] * v[GRADIENT, j]
        stress_work += stresses[k, i // 3, i % 3] * v[GRADIENT, i]
    for i in range(9):
        tangent_work += v[GRADIENT, i] * v[_RIGHT, i]
    energy = s * stress_work * THIRD
    energy_theta = (s * s * tangent_work + s * stress_work) * THIRD * THIRD / theta
    for i in range(9):
        stress = stresses[k, i // 3, i % 3]
        slope = s * s * (v[_LEFT, i] - tangent_work * THIRD * v[INVERSE, i])
        slope = THIRD * (slope + s * (stress - stress_work * THIRD * v[INVERSE, i]))
        v[MEAN, i] = slope / theta
        v[OWN, i] = s * THIRD / theta * (stress + s * v[_RIGHT, i]) - energy_theta * v[INVERSE, i]
        v[FORCE, i] = s * stress + (pressure * ratio - energy) * v[INVERSE, i]
    for i in range(9):
        stress = stresses[k, i // 3, i % 3]
        for j in range(9):
            twist = v[INVERSE, 3 * (i // 3) + j % 3] * v[INVERSE, 3 * (j // 3) + i % 3]
            b[i, j] = (
                s * s * (tangents[k, i, j] - THIRD * v[_RIGHT, i] * v[INVERSE, j])
                - s * THIRD * stress * v[INVERSE, j]
                - v[INVERSE, i] * (theta * v[MEAN, j] - pressure * ratio * v[INVERSE, j])
                + (energy - pressure * ratio) * twist
            )
    return (energy_theta - energy / theta) / theta
