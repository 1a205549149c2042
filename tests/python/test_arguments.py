# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever is passed: a result or a sentence, never a crash, and nothing of the caller's is changed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays

import anisosmooth

REAL = [np.float32, np.float64, np.float16, np.int32, np.uint8, ">f8", ">f4", bool, np.longdouble]
INTEGER = [np.int8, np.uint8, np.int16, np.int32, np.uint32, np.int64, np.uint64, ">i4", ">i8"]


@pytest.mark.parametrize("dtype", INTEGER)
def test_any_integers_for_faces(dtype, mesh):
    V, F = mesh[0], mesh[1]
    if np.dtype(dtype).itemsize == 1:
        keep = (F < 120).all(axis=1)
        F = F[keep]
    expected = anisosmooth.smooth(V, F)
    np.testing.assert_array_equal(anisosmooth.smooth(V, F.astype(dtype)), expected)


@pytest.mark.parametrize("strided", ["fortran", "every other", "backwards", "a field of records", "unaligned"])
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_any_strides(strided, dtype, mesh):
    V, F = mesh[0].astype(dtype), mesh[1].astype(np.int32)
    expected = anisosmooth.smooth(V, F)

    def lay_out(array):
        if strided == "fortran":
            return np.asfortranarray(array)
        if strided == "every other":
            wide = np.zeros((2 * len(array), 6), array.dtype)
            wide[::2, ::2] = array
            return wide[::2, ::2]
        if strided == "backwards":
            return array[::-1].copy()[::-1]
        records = np.zeros(len(array), [("tag", "u1"), ("value", array.dtype, 3)])
        if strided == "unaligned":
            records = np.zeros(len(array), np.dtype([("tag", "u1"), ("value", array.dtype, 3), ("more", "u2")]))
        records["value"] = array
        return records["value"]

    v, f = lay_out(V), lay_out(F)
    v.flags.writeable = f.flags.writeable = False
    np.testing.assert_array_equal(anisosmooth.smooth(v, f), expected)
    np.testing.assert_array_equal(v, V)
    np.testing.assert_array_equal(f, F)


