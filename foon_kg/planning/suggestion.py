"""What can be made of what is at hand: the goals of all dish types, each with what is taken, missing and left over.

Goals are ranked cheaply first, by the names of their foods; the best of them are proven: the exact search looks for
the reference tree that lacks the least, and what is said of a dish is what that tree takes. A food of one's own stands
for a food of the dish where a cook would rather accept it than not.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace

from foon_kg.food import singular
from foon_kg.model import Goal, KnownUnit, ObjectNode
from foon_kg.model.errors import NoTreeError, UsageError
from foon_kg.model.json_fields import JsonObject
from foon_kg.model.knowledge import FAIR, KnowledgeView
from foon_kg.model.node_json import node_to_json
from foon_kg.model.tree import leaves_of
from foon_kg.plans.stock import StockedKitchen
from foon_kg.search import ReferenceTree, SearchProblem, UnitIndex, retrieve
from foon_kg.search.gaps import ABSENT, gap_cost, mixtures
from foon_kg.similarity import Similarity, food_similarity

MOST_CONSIDERED = 2_000
"""Of a FOON with more goals so many are looked at: those with most foods that are like the foods at hand."""

LEAST_PROVEN = 10
"""So many of the cheaply ranked goals are proven at least; twice as many as are asked for, where that is more."""

_MISSING = 100_000
"""What the search pays for a food that nobody has: more than for whatever is there in another state."""

_READY_MADE = 10
"""How many missing foods a missing mixture counts for, so that it is made of what is there, if there is a way."""


@dataclass(frozen=True, order=True)
class Taken:
    """A food that a dish takes, the food of one's own that stands for it, and how sure a cook would accept that."""

    food: str
    own: str
    confidence: float


@dataclass(frozen=True)
class Suggestion:
    """A dish and its best reference tree, seen from what is at hand.

    ``missing`` are the foods and utensils that the tree takes and that are not there; where utensils were named,
    :func:`~foon_kg.planning.suggested.as_planned` puts those there that the plan of the dish lacks. ``assumed`` are the
    leaves of which only the food is there, in another state, ``unused`` the foods at hand that the tree does not take.
    ``exact`` says that it is proven that no tree of this goal lacks less food (see ``docs/ties.md`` for the order).

    >>> from foon_kg import Foon
    >>> from foon_kg.foon.demo import demo_folder
    >>> best = Foon.from_files(demo_folder()).suggest(["egg", "butter"], most=1)[0]
    >>> best.goal.node.label, best.missing, best.share
    ('omelette', ('salt',), 0.67)
    """

    goal: Goal
    units: int
    taken: tuple[Taken, ...]
    missing: tuple[str, ...]
    assumed: tuple[ObjectNode, ...]
    unused: tuple[str, ...]
    exact: bool

    @property
    def share(self) -> float:
        """How much of what the dish takes is there (0 to 1), each food weighed with its confidence.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> [dish.share for dish in Foon.from_files(demo_folder()).suggest(["egg", "butter", "salt"], most=2)]
        [1.0, 0.6]
        """
        return round(sum(t.confidence for t in self.taken) / (len(self.taken) + len(self.missing)), 2)

    @property
    def rank(self) -> tuple[object, ...]:
        """The key that suggestions are sorted by, the lesser the better.

        The greatest :attr:`share` comes first, then the fewest ``assumed``, most foods of one's own, the fewest units.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> first, second = Foon.from_files(demo_folder()).suggest(["egg", "butter"], most=2)
        >>> first.rank < second.rank
        True
        """
        own = len({taken.own for taken in self.taken})
        goal = self.goal
        return (-self.share, len(self.assumed), -own, self.units, goal.node.sort_key, goal.dish_type)

    def to_json(self) -> JsonObject:
        """Return one of the ``suggestions`` of ``foon suggest --json``.

        >>> from foon_kg import Foon
        >>> from foon_kg.foon.demo import demo_folder

        >>> told = Foon.from_files(demo_folder()).suggest(["egg", "butter"], most=1)[0].to_json()
        >>> told["dish_type"], told["taken"][0], told["missing"]
        ('omelette', {'food': 'butter', 'own': 'butter', 'confidence': 1.0}, ['salt'])
        """
        return {
            "goal": node_to_json(self.goal.node),
            "dish_type": self.goal.dish_type,
            "videos": list(self.goal.videos),
            "units": self.units,
            "share": self.share,
            "taken": [{"food": t.food, "own": t.own, "confidence": t.confidence} for t in self.taken],
            "missing": list(self.missing),
            "assumed": [node_to_json(node) for node in self.assumed],
            "unused": list(self.unused),
            "exact": self.exact,
        }


@dataclass(frozen=True)
class Suggestions:
    """The best dishes, best first; of ``considered`` goals the trees of ``proven`` were looked for."""

    found: tuple[Suggestion, ...]
    considered: int
    proven: int


