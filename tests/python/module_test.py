"""The module raycheck for NumPy: answers against rational arithmetic, shapes, errors, judging."""

import pickle
import signal
import threading
import time
from fractions import Fraction

import hypothesis
import numpy as np
import pytest

import raycheck
import raycheck.testing
from raycheck import _core

MISS, HIT, TANGENT, INVALID = range(4)


def textbook(origins, directions, centre, radius, far=False):
    """s by (b - sqrt(b^2 - ac))/a; NaN for a miss."""
    to_centre = centre - origins
    a = (directions * directions).sum(1)
    b = (to_centre * directions).sum(1)
    c = (to_centre * to_centre).sum(1) - radius * radius
    with np.errstate(all="ignore"):
        root = np.sqrt(b * b - a * c)
        first, last = (b - root) / a, (b + root) / a
    s = np.where(first >= 0, first, last)
    if far:
        s = last
    return np.where(s >= 0, s, np.nan)


def exact(origin, direction, centre, radius):
    """a, b and c of a s^2 - 2 b s + c = 0, and its class for roots s >= 0."""
    o, d, m = ([Fraction(float(x)) for x in v] for v in (origin, direction, centre))
    t = [y - x for x, y in zip(o, m)]
    a, b = sum(x * x for x in d), sum(x * y for x, y in zip(t, d))
    c = sum(x * x for x in t) - Fraction(float(radius)) ** 2
    square = b * b - a * c
    if square < 0 or (c > 0 and b < 0):
        return a, b, c, MISS
    return a, b, c, TANGENT if square == 0 else HIT


def of_sources(count):
    """Rays and spheres of all sources without cameras, at every severity in turn."""
    sources = [one for one in _core.sources() if not one[2]]
    for k in range(count):
        name, _, _, dial, highest, *_ = sources[k % len(sources)]
        severity = k // len(sources) % (highest + 1) if dial else 0
        case = _core.make_case(name, k, 0, severity)
        for origin, direction in zip(case["origins"], case["directions"]):
            for centre, radius in zip(case["centres"], case["radii"]):
                yield origin, direction, centre, radius


def test_classes_and_s_are_those_of_fractions():
    cases = list(of_sources(600))
    columns = [np.array(column) for column in zip(*cases)]
    met = raycheck.decide(*columns)
    assert set(met.hit_class.tolist()) == {MISS, HIT, TANGENT}
    for k, case in enumerate(cases):
        a, b, c, expected = exact(*case)
        assert met.hit_class[k] == expected, (k, case)
        if expected == MISS:
            assert np.isnan(met.s[k])
            continue
        s, error = Fraction(float(met.s[k])), met.s_error[k]
        if not np.isfinite(error):
            continue
        side = 1 if met.root[k] else -1
        for end, sign in ((-1, -1), (1, 1)):
            y = a * (s + end * Fraction(float(error))) - b
            # The sign of y - side sqrt(b^2 - a c)
            beyond = side * (y * y - (b * b - a * c)) if y * side >= 0 else y
            assert beyond * sign >= 0, (k, case)


@pytest.mark.parametrize("kind", [np.float64, np.float32])
def test_shapes_are_broadcast_and_strides_followed(kind):
    random = np.random.default_rng(1)
    origins = random.normal(size=(4, 1, 3)).astype(kind)
    directions = random.normal(size=(5, 6)).astype(kind)[:, ::-2]
    centres = np.asfortranarray(random.normal(size=(2, 4, 5, 3)).astype(kind))
    radii = np.broadcast_to(kind(1.5), (2, 1, 1))
    met = raycheck.decide(origins, directions, centres, radii)
    assert met.s.shape == met.hit_class.shape == (2, 4, 5)
    assert met.point.shape == (2, 4, 5, 3)
    assert met.s.dtype == kind
    for at in np.ndindex(2, 4, 5):
        one = raycheck.decide(origins[at[1], 0], directions[at[2]], centres[at], kind(1.5))
        assert one.hit_class == met.hit_class[at]
        assert np.array_equal(one.s, met.s[at], equal_nan=True)
        assert np.array_equal(one.point, met.point[at], equal_nan=True)