def test_lists_are_fine():
    assert anisosmooth.smooth([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).shape == (3, 3)


@pytest.mark.parametrize(
    "arguments, words",
    [
        (([[0, 0]], [[0, 0, 0]]), "shape"),
        (([[0, 0, 0]], [[0, 0, 0, 0]]), "shape"),
        (([["a", "b", "c"]], [[0, 0, 0]]), "real numbers"),
        (([[1j, 0, 0]], [[0, 0, 0]]), "real numbers"),
        (([[0, 0, 0]], [[0.0, 0, 0]]), "integers"),
        (([[0, 0, 0]], []), "no faces"),
        (([], []), "shape"),
        (([[0, 0, 0], [1, 0, 0]], [[0, 1, 2]]), "refers to a vertex"),
        (([[0, 0, 0], [1, 0, 0]], [[0, 1, -1]]), "refers to a vertex"),
        (([[np.nan, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), "not a finite number"),
    ],
)
def test_says_what_is_wrong(arguments, words):
    with pytest.raises(ValueError, match=words):
        anisosmooth.smooth(*arguments)


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
@pytest.mark.parametrize("method", ["guided", "paper", "jones", "taubin"])
def test_vertices_without_a_place_that_nothing_uses_are_passed_over(dtype, method, mesh):
    V, F = mesh[0].astype(dtype), mesh[1]
    odd = np.array([[np.nan, 0, 1], [0, np.inf, np.nan]], dtype)
    odd.view(np.uint32 if dtype == np.float32 else np.uint64)[0, 0] |= 0x1234  # which of all the NaNs it is
    places = [100, len(V) + 1]
    more = np.concatenate([V[:100], odd[:1], V[100:], odd[1:]])
    faces = np.where(F >= 100, F + 1, F)
    V2, report = anisosmooth.smooth(more, faces, method=method, return_report=True)
    assert V2[places].tobytes() == odd.tobytes()
    np.testing.assert_array_equal(np.delete(V2, places, axis=0), anisosmooth.smooth(V, F, method=method))
    assert report["vertices"] == len(V)


def test_measures_pass_over_vertices_without_a_place(mesh):
    V, F = mesh[:2]
    more = np.concatenate([V, [[np.nan] * 3]])
    assert anisosmooth.estimate_noise(more, F) == anisosmooth.estimate_noise(V, F)
    distances = anisosmooth.distance(more, F, 0)
    np.testing.assert_array_equal(distances[:-1], anisosmooth.distance(V, F, 0))
    assert distances[-1] == np.inf
    for used in ({"F": np.concatenate([F, [[0, 1, len(V)]]])}, {"F": F, "creases": [[0, len(V)]]}):
        with pytest.raises(ValueError, match="not a finite number"):
            anisosmooth.smooth(more, **used)


@pytest.mark.parametrize(
    "keywords, error, words",
    [
        ({"method": "papr"}, ValueError, "allowed are paper"),
        ({"method": "paper", "sigma_c": 0}, ValueError, "sigma_c is 0"),
        ({"method": "paper", "sigma_c": "wide"}, (TypeError, ValueError), ""),
        ({"method": "paper", "strength": 1}, TypeError, "no parameter of method paper"),
        ({"boundary": "loose"}, ValueError, "boundary is 'loose'; allowed are fixed and free"),
        ({"iterations": 1.5}, TypeError, ""),
        ({"iterations": 10**12}, ValueError, "too large"),
        ({"sigma": 1}, TypeError, "unexpected keyword"),
        ({"threads": -1}, ValueError, "threads"),
        ({"weights": [1.0]}, ValueError, "weights"),
        ({"weights": 2.0}, ValueError, "weights"),
        ({"selected": [True]}, ValueError, "selected"),
        ({"selected": [10**9]}, ValueError, "selected"),
        ({"colors": [[0, 0, 0]]}, ValueError, "colors"),
        ({"creases": [[0, 1, 2]]}, ValueError, "creases"),
        ({"max_displacement": -1}, ValueError, "max_displacement"),
        ({"weld_distance": float("nan")}, ValueError, "weld_distance"),
    ],
)
def test_says_what_is_wrong_with_a_keyword(keywords, error, words, mesh):
    with pytest.raises(error, match=words):
        anisosmooth.smooth(mesh[0], mesh[1], **keywords)


def test_weights_beyond_their_range(mesh):
    V, F = mesh[:2]
    for wrong in (-0.1, 1.1, np.nan):
        weights = np.ones(len(V))
        weights[7] = wrong
        with pytest.raises(ValueError, match="weight"):
            anisosmooth.smooth(V, F, weights=weights)


shapes = arrays.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=5)
any_rows = st.one_of(shapes, st.tuples(st.integers(0, 12), st.just(3)))


@settings(max_examples=400, deadline=None)
@given(st.data())
def test_never_crashes(data):
    V = data.draw(arrays.arrays(st.sampled_from(REAL), any_rows, elements=None))
    integer = st.sampled_from(INTEGER)
    few = st.integers(0, max(len(V) if V.ndim else 0, 1))
    F = data.draw(st.one_of(arrays.arrays(integer, any_rows), arrays.arrays(integer, any_rows, elements=few)))
    method = data.draw(st.sampled_from(list(anisosmooth._smooth.CATALOGUE)))
    before = V.copy(), F.copy()
    try:
        with np.errstate(all="ignore"):
            result, _ = anisosmooth.smooth(V, F, method, return_report=True)
        assert result.shape == V.shape
        # A vertex without faces stays where it is, wherever that is.
        was_finite = np.isfinite(V.astype(float))
        assert np.isfinite(result.astype(float))[was_finite].all()
    except ValueError as error:
        assert str(error)
    np.testing.assert_array_equal(V, before[0])
    np.testing.assert_array_equal(F, before[1])
    for function in (lambda: anisosmooth.distance(V, F, 0), lambda: anisosmooth.estimate_noise(V, F)):
        try:
            function()
        except ValueError as error:
            assert str(error)
