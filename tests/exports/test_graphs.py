"""DOT, Mermaid and GraphML say the same graph: one node an object and a unit, one edge an input and an output."""

from __future__ import annotations

import html
import json
import re
from dataclasses import replace

import pytest
from exports.odd_trees import of_file, trees
from hypothesis import given, settings
from kitchen_stories import SALAD, node, subgraph, unit

from foon_kg.food.motion_costs import MotionCosts
from foon_kg.formats.exports.dot import write_dot
from foon_kg.formats.exports.graph import BipartiteGraph
from foon_kg.formats.exports.graphml import write_graphml
from foon_kg.formats.exports.mermaid import write_mermaid
from foon_kg.formats.exports.tree import ExportedTree
from foon_kg.model import Recipe, Sighting
from foon_kg.model.errors import FormatError
from foon_kg.model.tree import Step, nodes_of
from foon_kg.plans.kitchen import Kitchen
from foon_kg.plans.result import PlanResult, ReferenceSummary
from foon_kg.store.snapshot import Snapshot

MERMAID_NODE = re.compile(r'  (\w+)(\(\[|\[)"((?:[\w ,.()\-+*\'/!]|#\d+;)*)"(\]\)|\]):::(food|utensil|goal|motion)')
MERMAID_EDGE = re.compile(r"  (\w+) (-->|==>) (\w+)")


