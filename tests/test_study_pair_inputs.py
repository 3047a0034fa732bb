"""Files of pairs in the conventions of OpenCV and COLMAP: the same pairs whoever wrote them, and no fault passes."""

import re
import sqlite3
from contextlib import closing

import numpy as np
import pytest
import xarray
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

from algebroproj_derivations.studies.pair import STUDY
from algebroproj_derivations.studies.pairs import estimating, explaining, populating, space
from algebroproj_derivations.studies.pairs.cameras import camera, distorted, ideal, read_cameras, undistorted
from algebroproj_derivations.studies.pairs.colmap import LAST_IMAGE
from algebroproj_derivations.studies.pairs.critical import nearest_critical
from algebroproj_derivations.studies.pairs.judging import DISTRUST, TRUST, held, judge, selected
from algebroproj_derivations.studies.pairs.measuring import measured
from algebroproj_derivations.studies.pairs.normalising import pairs_of
from algebroproj_derivations.studies.pairs.pair_files import read_pairs
from algebroproj_derivations.studies.pairs.populating import pair
from algebroproj_derivations.studies.pairs.robust import chance, doubtful, kept
from algebroproj_sym.cli import main

pytestmark = pytest.mark.usefixtures("sources_read_once")
COUNT = 30
KNOWN = pair(1, "ordinary", COUNT, 0.5)
LEFT, RIGHT = (np.float32(side + 500).astype(np.float64) for side in (KNOWN.x1, KNOWN.x2))
OPENCV = [1000.0, 1010.0, 500.0, 490.0, -0.05, 0.01, 1e-3, -2e-3]
MATRIX = [[1000.0, 0, 500], [0, 1010, 490], [0, 0, 1]]
SCHEMA = """
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY, model INTEGER, width INTEGER, height INTEGER, params BLOB,
    prior_focal_length INTEGER);
CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT, camera_id INTEGER);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY, rows INTEGER, cols INTEGER, data BLOB);
CREATE TABLE matches (pair_id INTEGER PRIMARY KEY, rows INTEGER, cols INTEGER, data BLOB);
CREATE TABLE two_view_geometries (pair_id INTEGER PRIMARY KEY, rows INTEGER, cols INTEGER, data BLOB, config INTEGER);
"""
# In the database the right picture has the lower number, and the last of its points is the first.
MATCHES = np.stack([np.arange(COUNT)[::-1], np.arange(COUNT)], axis=1)


def database(folder, change=""):
    path = folder / "database.db"
    with closing(sqlite3.connect(path)) as file:
        file.executescript(SCHEMA)
        file.execute("INSERT INTO cameras VALUES (7, 4, 1000, 1000, ?, 0)", (np.array(OPENCV).tobytes(),))
        for number, name, points in ((3, "right.jpg", RIGHT[::-1]), (5, "left one.jpg", LEFT)):
            data = np.hstack([points, np.ones((COUNT, 4))]).astype("<f4")
            file.execute("INSERT INTO images VALUES (?, ?, 7)", (number, name))
            file.execute("INSERT INTO keypoints VALUES (?, ?, 6, ?)", (number, COUNT, data.tobytes()))
        for table, columns, some in (
            ("matches", "?, ?, 2, ?", MATCHES),
            ("two_view_geometries", "?, ?, 2, ?, 3", MATCHES[:20]),
        ):
            values = (3 * LAST_IMAGE + 5, len(some), some.astype("<u4").tobytes())
            file.execute(f"INSERT INTO {table} VALUES ({columns})", values)
        file.executescript(change)
        file.commit()
    return path


def model(folder, change=("", "")):
    order = np.random.default_rng(0).permutation(COUNT)
    lines = ["# Image list with two lines of data per image:"]
    for number, name, points in ((1, "left one.jpg", LEFT), (2, "right.jpg", RIGHT), (3, "none.jpg", LEFT[:0])):
        some = range(len(points)) if number == 1 else order[: len(points)]
        seen = [f"{points[k, 0]} {points[k, 1]} {k}" for k in some] + ["4.0 5.0 -1"] * len(points)
        lines += [f"{number} 1 0 0 0 0 0 0 7 {name}", " ".join(seen)]
    path = folder / "images.txt"
    path.write_text("\n".join(lines).replace(*change) + "\n")
    (folder / "cameras.txt").write_text("# Camera list\n7 OPENCV 1000 1000 " + " ".join(map(str, OPENCV)) + "\n")
    return path


