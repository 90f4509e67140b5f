"""Which laws fit together, as text: the table of core_models.compatibility, written out slot by slot."""

from collections.abc import Iterator

from core_models.compatibility import ABSENT, CLASHES, PRESENT, Clash, clash_of
from core_models.schema import SLOTS, UPDATE
from studies.output.text_table import aligned


def compatibility_text() -> str:
    """Every law against every update, then what each slot needs of another; what is not named fits."""
    reasons = list(dict.fromkeys(clash.why for clash in CLASHES if clash.slot == "update"))
    updates = [model.law for model in UPDATE.models]
    parts = ["Laws against updates: fits, or the number of the reason below."]
    for slot in SLOTS:
        laws = [model.law for model in slot.models]
        if laws and slot is not UPDATE:
            rows = [[slot.slot, *(update.__name__ for update in updates)]]
            rows += [[f"  {law.__name__}", *_verdicts(slot.slot, law, updates, reasons)] for law in laws]
            parts.append(aligned(rows))
    parts.append("\n".join(f"[{number}] {_told(why)}" for number, why in enumerate(reasons, 1)))
    pairs = [_sentence(clash) for clash in CLASHES if clash.slot != "update"]
    parts.append("\n  ".join(["Slots against each other", *pairs]))
    parts.append("All other pairs of laws fit.")
    return "\n\n".join(parts)


def _verdicts(slot: str, law: type, updates: list[type], reasons: list[str]) -> Iterator[str]:
    for update in updates:
        clash = clash_of("update", update, slot, law)
        yield "fits" if clash is None else f"[{reasons.index(clash.why) + 1}]"


def _told(why: str) -> str:
    """A reason with all its remedies."""
    return f"{why}: {', '.join(clash.remedy for clash in CLASHES if clash.why == why)}"


def _sentence(clash: Clash) -> str:
    first, second = _side(clash.slot, clash.laws), _side(clash.other, clash.others)
    where = "" if clash.updates == PRESENT else f" in {' or '.join(law.__name__ for law in clash.updates)}"
    return f"{first} with {second}{where}: {clash.why}: {clash.remedy}"


def _side(slot: str, laws: tuple[type, ...]) -> str:
    if laws == PRESENT:
        return slot
    return f"no {slot}" if laws == ABSENT else f"{slot} {' or '.join(law.__name__ for law in laws)}"
