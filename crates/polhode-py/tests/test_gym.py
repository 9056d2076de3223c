"""Environments of Gymnasium: its own check, the same bits by seed and from snapshots, bad input."""

import subprocess
import sys
import warnings

import numpy as np
import polhode as ph
import pytest

pytest.importorskip("gymnasium")


def played(env, actions):
    return [env.step([action])[0] for action in actions]


def cart(**keys):
    scene = ph.Scene(gravity=9.81, duration=0.1)
    body = scene.add(ph.Box(0.5, 0.3, 0.2), name="cart", mass=1.0)
    scene.joint(ph.Slider(at=(0, 0, 0), axis=(1, 0, 0)), body, name="rail")
    keys = {"actions": {"rail": 10.0}, "observe": ["rail.displacement_rate"], **keys}
    return ph.gym.SceneEnv(scene, **keys)


MAKERS = [ph.gym.cart_pole, ph.gym.hopper, lambda: cart(vary={"bodies.cart.mass": ph.Uniform(1, 2)})]


@pytest.mark.parametrize("make", MAKERS)
def test_it_passes_the_check_of_gymnasium(make):
    from gymnasium.utils.env_checker import check_env

    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        check_env(make())
    unlike = [str(one.message) for one in told if "infinity" not in str(one.message)]
    assert not [text for text in unlike if "spec" not in text and "symmetric" not in text], unlike


def test_the_same_seed_gives_the_same_bits():
    actions = np.sin(np.arange(20.0))
    episodes = []
    for env in (ph.gym.cart_pole(), ph.gym.cart_pole()):
        for seed in (3, 4):
            first, info = env.reset(seed=seed)
            assert info["t"] == 0.0
            episodes.append(np.array([first, *played(env, actions)]))
    assert np.array_equal(episodes[0], episodes[2]) and np.array_equal(episodes[1], episodes[3])
    assert not np.array_equal(episodes[0], episodes[1])


def test_a_snapshot_goes_on_with_the_same_bits():
    env = ph.gym.cart_pole()
    env.reset(seed=5)
    played(env, [0.3] * 5)
    saved, seen = ph.Snapshot.from_bytes(env.snapshot().to_bytes()), env.observation()
    after = played(env, [-0.7] * 9)
    assert np.array_equal(env.restore(saved), seen)
    assert np.array_equal(played(env, [-0.7] * 9), after)
    other = ph.gym.cart_pole()
    assert np.array_equal(other.reset(seed=9, options={"snapshot": saved})[0], seen)
    assert np.array_equal(played(other, [-0.7] * 9), after)


def test_the_pole_falls_and_a_controller_keeps_it_up():
    env = ph.gym.cart_pole()
    env.reset(seed=1)
    for number in range(500):
        if env.step([0.0])[2]:
            break
    assert 10 < number < 200
    observation, _ = env.reset(seed=1)
    for number in range(500):
        action = np.clip(observation @ [0.1, 0.2, 3.0, 0.6], -1, 1)
        observation, reward, terminated, truncated, info = env.step([action])
        assert reward == 1.0 and not terminated
    assert truncated and info["t"] == 10.0


def test_actions_rewards_and_draws():
    env = cart(reward=lambda env: -abs(env.action[0]), terminated=lambda env: env.sim.time > 0.05)
    env.reset(seed=0)
    observation, reward, terminated, truncated, info = env.step([0.5])
    assert observation[0] == pytest.approx(5 * 0.02, rel=1e-12) and reward == -0.5 and not terminated
    assert env.step([9.0])[1] == -1.0 and env.step([0.0])[2]
    env = cart(vary={"bodies.cart.mass": ph.Uniform(1, 2)})
    speeds = {float((env.reset(seed=seed), env.step([1.0]))[1][0][0]) for seed in (1, 2, 1)}
    assert len(speeds) == 2 and all(0.1 < speed < 0.2 for speed in speeds)
    seen = ["cart.position", "cart.velocity[0]", "rail.displacement"]
    assert cart(observe=seen).reset()[0].shape == (5,)


def test_a_hopper_stands_hops_and_goes_on_from_a_snapshot_with_the_same_bits():
    env = ph.gym.hopper()
    first, _ = env.reset(seed=1)
    assert first.shape == (11,) and first[0] == pytest.approx(1.21)
    actions = np.sin(np.outer(np.arange(40), [0.3, 0.5, 0.7]))

    def play(env, actions):
        return np.array([[*observation, reward] for observation, reward, *_ in map(env.step, actions)])

    def stands(env):
        return any("foot" in (contact.body_a, contact.body_b) for contact in env.sim.contacts())

    assert stands(env)
    play(env, actions[:20])
    assert not stands(env)    # it has pushed itself off
    saved = ph.Snapshot.from_bytes(env.snapshot().to_bytes())
    after = play(env, actions[20:])
    env.restore(saved)
    assert np.array_equal(play(env, actions[20:]), after)
    other = ph.gym.hopper()
    other.reset(seed=5, options={"snapshot": saved})
    assert np.array_equal(play(other, actions[20:]), after)
    # It stays in its plane, and its parts stay together.
    assert abs(env.sim.body("torso").position[1]) < 1e-9
    assert env.sim.certificate["max_joint_error_of_limit"] < 1


def test_a_hopper_falls_when_nothing_drives_it():
    env = ph.gym.hopper()
    env.reset(seed=2)
    for number in range(400):
        observation, reward, terminated, truncated, _ = env.step([0.0, 0.0, 0.0])
        if terminated:
            break
    assert 20 < number < 399 and not truncated and reward < 1.0 + observation[2] + 1e-9


@pytest.mark.parametrize(
    ("keys", "error", "said"),
    [
        ({"actions": {"rial": 1.0}}, ph.UnknownName, "rail"),
        ({"actions": {"rail.angle": 1.0}}, ph.UnknownName, "displacement"),
        ({"actions": {"rail": -1.0}}, ValueError, "above 0"),
        ({"actions": {}}, ValueError, "at least 1"),
        ({"observe": []}, ValueError, "at least 1"),
        ({"observe": ["cat.position"]}, ph.UnknownName, "cart"),
        ({"observe": ["cart.positions"]}, ph.UnknownName, "position"),
        ({"observe": ["cart.position[3]"]}, ValueError, "0 to 2"),
        ({"observe": ["rail.angle"]}, ph.UnknownName, "displacement"),
        ({"observe": ["rail.speed"]}, ph.UnknownName, "displacement"),
        ({"interval": 0.0}, ValueError, "above 0 s"),
        ({"vary": {"bodies.cart.mass": 2.0}}, TypeError, "distribution"),
        ({"vary": {"bodies.cat.mass": ph.Normal(1, 0)}}, ph.SceneError, "cat"),
    ],
)
def test_bad_input_is_refused_when_it_is_made(keys, error, said):
    with pytest.raises(error, match=said):
        cart(**keys)


@pytest.mark.parametrize("action", [[float("nan")], [1.0, 2.0], 1.0])
def test_bad_actions_are_refused(action):
    env = cart()
    before = env.snapshot()
    with pytest.raises(ValueError, match="action"):
        env.step(action)
    assert env.snapshot() == before


def test_without_gymnasium_it_says_what_to_install():
    code = "import sys; sys.modules['gymnasium'] = None; import polhode; polhode.gym"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "pip install polhode[gym]" in done.stderr.splitlines()[-1]
    subprocess.run([sys.executable, "-c", "import sys, polhode; assert 'gymnasium' not in sys.modules"], check=True)
