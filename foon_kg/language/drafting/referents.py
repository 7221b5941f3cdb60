"""What is meant: which things of the scene a name, a pronoun or nothing at all stands for.

People call a mixture by what is in it (the sugar mixture), by what it became (the dough, the cookies) or by nothing
("bake 20 minutes"). Where several things could be meant, it is what was worked on last.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from foon_kg.food import motions, singular, tables
from foon_kg.food.lists import word_list
from foon_kg.language.drafting.larder import Larder
from foon_kg.language.drafting.precedents import FoonPrecedents
from foon_kg.language.drafting.scene import EVERYTHING, MIXTURE, PRONOUNS, Scene
from foon_kg.language.line_words import split_name
from foon_kg.model.names import canonical
from foon_kg.model.narration import Mention, NarratedAction, Place
from foon_kg.similarity.groups import food_groups

_MIXED = word_list("called a mixture")
_SHAPES = word_list("shapes")
_DISHES = word_list("groups of dishes")
_ON_TOP = word_list("is the outside of what is at hand")
_ANOTHER = word_list("is another vessel")
_INGREDIENTS = word_list("speaks of ingredients")
_DRY, _WET = word_list("speaks of what is dry"), word_list("speaks of what is wet")
_COATS = frozenset({"coat", "grease", "spread"})
_BOTH = 2
IT = "it"
_RAW = frozenset({"boil", "cook", "peel", "wash"})
_SEVERAL = word_list("speaks of several")
_IS_DRY = word_list("is dry in a batter") | word_list("sweetens a batter")
_REMAINING = word_list("speaks of what remains")
_DETERMINERS = word_list("says nothing of a thing")
_ALL = word_list("speaks of all of it")


@dataclass
class Referents:
    """Finds what is meant in ``scene``.

    ``title`` is the dish in the recipe's name (bread), ``None`` where things are called by labels and not freely: then
    a name means another thing only if that was mixed.

    ``called`` has the names by which mixtures were spoken of that nobody named when they were made.
    """

    precedents: FoonPrecedents
    scene: Scene
    title: str | None = ""
    called: dict[str, str] = field(default_factory=dict)
    larder: Larder = field(default_factory=Larder)

    def objects(self, action: NarratedAction) -> tuple[tuple[Mention, ...], tuple[str, ...]]:
        """Return what an action is done to, and the doubts about it; nothing where nothing is at hand."""
        merged = not self._adds(action)
        besides = self._things_of(action.places, contents=not merged)
        told = [mention for mention in action.objects if not self._is_state(mention.name)]  # serve hot
        named = [one for mention in told for one in self._meant(mention, action, besides, merged=merged)]
        doubts: list[str] = []
        if not told:
            named = [Mention(label) for label in self._at_hand(besides)]
            if named:
                doubts.append(f"nobody says what “{action.verb}” is done to: taken as what is at hand")
        return tuple(dict.fromkeys(named)), tuple(doubts)

    def _meant(
        self, mention: Mention, action: NarratedAction, besides: frozenset[str], *, merged: bool
    ) -> Sequence[Mention]:
        """Return what one object of an action means: things of the scene, else a thing that comes for the first time.

        ``besides`` is what it cannot mean; with ``merged`` it may be in a mixture by now.
        """
        name = mention.name
        if (mixed := self._dry_or_wet(name)) is not None:
            return [Mention(mixed)]
        if speaks_of_all(name):
            return self._ingredients(name, action.said) or self._all_of(name, besides)
        label = self.thing(name, besides) or (self._merged(name) if merged else None)
        if label is None or (label in self.scene.foods and self._greases(action, name, label)):
            return [self._new(mention)]
        return [Mention(label, mention.states)]

    def _all_of(self, name: str, besides: frozenset[str]) -> Sequence[Mention]:
        """Return the things of the scene that "all", "it" or "both" mean."""
        several = [*self.scene.foods][-_BOTH:] if name.lower() in _SEVERAL else []
        return [Mention(label) for label in several or self._everything(name, besides)]

    def turned(self, action: NarratedAction) -> NarratedAction:
        """Return the ``action`` "pour over the cream" as "pour the cream over" where no cream is there to pour onto."""
        if action.objects or len(action.places) != 1 or not self._hand():
            return action
        (place,) = action.places
        if place.relation != "over" or self.precedents.kitchen.is_utensil(place.name) or self._is_there(place.name):
            return action
        return replace(action, objects=(Mention(place.name),), places=(Place("into", IT),))

    def _is_there(self, name: str) -> bool:
        """Whether ``name`` speaks of something that is there by now, if only as "the cake" speaks of any dish."""
        words = canonical(name).split()
        there = speaks_of_all(name) or self._would_mean(name) is not None
        return there or (len(words) == 1 and self._is_dish(words))

    def _would_mean(self, name: str, besides: frozenset[str] = frozenset()) -> str | None:
        """Return what :meth:`thing` returns, and call no mixture by this name from here on."""
        called = dict(self.called)
        found = self.thing(name, besides)
        self.called = called
        return found

    def places(self, action: NarratedAction) -> tuple[Place, ...]:
        """Return the places of an action by their names in the scene; what is no place is left out."""
        besides = frozenset(filter(None, (self._already(one.name, action) for one in action.objects)))
        besides |= frozenset() if action.objects else frozenset(self._hand())
        found = [one for place in action.places for one in self._place(place, action.said, besides)]
        return tuple(dict.fromkeys(found))

    def _place(self, place: Place, said: str, besides: frozenset[str]) -> Sequence[Place]:
        """Return what one place means: things of the scene, else one that comes for the first time; a shape is none.

        ``said`` are the words of the action, ``besides`` is what the place cannot mean.
        """
        labels = self._labels_of(place.name, said, besides)
        if labels is not None:
            return [Place(place.relation, label) for label in labels]
        words = canonical(place.name).split()
        if self._is_dish(words) and (vessel := self.scene.lying(besides)) is not None:
            return [Place("into", vessel)]
        if words[-1] in _SHAPES:
            return []
        return [Place(place.relation, self._new(Mention(place.name)).name)]

    def _labels_of(self, name: str, said: str, besides: frozenset[str]) -> Sequence[str] | None:
        """Return the things that are there already and that a place means by ``name``, ``None`` where it is none."""
        if self.precedents.kitchen.is_utensil(name):
            return [self._vessel(name, said)]
        if (mixed := self._dry_or_wet(name)) is not None:
            return [mixed]
        if speaks_of_all(name):
            return self._greased() or self._hand()
        label = self.thing(name, besides) or self._merged(name)
        return None if label is None else [label]

    def thing(self, name: str, besides: frozenset[str] = frozenset()) -> str | None:
        """Return the thing of the scene that ``name`` speaks of, none of ``besides``.

        ``None`` where it is none of them.
        """
        if (known := self.scene.called(name)) is not None:
            return known
        words = canonical(name).split()
        if self.title is None:
            return self._mixture(words, besides) if words[-1] in _MIXED and not self._is_bought(name) else None
        if (known := self._called_in_short(name, words)) is not None:
            return known
        if words[-1] in _MIXED or words[-1] in tables().unfinished:
            return self._mixture(words, besides)
        return self._product(words, besides) or self._of_kind(name)

    def _called_in_short(self, name: str, words: Sequence[str]) -> str | None:
        """Return the thing of the scene that ``name`` speaks of without its states, or without its shape."""
        _, bare = split_name(name)
        if bare != name and (known := self.scene.called(bare)) is not None:
            return known
        shaped = len(words) > 1 and words[-1] in _SHAPES
        return self.scene.called(" ".join(words[:-1])) if shaped else None

    def _of_kind(self, name: str) -> str | None:
        """Return the only thing of the scene that is of the kind that ``name`` is: the spaghetti that pasta is."""
        foods, called = tables().foods, canonical(name)
        kind = foods.food(called).kind
        if kind.split()[-1] != called or called in self.larder.listed:
            return None
        alike = [label for label in self.scene.foods if foods.food(label).kind == kind]
        return alike[0] if len(alike) == 1 else None

    def _is_state(self, name: str) -> bool:
        """Whether a word only says how something is: hot, warm."""
        known = canonical(name)
        listed = known in self.precedents.labels or tables().foods.is_listed(known)
        return self.title is not None and not listed and name.lower() in tables().states

    def _greases(self, action: NarratedAction, name: str, label: str) -> bool:
        """Whether empty vessels are brushed with a fat that is in a dish by now: more of it is taken for that."""
        if "fat" not in tables().foods.food(name).traits or len(self.scene.parts(self.scene.foods[label])) == 1:
            return False
        vessels = [one.name for one in action.places if self.precedents.kitchen.is_utensil(one.name)]
        empty = len(vessels) == len(action.places) > 0 and not any(map(self.scene.held, vessels))
        return empty and not tables().motion(action.verb).does.isdisjoint(_COATS)

    def _dry_or_wet(self, name: str) -> str | None:
        """Return the mixture of what is dry, or of what is not, where both were mixed: "the wet ingredients"."""
        words = set(canonical(name).split())
        made = self.scene.made()
        if words.isdisjoint(_INGREDIENTS) or words.isdisjoint(_DRY | _WET) or not made:
            return None
        foods = tables().foods
        shares = {}
        for label in made:
            parts = self.scene.parts(self.scene.foods[label])
            shares[label] = sum(foods.food(part).is_any(_IS_DRY) for part in parts) / len(parts)
        best = max if not words.isdisjoint(_DRY) else min
        return best(shares, key=lambda label: shares[label])

    def _merged(self, name: str) -> str | None:
        """Return the mixture in which a food went that is by itself no more: the creamed butter."""
        if self.title is None:
            return None
        words = set(canonical(split_name(name)[1]).split())
        for label in reversed(self.scene.made()):
            if any(words <= set(canonical(part).split()) for part in self.scene.parts(self.scene.foods[label])):
                return label
        return None

    def _adds(self, action: NarratedAction) -> bool:
        """Whether something new comes to a thing: another egg, though one was mixed in before."""
        motion = next(iter(self.precedents.verbs.reading(action.verb).motions), "")
        return motions.transfers(motion) or motions.mixes(motion)

    def _is_bought(self, name: str) -> bool:
        """Whether the FOON has a thing of this name, and no mixture is waiting for one; soy sauce is always bought."""
        words = canonical(name).split()
        if len(words) > 1 and words[-1] != MIXTURE and tables().foods.is_listed(singular(name)):
            return True
        return canonical(name) in self.precedents.labels and not any(
            made.endswith(MIXTURE) for made in self.scene.made()
        )

    def _mixture(self, words: Sequence[str], besides: frozenset[str]) -> str | None:
        """Return the mixture that has what ``words`` say in it, the latest one; of those at hand only if it must be."""
        last = [label for label in reversed(self.scene.made()) if label not in besides]
        said = set(words[:-1]) - _DETERMINERS
        having = self._with_words(said, last) if said else last
        if not having and words[-1] in {MIXTURE, "mix"} and not tables().foods.is_listed(" ".join(words)):
            having = sorted(last, key=lambda label: self.scene.foods[label].container == self.scene.focus)
        if not having:
            return None
        self._call(having[0], words)
        return having[0]

    def _with_words(self, said: set[str], mixtures: Sequence[str]) -> Sequence[str]:
        """Return the ``mixtures`` that have a food of these words in them, else the foods that are called so."""
        having = [label for label in mixtures if said & self._words_in(label)]
        return having or [label for label in reversed(self.scene.foods) if said & set(canonical(label).split())]

    def _call(self, label: str, words: Sequence[str]) -> None:
        """Note that a mixture that nobody named is called by ``words`` now: the dough."""
        name = " ".join(words)
        names_it = words[-1] in _MIXED and words[-1] != MIXTURE
        if names_it and label.endswith(MIXTURE) and not self.scene.called(name):
            self.called.setdefault(label, name)

    def _product(self, words: Sequence[str], besides: frozenset[str]) -> str | None:
        """Return what was made last, where its name is that of a dish or of a shape: the cookies, the balls."""
        if not self._is_dish(words) and not _is_shaped(words):
            return None
        made = [label for label in reversed(self.scene.made()) if label not in besides]
        if not made and words[-1] in _SHAPES:
            made = [label for label in reversed(self.scene.last) if label in self.scene.foods]
        return made[0] if made else None

    def _is_dish(self, words: Sequence[str]) -> bool:
        """Whether a name is that of a dish: nothing that is bought for one."""
        groups = food_groups()
        name = " ".join(words)
        if self.larder.listed and words[-1] in tables().dishes and not self.larder.names(words):
            return True
        if not tables().foods.food(name).owes.keys().isdisjoint(_RAW):
            return False  # potatoes are dishes by no other sign than their name
        return words[-1] == self.title or not _DISHES.isdisjoint(groups.of(" ".join(words)) or groups.of(words[-1]))

    def _already(self, name: str, action: NarratedAction) -> str | None:
        """Return what an object means whatever the places are: the same name, or what was mixed last.

        With a dressing what is at hand is tossed, so it is none of that.
        """
        words = canonical(name).split()
        if (known := self.scene.called(name)) is not None or not words or words[-1] not in _MIXED:
            return known
        joins = all(is_everything(place.name) for place in action.places)
        return self._would_mean(name, frozenset(self._hand()) if joins else frozenset())

    def _words_in(self, label: str) -> set[str]:
        node = self.scene.foods[label]
        return {word for name in (label, *node.ingredients) for word in canonical(name).split()} - {MIXTURE}

    def _things_of(self, places: Sequence[Place], *, contents: bool) -> frozenset[str]:
        """Return the foods that are meant by places, or are in them: they are not what is brought there."""
        found: set[str] = set()
        for place in places:
            if place.name in self.scene.foods:
                found.add(place.name)
            found.update(self.scene.held(place.name) if contents else ())
        return frozenset(found)

    def _at_hand(self, besides: frozenset[str]) -> tuple[str, ...]:
        hand = tuple(label for label in self._hand() if label not in besides)
        if hand or not besides:
            return hand
        others = [label for label in (*reversed(self.scene.last), *reversed(self.scene.made())) if label not in besides]
        return tuple(label for label in others if label in self.scene.foods)[:1]

    def _greased(self) -> tuple[str, ...]:
        """Return the vessel at hand in which only fat is: things are laid on the tray, and not on its oil."""
        hand = self._hand()
        fat = all("fat" in tables().foods.food(label).traits for label in hand)
        bare = all(len(self.scene.parts(self.scene.foods[label])) == 1 for label in hand)
        at = {self.scene.foods[label].container for label in hand}
        return (self.scene.focus,) if hand and fat and bare and at == {self.scene.focus} and self.scene.focus else ()

    def _hand(self) -> tuple[str, ...]:
        return self.scene.at_hand()

    def _everything(self, name: str, besides: frozenset[str]) -> tuple[str, ...]:
        last = tuple(food for food in self.scene.last if food in self.scene.foods and food not in besides)
        if name.lower() in PRONOUNS and self.scene.last:
            return last or self._at_hand(besides)
        if canonical(name) == MIXTURE and (mixture := self._mixture([MIXTURE], besides)) is not None:
            return (mixture,)
        return tuple(dict.fromkeys((*self._at_hand(besides), *last)))

    def _ingredients(self, name: str, said: str) -> list[Mention]:
        """Return what the recipe lists and nobody used: the dry ones, what remains, all where nothing is at hand."""
        words = set(canonical(name).split())
        if words.isdisjoint(_INGREDIENTS):
            return []
        if not words.isdisjoint(_DRY):
            return [self._new(one) for one in self.larder.left() if tables().foods.food(one.name).is_any(_IS_DRY)]
        remaining = not set(said.lower().split()).isdisjoint(_REMAINING)
        return [self._new(one) for one in self.larder.left()] if remaining or not self._hand() else []

    def _new(self, mention: Mention) -> Mention:
        """Return a thing that comes for the first time by its name in the FOON, with the states that its name says.

        An ingredient has the name and the states under which the recipe lists it.
        """
        if (listed := self.larder.take(mention.name) or self.larder.take(split_name(mention.name)[1])) is not None:
            mention = Mention(listed.name, mention.states or listed.states)
        label = self.precedents.labels.get(canonical(mention.name))
        if label is not None or self.precedents.kitchen.is_utensil(mention.name):
            return Mention(label or mention.name, mention.states)
        states, name = split_name(mention.name)
        label = self.precedents.labels.get(canonical(name))
        return Mention(label or name, (*mention.states, *states))

    def _vessel(self, name: str, said: str) -> str:
        """Return the label of a vessel; another one where the words before it say so ("in a separate bowl").

        The pan is the baking pan that was greased before, a pan is not.
        """
        label = self.precedents.labels.get(canonical(name)) or singular(name)
        words = "|".join(sorted(_ANOTHER))
        fresh = re.search(rf"\b(?:{words})\s+(?:[\w-]+\s+){{0,2}}?{re.escape(name)}", said, re.IGNORECASE)
        if fresh:
            return self.scene.another(label) if self.scene.held(label) else label
        used = [one for one in reversed(self.scene.utensils) if one == label or one.endswith(f" {label}")]
        return label if label in used or not used else used[0]


def is_everything(name: str) -> bool:
    """Whether a name is a pronoun, or speaks of all that is there."""
    said = set(canonical(name).split())
    words = said - _DETERMINERS
    return name.lower() in PRONOUNS | _SEVERAL or (words <= EVERYTHING if words else said <= _ALL)


def is_outside(name: str) -> bool:
    """Whether a name is that of a side or top of what is at hand."""
    return not _ON_TOP.isdisjoint(canonical(name).split()[-1:])


def speaks_of_all(name: str) -> bool:
    """Whether a name is a pronoun, speaks of all that is there, or of its outside: no food is called so."""
    return is_everything(name) or is_outside(name)


def _is_shaped(words: Sequence[str]) -> bool:
    """Whether a name is that of a shape into which something was made, and of nothing bought: a few ice cubes."""
    ends = (" ".join(words[place:]) for place in range(len(words) - 1))
    return words[-1] in _SHAPES and not any(tables().foods.is_listed(end) for end in ends)
