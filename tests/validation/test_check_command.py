"""``foon check``: what it prints and how it exits, for plan results and for FOON text, and how it tells the rules."""

from __future__ import annotations

import json

import pytest
from typer.testing import CliRunner
from validation.soups import SALAD, SOUP, SUBGRAPHS, salad, soup, without

from foon_kg.cli import app
from foon_kg.loaders import write_text
from foon_kg.plans.kitchen import Kitchen
from foon_kg.store.snapshot import Snapshot
from foon_kg.validation import RULES, KnownFoon, tree_from_json
from foon_kg.validation import check as judge
from foon_kg.validation.contract import rule, rules

ACCEPTED = "accepted (robot yes, cook yes, form kept)"
UNPEELED = (SOUP[0], SOUP[2].replace("peeled", "whole"), *SOUP[3:])


@pytest.fixture
def foon(tmp_path):
    folder = tmp_path / "foon"
    folder.mkdir()
    for one in SUBGRAPHS:
        (folder / f"{one.name}.txt").write_text(write_text(one), encoding="utf-8")
    return folder


@pytest.fixture
def check(foon, tmp_path):
    def run(text, *options, name="tree.json", stdin=None):
        (tmp_path / name).write_text(text, encoding="utf-8")
        source = "-" if stdin is not None else str(tmp_path / name)
        return CliRunner().invoke(app, ["check", source, "--files", str(foon), *map(str, options)], input=stdin)

    return run


def tell(*options):
    return CliRunner().invoke(app, ["check", *map(str, options)])


def findings(result, level):
    """The rules that are named under ``fatal:`` or ``minor:``, and with each its line."""
    found, under = [], ""
    for line in result.stdout.splitlines():
        if line in {"  fatal:", "  minor:"}:
            under = line.strip(" :")
        elif line.startswith("    ") and under == level:
            found.append(line.strip())
        else:
            under = ""
    return found


def lines(*trees):
    return "\n".join(json.dumps(tree | {"recipe": tree["recipe"] | {"id": str(n)}}) for n, tree in enumerate(trees))


def test_a_tree_that_robot_and_cook_accept(check):
    result = check(json.dumps(salad()))
    assert (result.exit_code, result.stdout) == (0, f"r1: {ACCEPTED}\n")


def test_what_no_robot_can_do_is_told_with_rule_step_nodes_and_reason(check):
    result = check(json.dumps(soup(without(SOUP, 6))))
    assert result.exit_code == 1
    assert result.stdout.startswith("r1: not accepted (robot no, cook yes, form broken: ")
    assert "W3 step 7, stove (on): the stove is said to be on, and nobody turned it on" in findings(result, "fatal")


def test_what_no_cook_would_serve_is_told_of_the_whole_tree(check):
    result = check(json.dumps(salad(without(SALAD, 1))))
    assert result.exit_code == 1
    assert result.stdout.startswith("r1: not accepted (robot yes, cook no, form kept)")
    assert "K2: tomato is in the dish in one piece" in findings(result, "fatal")


def test_fatal_findings_come_before_minor_ones_and_each_once(check):
    tree = soup(without(UNPEELED, len(UNPEELED) - 1))
    result = check(json.dumps(tree))
    titles = [line.strip() for line in result.stdout.splitlines() if line in {"  fatal:", "  minor:"}]
    assert titles == ["fatal:", "minor:"]
    assert "C3: the stove is still on at the end" in findings(result, "fatal")
    assert "K2: carrot is in the dish in its skin" in findings(result, "minor")
    told = findings(result, "fatal") + findings(result, "minor")
    assert len(told) == len(json.loads(check(json.dumps(tree), "--json").stdout)["findings"])


@pytest.mark.slow
def test_a_minor_finding_alone_is_no_failure(check):
    result = check(json.dumps(soup(UNPEELED)))
    assert result.exit_code == 0, result.stdout
    assert result.stdout.splitlines()[:3] == [
        f"r1: {ACCEPTED}",
        "  minor:",
        "    K2: carrot is in the dish in its skin",
    ]


def test_a_tree_that_is_accepted_and_breaks_its_form_fails(check):
    result = check(json.dumps(soup(SOUP[:-1])))
    assert result.exit_code == 1
    assert result.stdout.startswith("r1: accepted (robot yes, cook yes, form broken: C3)\n")


