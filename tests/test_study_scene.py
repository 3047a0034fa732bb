"""Scenes from files: what is wrong with one is said before work begins."""

import json

import numpy as np
import pytest
from click.testing import CliRunner

from algebroproj_derivations.studies.stereo.aerial import aerial
from algebroproj_derivations.studies.stereo.scene_files import read_scene
from algebroproj_sym.cli import main

pytestmark = pytest.mark.usefixtures("sources_read_once")


def table(name, rows, unit):
    lines = [f"{key} = [{', '.join(repr(float(x)) for x in row)}]" for key, row in rows.items()]
    return "\n".join([f"[{name}]", *([f'unit = "{unit}"'] if unit else []), *lines, ""])


def written(folder, change=lambda points: None, unit="m", unit_of_centers="m", centers=("left", "right"), count=10):
    batch = aerial(21, [0], count=count)
    points = {f"P{k}": 300 * row for k, row in enumerate(batch.points[0], 1)}
    change(points)
    path = folder / "scene.toml"
    path.write_text(
        table("points", points, unit)
        + table("centers", dict(zip(centers, 300 * batch.centers[0], strict=True)), unit_of_centers)
        + table("axes", dict(zip(("left", "right"), batch.planes[0], strict=True)), None)
    )
    return path


def study(path, out, *arguments):
    return CliRunner().invoke(
        main, ["study", "scene", "--file", str(path), "--members", "40", "--out", str(out), *arguments]
    )


def test_a_scene_is_judged(tmp_path):
    result = study(written(tmp_path), tmp_path / "out", "--moved", "0.5")
    assert result.exit_code == 0, result.stderr
    assert "P1, P2, P3, P4, P5, P6, P7, P8: regular; rank 8 of the eight equations." in result.stdout
    assert "P8 may not lie on this" in result.stdout
    assert "Exchange" in result.stdout
    names = {path.name for path in (tmp_path / "out" / "figures").iterdir()}
    assert names == {"quadric.png", "quadric.pdf", "map.png", "map.pdf"}
    arguments = json.loads((tmp_path / "out" / "manifest.json").read_text())["arguments"]
    assert arguments["options"]["file"].startswith("scene.toml, sha256 ")
    assert str(tmp_path) not in (tmp_path / "out" / "manifest.json").read_text()


def test_another_file_of_the_same_name_is_another_sweep(tmp_path):
    assert study(written(tmp_path), tmp_path / "out").exit_code == 0
    result = study(written(tmp_path, count=9), tmp_path / "out")
    assert result.exit_code == 2
    assert "in this folder has arguments.options.file" in result.stderr


def test_a_critical_scene_is_found(tmp_path):
    def flatten(points):
        for k in (1, 2, 3, 5, 6, 7, 8):
            points[f"P{k}"][2] = 0.0

    result = study(written(tmp_path, flatten, count=8), tmp_path / "out")
    assert result.exit_code == 0, result.stderr
    assert ": critical; rank 7 of the eight equations." in result.stdout
    assert "no result in any of 40 cases" in result.stdout
    assert "the points move by 0 m in all" in result.stdout


def test_the_file_is_read_as_it_is_written(tmp_path):
    found = read_scene(written(tmp_path))
    batch = aerial(21, [0], count=10)
    assert found.names == tuple(f"P{k}" for k in range(1, 11))
    assert np.array_equal(found.scene.points, 300 * batch.points[0, :8])
    assert np.array_equal(found.candidates, 300 * batch.points[0, 8:])
    assert found.unit == "m"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"count": 7}, "points: expected at least 8, got 7"),
        ({"change": lambda p: p["P3"].fill(np.nan)}, "points: expected finite numbers"),
        (
            {"change": lambda p: p.update(P2=p["P1"])},
            "expected four different basic points, got G0 and G1 in one place",
        ),
        ({"change": lambda p: p.update(P3=(p["P1"] + p["P2"]) / 2)}, "got G0, G1 and G2 on a line"),
        (
            {"change": lambda p: p.update(P4=(p["P1"] + p["P2"] + p["P3"]) / 3)},
            "expected basic points that are not coplanar",
        ),
        ({"change": lambda p: p.update(P9=[1.0, 2.0])}, "points.P9: expected three numbers, got [1.0, 2.0]"),
        ({"unit_of_centers": "km"}, "centers: expected the unit of the points, m, got km"),
        ({"unit": "furlong"}, "points: expected a unit among mm, cm, dm, m, km, 1, got furlong"),
        ({"centers": ("left", "other")}, "centers: expected left and right, got left, other"),
    ],
)
def test_a_bad_scene_is_exit_status_2_before_work_begins(tmp_path, arguments, message):
    result = study(written(tmp_path, **arguments), tmp_path / "out")
    assert result.exit_code == 2
    assert message in result.stderr
    assert not (tmp_path / "out").exists()


def test_what_is_no_toml_file_or_no_file_is_exit_status_2(tmp_path):
    (tmp_path / "bad.toml").write_text("points = [")
    result = study(tmp_path / "bad.toml", tmp_path / "out")
    assert result.exit_code == 2
    assert "expected a TOML file" in result.stderr
    assert study(tmp_path / "none.toml", tmp_path / "out").exit_code == 2
    result = CliRunner().invoke(main, ["study", "scene", "--out", str(tmp_path / "out")])
    assert result.exit_code == 2
    assert "file: expected the TOML file of a scene, got none" in result.stderr
    assert not (tmp_path / "out").exists()
