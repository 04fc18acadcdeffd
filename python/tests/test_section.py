"""Sections with tables, against the command."""

import csv
import io

import numpy as np
import pytest

import sextic

CASE = "derivations/cases/tuned.toml"


def columns(text):
    heading, *rows = csv.reader(io.StringIO(text))
    return {name: [row[place] for row in rows] for place, name in enumerate(heading)}


@pytest.mark.parametrize("settings", [{}, {"U": 12.0}])
def test_columns_are_those_of_the_command(command, settings):
    words = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
    expected = columns(command("stability", CASE, *words, "--format", "csv", is_json=False))
    found = sextic.Section.from_toml(CASE).with_(**settings).stability()
    assert found.keys() == expected.keys() and len(found["alpha_deg"]) > 300
    assert found["verdict"].tolist() == expected["verdict"]
    for name in ["alpha_deg", "s3d_exact", "s3d_closed", "frequency_hz"]:
        np.testing.assert_array_equal(found[name], [float(own or "nan") for own in expected[name]])


def test_a_data_frame_stands_in_for_a_table():
    pandas = pytest.importorskip("pandas")
    table = pandas.read_csv("derivations/cases/formulas.csv", comment="#")
    found = sextic.Section.from_table(CASE, table).stability()
    frame = pandas.DataFrame(found)
    np.testing.assert_array_equal(frame["s3d_exact"], sextic.Section.from_toml(CASE).stability()["s3d_exact"])


def test_what_cannot_be_used_is_told(tmp_path):
    for path in ["missing.toml", tmp_path]:
        with pytest.raises(sextic.InputError, match="cannot be read"):
            sextic.Section.from_toml(path)
    wrong = tmp_path / "wrong.toml"
    wrong.write_text("[section]\nD = -1\n", encoding="utf-8")
    with pytest.raises(sextic.InputError, match=r"wrong\.toml"):
        sextic.Section.from_toml(wrong)
    with pytest.raises(sextic.InputError, match="did you mean `U`"):
        sextic.Section.from_toml(CASE).with_(u=1)
    with pytest.raises(sextic.InputError, match="data frame"):
        sextic.Section.from_table(CASE, [1, 2])