def shape(tree):
    """The nodes and edges that a tree has, counted without any help of the exports."""
    objects = {node for known in tree.units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
    edges = sum(len(k.unit.input_nodes) + len(k.unit.output_nodes) for k in tree.units)
    return len(objects | set(tree.kitchen)), len(tree.units), edges


def read_by_networkx(graphml):
    from networkx import parse_graphml

    return parse_graphml(graphml)


def nodes_in(tree):
    return nodes_of(known.unit for known in tree.units)


def parsed_mermaid(text):
    """Read a flowchart strictly: every line has to be one that is known."""
    first, title, last, kind, *lines = text.splitlines()
    assert (first, last, kind) == ("---", "---", "flowchart TD")
    nodes, edges = {}, []
    for line in lines:
        if line.startswith("  classDef "):
            continue
        if node := MERMAID_NODE.fullmatch(line):
            nodes[node[1]] = (html.unescape(re.sub(r"#(\d+);", r"&#\1;", node[3])), node[5])
        else:
            edge = MERMAID_EDGE.fullmatch(line)
            assert edge, line
            edges.append((edge[1], edge[3], edge[2] == "==>"))
    return json.loads(title.removeprefix("title: ")), nodes, edges


@settings(max_examples=25, deadline=None)
@given(trees)
def test_a_flowchart_has_the_graph_and_every_name(tree):
    title, nodes, edges = parsed_mermaid(write_mermaid(BipartiteGraph.of_tree(tree)))
    objects, units, count = shape(tree)
    motions = [text for text, kind in nodes.values() if kind == "motion"]
    assert title == tree.title
    assert (len(nodes), len(motions), len(edges)) == (objects + units, units, count)
    assert motions == [known.unit.motion + "*" * known.unit.accepts_any for known in tree.units]
    assert {str(node) for node in nodes_in(tree)} <= {text for text, _ in nodes.values()}
    assert {end for edge in edges for end in edge[:2]} <= nodes.keys()


@settings(max_examples=25, deadline=None)
@given(trees)
def test_graphml_gives_networkx_every_field(tree):
    graph = read_by_networkx(write_graphml(BipartiteGraph.of_tree(tree)))
    objects, units, count = shape(tree)
    found = [data for _, data in graph.nodes(data=True) if data["kind"] != "motion"]
    assert (graph.number_of_nodes(), graph.number_of_edges()) == (objects + units, count)
    read = {
        (
            d["label"],
            *map(tuple, map(json.loads, (d["states"], d["ingredients"]))),
            d.get("relation"),
            d.get("container"),
        )
        for d in found
    }
    assert read >= {(n.label, n.states, n.ingredients, n.relation, n.container) for n in nodes_in(tree)}
    assert len(read) == objects
    motions = [graph.nodes[f"m{place}"] for place in range(1, units + 1)]
    assert [(m["motion"], m["accepts_any"]) for m in motions] == [
        (k.unit.motion, k.unit.accepts_any) for k in tree.units
    ]


def test_graphml_has_the_success_rate_of_motions_that_have_a_weight():
    tree = of_file(subgraph("salad", "salad", *SALAD))
    motions = sorted({known.unit.motion for known in tree.units})
    costs = MotionCosts({motions[0]: 0.9})
    graph = read_by_networkx(write_graphml(BipartiteGraph.of_tree(tree, costs)))
    rates = {values["motion"]: values.get("success_rate") for _, values in graph.nodes(data=True) if "motion" in values}
    assert len(rates) > 1
    assert rates == dict.fromkeys(motions) | {motions[0]: 0.1}


@pytest.mark.filterwarnings("ignore::DeprecationWarning:pydot")  # its own use of pyparsing
@settings(max_examples=8, deadline=None)
@given(trees)
def test_dot_is_read_by_a_parser_of_dot(tree):
    from pydot import graph_from_dot_data

    (graph,) = graph_from_dot_data(write_dot(BipartiteGraph.of_tree(tree)))
    objects, units, count = shape(tree)
    nodes = {node.get_name(): node for node in graph.get_nodes() if re.fullmatch(r"[om]\d+", node.get_name())}
    assert (len(nodes), len(graph.get_edges())) == (objects + units, count)
    labels = {unquoted(node.get("label")) for node in nodes.values()}
    assert {str(node) for node in nodes_in(tree)} <= labels


def unquoted(text):
    assert text[0] == text[-1] == '"'
    return re.sub(r"&amp;(?=#?\w+;)", "&", re.sub(r"\\(.)", r"\1", text[1:-1]))


def test_colours_tell_goal_foods_utensils_and_motions_and_what_moves_is_thick():
    text = write_dot(BipartiteGraph.of_tree(of_file(subgraph("salad", "salad", *SALAD))))
    assert text.count("#f2c14e") == 1
    assert text.count("#e06666") == len(SALAD)
    assert '[label="knife", shape=ellipse, fillcolor="#d5ecdb", peripheries=2]' in text
    assert '[label="onion (chopped; in bowl)", shape=ellipse, fillcolor="#8bc99b"]' in text


def test_a_whole_foon_is_one_graph_in_which_videos_meet():
    lines = ("onion(whole); knife > chop > onion(chopped)", "onion(chopped) > fry > soup{onion}")
    foon = Snapshot.of([subgraph("a", "soup", *lines), subgraph("b", "soup", *lines)], Kitchen.default())
    graph = read_by_networkx(write_graphml(BipartiteGraph.of_foon(foon)))
    assert (graph.number_of_nodes(), graph.number_of_edges()) == (6, 5)
    chop = next(data for _, data in graph.nodes(data=True) if data.get("motion") == "chop")
    assert [seen["video"] for seen in json.loads(chop["seen_in"])] == ["a", "b"]
    from networkx import is_directed_acyclic_graph

    assert is_directed_acyclic_graph(graph)


def test_control_characters_are_refused_where_xml_cannot_hold_them():
    tree = of_file(subgraph("x", "soup", "onion\x07 > fry > soup{onion}"))
    with pytest.raises(FormatError, match=r"U\+0007"):
        write_graphml(BipartiteGraph.of_tree(tree))


def with_numbers(unit, *sides):
    inputs, outputs = (
        tuple(one._replace(thing=number, container_thing=within) for one, (number, within) in zip(*both, strict=True))
        for both in zip((unit.inputs, unit.outputs), sides, strict=True)
    )
    return replace(unit, inputs=inputs, outputs=outputs)


def test_two_things_that_look_alike_are_two_nodes_where_the_plan_numbers_them():
    lines = ("bowl; onion > add > bowl{onion}", "bowl; leek > add > bowl{leek}", "bowl{leek}; bowl{onion} > mix > soup")
    things = ([(1, None), (2, None)], [(3, None), (4, None)], [(3, None), (1, None)])
    planned = [Step.of_unit(unit(line), "foon", ()) for line in lines]
    numbered = [
        with_numbers(one, taken, [(taken[0][0] if place < 2 else 5, None)])
        for place, (one, taken) in enumerate(zip(planned, things, strict=True))
    ]
    goal = node("soup")

    def drawn(units):
        result = PlanResult(Recipe("soup", ()), ReferenceSummary(goal, 1, 0, exact=True), goal, tuple(units), ())
        return BipartiteGraph.of_tree(ExportedTree.of_plan(result))

    def bowls(units):
        return sum(one == node("bowl") for one in drawn(units).objects.values())

    assert (bowls(planned), bowls(numbered)) == (1, 2)
    told = read_by_networkx(write_graphml(drawn(numbered)))
    assert {one["thing"] for _, one in told.nodes(data=True) if one.get("text") == "bowl"} == {1, 3}
    for text in (
        write_dot(drawn(numbered)),
        html.unescape(re.sub(r"#(\d+);", r"&#\1;", write_mermaid(drawn(numbered)))),
    ):
        assert all(f'"bowl #{number}"' in text for number in (1, 3))
    assert "thing" not in {
        key for _, one in read_by_networkx(write_graphml(drawn(planned))).nodes(data=True) for key in one
    }


@pytest.mark.parametrize(
    ("source", "linked"),
    [
        ("https://example.org/v?t=1", True),
        ("javascript:alert(1)", False),
        ("file:///etc/passwd", False),
        ("x:[", False),
    ],
)
def test_dot_links_to_pages_of_the_web_only(source, linked):
    graph = BipartiteGraph.of_tree(of_file(subgraph("salad", "salad", *SALAD)))
    seen = (Sighting("salad", 0, source),)
    units = {name: replace(known, seen_in=seen) for name, known in graph.units.items()}
    text = write_dot(replace(graph, units=units))
    assert (f'URL="{source}"' in text) is linked
    assert ("URL=" in text) is linked
