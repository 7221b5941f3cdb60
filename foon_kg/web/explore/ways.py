"""The shortest way of a food from one state to another: over steps that carry the food on, never over a knife."""

from __future__ import annotations

from collections import deque
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from foon_kg.foon import IngredientWords
from foon_kg.model import KnownUnit, ObjectNode
from foon_kg.model.names import canonical
from foon_kg.web.explore.network import NO_FILTERS, Filters, Network, grouped
from foon_kg.web.questions import UnknownError

MOST_TOLD = 12
"""So many states of a food are told where the asked one is unknown."""


class NoWayError(UnknownError):
    """No steps lead from the one to the other."""

    code = "no-way"


@dataclass(frozen=True)
class Stop:
    """Where a food is on its way: the object that is it, or that it is in; ``name`` is what it is called by then."""

    node: ObjectNode
    name: str


@dataclass(frozen=True)
class Way:
    """The stops of a food, and the step between each two: one fewer."""

    stops: tuple[Stop, ...]
    steps: tuple[KnownUnit, ...]


class Ways:
    """The ways of foods through a network."""

    def __init__(self, network: Network) -> None:
        self.network = network
        self.kitchen = network.kitchen
        self._words = IngredientWords(network.snapshot.vocabulary(), network.kitchen)

    def shortest(self, start: str, end: str, filters: Filters = NO_FILTERS) -> Way:
        """Return the way with the fewest steps from ``start`` to ``end``, each said as “boiled potato” or by its id.

        Only steps that pass ``filters`` count. Of several ways it is that of the steps which more videos show. Raises
        UnknownError where one is not known (with the states in which the food is), NoWayError where no steps lead
        there.
        """
        begins, ends = self._beginnings(self._places(start)), set(self._places(end))
        ahead = deque(Stop(node, name) for node in begins if node not in ends for name in self._names(node))
        if not ahead:
            raise NoWayError(
                f"“{start}” is “{end}” already", hint="Name two states: from whole potato to boiled potato."
            )
        came: dict[Stop, tuple[Stop, KnownUnit] | None] = dict.fromkeys(ahead)
        while ahead:
            stop = ahead.popleft()
            if stop.node in ends:
                return _traced(stop, came)
            for known, after in self._next(stop, filters):
                if after not in came:
                    came[after] = (stop, known)
                    ahead.append(after)
        raise NoWayError(
            f"no steps of this FOON lead from “{start}” to “{end}”",
            hint="Choose another beginning or end, or fewer filters.",
        )

    def carried(self, known: KnownUnit, stop: Stop) -> Iterator[Stop]:
        """Yield where the step of a ``known`` unit that takes ``stop`` leaves its food, unless that stays as it is.

        That is what is called so or made of what is called so, and what came to be: foods that were not there before. A
        vessel that holds it is followed only where the step tells no more of it: a board with potato on it does not
        know that the potato was diced.
        """
        if stop.node in known.unit.output_nodes:
            return  # this step is about something else
        before = {one.name for one in self._stops(known.unit.input_nodes)}
        led = [one for one in self._stops(known.unit.output_nodes) if one.name == stop.name or one.name not in before]
        yield from [one for one in led if not self.kitchen.is_utensil(one.node.label)] or led

    def _stops(self, nodes: Iterable[ObjectNode]) -> Iterator[Stop]:
        """Yield every food in ``nodes`` with the node that it is in."""
        return (Stop(node, name) for node in nodes for name in self._foods(node))

    def _next(self, stop: Stop, filters: Filters) -> Iterator[tuple[KnownUnit, Stop]]:
        steps = [known for known in self.network.takers.get(stop.node, ()) if self.network.passes(known, filters)]
        for known in sorted(steps, key=lambda known: (-len(known.seen_in), known.unit.key)):
            for after in self.carried(known, stop):
                yield known, after

    def _foods(self, node: ObjectNode) -> tuple[str, ...]:
        """Return the foods that are in an object: what it is called, if it is no utensil, and what it is made of."""
        inside = self.kitchen.foods_in(node)
        return inside if self.kitchen.is_utensil(node.label) else (node.label, *inside)

    def _beginnings(self, nodes: list[ObjectNode]) -> list[ObjectNode]:
        """Return those of the least states, and of them those at hand in a kitchen: there a way begins."""
        fewest = min((len(self.kitchen.processed_states(node)) for node in nodes), default=0)
        least = [node for node in nodes if len(self.kitchen.processed_states(node)) == fewest]
        begun = [node for node in least if self.kitchen.has(node)] or least
        return sorted(begun, key=lambda node: node.sort_key)

    def _names(self, node: ObjectNode) -> tuple[str, ...]:
        """Return what to follow from an object on: what it is, if it is a food, else all that is in it."""
        return self._foods(node) if self.kitchen.is_utensil(node.label) else (node.label,)

    def _places(self, text: str) -> list[ObjectNode]:
        """Return the objects that a text means; raises UnknownError where it means none."""
        if self.network.has(text):
            thing = self.network.thing(text)
            if thing.kind == "object":
                node = self.network.object_of(thing)
                if not self._names(node):
                    raise UnknownError(
                        f"“{node}” holds no food", hint="Only foods are followed: name one at both ends."
                    )
                return [node]
            text = thing.name
        food, states, rest = self._words.parts(text)
        called = self._called.get(canonical(food), [])
        if nodes := self._in_states(called, food, [*states, *rest]):
            return nodes
        if self.kitchen.is_utensil(food) and not called:
            raise UnknownError(f"“{text}” is a utensil", hint="Only foods are followed: name one at both ends.")
        raise _unknown(text, food, called)

    def _in_states(self, nodes: list[ObjectNode], food: str, asked: Sequence[str]) -> list[ObjectNode]:
        """Return those of a food's nodes that have all the asked states; the raw one, where it is called whole."""
        found = [node for node in nodes if {*asked} <= {state.lower() for state in node.states}]
        if found or not all(self.kitchen.is_start_state(food, word) for word in asked):
            return found
        return [node for node in nodes if not self.kitchen.processed_states(node)]

    @cached_property
    def _called(self) -> Mapping[str, list[ObjectNode]]:
        foods = (label for label in self.network.called if not self.kitchen.is_utensil(label))
        return grouped((canonical(label), node) for label in foods for node in self.network.called[label])


def _unknown(text: str, food: str, called: Collection[ObjectNode]) -> UnknownError:
    states = sorted({state for node in called for state in node.states})
    if not called:
        return UnknownError(f"this FOON has no food “{food}”", hint="The page and /api/complete complete names.")
    told = ", ".join(states[:MOST_TOLD]) + (", …" if len(states) > MOST_TOLD else "")
    hint = f"It is seen {told}." if told else "It is seen in no state."
    return UnknownError(f"no {food} of this FOON is “{text}”", hint=hint)


def _traced(last: Stop, came: Mapping[Stop, tuple[Stop, KnownUnit] | None]) -> Way:
    stops, steps = [last], list[KnownUnit]()
    while (before := came[stops[-1]]) is not None:
        stops.append(before[0])
        steps.append(before[1])
    return Way(tuple(reversed(stops)), tuple(reversed(steps)))
