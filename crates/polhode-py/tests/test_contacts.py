"""Forces of friction and impacts as functions of arrays: closed forms of each law, and bad input."""

import math

import numpy as np
import polhode as ph
import pytest

LAWS = ["reflection", "propagation", "simultaneous", "poisson", "energetic", "pulse"]
SINGLE_LAWS = ["stronge", "poisson", "newton", "whittaker", "chatterjee-ruina"]


def box_on_corners(mass=2.0, size=(1.0, 0.6, 0.4)):
    """A box whose four lower corners touch a floor: Delassus matrix, and velocities after a step of gravity of 1 s."""
    corners = [(x * size[0] / 2, y * size[1] / 2, -size[2] / 2) for x in (-1, 1) for y in (-1, 1)]
    square = [length * length for length in size]
    moments = mass / 12 * np.array([square[1] + square[2], square[0] + square[2], square[0] + square[1]])
    axes = np.eye(3)[[2, 0, 1]]
    rows = np.array([[*axis, *np.cross(corner, axis)] for corner in corners for axis in axes])
    inverse = np.diag(np.concatenate([np.full(3, 1 / mass), 1 / moments]))
    return rows @ inverse @ rows.T, rows


def test_a_box_at_rest_shares_its_load_among_its_corners():
    matrix, rows = box_on_corners()
    q = rows @ [0, 0, -9.81, 0, 0, 0]
    solution = ph.solve_friction(matrix, q, 0.5)
    assert solution.is_solved and solution.residual < 1e-12 and solution.squeeze is None
    assert solution.impulses.shape == (4, 3) and solution.contacts == ["stick"] * 4
    assert np.allclose(solution.impulses, [2.0 * 9.81 / 4, 0, 0], atol=1e-10)
    assert np.abs(solution.velocities).max() < 1e-11


@pytest.mark.parametrize("push, slides", [(0.4 * 9.81, False), (0.6 * 9.81, True)])
def test_a_box_that_is_pushed_slides_beyond_the_cone(push, slides):
    matrix, rows = box_on_corners()
    # Pushed at the height of its corners, where the push turns nothing.
    q = rows @ np.linalg.pinv(rows) @ rows @ [push, 0, -9.81, 0, 0, 0]
    solution = ph.solve_friction(matrix, q, [0.5] * 4)
    total = solution.impulses.sum(axis=0)
    assert solution.is_solved and total[0] == pytest.approx(2 * 9.81, rel=1e-9)
    assert math.hypot(total[1], total[2]) == pytest.approx(2 * min(push, 0.5 * 9.81), rel=1e-6)
    assert (solution.contacts == ["slide"] * 4) == slides


def test_the_order_of_contacts_and_the_start_do_not_matter():
    matrix, rows = box_on_corners()
    q = rows @ [1.0, 0.5, -9.81, 0.3, 0.2, 0.1]
    solution = ph.solve_friction(matrix, q, 0.3)
    order = np.array([6, 7, 8, 0, 1, 2, 9, 10, 11, 3, 4, 5])
    other = ph.solve_friction(matrix[np.ix_(order, order)], q[order], 0.3)
    assert np.allclose(other.impulses, solution.impulses[[2, 0, 3, 1]], atol=1e-8)
    again = ph.solve_friction(matrix, q.reshape(4, 3), 0.3, start=solution.impulses)
    assert again.is_solved and np.allclose(again.impulses, solution.impulses, atol=1e-8)


def test_contacts_in_a_plane_have_two_rows():
    solution = ph.solve_friction([[0.5, 0], [0, 0.5]], [-3.0, 4.0], [0.5])
    assert solution.impulses.tolist() == [[6.0, -3.0]] and solution.method == "gauss-seidel"


def test_bodies_that_are_squeezed_are_told():
    # A body between two walls that come nearer: no impulses keep both apart.
    matrix = np.zeros((6, 6))
    for (i, a) in ((0, 1.0), (3, -1.0)):
        for (j, b) in ((0, 1.0), (3, -1.0)):
            matrix[i, j] = a * b
    matrix[1, 1] = matrix[2, 2] = matrix[4, 4] = matrix[5, 5] = 1.0
    solution = ph.solve_friction(matrix, [-1.0, 0, 0, -1.0, 0, 0], 0.5)
    assert solution.status == "infeasible" and not solution.is_solved
    assert solution.squeeze.shape == (2,) and np.allclose(solution.squeeze, 1.0)


def test_no_contacts_have_no_impulses():
    solution = ph.solve_friction(np.zeros((0, 0)), [], [])
    assert solution.impulses.shape == (0, 3) and solution.is_solved
    assert ph.impact(np.zeros((0, 0)), [], 1.0).impulses.shape == (0,)


