"""Files for other programs hold the table: read back by pandas, SciPy and pyarrow."""

import pandas as pd
import pytest
from pyarrow import csv
from scipy.io import loadmat

import stridemap
from stridemap.errors import InputError, StorageError


def test_csv_has_all_digits_and_units_beside_it(table, tmp_path):
    paths = table.export(tmp_path / "t.csv")
    assert [path.name for path in paths] == ["t.csv", "t_columns.csv"]
    back = csv.read_csv(paths[0]).to_pandas()
    for name in ("k", "period", "cot", "multiplier_1_im"):
        assert back[name].tolist() == table.frame[name].tolist()
    about = pd.read_csv(paths[1]).set_index("column")
    assert about.index.tolist() == back.columns.tolist()
    assert about.unit["Kd"] == "M g L sqrt(L/g)"
    assert about.meaning["cot"] == "cost of transport"


def test_mat(table, tmp_path):
    (path,) = table.export(tmp_path / "t.mat")
    read = loadmat(path, squeeze_me=True, struct_as_record=False)
    assert read["orbits"].cot.tolist() == table.frame.cot.tolist()
    assert read["orbits"].group.tolist() == table.frame.group.tolist()
    assert read["orbits"].peaks.dtype.kind == "i"
    assert read["grid"].alpha.tolist() == [0.2, 0.25]
    assert read["cells"].status.tolist() == table.cells.status.tolist()
    assert (read["units"].speed, read["meanings"].cot, read["model"]) == (
        "sqrt(g L)",
        "cost of transport",
        "wobbling",
    )
    first = path.read_bytes()
    table.export(path)
    assert path.read_bytes() == first  # without the time that SciPy writes
    assert loadmat(path, squeeze_me=False)["orbits"]["cot"][0, 0].shape == (len(table), 1)


def test_parquet_says_what_its_columns_hold(orbits, tmp_path):
    path = tmp_path / "orbits_here.parquet"
    stridemap.Units(0.75, 32).table_si(orbits).to_parquet(path)
    back = stridemap.read_table(path)
    assert (back.model, back.what) == ("wobbling", "limit cycles")
    assert back.columns["k"].unit == "N/m"
    with pytest.raises(InputError, match="in SI units already: k is in N/m"):
        back.to_si(stridemap.Units(0.75, 32))


def test_hostile_words_in_a_file_are_not_taken(orbits, tmp_path):
    frame = orbits.to_frame()
    frame.attrs["stridemap"]["columns"]["k"]["label"] = "x\x1b[31m\n"
    frame.attrs["stridemap"]["columns"]["cot"]["unit"] = ["no text"]
    frame.attrs["stridemap"]["model"] = {"no": "text"}
    frame.to_parquet(tmp_path / "h.parquet")
    back = stridemap.read_table(tmp_path / "h.parquet")
    assert back.columns["k"].label == "x[31m"
    assert back.columns["cot"].label == "cost of transport"
    assert back.model == ""


def test_a_csv_and_its_model(orbits, tmp_path):
    orbits.to_frame().to_csv(tmp_path / "o.csv", index=False)
    plain = stridemap.read_table(tmp_path / "o.csv")
    assert plain.columns["k"].unit == ""
    assert plain.columns["cot"].label == "cost of transport"
    named = stridemap.read_table(tmp_path / "o.csv", "wobbling")
    assert named.columns["k"].unit == "M g / L"
    with pytest.raises(InputError, match="has no column mu, which tables of goswami_compass have"):
        stridemap.read_table(tmp_path / "o.csv", "goswami_compass")


@pytest.mark.parametrize(
    ("name", "content", "sentence"),
    [
        ("no.xls", b"", "is not a table; give the output folder of a sweep, or a file that ends in"),
        ("no.parquet", b"PAR1 not", "damaged or is not a Parquet file"),
        ("empty.csv", b"", "is not a table of comma-separated values"),
        ("bad.csv", b"a,b\n1,2\n1,2,3\n", "is not a table of comma-separated values"),
        ("bytes.csv", b"\xff\xfe\x00", "is not a table of comma-separated values"),
        ("gone.csv", None, "cannot read"),
    ],
)
def test_files_that_are_no_tables(tmp_path, name, content, sentence):
    if content is not None:
        (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match=sentence):
        stridemap.read_table(tmp_path / name)


def test_refusals(table, tmp_path):
    with pytest.raises(InputError, match="must end in .csv, .mat, .nc, .parquet"):
        table.export(tmp_path / "t.txt")
    with pytest.raises(InputError, match="has the name of a table that a sweep wrote; choose another name"):
        table.export(tmp_path / "orbits.parquet")
    (tmp_path / "folder.csv").mkdir()
    with pytest.raises(StorageError, match="cannot write .*folder.csv"):
        table.export(tmp_path / "folder.csv")
