"""Words by code: of the service in each language, and the page's own words of `static`.

English stands at the things that it names; `uk.json` and `ru.json` have it in their language, and
also what other descriptions of the service say in English.
"""

import re
from collections.abc import Mapping
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any, Literal, cast

import orjson

from app import theme
from app.problems import TEXTS
from app.units import api_value, shown_unit
from core.checks.records import CHECKS
from core.checks.words import CHECK_SOURCES, GROUPS, NOT_CONSIDERED
from core.codes import CODES, REFUSALS, WARNINGS, WAS, Code
from core.errors import METHODS, PLACES
from core.hertz import CRITERIA, LIMIT_SOURCES, VERIFIED
from core.material_table import MATERIALS
from core.work_precision.study import SETTINGS
from core.worked import words as worked

Language = Literal["en", "uk", "ru"]

STATIC = Path(__file__).parents[2] / "static"
"""Files of the page."""

DIGITS = 4
"""Significant digits of a number in a text."""

ALL = 12
"""Significant digits of a typed number, without the noise of binary sums."""

ROUGH = re.compile(
    r"_life_h|^life_h|safety|(?:contact|force)_ratio$|inertia|slope|shift|turn_mrad|unbalance"
    r"|couple|pv_MPa|speed_m_per_s"
)
"""Results whose models are rougher than their numbers: they have three digits."""

LIMITS = ("limit", "low", "high", "value")
"""Parameters of a text that are values of its field."""

SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def _named(words: Any) -> Any:
    """Texts, nested as given, whose ``{name:format}`` is ``{name}``; " mm" behind a length goes."""
    if isinstance(words, str):
        return re.sub(r"(_mm)?:[^{}]*}(?(1)( mm)?)", r"\1}", words)
    return {code: _named(each) for code, each in words.items()}


def _notice(code: Code) -> dict[str, Any]:
    return {name: text for name, text in asdict(code).items() if name != "kind"}


def _check(code: str) -> dict[str, Any]:
    """Words of a check, and of the warning or refusal that has its code."""
    said: dict[str, Any] = {"title": CHECKS[code].title, "why": CHECKS[code].why}
    if code in WARNINGS:
        said["warning"] = _notice(WARNINGS[code])
    elif code in REFUSALS:
        said["refusal"] = REFUSALS[code].text
    return said


@cache
def english() -> dict[str, Any]:
    """English texts of the service, in a table for each kind of code."""
    tables = {
        "refusals": {code: text for code, text in TEXTS.items() if code not in CHECKS},
        "places": {api_value(name, 0.0)[0]: text for name, text in PLACES.items()},
        "notices": {code: _notice(each) for code, each in WARNINGS.items() if code not in CHECKS},
        "checks": {code: _check(code) for code in CHECKS},
        "check_groups": GROUPS,
        "reasons": {code: each.text for code, each in CODES.items() if each.kind == "unknown"},
        "was": WAS,
        "sources": CHECK_SOURCES | LIMIT_SOURCES,
        "criteria": CRITERIA,
        "verified": VERIFIED,
        "not_considered": NOT_CONSIDERED,
        "methods": METHODS,
        "worked_values": worked.VALUES,
        "worked_notes": worked.NOTES,
        "worked_errata": worked.ERRATA,
        "worked_sources": worked.SOURCES,
        "settings": SETTINGS,
        "figures": theme.TEXTS,
    }
    return {kind: _named(table) for kind, table in tables.items()}


@cache
def words_in(language: Language) -> dict[str, Any]:
    """Texts of the service in a language; English for codes that its file does not have."""
    own, known = {} if language == "en" else _read(Path(__file__).parent, language), english()
    return {kind: known.get(kind, {}) | own.get(kind, {}) for kind in known | own}


def _read(folder: Path, language: Language) -> dict[str, Any]:
    return cast(dict[str, Any], orjson.loads((folder / f"{language}.json").read_bytes()))


MATERIAL_TITLES = {name: each.title for name, each in MATERIALS.items()}


