"""Evaluators over arrays: against formulas written here, against the command, and against each other."""

import threading

import numpy as np
import pytest

import sextic
from sextic import evaluators

ANGLES = {"alpha_0", "alpha_g", "beta_b", "gamma_r", "theta_0"}
SPRING = """# A spring
```sextic
parameter m : kg > 0
parameter k : N/m > 0
evaluator (1) frequency: omega = sqrt(k/m)
domain m = [1, 2], k = [1, 2]
```
"""


def shipped():
    return [name for name in dir(evaluators) if name != "Evaluator"]


def points(evaluator, shape, seed=1):
    """Quantities at random, with the mass centre nearer than the radius of gyration."""
    random = np.random.default_rng(seed)
    given = {name: random.uniform(1.0, 2.0, shape) for name in evaluator.inputs}
    return {name: own / 8 if name == "L_g" else own for name, own in given.items()}


def closed_form(m, r, L_g, alpha_g, theta_0, rho, D, U, S_xx, S_xy, S_yx, S_yy, S_xt, S_yt, S_tx, S_ty, S_tt):
    """Equations (21) to (23) of He & Macdonald (2017), by hand."""
    c, s = np.cos(alpha_g + theta_0), np.sin(alpha_g + theta_0)
    first = -(S_xx * s**2 + S_yy * c**2 + (S_xy + S_yx) * s * c + S_tt)
    second = (S_ty + S_yt) * c + (S_xt + S_tx) * s
    scale = rho * D * U / (8 * m)
    return (
        scale * r / (r - L_g) * (first + second),
        -2 * scale * (S_xx + S_yy + S_tt + first),
        scale * r / (r + L_g) * (first - second),
    )


@pytest.mark.parametrize("shape", [(), (1,), (7,), (513,), (3, 1, 40)])
def test_the_closed_form_is_that_of_the_paper(shape):
    given = points(evaluators.closed_form, shape)
    found = evaluators.closed_form(**given)
    assert found._fields == ("lamda_R1", "lamda_R2", "lamda_R3")
    for own, expected in zip(found, closed_form(**given)):
        assert own.shape == shape and own.dtype == np.float64
        np.testing.assert_allclose(own, expected, rtol=1e-11, atol=1e-12)


# The command reads all documents each time.
@pytest.mark.parametrize("name", ["closed_form_in_wind", "no_wind_modes"])
def test_shipped_evaluators_give_the_bits_of_the_command(name, command):
    evaluator = getattr(evaluators, name)
    given = {own: float(value) for own, value in points(evaluator, ()).items()}
    settings = [word for own, value in given.items() for word in ("--set", f"{own}={value!r}")]
    expected = command("evaluate", name, *settings, "--format", "json")["outputs"]
    assert evaluator(**given)._asdict() == expected


def test_compiled_evaluators_give_the_bits_of_shipped_ones(audits):
    seen = []
    for audit in audits:
        for name in audit.evaluators:
            compiled, own = sextic.compile(audit, name), getattr(evaluators, name)
            assert sorted(compiled.inputs) == sorted(own.inputs) and compiled.outputs.keys() == own.outputs.keys()
            given = points(own, (700,))
            # What is the same everywhere is computed once, and must not differ for that.
            for few in (given, {key: array if place % 3 else array[0] for place, (key, array) in enumerate(given.items())}):
                for one, other in zip(compiled(**few), own(**few)):
                    np.testing.assert_array_equal(one, other)
            for ours, theirs in zip(compiled(**given, bounds=True), own(**given, bounds=True)):
                np.testing.assert_allclose(ours, theirs, rtol=1e-6)
            seen.append(name)
    assert sorted(seen) == sorted(shipped())


def test_arrays_are_broadcast_whatever_their_layout():
    evaluator = evaluators.closed_form
    given = points(evaluator, (4, 6))
    expected = evaluator(**given)
    layouts = {
        "m": np.asfortranarray(given["m"]),
        "r": np.repeat(given["r"], 2, axis=1)[:, ::2],
        "D": given["D"][::-1][::-1],
        "U": given["U"].tolist(),
    }
    for own, other in zip(evaluator(**{**given, **layouts}), expected):
        np.testing.assert_array_equal(own, other)
    row, column = given["rho"][:1], given["U"][:, :1]
    wide = evaluator(**{**given, "rho": row, "U": column})
    whole = evaluator(**{**given, "rho": np.repeat(row, 4, axis=0), "U": np.repeat(column, 6, axis=1)})
    np.testing.assert_array_equal(wide, whole)
    assert evaluator(**{**given, "m": 2, "r": np.float32(1.5)}).lamda_R1.shape == (4, 6)