def suggest(
    view: KnowledgeView,
    kitchen: StockedKitchen,
    *,
    most: int = 10,
    similarity: Similarity | None = None,
    time_limit: float | None = 20.0,
) -> Suggestions:
    """Return the at most ``most`` dishes of ``view`` that can best be made of what ``kitchen`` names.

    A dish of which nothing is there is none. Foods are compared by ``similarity``, ``None`` for the usual one;
    ``time_limit`` (seconds) is for each tree. Raises :class:`~foon_kg.model.errors.UsageError` where the kitchen names
    no food, and :class:`~foon_kg.model.errors.NoTreeError` where no goal of the FOON takes any of them.
    """
    own = Larder.of(kitchen, similarity or food_similarity())
    goals = view.likely_goals(None, own.foods, MOST_CONSIDERED).goals
    named = {name for goal in goals for name in goal.ingredients}
    own = own.with_mixtures(named, view).knowing(named)
    likely = _most_likely(goals, own, max(LEAST_PROVEN, 2 * most))
    units = view.behind([goal.node for goal in likely])
    own = own.among(units, view)
    index = _index(units, own)
    found = [s for goal in likely if (s := _proven(goal, index, own, time_limit)) is not None and s.taken]
    if not found:
        raise NoTreeError(
            f"no dish of this FOON takes any of {', '.join(own.foods)}",
            code="no-goal",
            hint="Name other foods, or known ones that are like these.",
        )
    return Suggestions(tuple(sorted(found, key=lambda s: s.rank)[:most]), len(goals), len(likely))


@dataclass(frozen=True)
class Larder:
    """One's own foods, and for which foods of a FOON each of them stands.

    ``mixed`` are the foods that the FOON makes of others: nothing else stands for these.
    """

    kitchen: StockedKitchen
    foods: tuple[str, ...]
    similarity: Similarity
    mixed: frozenset[str]
    stands_for: dict[str, tuple[str, float]]

    @classmethod
    def of(cls, kitchen: StockedKitchen, similarity: Similarity) -> Larder:
        """Return the larder that ``kitchen`` names, compared by ``similarity``.

        Raises UsageError where it has no food.
        """
        foods = kitchen.food_names
        if not foods:
            raise UsageError(
                "no food is at hand", hint="Name foods, as in foon suggest egg “chopped onion”, or a --kitchen file."
            )
        return cls(kitchen, foods, similarity, frozenset(), {})

    def with_mixtures(self, names: Collection[str], view: KnowledgeView) -> Larder:
        """Return this larder, where it is known which of ``names`` the FOON of ``view`` makes of others."""
        found = mixtures(self.kitchen.with_every_food(), view.words_named(names))
        return replace(self, mixed=self.mixed | found)

    def knowing(self, names: Collection[str]) -> Larder:
        """Return this larder, with what it has for each of ``names`` as well."""
        new = sorted(set(names) - self.stands_for.keys())
        rows = self.similarity.matrix(new, self.foods).tolist() if new else []
        known = dict(self.stands_for)
        for name, row in zip(new, rows, strict=True):
            same = next((food for food in self.foods if singular(food) == singular(name)), None)
            if same is not None or name in self.mixed:
                known[name] = (same or name, 1.0 if same else 0.0)
            else:
                known[name] = max(zip(self.foods, map(float, row), strict=True), key=lambda r: (r[1], r[0]))
        return replace(self, stands_for=known)

    def own_for(self, name: str) -> tuple[str, float] | None:
        """Return which food of one's own stands for ``name``, and how surely; ``None`` where none fairly does."""
        own, sure = self.stands_for[name]
        return (own, round(sure, 4)) if sure >= FAIR else None

    def taken(self, names: Iterable[str]) -> tuple[Taken, ...]:
        """Return which of ``names`` a food of one's own stands for, sorted by name."""
        found = ((name, self.own_for(name)) for name in sorted(names))
        return tuple(Taken(name, *mine) for name, mine in found if mine is not None)

    def among(self, units: Iterable[KnownUnit], view: KnowledgeView) -> Larder:
        """Return this larder, with what it has for each food of ``units``, of the FOON of ``view``."""
        nodes = {node for known in units for node in (*known.unit.input_nodes, *known.unit.output_nodes)}
        own = self.with_mixtures({name for node in nodes for name in (node.label, *node.ingredients)}, view)
        return own.knowing({name for node in nodes for name in own.names_in(node)})

    def names_in(self, node: ObjectNode) -> tuple[str, ...]:
        """Return the foods that ``node`` is or holds, free ones apart."""
        foods = self.kitchen.foods_in(node)
        names = (node.label, *foods) if self.kitchen.is_food(node) else foods
        return tuple(name for name in dict.fromkeys(names) if not self.kitchen.is_free(name))

    def missing_in(self, node: ObjectNode) -> tuple[str, ...]:
        """Return the foods of ``node`` for which there is none at hand, and the utensil that it is or stands in."""
        foods = tuple(name for name in self.names_in(node) if self.own_for(name) is None)
        utensil = node.label if self.kitchen.is_utensil(node.label) else node.container
        return (*foods, utensil) if utensil and self._is_absent(utensil, node) else foods

    def mine(self, node: ObjectNode) -> ObjectNode:
        """Return ``node`` with one's own foods in the place of those that they stand for; it lacks none."""
        inside = tuple(self._own_name(name) for name in node.ingredients)
        return replace(node, label=self._own_name(node.label), ingredients=inside)

    def has(self, node: ObjectNode) -> bool:
        """Whether ``node`` is at hand, by one's own foods."""
        return not self.missing_in(node) and self.kitchen.has(self.mine(node))

    def has_otherwise(self, node: ObjectNode) -> bool:
        """Return whether all foods of ``node`` are at hand, and it is not there as it is asked."""
        return not self.missing_in(node) and self.kitchen.lacks(self.mine(node))

    def promise(self, goal: Goal) -> float:
        """Return how much of ``goal`` is there (0 to 1) by the names of its ingredients alone, mixtures apart."""
        names = [name for name in goal.ingredients if not (self.kitchen.is_utensil(name) or self.kitchen.is_free(name))]
        names = [name for name in names if name not in self.mixed or self.own_for(name)]
        sure = [own[1] for name in names if (own := self.own_for(name)) is not None]
        return round(sum(sure) / len(names), 2) if names else 0.0

    def _is_absent(self, utensil: str, node: ObjectNode) -> bool:
        """Return whether nobody has ``utensil``; storage comes with the food that is in it."""
        if not self.kitchen.is_utensil(utensil) or (self.kitchen.is_storage(utensil) and self.names_in(node)):
            return False
        states = node.states if utensil == node.label else ()
        return self.kitchen.with_every_food().lacks(ObjectNode(utensil, states))

    def _own_name(self, name: str) -> str:
        if self.kitchen.is_utensil(name) or self.kitchen.is_free(name):
            return name
        own = self.own_for(name)
        return name if own is None else own[0]