class Words:
    """Words and numbers in a language; `titles` are the English titles of fields by name."""

    def __init__(self, language: Language, titles: Mapping[str, str]) -> None:
        self.language, self.titles = language, titles
        self.own = _read(STATIC / "messages", language)
        self.service = {"materials": MATERIAL_TITLES} | words_in(language)

    def message(self, *keys: str, **values: Any) -> str:
        """Text of the page by its keys, its places filled."""
        found: Any = self.own
        for key in keys:
            found = found[key]
        return _filled(found, values)

    def said(self, kind: str, code: str, **values: Any) -> str:
        """Text of the service by kind and code; empty without one."""
        found = self._found(kind, code)
        return _filled(found.get("title", "") if isinstance(found, dict) else found, values)

    def _found(self, kind: str, code: str) -> Any:
        return self.service.get(kind, {}).get(code, "")

    def number(self, value: float, digits: int = DIGITS) -> str:
        """Number to so many significant digits, whole ones without noughts after them.

        >>> Words("uk", {}).number(12345.678), Words("en", {}).number(2.5e-7)
        ('12\u202f350', '2.5\u202f×\u202f10⁻⁷')
        """
        if value == 0:
            return "0"
        mantissa, _, power = f"{abs(value):.{digits - 1}e}".partition("e")
        sign, exponent, page = "−" if value < 0 else "", int(power), self.own["page"]
        if not -3 <= exponent <= 6:
            raised = str(exponent).translate(SUPERSCRIPTS)
            return f"{sign}{_trimmed(mantissa, page)}{page['times']}10{raised}"
        plain = f"{float(f'{mantissa}e{power}'):.{max(0, digits - 1 - exponent)}f}"
        return sign + _trimmed(plain, page)

    def unit(self, unit: str) -> str:
        """Name of a unit."""
        return str(self.own["unit"].get(unit, unit))

    def after(self, unit: str) -> str:
        """Unit as it follows a number."""
        return ("" if unit in ("", "°", "′") else "\u00a0") + self.unit(unit)

    def quantity(self, value: float, unit: str, digits: int = DIGITS) -> str:
        """Number with its unit."""
        return self.number(value, digits) + self.after(unit)

    def field(self, name: str, group: str = "") -> str:
        """Title of a field of requests."""
        fields, own = self.service.get("fields", {}), self.own["own"]
        for key in (f"{group}.{name}", name):
            for table in (fields, own):
                if key in table:
                    return str(table[key]["title"])
        return self.titles.get(name, name)

    def result(self, name: str, section: str = "") -> str:
        """Title of a quantity of an answer; empty if it has none."""
        table = self.own["quantity"]
        found = table.get(f"{section}.{name}") or table.get(name)
        return found or self.said("worked_values", name)

    def value(self, value: Any) -> str:
        """Typed value: a number, a list of them, or a name."""
        if isinstance(value, bool):
            return self.message("option", str(value).lower())
        if isinstance(value, (int, float)):
            return self.number(value, ALL)
        if isinstance(value, list):
            return "; ".join(map(self.value, value))
        return self.said("materials", value) or self.own["option"].get(value) or str(value)

    def text(self, notice: Mapping[str, Any], field: str = "") -> str:
        """Sentence of a warning or of a reason, whose numbers are those of a field."""
        code, check = notice["code"], self._found("checks", notice["code"])
        text = self._found("refusals", code) or self._found("notices", code)
        text = text or self._found("reasons", code) or check.get("warning") or check["refusal"]
        unit, params = shown_unit(field), notice.get("params", {})
        values = {name: self._param(name, each, unit) for name, each in params.items()}
        said = _filled(text["text"] if isinstance(text, dict) else text, values)
        return said[:1].upper() + said[1:]

    def _param(self, name: str, value: Any, unit: str) -> str:
        """Parameter of a sentence."""
        if name in ("field", "other"):
            return self.message("page", "quoted", title=self.field(value))
        if name == "reason" and isinstance(value, str):
            return self.message("shares", "reason", value)
        if name == "names":
            return "; ".join(map(self.field, value.split(", ")))
        if not isinstance(value, (int, float)):
            return (name == "material" and self.said("materials", value)) or str(value)
        own = shown_unit(name) or (unit if name in LIMITS else "")
        whole = isinstance(value, int) or value.is_integer()
        return self.quantity(value, own, ALL if own or whole or name in LIMITS else 3)

    def worked(self, code: str, params: Mapping[str, Any]) -> str:
        """Words of the method of a worked step."""
        kinds = {"criterion": "criteria", "source": "sources"}
        values = {
            name: self.said(kinds.get(name, ""), value) or value
            if isinstance(value, str)
            else self.quantity(value, shown_unit(name), ALL)
            for name, value in params.items()
        }
        return self.said("worked_notes", code, **values)

    def drawn(self, id: str, params: Mapping[str, Any]) -> str:
        """Text of a figure by its id and parameters."""
        kind, _, code = id.rpartition(".")
        values = {name: self._placed(name, each) for name, each in params.items()}
        return self.said(kind or "figures", code, **values)

    def _placed(self, name: str, param: Any) -> str:
        """Parameter of a text of a figure: words of their own, an amount, a unit."""
        if isinstance(param, list):
            return self.drawn(*param)
        if isinstance(param, dict):
            value = param["value"]
            if isinstance(value, str):
                return value
            return self.quantity(value, param["unit"], min(param["digits"], DIGITS))
        if name == "unit":
            return self.unit(param)
        return self.number(param, ALL) if isinstance(param, (int, float)) else str(param)


def _filled(text: str, values: Mapping[str, Any]) -> str:
    """Text with values in place of the names in braces."""
    return re.sub(r"\{(\w+)}", lambda found: str(values.get(found[1], found[0])), text)


def _trimmed(digits: str, page: Mapping[str, str]) -> str:
    """Digits without noughts at their end, groups of three apart, with the decimal sign."""
    whole, _, fraction = digits.partition(".")
    grouped = whole if len(whole) < 5 else f"{int(whole):,}".replace(",", "\u202f")
    fraction = fraction.rstrip("0")
    return grouped + (page["decimal"] + fraction if fraction else "")


def digits_of(name: str) -> int:
    """Number of significant digits with which a result is shown."""
    return 3 if ROUGH.search(name) else DIGITS
