from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from kitchen_stories import SALAD, node, script

from foon_kg.kitchen import Kitchen
from foon_kg.rehearsal import Rehearsal
from foon_kg.replay import replay as replay_script
from foon_kg.script import Casting, Item, Recast, Repertoire, Script, emptied

KITCHEN = Kitchen.default()
SALAD_MADE = node("salad(mixed){onion,salt,tomato}@bowl")


def replay(units, casting, kitchen, additions=None):
    return replay_script(Script.of(units, Repertoire(kitchen)), casting, additions)


def made(replayed):
    return {n for step in replayed.steps for n in step.output_nodes}


def labels(replayed):
    return {n.label for step in replayed.steps for n in (*step.input_nodes, *step.output_nodes)}


def names(nodes):
    return {n.label for n in nodes} | {name for n in nodes for name in n.ingredients}


def test_with_nobody_recast_every_unit_happens_as_it_is_written():
    units = script(*SALAD)
    replayed = replay(units, Casting(), KITCHEN)
    assert [(s.input_nodes, s.motion, s.output_nodes) for s in replayed.steps] == [
        (k.unit.input_nodes, k.unit.motion, k.unit.output_nodes) for k in units
    ]


def test_a_dropped_food_is_gone_everywhere_and_so_are_the_units_that_only_served_it():
    replayed = replay(script(*SALAD), Casting({"onion": None}), KITCHEN)
    assert "onion" not in labels(replayed)
    assert [s.place for s in replayed.steps] == [0, 1, 2, 6, 7]
    assert replayed.items[SALAD_MADE].node == node("salad(mixed){salt,tomato}@bowl")


def test_when_the_first_food_is_dropped_the_next_goes_into_the_vessel_that_is_still_empty():
    replayed = replay(script(*SALAD), Casting({"tomato": None}), KITCHEN)
    step = next(s for s in replayed.steps if s.place == 5)
    assert node("bowl(empty)") in step.input_nodes
    assert node("bowl{onion}") in step.output_nodes


def test_a_recast_food_is_renamed_in_every_label_state_and_list():
    recast = Recast("courgette", {"diced": "sliced"}, {"dice": "slice"})
    replayed = replay(script(*SALAD), Casting({"tomato": recast}), KITCHEN)
    assert "tomato" not in labels(replayed)
    assert [s.motion for s in replayed.steps][:2] == ["pick-and-place", "slice"]
    assert node("courgette(sliced)@bowl") in made(replayed)
    assert replayed.items[SALAD_MADE].node == node("salad(mixed){courgette,onion,salt}@bowl")


def test_an_added_food_flows_from_its_unit_to_the_end_and_not_before():
    olive = Item(node("olive(whole)"), frozenset({("", "olive")}))
    replayed = replay(script(*SALAD), Casting(), KITCHEN, {6: [olive]})
    assert replayed.items[SALAD_MADE].node == node("salad(mixed){olive,onion,salt,tomato}@bowl")
    assert all("olive" not in names((*s.input_nodes, *s.output_nodes)) for s in replayed.steps if s.place < 6)
    assert node("salt(granulated)@bowl") in made(replayed)


def test_a_food_that_joins_keeps_a_unit_going_whose_own_food_was_dropped():
    olive = Item(node("olive(whole)"), frozenset({("", "olive")}))
    replayed = replay(script(*SALAD), Casting({"salt": None}), KITCHEN, {6: [olive]})
    step = next(s for s in replayed.steps if s.place == 6)
    assert set(step.input_nodes) == {node("bowl{onion,tomato}"), node("olive(whole)")}
    assert step.output_nodes == (node("bowl{olive,onion,tomato}"),)


def test_a_food_is_taken_from_the_kitchen_once():
    twice = (
        *SALAD[:-1],
        "bowl{onion,salt,tomato}; salt(granulated)@shaker; spoon > mix* > salad(mixed){onion,salt,tomato}@bowl",
    )
    replayed = replay(script(*twice), Casting(), KITCHEN)
    takers = [s.place for s in replayed.steps if node("salt(granulated)@shaker") in s.input_nodes]
    assert takers == [6]
    assert replayed.items[SALAD_MADE].node == SALAD_MADE


def test_a_name_that_the_script_forgets_is_carried_to_the_end():
    forgets = (*SALAD[:-1], "bowl{onion,salt,tomato}; spoon > mix* > salad(mixed){onion,salt}@bowl")
    goal = node("salad(mixed){onion,salt}@bowl")
    assert replay(script(*forgets), Casting(), KITCHEN).items[goal].node.ingredients == ("onion", "salt")
    carried = replay(script(*forgets), Casting(carried=frozenset({"tomato"})), KITCHEN)
    assert carried.items[goal].node.ingredients == ("onion", "salt", "tomato")


