"""Damping coefficients of the example cases, by NumPy and from the forces themselves.

    python3 tests/data/stability/reference.py > tests/data/stability/reference.csv

Nothing is shared with the project: forces are those of the quasi-steady theory at a moving section, the
damping matrix is their derivative by central differences, and so is aerodynamic stiffness, the spline is solved as a circulant system, and
eigenvalues are those of numpy.linalg.eigvals.
"""

import csv
import pathlib
import tomllib

import numpy as np

CASES = pathlib.Path(__file__).parents[3] / "derivations" / "cases"

# What each variant changes in a case file: (table, key, value).
VARIANTS = {
    "tuned": ("tuned", []),
    "tuned, no eccentricity": ("tuned", [("section", "L_g", 0.0)]),
    "tuned, strong wind": ("tuned", [("wind", "U", 90.0)]),
    "tuned, wind turned": ("tuned", [("sweep", "turn", "wind"), ("section", "alpha_g_deg", 20.0)]),
    "light": ("light", []),
    "detuned": ("detuned", []),
    "detuned, no eccentricity": ("detuned", [("section", "L_g", 0.0)]),
    "detuned, no damping": (
        "detuned",
        [("structure", "zeta_x", 0.0), ("structure", "zeta_y", 0.0), ("structure", "zeta_theta", 0.0)],
    ),
    "detuned, heave and turn": ("detuned", [("structure", "free", ["y", "theta"])]),
    "stiff": ("stiff", []),
    "stiff, strong wind": ("stiff", [("wind", "U", 20.0)]),
}


def spline(angles, values):
    """Value and slope per radian of a periodic cubic spline on a uniform grid, by its second derivatives."""
    n = len(values)
    h = np.radians(angles[1] - angles[0])
    system = np.zeros((n, n))
    right = np.zeros(n)
    for i in range(n):
        system[i, (i - 1) % n] += h / 6
        system[i, i] += 2 * h / 3
        system[i, (i + 1) % n] += h / 6
        right[i] = (values[(i + 1) % n] - 2 * values[i] + values[(i - 1) % n]) / h
    second = np.linalg.solve(system, right)

    def at(angle):
        place = np.radians(angle % 360) / h
        i = int(np.floor(place + 1e-12)) % n
        j = (i + 1) % n
        b = place - i
        a = 1 - b
        value = a * values[i] + b * values[j] + ((a**3 - a) * second[i] + (b**3 - b) * second[j]) * h**2 / 6
        slope = (values[j] - values[i]) / h + (-(3 * a**2 - 1) * second[i] + (3 * b**2 - 1) * second[j]) * h / 6
        return value, slope

    return at


def forces(case, coefficients, alpha_0, theta_0, velocity, turn=0.0):
    """F_x, F_y, F_theta on a section that moves, or is turned."""
    s, w = case["section"], case["wind"]
    beta = np.radians(s["gamma_r_deg"]) + theta_0
    velocity_a = np.array(
        [
            velocity[0] + s["L_a"] * velocity[2] * np.sin(beta),
            velocity[1] + s["L_a"] * velocity[2] * np.cos(beta),
        ]
    )
    u, v = w["U"] * np.array([np.cos(alpha_0), np.sin(alpha_0)]) - velocity_a
    speed = np.hypot(u, v)
    turned = np.arctan2(v, u) - alpha_0
    turned -= 2 * np.pi * np.round(turned / (2 * np.pi))
    cd, cl, cm = (value + slope * (turned + turn) for value, slope in coefficients)
    pressure = 0.5 * w["rho"] * s["D"] * speed**2
    along, across = np.array([u, v]) / speed, np.array([-v, u]) / speed
    drag_and_lift = pressure * (cd * along + cl * across)
    return np.array([*drag_and_lift, pressure * s["D"] * cm])


def answers(case, curves, angle):
    s, t, w = case["section"], case["structure"], case["wind"]
    alpha = np.radians(angle)
    alpha_0, theta_0 = (0, alpha) if case["sweep"]["turn"] == "section" else (alpha, 0)
    coefficients = [curve(angle) for curve in curves]
    c_a = np.zeros((3, 3))
    for column in range(3):
        step = np.zeros(3)
        step[column] = 1e-3 * w["U"] * (1 if column < 2 else 1 / s["r"])

        def slope(factor):
            ahead = forces(case, coefficients, alpha_0, theta_0, factor * step)
            behind = forces(case, coefficients, alpha_0, theta_0, -factor * step)
            return (ahead - behind) / (2 * factor * step[column])

        # Richardson: the error of order 2 is taken out.
        c_a[:, column] = -(4 * slope(0.5) - slope(1)) / 3
    m, r, lg = s["m"], s["r"], s["L_g"]
    phi = np.radians(s["alpha_g_deg"]) + theta_0
    mass = m * np.array(
        [[1, 0, lg * np.sin(phi)], [0, 1, lg * np.cos(phi)], [lg * np.sin(phi), lg * np.cos(phi), r**2]]
    )
    inertia = np.array([m, m, m * r**2])
    omega = 2 * np.pi * np.array([t["f_x"], t["f_y"], t["f_theta"]])
    zeta = np.array([t["zeta_x"], t["zeta_y"], t["zeta_theta"]])
    damping = c_a + np.diag(2 * inertia * omega * zeta)
    stiffness = np.diag(inertia * omega**2)
    if w.get("aerodynamic_stiffness", False):
        at_rest = lambda turn: forces(case, coefficients, alpha_0, theta_0, np.zeros(3), turn)
        stiffness[:, 2] -= (at_rest(1e-3) - at_rest(-1e-3)) / 2e-3
    free = [["x", "y", "theta"].index(name) for name in t.get("free", ["x", "y", "theta"])]
    mass, damping, stiffness = (matrix[np.ix_(free, free)] for matrix in (mass, damping, stiffness))
    n = len(free)
    inverse = np.linalg.inv(mass)
    state = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ stiffness, -inverse @ damping]])
    scale = -4 * m / (w["rho"] * s["D"] * w["U"])
    exact = scale * max(np.linalg.eigvals(state).real)
    if len(set(omega)) > 1 or n < 3:
        return exact, None
    # Eqs. (21)-(23), by first-order perturbation: -phi' C phi / (2 phi' M phi).
    shapes = [
        [-r * np.sin(phi), -r * np.cos(phi), 1],
        [np.cos(phi), -np.sin(phi), 0],
        [r * np.sin(phi), r * np.cos(phi), 1],
    ]
    parts = [-(np.array(q) @ c_a @ q) / (2 * np.array(q) @ mass @ q) for q in shapes]
    return exact, scale * max(parts)


def main():
    with open(CASES / "formulas.csv") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    column = lambda name: np.array([float(row[name]) for row in rows])
    curves = [spline(column("alpha_deg"), column(name)) for name in ("CD", "CL", "CM")]
    print("variant;alpha_deg;s3d_exact;s3d_closed")
    for variant, (name, changes) in VARIANTS.items():
        case = tomllib.loads((CASES / f"{name}.toml").read_text())
        for table, key, value in changes:
            case[table][key] = value
        for angle in range(0, 181, 10):
            exact, closed = answers(case, curves, angle)
            closed = "" if closed is None else f"{closed:.9f}"
            print(f"{variant};{angle};{exact:.9f};{closed}")


main()