def archive(folder, **changes):
    path = folder / "pairs.npz"
    whole = {"keypoints1": LEFT, "keypoints2": RIGHT[::-1], "matches": MATCHES[:, ::-1]} | changes
    np.savez(path, **{name: array for name, array in whole.items() if array is not None})
    return path


def rows(pixels):
    return sorted(map(tuple, np.hstack(list(pixels)).tolist()))


EXPECTED = rows([LEFT, RIGHT])


def test_all_files_give_the_same_pairs(tmp_path):
    csv = tmp_path / "a.csv"
    csv.write_text("\n".join(f"{b},{d},{a},{c}" for a, b, c, d in EXPECTED))
    assert rows(read_pairs(csv, "3,1,4,2")) == EXPECTED
    assert rows(read_pairs(archive(tmp_path))) == EXPECTED
    assert rows(read_pairs(archive(tmp_path, matches=None, keypoints1=None, x1=LEFT, x2=RIGHT))) == EXPECTED
    assert rows(read_pairs(database(tmp_path), images="left one.jpg, right.jpg", every=True)) == EXPECTED
    assert rows(read_pairs(model(tmp_path), images="left one.jpg,right.jpg")) == EXPECTED


def test_verified_matches_are_taken_unless_all_are_asked_for_and_pictures_can_be_exchanged(tmp_path):
    path = database(tmp_path)
    right, left = read_pairs(path)
    assert rows([left, right]) == rows([LEFT[:20], RIGHT[:20]])
    assert np.array_equal(read_pairs(path, images="left one.jpg,right.jpg"), [left, right])


def test_a_key_point_with_two_orientations_is_one_pair(tmp_path):
    twice = archive(tmp_path, keypoints1=np.vstack([LEFT, LEFT[:3]]), matches=np.vstack([MATCHES[:, ::-1], [[30, 29]]]))
    assert rows(read_pairs(twice)) == EXPECTED


@pytest.mark.parametrize(
    ("make", "images", "message"),
    [
        (
            lambda f: database(f),
            "left.jpg,right.jpg",
            "images: expected two of the 2 pictures right.jpg, left one.jpg of",
        ),
        (lambda f: database(f), "right.jpg,right.jpg", "images: expected two of the 2 pictures"),
        (lambda f: model(f), None, "images: expected two of the 3 pictures .* got none"),
        (
            lambda f: database(f, "DELETE FROM keypoints WHERE image_id = 3"),
            None,
            "expected key points of right.jpg, got none",
        ),
        (
            lambda f: database(f, "DELETE FROM two_view_geometries"),
            None,
            "expected verified matches of right.jpg and left",
        ),
        (lambda f: database(f, "DROP TABLE images"), None, r"expected a database of COLMAP, got .*no such table"),
        (lambda f: database(f, "UPDATE keypoints SET rows = 29"), None, "expected 29 rows of 6 numbers, got 720 bytes"),
        (lambda f: database(f, "UPDATE keypoints SET rows = 'x'"), None, "expected x rows of 6 numbers"),
        (lambda f: database(f, "UPDATE keypoints SET data = NULL"), None, "expected 30 rows of 6 numbers, got none"),
        (lambda f: model(f, ("# Image", "Image")), None, "file: expected ten words for each picture, got 'Image list"),
        (lambda f: model(f, ("4.0 5.0 -1", "4.0 five -1")), "left one.jpg,right.jpg", "file: expected numbers in"),
        (
            lambda f: model(f, ("4.0 5.0 -1\n", "4.0 5.0\n")),
            "left one.jpg,right.jpg",
            "three finite numbers for each point of left one",
        ),
        (
            lambda f: model(f, ("4.0 5.0 -1", "4.0 5.0 nan")),
            "left one.jpg,right.jpg",
            "three finite numbers for each point",
        ),
        (lambda f: archive(f), "a,b", "images: expected them with a database or images.txt of COLMAP alone"),
        (
            lambda f: archive(f, keypoints2=None),
            None,
            "expected the arrays x1 and x2, or keypoints1, keypoints2 and matches",
        ),
        (
            lambda f: archive(f, matches=MATCHES + 1),
            None,
            "expected matches among the 30 key points of picture 1, got 30",
        ),
        (
            lambda f: archive(f, matches=MATCHES - 1),
            None,
            "expected matches among the 30 key points of picture 1, got -1",
        ),
        (lambda f: archive(f, matches=MATCHES / 2), None, "matches as whole numbers of the shape .* got float64"),
        (lambda f: archive(f, keypoints1=LEFT[:, 0]), None, r"expected keypoints1 as numbers of the shape \(n, 2\)"),
        (lambda f: archive(f, keypoints1=LEFT * np.nan), None, "expected finite numbers, got nan"),
        (
            lambda f: archive(f, keypoints1=np.array([{}])),
            None,
            "expected arrays of numbers as numpy.savez writes them",
        ),
        (lambda f: archive(f, matches=None, x1=LEFT, x2=RIGHT[1:]), None, "expected 30 points x2 as of x1, got 29"),
    ],
)
def test_faults_of_files_are_named(tmp_path, make, images, message):
    with pytest.raises(ValueError, match=message):
        read_pairs(make(tmp_path), images=images)