def test_a_name_that_nothing_brings_is_not_written_down():
    sloppy = (*SALAD[:-1], "bowl{onion,salt,tomato}; spoon > mix* > salad(mixed){feta,onion,salt,tomato}@bowl")
    item = replay(script(*sloppy), Casting(), KITCHEN).items[node("salad(mixed){feta,onion,salt,tomato}@bowl")]
    assert item.node.ingredients == ("onion", "salt", "tomato")


def test_a_vessel_known_as_it_was_is_taken_as_it_is_now():
    stale = (*SALAD[:6], SALAD[6].replace("bowl{onion,tomato};", "bowl{tomato};", 1), SALAD[7])
    step = next(s for s in replay(script(*stale), Casting(), KITCHEN).steps if s.place == 6)
    assert node("bowl{onion,tomato}") in step.input_nodes


@pytest.mark.parametrize("cut", ["lemon juice"])
def test_a_food_cut_from_its_maker_is_a_leaf(cut):
    units = script(
        "lemon(whole); knife > cut > lemon(halved)",
        "lemon(halved); bowl(empty) > squeeze > bowl{lemon juice}; lemon juice(liquid)@bowl",
        "glass(empty); bowl{lemon juice}; lemon juice(liquid)@bowl > pour > lemon juice(liquid)@glass",
    )
    casting = Casting({"lemon": None, cut: Recast(cut)}, cut=frozenset({cut}))
    replayed = replay(units, casting, KITCHEN)
    assert [s.place for s in replayed.steps] == [2]
    assert node("bowl{lemon juice}") in replayed.steps[0].input_nodes


foods = st.sampled_from(["tomato", "onion", "salt"])


@given(
    dropped=st.sets(foods),
    renamed=st.dictionaries(foods, st.sampled_from(["kohlrabi", "leek", "fennel"])),
    places=st.lists(st.sampled_from([2, 5, 6, 7]), max_size=3),
)
def test_nothing_appears_from_nowhere_and_every_input_is_there(dropped, renamed, places):
    casting = Casting({name: Recast(to) for name, to in renamed.items()} | dict.fromkeys(dropped))
    additions = {p: [Item(node(f"extra{i}"), frozenset({("", f"extra{i}")}))] for i, p in enumerate(places)}
    replayed = replay(script(*SALAD), casting, KITCHEN, additions)
    later = set()
    for step in replayed.steps:
        later |= set(step.output_nodes)
    there = set()
    for step in replayed.steps:
        for n in step.input_nodes:
            assert n in there or n not in later or KITCHEN.has(n), f"{n} is used before it is made"
        derived = {n.label for n in step.output_nodes if n.label == "salad"}
        assert names(step.output_nodes) <= names(step.input_nodes) | derived
        assert not set(step.output_nodes) <= set(step.input_nodes)
        there |= set(step.output_nodes)
    gone = dropped - set(renamed.values())
    assert not gone & {name for s in replayed.steps for name in names((*s.input_nodes, *s.output_nodes))}


casts = st.fixed_dictionaries(
    {
        "foods": st.dictionaries(foods, st.sampled_from([None, Recast("leek"), Recast("leek", {"whole": "peeled"})])),
        "carried": st.frozensets(st.sampled_from(["olive", "leek", "tomato"])),
        "goal": st.sampled_from([None, SALAD_MADE]),
    }
)
parties = st.dictionaries(st.sampled_from([2, 5, 6, 7]), st.sampled_from(["olive", "leek"]))


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(casts, parties), min_size=2, max_size=4))
def test_what_was_played_before_changes_nothing(replays):
    repertoire = Repertoire(KITCHEN)
    short, whole = Script.of(script(*SALAD)[2:], repertoire), Script.of(script(*SALAD), repertoire)
    for cast, joining in replays:
        casting = Casting(**cast)
        additions = {place: [Item(node(name), frozenset({("", name)}))] for place, name in joining.items()}
        replay_script(short, casting, additions)
        assert replay_script(whole, casting, additions) == replay(script(*SALAD), casting, KITCHEN, additions)
        assert Rehearsal(whole, casting).replay(additions) == replay(script(*SALAD), casting, KITCHEN, additions)


@settings(max_examples=40, deadline=None)
@given(st.lists(parties, max_size=4))
def test_what_was_rehearsed_before_changes_nothing(rehearsed):
    rehearsal = Rehearsal(Script.of(script(*SALAD), Repertoire(KITCHEN)), Casting({"salt": None}))
    for joining in rehearsed:
        additions = {place: [Item(node(name), frozenset({("", name)}))] for place, name in joining.items()}
        assert rehearsal.replay(additions) == replay(script(*SALAD), rehearsal.casting, KITCHEN, additions)