def test_one_ray_meets_many_spheres():
    centres = [[0, 0, z] for z in range(2, 50)]
    met = raycheck.decide([0, 0, 0], [0, 0, 1], centres, 1)
    assert met.s.tolist() == list(range(1, 49))
    seen = raycheck.nearest([0, 0, 0], [[0, 0, 1], [0, 1, 0]], centres, 1)
    assert (seen.sphere.tolist(), seen.ties.tolist()) == ([0, -1], [1, 0])


@pytest.mark.parametrize("radii", [np.zeros(0), 1])
def test_no_spheres_are_seen_where_there_are_none(radii):
    seen = raycheck.nearest(np.zeros((2, 3)), [0, 0, 1], np.zeros((0, 3)), radii)
    assert seen.sphere.tolist() == [-1, -1] and seen.ties.tolist() == [0, 0]
    assert np.isinf(seen.s).all() and np.isinf(seen.point).all()


def test_other_numbers_are_converted():
    big = np.array([0, 0, 5], ">f8")
    for centre in ([0, 0, 5], big, big.astype("f2"), big.astype("i8")):
        assert raycheck.decide([0, 0, 0], [0, 0, 1], centre, True).s == 4


@pytest.mark.parametrize("arguments, message", [
    (([0, 0], [0, 0, 1], [0, 0, 5], 1), r"origins: must have the shape \(\.\.\., 3\), not \(2,\)"),
    ((np.zeros((2, 3)), np.ones((3, 3)), [0, 0, 5], 1),
     r"the shapes \(2,\), \(3,\), \(\), \(\) cannot be broadcast together"),
    ((np.zeros((2, 2, 3)), [[[0, 0, 1]], [[0, 0, 0]]], [0, 0, 5], 1),
     r"directions\[1, 0\]: \[0, 0, 0\] is the zero vector"),
    (([0, 0, 0], [0, 0, 1], [0, 0, 5], [1, 2, -1]), r"radii\[2\]: "),
])
def test_what_is_wrong_is_named(arguments, message):
    with pytest.raises(ValueError, match=message):
        raycheck.decide(*arguments)


@pytest.mark.parametrize("rays", [(), (2,), (40,)])
def test_a_sphere_of_a_list_is_named_by_its_own_index(rays):
    centres = np.full((50, 3), 9.0)
    centres[30, 1] = np.nan
    with pytest.raises(ValueError, match=r"centres\[30\]: \[9, nan, 9\] is not finite"):
        raycheck.nearest(np.zeros((*rays, 3)), [0, 0, 1], centres, 1)
    with pytest.raises(ValueError, match=r"radii\[31\]: -1 is negative"):
        raycheck.nearest(np.zeros((*rays, 3)), [0, 0, 1], np.ones((50, 3)),
                         np.where(np.arange(50) == 31, -1, 1))


def test_numbers_that_are_not_numbers_are_refused_or_nan():
    with pytest.raises(TypeError, match="radii: must be an array of numbers"):
        raycheck.decide([0, 0, 0], [0, 0, 1], [0, 0, 5], "one")
    directions = [[0, 0, 1], [0, np.nan, 1]]
    met = raycheck.decide([0, 0, 0], directions, [0, 0, 5], 1, invalid="nan")
    assert met.hit_class.tolist() == [HIT, INVALID]
    assert met.s[0] == 4 and np.isnan(met.s[1])


def test_roots_are_those_that_count():
    call = ([0, 0, 0], [0, 0, 1], [0, 0, 5], 1)
    assert raycheck.decide(*call, roots=raycheck.Roots(t_min=4.5)).s == 6
    assert raycheck.decide(*call, roots=raycheck.Roots(t_max=4, ends="open")).hit_class == MISS
    with pytest.raises(ValueError, match="ends = ajar: must be closed, open-max, open-min or open"):
        raycheck.Roots(ends="ajar")