@pytest.mark.parametrize("dtype", ["int8", "uint16", "int64", "float16", "float32", ">f8", "longdouble"])
def test_other_types_become_doubles(dtype):
    speeds = np.array([1, 2, 3], dtype=dtype)
    found = evaluators.damping_coefficient(m=1.0, rho=1.0, D=1.0, U=speeds, lamda_R=-1.0)
    np.testing.assert_array_equal(found.S, 4.0 / np.array([1.0, 2.0, 3.0]))


def test_no_point_gives_no_value():
    given = points(evaluators.closed_form, (0, 3))
    for found in (evaluators.closed_form(**given), *evaluators.closed_form(**given, bounds=True)):
        assert {own.shape for own in found} == {(0, 3)}


def test_nothing_that_is_given_is_written_to():
    speeds = np.array([1.0, 2.0])
    speeds.flags.writeable = False
    own = sextic.compile(SPRING, "frequency")
    found = own(k=speeds, m=1.0)
    found.omega[:] = 0.0
    np.testing.assert_array_equal(speeds, [1.0, 2.0])


def test_what_has_no_value_is_not_a_number():
    speeds = np.array([1.0, np.nan, 0.0, np.inf])
    found = evaluators.damping_coefficient(m=1.0, rho=1.0, D=1.0, U=speeds, lamda_R=-1.0).S
    np.testing.assert_array_equal(found, [4.0, np.nan, np.inf, 0.0])
    values, errors = evaluators.damping_coefficient(m=1.0, rho=1.0, D=1.0, U=speeds, lamda_R=-1.0, bounds=True)
    np.testing.assert_array_equal(np.isinf(errors.S), [False, True, True, True])
    assert np.isnan(values.S[1])


def test_masks_go_through():
    speeds = np.ma.array([1.0, 2.0, 3.0], mask=[False, True, False])
    found = evaluators.damping_coefficient(m=1.0, rho=1.0, D=[[1.0], [2.0]], U=speeds, lamda_R=-1.0).S
    np.testing.assert_array_equal(found.mask, [[False, True, False]] * 2)
    assert found[1, 0] == 2.0


def test_bounds_hold_what_is_exact():
    longer = points(evaluators.closed_form, (300,))
    values, errors = evaluators.closed_form(**longer, bounds=True)
    for value, error, plain in zip(values, errors, evaluators.closed_form(**longer)):
        np.testing.assert_array_equal(value, plain)
        assert (error > 0).all() and (error < 1e-12).all()
    # In longer numbers, from the doubles that sine and cosine are.
    given = {name: own.astype(np.longdouble) for name, own in longer.items()}
    turned = longer["alpha_g"] + longer["theta_0"]
    c, s = np.cos(turned).astype(np.longdouble), np.sin(turned).astype(np.longdouble)
    damping = given["S_xx"] * s**2 + given["S_yy"] * c**2 + (given["S_xy"] + given["S_yx"]) * s * c
    exact = -given["rho"] * given["D"] * given["U"] / (4 * given["m"]) * (given["S_xx"] + given["S_yy"] - damping)
    assert (abs(values.lamda_R2 - exact) <= errors.lamda_R2 + 1e-14).all()


def test_degrees_and_hertz_are_known():
    degrees = evaluators.small_motion(theta_0_deg=30, L_b=1, beta_b_deg=[0, 90], a_x=0, a_y=0, a_theta=1)
    angles = evaluators.small_motion(
        theta_0=30 * (np.pi / 180), L_b=1, beta_b=np.array([0, 90]) * (np.pi / 180), a_x=0, a_y=0, a_theta=1
    )
    np.testing.assert_array_equal(degrees, angles)
    given = dict(r=1.0, L_g=0.1, alpha_g=0.0, theta_0=0.0)
    one, other = evaluators.no_wind_modes(**given, f_n=2.0), evaluators.no_wind_modes(**given, omega_n=4 * np.pi)
    assert one == other


