"""What an entry of the card schema says: a range, a tag, a model, a slot."""

import math
from dataclasses import dataclass
from typing import NamedTuple


class Interval(NamedTuple):
    """A range of numbers, `low <= x <= high`, each end open on request."""

    low: float = -math.inf
    high: float = math.inf
    low_open: bool = False
    high_open: bool = False

    def __contains__(self, number: float) -> bool:
        above = number > self.low if self.low_open else number >= self.low
        below = number < self.high if self.high_open else number <= self.high
        return above and below

    def __str__(self) -> str:
        low = "" if self.low == -math.inf else f"{'>' if self.low_open else '>='} {self.low:g}"
        high = "" if self.high == math.inf else f"{'<' if self.high_open else '<='} {self.high:g}"
        return " and ".join(filter(None, (low, high))) or "any number"


ANY = Interval()
POSITIVE = Interval(low=0.0, low_open=True)
NOT_NEGATIVE = Interval(low=0.0)
ZERO = Interval(0.0, 0.0)
ANY_NUMBER_OF = 0  # size of a vector that may have any length from 2 on


@dataclass(frozen=True)
class Parameter:
    """One tag that holds a number (or, with another `size` than 1, a vector of so many numbers).

    `feeds` names the field of the law that it becomes, for a constant of the card the Material's `field`
    or `slot.field`; empty means the tag's own name. A tag that is left out takes `default`, else the value of
    `fallback` in the same block or in the card around it; with neither it is required, unless `optional`.
    """

    tag: str
    unit: str
    range: Interval
    help: str
    feeds: str = ""
    default: float | None = None
    fallback: str = ""
    optional: bool = False
    aliases: tuple[str, ...] = ()
    size: int = 1
    whole: bool = False

    @property
    def field(self) -> str:
        """What the tag feeds."""
        return self.feeds or self.tag

    @property
    def said_unit(self) -> str:
        """The unit after a number, nothing for a pure number."""
        return "" if self.unit == "-" else f" {self.unit}"

    @property
    def requirement(self) -> str:
        """What happens when the tag is left out, in words."""
        if self.default is not None:
            return f"default {self.default:g}"
        if self.fallback:
            return f"default <{self.fallback}>"
        return "optional" if self.optional else "required"


@dataclass(frozen=True)
class Inert:
    """A tag of an effect that is not offered, or that no formula uses: accepted where its value means "off" or says
    nothing, else refused.
    """

    tag: str
    range: Interval
    effect: str


@dataclass(frozen=True)
class Switch:
    """A tag of an old deck that holds a word: accepted where the word says what is done anyway, else refused."""

    tag: str
    words: tuple[str, ...]
    effect: str


@dataclass(frozen=True)
class ModelSchema:
    """One law: the type names that select it (the first is the one written), its class and its tags.

    `ascending` names pairs of tags of which the first must be smaller than the second. What else the numbers must
    fulfil together the law itself says, by a method `fault()` that returns a sentence, empty for good numbers;
    what is allowed and should be known, by `caution()`.
    """

    types: tuple[str, ...]
    law: type
    help: str
    parameters: tuple[Parameter, ...] = ()
    inert: tuple[Inert, ...] = ()
    ascending: tuple[tuple[str, str], ...] = ()


@dataclass(eq=False)
class SlotSchema:
    """One slot of a Material: the tags that fill it (first: the one written), where they stand, its models.

    Nothing of it changes but `models`, and these only by `register_model`.

    `plain` types switch nothing on; `unavailable` types are known from other codes and refused by name.
    `absent` says what a card without the tag gets; empty means that the tag is required.
    """

    slot: str
    tags: tuple[str, ...]
    places: tuple[str, ...]
    absent: str
    models: tuple[ModelSchema, ...] = ()
    plain: tuple[str, ...] = ()
    unavailable: tuple[str, ...] = ()
    attribute: str = "type"

    @property
    def types(self) -> tuple[str, ...]:
        """The names that select something here: the written name of every model, then the plain types."""
        return tuple(model.types[0] for model in self.models) + self.plain

    def model_named(self, name: str) -> ModelSchema | None:
        """The model that a type name selects."""
        return next((model for model in self.models if name in model.types), None)

    def model_of(self, law: tuple) -> ModelSchema | None:
        """The model whose law this is."""
        return self.model_of_class(type(law))

    def model_of_class(self, law: type) -> ModelSchema | None:
        """The model of a class of laws."""
        return next((model for model in self.models if model.law is law), None)