def test_values_enclose_the_rounded_ones():
    call = ([1, 1, 3], [4, 3, 0], [5, 5, 5], 3)
    around, rounded = raycheck.enclose(*call), raycheck.round(*call)
    assert around.s_lower <= rounded.s <= around.s_upper
    assert np.nextafter(around.s_lower, 9) == around.s_upper
    assert 1 <= raycheck.condition(*call).s < 100
    errors = raycheck.errors(*call, is_hit=True, s=rounded.s, points=rounded.point)
    assert errors.s_ulp <= 0.5 and errors.hit_class == 0
    assert raycheck.errors(*call, is_hit=False).hit_class == 1
    assert raycheck.errors(*call, is_hit=True, s=1.54).root == 1


def test_errors_of_floats_are_in_their_own_units():
    call = [np.float32(x) for x in ([1, 1, 3], [4, 3, 0], [5, 5, 5], 3)]
    rounded = raycheck.round(*call)
    assert rounded.s.dtype == rounded.point.dtype == np.float32
    many = [np.broadcast_to(x, (4, *np.shape(x))) for x in call]
    s, points = np.tile(rounded.s, 8)[::2], np.tile(rounded.point, (8, 1))[::2]
    errors = raycheck.errors(*many, is_hit=np.ones(4, bool), s=s, points=points)
    assert (errors.s_ulp <= 0.5).all() and (errors.point_u <= 1).all()
    s = s + np.float32(2**-23)
    assert (raycheck.errors(*many, is_hit=np.ones(4, bool), s=s).s_ulp >= 1).all()


@pytest.mark.parametrize("kind, excused", [(np.float64, [0, 0]), (np.float32, [1, 0])])
def test_hits_without_s_are_excused_by_roundings_of_the_inputs_type(kind, excused):
    origins = np.array([[0, 1 + 2**-22, 0], [0, 2, 0]], kind)
    call = origins, np.array([0, 0, 1], kind), np.array([0, 0, 5], kind), kind(1)
    errors = raycheck.errors(*call, is_hit=[1, 1])
    assert errors.hit_class.tolist() == [1, 1] and errors.excused.tolist() == excused


def test_a_hit_is_any_number_but_0():
    call = [0, 0, 0], [0, 0, 1], [[0, 0, 5], [0, 9, 5]], 1
    for hits in ([256, 0], [True, False], [0.5, 0.0], np.array([-(2**40), 0])):
        assert raycheck.errors(*call, is_hit=hits).hit_class.tolist() == [0, 0]


def test_values_are_those_of_their_names():
    call = ([1, 1, 3], [4, 3, 1], [5, 5, 5], 3)
    around, rounded, condition = (ask(*call) for ask in (raycheck.enclose, raycheck.round,
                                                         raycheck.condition))
    for name in ("s", "point", "direction", "pixel_point"):
        value = getattr(rounded, name)
        lower, upper = getattr(around, name + "_lower"), getattr(around, name + "_upper")
        assert ((lower <= value) & (value <= upper) & (upper <= np.nextafter(lower, 9))).all()
        assert np.isfinite(getattr(condition, name)).all()
    assert (rounded.pixel_point == call[0]).all() and (condition.pixel_point == 1).all()
    assert np.allclose(rounded.direction, np.array(call[1]) / np.sqrt(26), rtol=1e-15)
    assert np.allclose(rounded.point, call[0] + rounded.s * np.array(call[1]), rtol=1e-15)


def test_answers_pass_between_processes():
    met = raycheck.decide([0, 0, 0], [[0, 0, 1], [0, 1, 0]], [0, 0, 5], 1)
    again = pickle.loads(pickle.dumps(met))
    assert again.arrays.keys() == met.arrays.keys() and again.s[0] == 4


@pytest.mark.parametrize("width, height", [(0, 5), (5, -1)])
def test_a_camera_without_pixels_is_refused(width, height):
    with pytest.raises(ValueError, match="(width = 0|height = -1): is below 1 pixel"):
        raycheck.Camera([0, 0, 5], [0, 0, 0], [0, 1, 0], -1, -1, 1, -1, 1, width, height)