def test_a_food_made_apart_comes_in_the_place_of_the_leaf_and_its_bowl_is_left_alone():
    units = script(
        "pot(empty); bowl{leek}; leek(chopped)@bowl > pour > pot{leek}; leek(chopped)@pot",
        "pot{leek}; leek(chopped)@pot > fry > leek(fried)@pot",
    )
    on_board = node("leek(chopped)@on cutting_board")
    recast = Recast("leek", ready={node("leek(chopped)@bowl"): on_board})
    first, last = replay(units, Casting({"leek": recast}), KITCHEN).steps
    assert first.input_nodes == (node("pot(empty)"), on_board)
    assert last.output_nodes == (node("leek(fried)@pot"),)


BAKED = (
    "tin(empty); dough(kneaded){flour} > place > tin{dough}; dough(kneaded){flour}@tin",
    "tin{dough}; dough(kneaded){flour}@tin; oven(on) > insert > tin{dough}@in oven; oven(on){tin}",
    "oven(on){tin}; dough(kneaded){flour}@tin > bake > bread(baked){flour}@tin",
)


def test_what_goes_into_the_oven_in_its_tin_is_still_there_to_be_baked():
    kitchen = replace(KITCHEN, utensils=KITCHEN.utensils | {"tin"})
    replayed = replay(script(*BAKED), Casting({"dough": Recast("dough")}), kitchen)
    assert [step.place for step in replayed.steps] == [0, 1, 2]


def test_only_a_vessel_that_is_taken_without_its_food_tells_what_is_in_the_food():
    units = script(
        "bowl{mush}; mush(mixed){leek}@bowl > stir > bowl{mush}; mush(stirred){leek}@bowl",
        "bowl{mush}; plate(empty) > pour > plate{mush}; mush(stirred){leek}@plate",
        "plate{mush}; mush(stirred){leek}@plate > serve > mush(served){leek}@plate",
    )
    assert Script.of(units, Repertoire(KITCHEN)).taken_alone == {node("bowl{mush}")}


def test_a_pan_that_nobody_greased_is_not_greased():
    assert emptied(node("pan(greased,hot){butter}")) == node("pan(empty,hot)")


def test_the_goal_keeps_its_name_and_names_the_food_that_stands_for_it():
    units = script("beefsteak(raw); grill(on) > grill > beefsteak(grilled)@on grill")
    goal = node("beefsteak(grilled)@on grill")
    replayed = replay(units, Casting({"beefsteak": Recast("venison")}, goal=goal), KITCHEN)
    assert replayed.items[goal].node == node("beefsteak(grilled){venison}@on grill")


def test_a_cup_out_of_which_nothing_comes_is_not_poured():
    units = script("pot{salt}; cup{water} > pour > pot{salt,water}; cup(empty)")
    assert replay(units, Casting({"salt": Recast("salt")}), KITCHEN).steps == ()


def test_water_is_there_once_the_tap_is_on_and_who_takes_it_finds_it():
    units = script(
        "faucet(off); measuring cup(empty) > turn on > faucet(on); measuring cup{water}; water@measuring_cup",
        "measuring cup{water}; water@measuring_cup; pot(empty) > pour > pot{water}; water@pot",
    )
    replayed = replay(units, Casting(), KITCHEN)
    assert [(s.input_nodes, s.output_nodes) for s in replayed.steps] == [
        (k.unit.input_nodes, k.unit.output_nodes) for k in units
    ]


def test_what_must_be_paid_for_comes_from_nowhere():
    units = script("faucet(off); bowl(empty) > turn on > faucet(on); bowl{wine}; wine@bowl")
    replayed = replay(units, Casting({"wine": None}), KITCHEN)
    assert "wine" not in names(made(replayed))


def test_what_no_output_names_went_into_what_was_acted_on():
    units = script(
        "salt(granulated); fish(raw)@plate > sprinkle > fish(salted)@plate",
        "lemon juice; fish(salted)@plate > pour > fish(marinated){lemon juice,salt}@plate",
    )
    replayed = replay(units, Casting(), KITCHEN)
    assert replayed.items[node("fish(marinated){lemon juice,salt}@plate")].node.ingredients == ("lemon juice", "salt")


def test_a_unit_that_only_brought_what_is_gone_does_not_happen_whatever_its_motion():
    units = script(
        "foil(empty); green bean(whole) > place > foil{green bean}; green bean(whole)@on foil",
        "foil{green bean}; green bean(whole)@on foil; grinder{black pepper}; black pepper(ground)@grinder"
        " > grind > foil{green bean,pepper}; green bean(whole){black pepper}@on foil",
    )
    assert [step.motion for step in replay(units, Casting({"black pepper": None}), KITCHEN).steps] == ["place"]
    assert [step.motion for step in replay(units, Casting(), KITCHEN).steps] == ["place", "grind"]