def _most_likely(goals: Iterable[Goal], own: Larder, most: int) -> list[Goal]:
    """Return the at most ``most`` of ``goals`` that, by the names in them, are best made of one's ``own`` foods."""
    return sorted((goal for goal in goals if own.promise(goal)), key=lambda goal: _cheap_rank(goal, own))[:most]


def _cheap_rank(goal: Goal, own: Larder) -> tuple[object, ...]:
    return (-own.promise(goal), -len(goal.ingredients), goal.node.sort_key, goal.dish_type)


def _index(units: Sequence[KnownUnit], own: Larder) -> UnitIndex:
    otherwise = gap_cost(own.kitchen, units, own.mixed)
    return UnitIndex.of(units, at_hand=own.has, gap_cost=_cost(own, otherwise))


def _cost(own: Larder, otherwise: Callable[[ObjectNode], int | None]) -> Callable[[ObjectNode], int]:
    def cost(node: ObjectNode) -> int:
        missing = [name for name in own.missing_in(node) if not own.kitchen.is_utensil(name)]
        if not missing and own.missing_in(node):
            return ABSENT
        foods = sum(_READY_MADE if name in own.mixed else 1 for name in missing)
        return _MISSING * foods + (otherwise(own.mine(node)) or 1)

    return cost


def _proven(goal: Goal, index: UnitIndex, own: Larder, time_limit: float | None) -> Suggestion | None:
    """Return what the tree of ``goal`` that lacks the least takes; ``None`` where nothing makes the goal."""
    number_of = {food: number for number, food in enumerate(own.foods)}
    wanted = {one.food: number_of[one.own] for one in own.taken(own.stands_for)}
    try:
        tree = retrieve(SearchProblem(index, (goal.node,), wanted), time_limit=time_limit)
    except NoTreeError:
        return None
    return _suggested(goal, tree, own)


def _suggested(goal: Goal, tree: ReferenceTree, own: Larder) -> Suggestion:
    """Return what the ``tree`` of ``goal`` takes of one's ``own`` foods, and what it lacks."""
    leaves = leaves_of(known.unit for known in tree.units)
    missing = {name for node in leaves for name in own.missing_in(node)}
    taken = own.taken({name for node in leaves for name in own.names_in(node)})
    used = {one.own for one in taken}
    unused = tuple(food for food in own.foods if food not in used)
    assumed = tuple(filter(own.has_otherwise, tree.gaps))
    return Suggestion(goal, len(tree.units), taken, tuple(sorted(missing)), assumed, unused, tree.exact)
