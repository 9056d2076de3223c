"""Does it stand: by statics, for towers whose answer is known, and for what is no standing at all."""

import math

import polhode as ph
import pytest

PALLET = [
    {"size_x": 0.4, "size_y": 0.3, "size_z": 0.25, "x": 0.4 * i, "y": 0.3 * j, "z": 0.125 + 0.25 * k, "mass": 8.0}
    for k in range(5)
    for j in range(3)
    for i in range(4)
]


@pytest.mark.parametrize("width", [0.5, 1.0, 2.0])
def test_a_column_tips_at_its_width_over_its_height(width):
    scene = ph.Scene()
    scene.fixed(ph.HalfSpace(), friction=2.0)
    scene.add(ph.Box(width, width, 4.0), name="column", mass=3.0, at=(1, 2, 2), friction=2.0)
    answer = ph.stands(scene)
    assert answer and answer.first == ("column",) and answer.how == "tips"
    assert answer.push == pytest.approx(width / 4.0, abs=1e-9)
    assert answer.tilt == pytest.approx(math.atan(width / 4.0), abs=1e-9)


def test_a_box_slides_where_friction_is_low():
    plate = {"size_x": 1, "size_y": 1, "size_z": 0.2, "x": 0, "y": 0, "z": 0.1, "mass": 1}
    answer = ph.stands(ph.boxes([plate], friction=0.3))
    assert answer and answer.how == "slides" and answer.push == pytest.approx(0.3, abs=1e-9)


@pytest.mark.parametrize("overhang, stands", [(0.24, True), (0.26, False)])
def test_a_box_on_a_box_falls_beyond_its_middle(overhang, stands):
    one = {"size_x": 0.5, "size_y": 0.5, "size_z": 0.2, "y": 0, "mass": 5}
    answer = ph.stands(ph.boxes([{**one, "x": 0, "z": 0.1}, {**one, "x": overhang, "z": 0.3, "name": "high"}]))
    assert bool(answer) is stands
    assert answer.first[0] == "high"


def test_what_floats_or_moves_does_not_stand():
    scene = ph.Scene()
    scene.fixed(ph.HalfSpace(), friction=0.5)
    scene.add(ph.Box(1, 1, 1), name="floats", mass=1.0, at=(0, 0, 0.6), friction=0.5)
    assert not ph.stands(scene) and ph.stands(scene).first == ("floats",)
    scene = ph.Scene()
    scene.fixed(ph.HalfSpace(), friction=0.5)
    scene.add(ph.Box(1, 1, 1), name="glides", mass=1.0, at=(0, 0, 0.5), velocity=(1, 0, 0), friction=0.5)
    assert not ph.stands(scene)


def test_a_pallet_is_a_table_in_any_form(tmp_path):
    answer = ph.stands(ph.boxes(PALLET))
    assert answer and answer.push > 0.1
    columns = {column: [box[column] for box in PALLET] for column in PALLET[0]}
    path = tmp_path / "pallet.csv"
    lines = [",".join(columns), *(",".join(str(box[column]) for column in columns) for box in PALLET)]
    path.write_text("\n".join(lines) + "\n")
    assert ph.boxes(columns).to_toml() == ph.boxes(PALLET).to_toml() == ph.boxes(path).to_toml()


@pytest.mark.parametrize(
    "change, word",
    [({"mass": "heavy"}, "heavy"), ({"x": float("nan")}, "nan"), ({"z": None}, "`z` is empty")],
)
def test_bad_tables_are_refused_with_their_row(change, word):
    with pytest.raises(ValueError, match=f"row 2.*{word}"):
        ph.boxes([PALLET[0], {**PALLET[1], **change}])


def test_unnamed_boxes_are_named_as_by_the_program():
    answer = ph.stands(ph.boxes([{**PALLET[0], "z": 1.0}]))
    assert answer.first == ("box 1",)
    with pytest.raises(ValueError, match="unknown column `height`"):
        ph.boxes([{**PALLET[0], "height": 1}])


def test_a_table_without_a_column_or_of_unlike_columns_is_refused():
    with pytest.raises(ValueError, match="`mass` is missing"):
        ph.boxes([{column: value for column, value in PALLET[0].items() if column != "mass"}])
    with pytest.raises(ValueError, match="different lengths"):
        ph.boxes({"x": [1, 2], "y": [1]})


@pytest.mark.parametrize("width, height", [(0.4, 1.0), (1.0, 2.0)])
def test_the_limit_of_an_overhang_is_half_the_width(width, height):
    scene = ph.Scene()
    scene.fixed(ph.HalfSpace(), friction=0.5)
    scene.add(ph.Box(width, 1, height), name="low", mass=2.0, at=(0, 0, height / 2), friction=0.5)
    scene.add(ph.Box(width, 1, height), name="high", mass=1.0, at=(0, 0, 1.5 * height), friction=0.5)
    found = ph.standing_limit(scene, "bodies.high.position[0]", 0.0, width, digits=5)
    assert found.limit == pytest.approx(width / 2, rel=2e-5)
    assert found.stands < found.falls and found.asked > 10


@pytest.mark.parametrize("low, high, digits", [(0.5, 0.1, 6), (0.0, math.inf, 6), (0.0, 0.1, 6), (0.0, 1.0, 99)])
def test_a_limit_is_not_sought_where_there_is_none(low, high, digits):
    scene = ph.Scene()
    scene.fixed(ph.HalfSpace(), friction=0.5)
    scene.add(ph.Box(1, 1, 1), name="box", mass=1.0, at=(0, 0, 0.5), friction=0.5)
    with pytest.raises(ValueError):
        ph.standing_limit(scene, "bodies.box.velocity[0]", low, high, digits=digits)