@pytest.mark.parametrize(
    "given, words",
    [
        (dict(m=1, rho=1, D=1, U=1), "damping_coefficient needs lamda_R too"),
        (dict(m=1, rho=1, D=1, U=1, lamdaR=1), "did you mean `lamda_R`"),
        (dict(m=1, rho=1, D=1, U=1, lamda_R=1, extra=1), "has no quantity `extra`"),
        (dict(m=1, rho=1, D=1, U=[1, 2], lamda_R=[1, 2, 3]), r"do not fit together: U \(2,\), lamda_R \(3,\)"),
        (dict(m=1, rho=1, D=1, U=1j, lamda_R=1), "`U` is an array of complex128"),
        (dict(m="1", rho=1, D=1, U=1, lamda_R=1), "`m` is an array of <U1"),
        (dict(m=None, rho=1, D=1, U=1, lamda_R=1), "`m` is an array of object"),
        (dict(m=True, rho=1, D=1, U=1, lamda_R=1), "`m` is an array of bool"),
        (dict(m=[[1], [1, 2]], rho=1, D=1, U=1, lamda_R=1), "`m` is no array"),
        (dict(m=10**400, rho=1, D=1, U=1, lamda_R=1), "`m` is an array of object"),
    ],
)
def test_what_cannot_be_used_is_told(given, words):
    with pytest.raises(sextic.InputError, match=words):
        evaluators.damping_coefficient(**given)


def test_unknown_evaluators_are_told_with_what_is_meant(paper):
    with pytest.raises(AttributeError, match="did you mean `closed_form`"):
        evaluators.closed_forn
    with pytest.raises(sextic.InputError, match="did you mean `closed_form`"):
        sextic.compile(paper, "closed_forn")


def test_quantities_can_be_fixed():
    free, fixed = sextic.compile(SPRING, "frequency"), sextic.compile(SPRING, "frequency", fix={"m": "4"})
    assert list(fixed.inputs) == ["k"]
    np.testing.assert_array_equal(fixed(k=[16.0, 4.0]), free(k=[16.0, 4.0], m=4.0))
    constant = sextic.compile(SPRING, "frequency", fix={"m": 4, "k": 16})
    assert constant().omega == 2.0
    for fix, words in [({"n": 1}, "rests on `n`"), ({"m": -1}, "does not allow"), ({"m": "x"}, "no decimal number")]:
        with pytest.raises(sextic.InputError, match=words):
            sextic.compile(SPRING, "frequency", fix=fix)


def test_angles_can_be_fixed(paper):
    given = points(evaluators.closed_form, (5,))
    own = sextic.compile(paper, "closed_form", fix={"alpha_g": 0, "theta_0": 0})
    assert not ANGLES & own.inputs.keys()
    level = evaluators.closed_form(**{**given, "alpha_g": 0.0, "theta_0": 0.0})
    found = own(**{name: given[name] for name in own.inputs})
    np.testing.assert_allclose(found, level, rtol=1e-12)


def test_a_document_that_is_not_as_it_says_is_not_compiled():
    with pytest.raises(sextic.InputError, match="not every verdict on text is as it expects"):
        sextic.compile(SPRING.replace("domain", "claim (2): k == 2*k\ndomain"), "frequency")
    with pytest.raises(sextic.DocumentError) as raised:
        sextic.compile(SPRING.replace("sqrt(k/m)", "sqrt(k/M)"), "frequency")
    assert raised.value.line == 5


def test_threads_compute_beside_each_other():
    given = points(evaluators.closed_form, (50_000,))
    expected = evaluators.closed_form(**given)
    found = []
    threads = [threading.Thread(target=lambda: found.append(evaluators.closed_form(**given))) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(found) == 4
    for own in found:
        np.testing.assert_array_equal(own, expected)


def test_every_evaluator_says_what_it_takes_and_gives():
    for name in shipped():
        evaluator = getattr(evaluators, name)
        for quantity, text in {**evaluator.inputs, **evaluator.outputs}.items():
            assert text and f"- {quantity}: {text}" in evaluator.__doc__
            assert "As in" not in text
        assert name in repr(evaluator)
