"""Names of dishes by their families: each is reached, and by a row that makes what is called so."""

from __future__ import annotations

from collections import Counter, defaultdict

import pytest

from foon_kg.food import tables, words
from foon_kg.food.lists import names_in
from foon_kg.food.shipped import shipped
from foon_kg.food.techniques import TABLES, techniques_called
from foon_kg.model import DISH_TYPES

FAMILIES = shipped("families")["families"]


def rows_of_families():
    """Return the names of the rows that say in ``called`` that they make a family, by the family."""
    found = defaultdict(set)
    for table in TABLES:
        for name, row in shipped(table)["techniques"].items():
            for one in row.get("called", ()):
                if one.startswith("@") and one[1:] in FAMILIES:
                    found[one[1:]].add(name)
    return found


ROWS = rows_of_families()


def reaching(title):
    """Yield the rows by whose name a dish may be called so, of whatever type."""
    told = words(title)
    for dish_type in DISH_TYPES:
        for one in techniques_called(dish_type, told):
            if one.called and one.is_called(dish_type, told):
                yield one.name


def reached(title):
    return set(reaching(title))


def test_every_family_has_a_row_that_makes_it():
    assert set(ROWS) == set(FAMILIES)


def test_every_name_reaches_a_row_of_its_family():
    named = [(family, name) for family, names in FAMILIES.items() for name in names]
    assert [(family, name) for family, name in named if ROWS[family].isdisjoint(reaching(name))] == []


def test_no_row_repeats_a_name_that_its_own_family_has():
    rows = [row["called"] for table in TABLES for row in shipped(table)["techniques"].values() if "called" in row]
    families = [{name for one in called if one[1:] in FAMILIES for name in FAMILIES[one[1:]]} for called in rows]
    assert [
        one
        for called, names in zip(rows, families, strict=True)
        for one in called
        if not one.startswith("@") and " ".join(words(one)) in names
    ] == []


def test_names_stand_as_words_of_a_title_are_compared():
    assert [name for names in FAMILIES.values() for name in names if name != " ".join(words(name))] == []


def test_no_name_is_of_two_families():
    counted = Counter(name for names in FAMILIES.values() for name in names)
    assert [name for name, times in counted.items() if times > 1] == []


def test_a_list_that_is_no_family_has_names_too():
    assert names_in("is rubbed and strewn") == {"betty", "crisp", "crumble"}
    with pytest.raises(KeyError):
        names_in("no such list")


@pytest.mark.parametrize(
    ("title", "family", "hidden"),
    [
        ("Esfiha aberta de carne", "risen dough under a topping", "parcels of dough, baked"),
        ("Gua bao with pork belly", "risen dough, steamed", "risen dough closed around a filling, steamed"),
        ("Hong Kong bolo bao", "rich dough that rises, shaped as buns", "risen dough closed around a filling, steamed"),
        ("Poulet roti aux herbes", "roast", "flat dough in a pan"),
        ("Dal puri", "thin dough around a filling, in a pan", "dough fried in much fat"),
    ],
)
def test_a_longer_name_hides_one_of_another_family_inside_it(title, family, hidden):
    assert reached(title) & ROWS[family]
    assert not reached(title) & ROWS[hidden] - ROWS[family]


def test_a_name_beside_a_longer_one_that_has_it_is_told_by_itself():
    assert reached("Bolo bao and bao") & ROWS["risen dough closed around a filling, steamed"]


def test_a_dish_is_not_known_by_a_name_inside_a_longer_one():
    named = {title: {dish.name for dish in tables().dishes_named(title)} for title in ("shotis puri", "puri")}
    assert named == {"shotis puri": set(), "puri": {"puri"}}


@pytest.mark.parametrize(("title", "is_so"), [("Trinidad Doubles", True), ("Double Cheeseburgers", False)])
def test_what_is_doubled_is_not_fried_bread(title, is_so):
    assert ("risen dough fried as rolls, opened and filled" in reached(title)) is is_so


def test_a_dish_of_a_family_is_known_by_each_of_its_names():
    dishes = tables().dishes
    assert {"bread", "cake"} <= dishes["mandazi"].is_no & dishes["oliebol"].is_no
    assert dishes["chebureki"].is_no == {"pie", "bread", "cake", "cookie"}