def test_a_damaged_file_never_ends_in_another_error(tmp_path):
    rng, messages = np.random.default_rng(5), []
    for make in (database, archive):
        whole = bytearray(make(tmp_path).read_bytes())
        path = tmp_path / "damaged.bin"
        for _ in range(40):
            damaged = whole.copy()
            for place in rng.integers(16, len(whole), 20):
                damaged[place] = rng.integers(256)
            path.write_bytes(damaged[: rng.integers(len(whole) // 2, len(whole))])
            try:
                read_pairs(path)
            except ValueError as error:
                messages.append(str(error))
    assert len(messages) > 20
    assert all(re.match("(file|images): expected ", message) for message in messages)


def test_cameras_are_the_same_whoever_describes_them(tmp_path):
    database(tmp_path)
    model(tmp_path)
    toml = tmp_path / "camera.toml"
    toml.write_text(f"K = {MATRIX}\ndistortion = {OPENCV[4:]}\n")
    npz = tmp_path / "camera.npz"
    np.savez(npz, K1=MATRIX, distortion=OPENCV[4:], K2=MATRIX)
    names = "left one.jpg,right.jpg"
    found = [
        read_cameras(toml),
        read_cameras(npz),
        read_cameras(tmp_path / "database.db", names),
        read_cameras(tmp_path / "cameras.txt", names),
    ]
    for each in np.ravel(found):
        assert np.array_equal(each.matrix, MATRIX)
        assert np.array_equal(each.distortion[:4], OPENCV[4:])


@given(st.floats(-0.1, 0.1), st.floats(-0.01, 0.01), st.integers(0, 100))
def test_distortion_is_undone(k1, p1, seed):
    given_camera = camera(MATRIX, [k1, 0.01, p1, -p1, 0.001])
    directions = np.random.default_rng(seed).uniform(-0.5, 0.5, (9, 2))
    assert np.allclose(undistorted(distorted(directions, given_camera), given_camera), directions, atol=1e-8)


def test_the_distortion_is_that_of_opencv():
    """The numbers are those of cv2.projectPoints, version 5.0."""
    given_camera = camera(MATRIX, [-0.2, 0.1, 1e-3, -2e-3, 0.05, 0.01, 0.02, -0.03])
    found = distorted(np.array([[0.3, -0.2], [-0.5, 0.4]]), given_camera)
    assert np.allclose(found, PROJECTED, atol=1e-9)


PROJECTED = [[791.5404638056557, 293.6523210375251], [31.169047125855798, 868.5669499223086]]


def test_distorted_pixels_contradict_sigma_and_undistorted_ones_do_not():
    strong = camera(MATRIX, [-0.3, 0.1, 0, 0])
    directions = ideal(np.stack([LEFT, RIGHT]), (camera(MATRIX), camera(MATRIX))) / camera(MATRIX).focal
    pixels = np.stack([distorted(side, strong) for side in directions])
    assert judge(*pixels, 0.5).verdict == DISTRUST
    assert judge(*ideal(pixels, (strong, strong)), 0.5).verdict == judge(LEFT, RIGHT, 0.5).verdict


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("K = [[1, 0], [0, 1]]", r"camera: expected a finite matrix K of the shape \(3, 3\)"),
        ("distortion = [1]", "camera: expected a matrix K for each picture, got none"),
        (f"K = {MATRIX}\ndistortion = [1.0]", "camera: expected 0, 4, 5 or 8 finite coefficients of distortion"),
        ("K = [[0, 0, 0], [0, 1, 0], [0, 0, 1]]", r"camera: expected K = \[\[fx, s, cx\]"),
        ("K = 'x'", "camera: expected K and distortion as numbers"),
        ("left = 3\nright = 4", "camera: expected a matrix K"),
        ("K = ", "camera: expected a TOML file"),
        (f"K = {MATRIX}\ndistortion = [-9.0, 0.0, 0.0, 0.0]", "camera: expected a distortion that can be undone"),
    ],
)
def test_faults_of_cameras_are_named(tmp_path, text, message):
    path = tmp_path / "camera.toml"
    path.write_text(text)
    with pytest.raises(ValueError, match=message):
        measured(archive(tmp_path), camera=path)


def test_a_camera_of_another_model_is_named(tmp_path):
    path = database(tmp_path, "UPDATE cameras SET model = 5")
    with pytest.raises(ValueError, match=r"expected one of the models SIMPLE_PINHOLE, .* got OPENCV_FISHEYE in"):
        read_cameras(path)


def test_check_points_and_additions_are_in_the_pictures():
    frames = np.array([[[0, 0], [1000, 1000]]] * 2)
    judgement = judge(LEFT, RIGHT, 0.5, frames)
    assert ((judgement.checks >= 0) & (judgement.checks <= 1000)).all()
    assert len(judgement.checks[0]) > 20
    assert (np.ptp(judgement.checks, axis=1) > 600).all()
    assert len({addition.place for addition in judgement.additions}) == 3


@pytest.mark.parametrize(
    ("size", "message"),
    [
        ("500,500", "expected the points of picture 1 within 500 by 500"),
        ("1000", "got 1000"),
        ("1000,-1", "got 1000,-1"),
    ],
)
def test_faults_of_the_size_are_named(tmp_path, size, message):
    with pytest.raises(ValueError, match=f"size: .*{message}"):
        measured(archive(tmp_path), size=size)


@pytest.mark.extra("pairs")
def test_wrong_pairs_are_left_out():
    rng = np.random.default_rng(2)
    known = pair(2, "ordinary", 80, 0.5)
    pixels = np.stack([known.x1, known.x2])
    wrong = rng.choice(80, 30, replace=False)
    pixels[1, wrong] = rng.uniform(-500, 500, (30, 2))
    mask = kept(pixels, 2.0)
    assert mask[np.setdiff1d(np.arange(80), wrong)].mean() > 0.9
    assert mask[wrong].mean() < 0.1
    assert chance(pixels, mask, 2.0) < -20


@pytest.mark.extra("pairs")
def test_wrong_pairs_that_pin_the_epipoles_of_a_plane_are_not_trusted():
    """A RANSAC keeps two wrong pairs beside a plane, and they fit."""
    verdicts = {"plane": [], "ordinary": []}
    for seed in range(6):
        for kind, found in verdicts.items():
            known, rng = pair(seed, kind, 60, 0.5, 1e-4), np.random.default_rng(seed)
            pixels = np.stack([known.x1, known.x2])
            wrong = np.stack([rng.uniform(side.min(axis=0), side.max(axis=0), (30, 2)) for side in pixels])
            pixels = np.concatenate([pixels, wrong], axis=1)
            mask = kept(pixels, 2.0)
            judgement = judge(*pixels[:, mask], 0.5)
            found.append(held(judgement, pixels[:, mask], doubtful(pixels, mask, 2.0)).verdict)
    assert TRUST not in verdicts["plane"]
    assert set(verdicts["ordinary"]) == {TRUST}


@pytest.mark.extra("pairs")
def test_wrong_pairs_alone_are_not_trusted():
    for seed in range(5):
        pixels = np.random.default_rng(seed).uniform(-500, 500, (2, 60, 2))
        mask = kept(pixels, 5.0)
        judgement = judge(*pixels[:, mask], 2.0)
        assert selected(judgement, 60, chance(pixels, mask, 5.0)).verdict == DISTRUST


@pytest.mark.extra("pairs")
def test_the_command_reads_colmap_and_leaves_out_wrong_pairs(tmp_path):
    path, out = database(tmp_path), tmp_path / "out"
    options = ["--file", str(path), "--images", "left one.jpg,right.jpg", "--size", "1000,1000", "--ransac", "2"]
    result = CliRunner().invoke(main, ["study", "pair", *options, "--members", "4", "--out", str(out)])
    assert result.exit_code == 0, result.output
    assert "RANSAC kept 30 of 30 pairs." in result.stdout


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--ransac", "-1"], "ransac: expected a positive number of pixels, got -1.0"),
        (["--images", "a,b"], "images: expected them with a database"),
        (["--size", "10,10"], "size: expected the points of picture 1 within 10 by 10"),
    ],
)
def test_the_command_names_faults(tmp_path, options, message):
    result = CliRunner().invoke(
        main, ["study", "pair", "--file", str(archive(tmp_path)), *options, "--out", str(tmp_path / "out")]
    )
    assert result.exit_code == 2, result.output
    assert message in " ".join(result.stderr.split())