def test_an_image_is_that_of_its_pixels_rays():
    camera = raycheck.Camera([0, 0, 5], [0, 0, 0], [0, 1, 0], -1, -0.5, 0.5, -0.3, 0.3, 20, 12,
                             samples="centres", origin="focal")
    centres, radii = [[0, 0, 0], [0.5, 0, 1], [0.5, 0, 1]], [1, 0.5, 0.5]
    image = raycheck.image(camera, centres, radii)
    assert image.sphere.shape == (12, 20)
    assert set(image.ties.ravel().tolist()) == {0, 1, 2}
    directions = raycheck.round(camera, None, [0, 0, 0], 1).direction
    seen = raycheck.nearest([0, 0, 5], directions, centres, radii)
    assert (image.sphere == seen.sphere).mean() > 0.99  # the directions are rounded


class Stopped(BaseException):  # as KeyboardInterrupt
    pass


def stop(*_):
    raise Stopped


def slow(*case):
    time.sleep(1e-3)
    return textbook(*case)


@pytest.mark.parametrize("call", [
    lambda: raycheck.judge(slow, cases=10**6),
    lambda: raycheck.decide(np.broadcast_to(np.zeros(3), (10**8, 3)), [0, 0, 1], [0, 0, 5], 1,
                            points=False),
])
def test_a_long_call_is_interrupted(call):
    signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, 0.3)
    with pytest.raises(Stopped):
        call()


def test_other_threads_run_during_a_call():
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(1e-4)

    other = threading.Thread(target=tick)
    other.start()
    origins = np.zeros((30_000, 3))
    was_seen = False
    for _ in range(200):  # on a busy machine the other thread may wait for long
        start = time.monotonic()
        raycheck.round(origins, [1e-9, 0, 1], [0, 0, 5], 1)
        end = time.monotonic()
        was_seen = any(start < at < end for at in ticks)
        if was_seen:
            break
    done.set()
    other.join()
    assert was_seen


def test_right_functions_pass_and_wrong_ones_are_shown():
    raycheck.testing.assert_right(textbook)
    with pytest.raises(AssertionError) as wrong:
        raycheck.testing.assert_right(lambda *case: textbook(*case, far=True), cases=40)
    text = str(wrong.value)
    for part in ("the far root is taken for the near one", "exact s = ", "[[sphere]]", "replay: "):
        assert part in text
    assert not raycheck.judge(textbook, "class", level="extreme", cases=60).passes
    never = raycheck.judge(lambda o, d, c, r: np.zeros(len(o), bool), "class", returns="class")
    assert not never.passes and never.shrunk["origins"].shape == (1, 3)


def test_functions_may_return_points_alone():
    def points(origins, directions, centre, radius):
        s = textbook(origins, directions, centre, radius)
        return origins + s[:, None] * directions

    raycheck.testing.assert_right(points, returns="point")
    raycheck.testing.assert_right(lambda *case: [textbook(*case), points(*case)], returns="hit")
    with pytest.raises(AssertionError, match="broken"):
        raycheck.testing.assert_right(lambda *case: points(*case) + 0.1, returns="point", cases=40)


def test_a_function_that_does_not_answer_is_said_to():
    verdict = raycheck.judge(lambda *_: 1, "class", cases=5)
    assert not verdict.passes
    assert "the function must return numbers of shape" in verdict.text
    for laws in ("frame", ["class", "nearest-rooot"]):
        with pytest.raises(ValueError, match="does not apply to the function; class, "):
            raycheck.testing.assert_right(textbook, laws=laws)
    with pytest.raises(ValueError, match="level = hard: must be ordinary, demanding or extreme"):
        raycheck.testing.rays_and_spheres("hard")


@hypothesis.settings(max_examples=60, deadline=None, database=None)
@hypothesis.given(raycheck.testing.rays_and_spheres("extreme"))
def test_strategies_draw_from_sources(case):
    assert raycheck.decide(*case).hit_class == exact(*case)[3]