def test_what_is_allowed_and_must_be_told_is_told(check):
    result = check(json.dumps(soup()))
    assert (result.exit_code, result.stdout.splitlines()) == (
        0,
        [f"r1: {ACCEPTED}", "  free foods that nobody asked for: water"],
    )


def test_json_is_the_report(check):
    snapshot = Snapshot.of(SUBGRAPHS, Kitchen.default())
    foon = KnownFoon.of(snapshot.units, snapshot.goals())
    for tree in (salad(), soup(without(SOUP, 6)), soup(UNPEELED)):
        expected = judge(tree_from_json(tree), foon).to_json()
        assert json.loads(check(json.dumps(tree), "--json").stdout) == expected


def test_json_lines_in_and_out(check):
    result = check(lines(salad(), salad(without(SALAD, 1)), soup()), "--json")
    reports = [json.loads(line) for line in result.stdout.splitlines()]
    assert [(r["name"], r["robot"], r["cook"], r["accepted"], r["form"]) for r in reports] == [
        ("0", True, True, True, True),
        ("1", True, False, False, True),
        ("2", True, True, True, True),
    ]
    (finding,) = [one for one in reports[1]["findings"] if one["rule"] == "K2"]
    assert (finding["level"], finding["unit"], finding["nodes"]) == ("fatal", None, [])
    assert result.exit_code == 1


def test_json_spread_over_lines(check):
    assert check(json.dumps(salad(), indent=2)).exit_code == 0


def test_standard_input(check):
    assert check("", stdin=json.dumps(salad())).stdout == f"r1: {ACCEPTED}\n"


def test_different_trees_for_one_recipe(check):
    other = salad()
    other["reference"]["overlap"] = 1
    result = check("\n".join(map(json.dumps, [salad(), salad(), other])))
    assert result.exit_code == 1
    assert result.stdout.splitlines() == [
        f"r1: {ACCEPTED}",
        f"r1: {ACCEPTED}",
        "r1: accepted (robot yes, cook yes, form broken: C9)",
        "  fatal:",
        "    C9: answer 1 differs from the first in reference.overlap",
        "  C9 takes plans of one recipe for asked in one kitchen and with the same wishes, which they do not tell",
    ]
    assert "wishes" not in check("\n".join(map(json.dumps, [salad(), salad()]))).stdout
    nobody_asked = [{key: value for key, value in one.items() if key != "recipe"} for one in (salad(), other)]
    assert "C9" not in check("\n".join(map(json.dumps, nobody_asked))).stdout
    answers = check("\n".join(map(json.dumps, [salad(), salad()])), "--json").stdout.splitlines()
    assert [[one["rule"] for one in json.loads(answer)["not_asked"]] for answer in answers] == [["C9"], []]


def test_a_recipe_without_a_tree_is_accepted_by_nobody(check):
    failure = {
        "recipe": salad()["recipe"],
        "error": {"code": "no-goal", "message": "this FOON has no salad", "hint": ""},
    }
    result = check(json.dumps(failure))
    assert result.exit_code == 1
    assert result.stdout.startswith("r1: no tree\n")
    assert "there is no tree: this FOON has no salad" in result.stdout
    value = json.loads(check(json.dumps(failure), "--json").stdout)
    assert [value[name] for name in ("accepted", "robot", "cook", "form")] == [False] * 4


def test_foon_text_and_what_was_not_asked(check):
    result = check(write_text(SUBGRAPHS[0]), name="mine.txt")
    assert (result.exit_code, result.stdout.splitlines()) == (
        0,
        [f"mine: {ACCEPTED}", "  not asked: C4, C5, K6 (no recipe is known)"],
    )


def test_foon_text_with_its_recipe(check, tmp_path):
    asked = salad()["recipe"] | {"type": "salad"}
    asked["ingredients"] = asked["ingredients"][:1]
    (tmp_path / "recipe.json").write_text(json.dumps(asked), encoding="utf-8")
    result = check(write_text(SUBGRAPHS[0]), "--recipe", tmp_path / "recipe.json", name="mine.txt")
    assert result.exit_code == 1
    assert "salt comes from the kitchen and nobody asked for it" in result.stdout