def object_points(seed, kind="ordinary", sigma=0.5, count=20, share=1e-3):
    """Return pixels of both pictures, shape (2, n, 2), and their object points."""
    rng = np.random.default_rng(seed)
    centers = np.array([[0.0, 0.0, 0.0], [0.5, 0.05, 0.1]])
    while True:
        cameras = [populating.FOCAL_MATRIX @ populating._towards(rng, center, 0.05) for center in centers]
        surface = populating._surface(rng, kind, centers)
        objects = populating._points(rng, count, cameras, centers, surface, share)
        if objects is not None:
            seen = [populating._seen(camera, center, objects) for camera, center in zip(cameras, centers, strict=True)]
            return np.stack(seen) + sigma * rng.normal(size=(2, count, 2)), 100 * objects


def written(path, pixels, objects, known):
    """Write a file of pairs of which some have object points."""
    lines = ["x1,y1,x2,y2,E,N,H"]
    for k, (one, two, place) in enumerate(zip(*pixels, objects, strict=True)):
        given = ",".join(map(repr, map(float, place))) if k < known else ",,"
        lines.append(",".join(map(repr, map(float, (*one, *two)))) + f",{given}")
    path.write_text("\n".join(lines) + "\n")


def test_exact_pairs_are_where_their_object_points_are():
    pixels, objects = object_points(1, sigma=0.0)
    pairs = pairs_of(*pixels)
    known = np.where(np.arange(20)[:, None] < 6, objects, np.nan)
    points = space.reconstructed(estimating.minima(pairs)[0].matrix, pairs)
    assert np.abs(space.placed(points, space.into_space(points, known)) - objects).max() < 1e-6