@pytest.mark.parametrize(
    ("row", "titles"),
    [
        (
            "dough closed around a filling and fried",
            ["Crimean Chebureki", "Punjabi Samosas", "Karipap (curry puffs)", "Brik à l'oeuf"],
        ),
        (
            "folded around a filling and baked",
            ["Uzbek Samsa with lamb", "Fatayer bi sabanekh", "Jamaican beef patties", "Forfar Bridies"],
        ),
        (
            "filled dough",
            ["Siberian pelmeni", "Georgian Khinkali", "Culurgiones"],
        ),
        ("filled dough, steamed", ["Afghan Mantu and manti", "Xiao Long Bao", "Tibetan Momos", "Pork Shumai"]),
        ("risen dough closed around a filling, steamed", ["Char siu bao", "Baozi", "Siopao asado", "Germknödel"]),
        ("risen dough, steamed", ["Mantou", "Hua juan", "Czech houskový knedlík"]),
        ("batter steamed", ["Rava idli", "Khaman dhokla", "Puto cheese", "Moi Moi"]),
        ("dough around a filling in leaves, steamed", ["Red chile pork tamales", "Humitas"]),
        ("dough around a filling in leaves, boiled", ["Hallacas venezolanas", "Zongzi"]),
        ("wrapped in leaves and steamed", ["Otak Otak", "Lo Mai Gai", "Patra ni Machhi", "Suman malagkit"]),
        ("dough of rice flour, steamed", ["Idiyappam", "Ukadiche Modak"]),
        ("pudding steamed in a covered basin", ["Christmas Pudding", "Spotted Dick", "Boston Brown Bread"]),
        ("eggs in broth, set in steam", ["Chawanmushi", "Chinese Steamed Eggs", "Gyeran Jjim"]),
        (
            "pieces stewed in their sauce",
            ["Hungarian gulyás", "Beef Rendang", "Doro Wat", "Poulet Yassa", "Carne mechada", "Pörkölt"],
        ),
        (
            "fish and shellfish stewed in their sauce",
            ["Marmitako", "Moqueca de peixe", "Bouillabaisse", "Halászlé", "Macher jhol"],
        ),
        ("pieces on skewers", ["Shish Tawook", "Jujeh kabab", "Mtsvadi", "Arrosticini", "Pinchos morunos"]),
        ("minced meat shaped by hand, done under the grill", ["Ćevapi", "Adana kebab", "Mititei", "Lamb seekh kebab"]),
        ("patties of minced meat, fried", ["Kotlety mielone", "Chapli kebab", "Frikadeller"]),
        ("mash around a filling, fried", ["Papas rellenas", "Alcapurrias", "Batata vada"]),
        ("thick white sauce, shaped, breaded and fried", ["Croquetas de jamón", "Dutch bitterballen"]),
        ("grated, shaped and fried", ["Draniki", "Raggmunk", "Mücver"]),
        ("batter fried on both sides", ["Bánh xèo", "Cachapas con queso", "Okonomiyaki", "Bindaetteok", "Palačinke"]),
        ("thin dough around a filling, cooked in a pan", ["Spinach Gözleme", "Bolani kachaloo", "Plăcinte cu brânză"]),
        ("rolled leaves", ["Gołąbki", "Sarmale", "Kåldolmar", "Warak enab", "Töltött káposzta"]),
        ("stuffed raw and simmered in a sauce", ["Punjene paprike", "Ardei umpluți", "Kousa mahshi"]),
        ("vegetables stuffed and baked", ["Gemista", "Petits farcis: tomates farcies", "Chiles en nogada"]),
        ("rolled flesh", ["Alouettes sans tête", "Španělský ptáček", "Rinderrouladen"]),
        ("breaded and fried", ["Milanesa napolitana", "Backhendl", "Kotlet schabowy", "Smažený řízek"]),
        ("layers of what was fried, baked", ["Pastelón de plátano", "Tombet", "Tepsi baytinijan"]),
        ("custard baked, under jam and beaten whites", ["Queen of Puddings"]),
        ("meal fried in fat, and swollen in syrup or milk", ["Sooji halwa", "Irmik helvasi", "Rava kesari"]),
        ("a thick pancake torn to pieces", ["Kaiserschmarrn"]),
        ("mash around a filling, boiled", ["Marillenknödel", "Cepelinai", "Švestkové knedlíky"]),
        ("bread soaked, shaped as dumplings and boiled", ["Semmelknödel", "Canederli"]),
        ("dough that is fried in oil", ["Faworki", "Oliebollen", "Mandazi", "Bomboloni", "Vetkoek"]),
        ("balls of dough, fried and soaked in syrup", ["Luqaimat", "Gulab jamun", "Chebakia"]),
        ("rich dough that rises, shaped as buns", ["Semlor", "Conchas", "Pandesal"]),
        ("thin layers of dough baked, and stacked with a cream", ["Medovik", "Torta Rogel"]),
        ("dipped and laid in layers", ["Bolo de bolacha", "Carlota de limón"]),
        ("flat bread under what is stewed", ["Jordanian Mansaf", "Thareed", "Rfissa"]),
        ("flat bread under onions and fowl, baked", ["Musakhan"]),
        ("roasted whole, skinned and dressed", ["Escalivada", "Salade mechouia", "Salată de vinete"]),
        ("caramel below a custard", ["Flan napolitano", "Pudim de leite", "Quindim"]),
        ("stirred over the heat until it is thick", ["Arroz doce", "Mazamorra morada", "Ashure", "Rødgrød med fløde"]),
    ],
)
def test_titles_as_people_write_them_reach_their_family(row, titles):
    assert [title for title in titles if row not in reached(title)] == []


@pytest.mark.parametrize(
    ("row", "titles"),
    [
        ("risen dough closed around a filling, steamed", ["Gai Mei Bao", "Bolo Bao", "Gua Bao"]),
        ("batter steamed", ["Puto Seko"]),
        ("dough closed around a filling and fried", ["Pastelitos criollos"]),
        ("thin layers of dough baked, and stacked with a cream", ["Krispy Kreme Bread Pudding"]),
        ("dough that is fried in oil", ["Chocolate Rosette Cake"]),
        ("pulses ground, shaped and fried", ["Bara Brith"]),
        ("caramel below a custard", ["Baked Custard", "Egg Custard", "Petits Pots de Crème", "Crème Brûlée"]),
    ],
)
def test_a_name_inside_that_of_another_dish_reaches_no_row_of_its_family(row, titles):
    assert [title for title in titles if row in reached(title)] == []
