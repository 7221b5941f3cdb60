"""What a task tree says of itself: what stands for what in it, and what is simply taken to be there."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, Self, get_args

from foon_kg.model.json_fields import Fields, JsonObject
from foon_kg.model.knowledge import UNLIKE
from foon_kg.model.node_json import node_from_json, node_to_json
from foon_kg.model.nodes import ObjectNode

SubstitutionKind = Literal["object", "state", "motion", "tool", "vessel"]

_NOTHING = frozenset[str]()


@dataclass(frozen=True)
class Alternative:
    """Another equivalent that was considered, with its confidence between 0 and 1.

    ``missing`` names the fields that a stranger's tree leaves out.
    """

    name: str
    confidence: float
    missing: frozenset[str] = _NOTHING

    @classmethod
    def claimed(cls, name: str, confidence: float | None) -> Self:
        """Return the alternative ``name`` of a tree that may leave its ``confidence`` (0 to 1) out.

        >>> Alternative.claimed("onion", None).missing
        frozenset({'confidence'})
        """
        return cls(name, confidence or 0.0, _missing(confidence=confidence))


@dataclass(frozen=True)
class Substitution:
    """What stood in FOON (``equivalent``) where the recipe wants ``required``, and how sure that is (0 to 1).

    ``kind`` is one of :data:`SubstitutionKind` in every plan of ours. ``object`` is the required food concerned; for an
    object substitution it equals ``required``. ``missing`` names the fields that a stranger's tree leaves out.
    """

    kind: str
    object: str
    required: str
    equivalent: str
    confidence: float
    alternatives: tuple[Alternative, ...] = ()
    missing: frozenset[str] = _NOTHING

    @classmethod
    def claimed(
        cls,
        kind: str,
        about: str,
        required: str,
        equivalent: str | None = None,
        *,
        confidence: float | None = None,
        alternatives: Iterable[Alternative] | None = None,
    ) -> Self:
        """Return an entry of a tree that may leave anything out; the judge says what (C7).

        ``kind`` is ``object`` or ``state``, ``about`` the food; the ``equivalent`` stands for what is ``required``,
        with a ``confidence`` from 0 to 1, and other ``alternatives`` could have.

        >>> Substitution.claimed("object", "leek", "leek", "onion").missing == {"confidence", "alternatives"}
        True
        """
        missing = _missing(equivalent=equivalent, confidence=confidence, alternatives=alternatives)
        return cls(kind, about, required, equivalent or "", confidence or 0.0, tuple(alternatives or ()), missing)

    @property
    def for_want(self) -> bool:
        """Whether nothing that is known is like the food: it is handled like something for want of anything.

        >>> Substitution("object", "zorbik", "zorbik", "steak", 0.0).for_want
        True
        """
        return self.kind == "object" and self.confidence < UNLIKE

    def to_json(self) -> JsonObject:
        """Return one of the ``substitutions`` of a plan result.

        >>> Substitution("object", "leek", "leek", "onion", 0.87).to_json()["equivalent"]
        'onion'
        """
        return {
            "kind": self.kind,
            "object": self.object,
            "required": self.required,
            "equivalent": self.equivalent,
            "confidence": self.confidence,
            "alternatives": [{"name": a.name, "confidence": a.confidence} for a in self.alternatives],
        }

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return what :meth:`to_json` wrote, from its ``fields``; raises ReadError where one is missing.

        >>> told = Substitution("object", "leek", "leek", "onion", 0.87)
        >>> Substitution.from_json(Fields(told.to_json(), "plan.json")) == told
        True
        """
        return cls(
            fields.one_of("kind", get_args(SubstitutionKind)),
            fields.text("object"),
            fields.text("required"),
            fields.text("equivalent"),
            fields.number("confidence"),
            tuple(Alternative(a.text("name"), a.number("confidence")) for a in fields.nested_list("alternatives")),
        )


@dataclass(frozen=True)
class Assumption:
    """A leaf of the tree that is simply taken to be there, and why."""

    node: ObjectNode
    why: str

    def to_json(self) -> JsonObject:
        """Return one of the ``assumptions`` of a plan result.

        >>> Assumption(ObjectNode("tuna", ("canned",)), "no step makes it so").to_json()["why"]
        'no step makes it so'
        """
        return {"node": node_to_json(self.node), "why": self.why}

    @classmethod
    def from_json(cls, fields: Fields) -> Self:
        """Return the assumption of the ``fields`` that :meth:`to_json` wrote.

        >>> told = Assumption(ObjectNode("tuna", ("canned",)), "no step makes it so")
        >>> Assumption.from_json(Fields(told.to_json(), "plan.json")) == told
        True
        """
        return cls(node_from_json(fields.nested("node")), fields.text("why"))


def _missing(**values: object) -> frozenset[str]:
    return frozenset(name for name, value in values.items() if value is None)