def test_a_kitchen_that_lacks_what_a_tree_takes(check, tmp_path):
    kitchen = tmp_path / "kitchen.txt"
    kitchen.write_text("cutting board\nbowl\nspoon\n", encoding="utf-8")
    result = check(json.dumps(salad()), "--kitchen", kitchen)
    assert result.exit_code == 1
    assert findings(result, "fatal") == ["C6 step 2, knife: it is not in the kitchen that was named"]
    kitchen.write_text("cutting board\nbowl\nspoon\nknife\n", encoding="utf-8")
    assert check(json.dumps(salad()), "--kitchen", kitchen).stdout == f"r1: {ACCEPTED}\n"


def test_what_a_person_names_as_chopped_is_chopped(check, tmp_path):
    kitchen = tmp_path / "kitchen.txt"
    kitchen.write_text("tomato, chopped\nsalt\n", encoding="utf-8")
    ready = "tomato(chopped); bowl(empty) > pour > bowl{tomato}; tomato(chopped)@bowl"
    tree = salad((ready, *SALAD[3:]))
    tree["units"][0]["seen_in"][0]["unit"] = 2
    assert [line[:9] for line in findings(check(json.dumps(tree)), "fatal")] == ["C6 step 1"]
    assert check(json.dumps(tree), "--kitchen", kitchen).exit_code == 0
    kitchen.write_text("tomato\nsalt\n", encoding="utf-8")
    assert "it is not in the kitchen" in check(json.dumps(tree), "--kitchen", kitchen).stdout


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('{"recipe": 1}', "tree.json:1"),
        ('{"recipe": {}', "tree.json:1"),
        ("{}\n\n{,}", "tree.json"),
        ("", "no task tree"),
    ],
)
def test_what_is_no_tree_is_an_error_with_its_place(check, text, said):
    result = check(text)
    assert result.exit_code == 1
    assert said in result.stderr


def test_a_file_that_is_not_there():
    assert tell("nowhere.json", "--files", "nowhere").exit_code == 2


def test_nothing_to_check_is_wrong_usage():
    result = tell()
    assert (result.exit_code, result.stdout) == (2, "")
    assert "there is no tree to check" in result.stderr


def test_the_rules_are_listed_without_any_tree():
    result = tell("--rules")
    assert result.exit_code == 0
    heads = [line.split()[0] for line in result.stdout.splitlines() if line and not line.startswith(" ")]
    assert heads == list(RULES)
    value = json.loads(tell("--rules", "--json").stdout)
    assert value == [{"id": one.id, "name": one.name, "summary": one.summary} for one in rules()]


@pytest.mark.parametrize("name", ["W3", "w3"])
def test_one_rule_is_told_with_its_text_and_its_examples(name):
    result, asked = tell("--rule", name), rule("W3")
    assert result.exit_code == 0
    assert result.stdout.startswith(f"W3 {asked.name}\n\n{asked.text}\n")
    shown = [line.strip() for line in result.stdout.splitlines()]
    for example in (asked.keeps, asked.breaks):
        assert all(line.strip() in shown for line in example.splitlines())
    assert json.loads(tell("--rule", name, "--json").stdout) == {
        "id": "W3",
        "name": asked.name,
        "summary": asked.summary,
        "text": asked.text,
        "keeps": asked.keeps,
        "breaks": asked.breaks,
    }


@pytest.mark.parametrize("name", ["S1", "W9", ""])
def test_an_unknown_rule_is_wrong_usage_that_names_the_rules(name):
    result = tell("--rule", name)
    assert (result.exit_code, result.stdout) == (2, "")
    assert f"there is no rule “{name}”" in result.stderr
    assert "W3" in result.stderr


@pytest.mark.parametrize("options", ["--rules plans.jsonl", "--rule W3 plans.jsonl", "--rules --rule W3"])
def test_rules_are_told_alone(options):
    result = tell(*options.split())
    assert (result.exit_code, result.stdout) == (2, "")
    assert "--rules and --rule stand alone" in result.stderr


def test_the_sense_measures_are_gone():
    assert tell("plans.jsonl", "--sense").exit_code == 2