ONE = 0.5 * np.eye(3)
Q = [-3.0, 1.0, 0.0]


@pytest.mark.parametrize(
    "W, q, mu, says",
    [
        (np.eye(4), Q, 0.5, r"shape \(3, 3\)"),
        (ONE[0], Q, 0.5, "shape"),
        (ONE, Q[:2], 0.5, "three numbers for each"),
        (ONE, [[*Q], [*Q]], 0.5, "shape"),
        (ONE, Q, [0.5, 0.5], "2 contacts"),
        (ONE, Q, [[0.5]], "mu"),
        (ONE, Q, -0.1, "at least 0"),
        (ONE, Q, float("nan"), "mu: finite"),
        (ONE * float("nan"), Q, 0.5, "W: finite numbers are needed, found nan at"),
        (ONE, [float("inf"), 0, 0], 0.5, "q: finite numbers are needed, found inf at"),
        (ONE + [[0, 0.3, 0], [0, 0, 0], [0, 0, 0]], Q, 0.5, "symmetric"),
        (ONE + [[0, 2, 0], [2, 0, 0], [0, 0, 0]], Q, 0.5, "positive semidefinite"),
        (-ONE, Q, 0.5, "positive semidefinite"),
        ([[1, 2], [3]], Q, 0.5, "W"),
    ],
)
def test_bad_problems_are_refused(W, q, mu, says):
    with pytest.raises(ValueError, match=says):
        ph.solve_friction(W, q, mu)


OF_OTHER_KINDS = [(ONE * 1j, Q, 0.5), (ONE, ["a", "b", "c"], 0.5), (ONE, Q, "rough"), (ONE > 0, Q, 1)]


@pytest.mark.parametrize("W, q, mu", OF_OTHER_KINDS)
def test_other_kinds_of_numbers_are_refused(W, q, mu):
    with pytest.raises(TypeError, match="numbers"):
        ph.solve_friction(W, q, mu)


@pytest.mark.parametrize("law", LAWS)
def test_a_ball_against_a_wall_leaves_with_its_restitution(law):
    for e in (0.0, 0.4, 1.0):
        ball = ph.impact([[0.5]], [-3.0], e, law=law)
        assert ball.velocities[0] == pytest.approx(3.0 * e, abs=1e-12)
        assert ball.impulses[0] == pytest.approx(2.0 * 3.0 * (1 + e))
        assert ball.energy_change == pytest.approx(-(1 - e * e) * 9.0, abs=1e-12)
    assert ph.impact([[0.5]], [3.0], 1.0, law=law).status == "no-approach"


def cradle(count):
    """Balls of 1 kg in a row that touch: the Delassus matrix of their contacts."""
    return 2.0 * np.eye(count - 1) - np.eye(count - 1, k=1) - np.eye(count - 1, k=-1)


def after(impulses, first=1.0):
    """Velocities of the balls, the first of which came with 1 m/s."""
    return np.array([first, *np.zeros(len(impulses))]) + np.diff([0.0, *impulses, 0.0]) * -1.0


@pytest.mark.parametrize("law", LAWS)
def test_a_cradle_keeps_momentum_and_energy(law):
    for count in (3, 5):
        struck = ph.impact(cradle(count), [-1.0] + [0.0] * (count - 2), 1.0, law=law)
        velocities = after(struck.impulses)
        assert velocities.sum() == pytest.approx(1.0) and struck.energy_change == pytest.approx(0.0, abs=1e-9)
        assert (velocities**2).sum() == pytest.approx(1.0)
        if law in ("propagation", "reflection"):
            assert np.allclose(velocities, [0.0] * (count - 1) + [1.0], atol=1e-12)
    if law in ("simultaneous", "poisson"):
        three = after(ph.impact(cradle(3), [-1.0, 0.0], 1.0, law=law).impulses)
        assert np.allclose(three, [-1 / 3, 2 / 3, 2 / 3])


def test_an_inelastic_cradle_moves_on_as_one():
    for law in LAWS:
        assert np.allclose(after(ph.impact(cradle(4), [-1.0, 0.0, 0.0], 0.0, law=law).impulses), 0.25)


#: A ball of 1 kg and radius 1 m, and a rod at 45 degrees that falls on its end (Stronge), in space.
BALL = np.diag([1.0, 3.5, 3.5])
ROD = np.array([[2.5, -1.5, 0.0], [-1.5, 2.5, 0.0], [0.0, 0.0, 2.5]])