def test_object_points_tell_errors_in_space(tmp_path):
    pixels, objects = object_points(1)
    written(tmp_path / "pairs.csv", pixels, objects, 8)
    arguments = ["study", "pair", "--file", str(tmp_path / "pairs.csv"), "--points", "E,N,H", "--members", "20"]
    result = CliRunner().invoke(main, [*arguments, "--out", str(tmp_path / "out")])
    assert result.exit_code == 0, result.output
    assert "8 object points: off by" in result.output
    with xarray.open_dataset(tmp_path / "out" / "pair.nc", engine="h5netcdf") as dataset:
        apart = np.linalg.norm(dataset.place_again.values - dataset.place.values, axis=-1)
        true = np.linalg.norm(dataset.place.values - objects, axis=-1)
    # The true errors are such as the simulated ones: their ratio has a median of about 1.
    assert 0.3 < np.median(true / np.median(apart, axis=0)) < 3


@pytest.mark.parametrize(("kind", "expected"), [("quadric", "In space this is a"), ("plane", "from a plane")])
def test_the_surface_is_told_in_space(kind, expected):
    pixels, objects = object_points(3, kind, count=12)
    pairs = pairs_of(*pixels)
    sentence = explaining.in_space(pairs, nearest_critical(pairs), objects)
    assert expected in sentence
    assert float(re.search(r"are ([0-9.e-]+)", sentence)[1]) < 1


@pytest.mark.parametrize(
    ("known", "points", "message"),
    [
        (4, "E,N,H", "points: expected at least 5 object points, got 4"),
        (8, "E,N", "points: expected three names such as X,Y,Z, got E,N"),
        (8, "E,N,Z", "expected one column Z in the first line"),
    ],
)
def test_faults_of_object_points_are_named(tmp_path, known, points, message):
    written(tmp_path / "pairs.csv", *object_points(1), known)
    with pytest.raises(ValueError, match=message):
        STUDY.arguments({"file": tmp_path / "pairs.csv", "points": points})


def test_object_points_in_a_plane_determine_nothing():
    pixels, objects = object_points(1, sigma=0.0)
    pairs = pairs_of(*pixels)
    points = space.reconstructed(estimating.minima(pairs)[0].matrix, pairs)
    with pytest.raises(ValueError, match="got points of a plane or a line"):
        space.into_space(points, objects * [1, 1, 0])