@pytest.mark.parametrize("law", SINGLE_LAWS)
def test_a_ball_without_coupling_sticks_or_slides_by_every_law(law):
    e, mu = 0.5, 0.2
    sliding = ph.impact(BALL, [-1.0, 2.0, 0.0], e, mu=mu, restitution_law=law)
    assert np.allclose(sliding.impulses, [[1.5, -0.3, 0.0]]) and np.allclose(sliding.velocities, [[0.5, 2.0 - 1.05, 0]])
    sticking = ph.impact(BALL, [-1.0, 0.35, 0.0], e, mu=mu, restitution_law=law)
    assert np.allclose(sticking.impulses, [[1.5, -0.1, 0.0]]) and np.allclose(sticking.velocities, [[0.5, 0.0, 0.0]])


def test_laws_of_one_contact_differ_where_slip_reverses():
    rod = {law: ph.impact(ROD, [-1.0, 0.6, 0.0], 0.5, mu=0.5, restitution_law=law) for law in SINGLE_LAWS}
    assert rod["stronge"].impulses[0, 0] == pytest.approx(0.6015435277299363, rel=1e-13)
    for law in ("newton", "whittaker"):
        assert rod[law].velocities[0, 0] == pytest.approx(0.5)
    assert rod["stronge"].energy_change < 0 and rod["poisson"].energy_change < 0
    assert len({round(float(one.impulses[0, 0]), 9) for one in rod.values()}) >= 3
    # The default of the law of several contacts: Stronge, and Poisson with it.
    assert np.array_equal(ph.impact(ROD, [-1.0, 0.6, 0.0], 0.5, mu=0.5).impulses, rod["stronge"].impulses)
    poisson = ph.impact(ROD, [-1.0, 0.6, 0.0], 0.5, mu=0.5, law="poisson")
    assert np.array_equal(poisson.impulses, rod["poisson"].impulses)


def test_a_super_ball_reverses_its_slip():
    ball = ph.impact(
        BALL, [-1.0, 0.35, 0.0], 1.0, mu=2.0, restitution_law="chatterjee-ruina", tangential_restitution=1.0
    )
    assert np.allclose(ball.velocities, [[1.0, -0.35, 0.0]]) and ball.energy_change == pytest.approx(0.0, abs=1e-14)


@pytest.mark.parametrize("law", ["simultaneous", "propagation", "pulse"])
def test_a_box_that_lands_flat_on_rough_ground(law):
    matrix, rows = box_on_corners()
    before = rows @ [0.2, 0.0, -1.0, 0, 0, 0]
    struck = ph.impact(matrix, before, 0.5, mu=0.5, law=law)
    assert struck.impulses.shape == (4, 3) and struck.energy_change < 0
    assert (struck.velocities[:, 0] >= -1e-9).all()
    normal, along = struck.impulses[:, 0], np.hypot(struck.impulses[:, 1], struck.impulses[:, 2])
    assert (along <= 0.5 * normal + 1e-9).all()


def test_the_springs_of_a_pulse_are_linear_or_hertz():
    hertz = ph.impact(cradle(5), [-1.0, 0, 0, 0], 1.0, law="pulse", pulse_exponent="hertz").impulses
    linear = ph.impact(cradle(5), [-1.0, 0, 0, 0], 1.0, law="pulse", pulse_exponent="linear").impulses
    assert np.array_equal(hertz, ph.impact(cradle(5), [-1.0, 0, 0, 0], 1.0, law="pulse").impulses)
    # Through Hertz's springs more of the momentum arrives at the last ball.
    assert after(hertz)[-1] > after(linear)[-1] > 0.9


@pytest.mark.parametrize(
    "change, says",
    [
        ({"law": "newton"}, "one of reflection, propagation"),
        ({"restitution_law": "stronge"}, "give mu"),
        ({"mu": 0.5, "restitution_law": "hertz"}, "one of stronge, poisson"),
        ({"mu": 0.5, "tangential_restitution": 0.5}, "chatterjee-ruina"),
        ({"mu": 0.5, "restitution_law": "chatterjee-ruina", "tangential_restitution": 3.0}, "between -1 and 1"),
        ({"law": "pulse", "pulse_exponent": "cubic"}, "one of linear, hertz"),
        ({"e": 1.5}, "between 0 and 1, found 1.5"),
        ({"e": [0.5, 0.5]}, r"shape \(3,\)"),
        ({"e": float("nan")}, "e: finite"),
        ({"v": [[-1.0, 0, 0]]}, "v"),
        ({"W": np.eye(2)}, r"shape \(3, 3\)"),
        ({"W": -np.eye(3)}, "positive semidefinite"),
        ({"mu": -1.0}, "at least 0"),
    ],
)
def test_bad_impacts_are_refused(change, says):
    given = {"W": np.eye(3), "v": [-1.0, 0.0, 0.0], "e": 0.5, **change}
    with pytest.raises(ValueError, match=says):
        ph.impact(given.pop("W"), given.pop("v"), given.pop("e"), **given)
