"""Checks of the contact of pin and hole: pressure, shakedown, first yield. Those of plastics alone
are in `core.checks.plastics`.
"""

from functools import partial
from typing import Any, get_args

from core.checks.check import Check, Kind, Unjudged, design_check, judged, judged_by
from core.checks.inputs import LIFE, LOADED, SLIDING
from core.design.document import Design
from core.design.results import Results
from core.errors import NotKnown, if_known, is_known
from core.hertz import HertzContact, force_factor
from core.materials import SLIDING as KNOWN_SLIDING
from core.materials import Body, ContactLimit, ElasticMaterial

BODIES: tuple[Body, ...] = get_args(Body)

FIXES = (
    "pin.diameter",
    "contact.contact_length",
    "contact.pin_radius",
    "load.pin_circle_radius",
    "mechanism.pins",
    "mechanism.satellites",
    "load.output_torque",
    "contact.fit",
)
_check = partial(
    design_check,
    group="contact",
    part="contact",
    inputs=LOADED,
    fixes=FIXES,
    needs=("touching", "load"),
)


def _against_limit(kind: Kind, results: Results, warning: str = "") -> Check:
    """The governing pressure against its limit."""
    design, contact = results.design, results.hertz
    return in_disc(
        kind=kind,
        results=results,
        contact=contact,
        pressure=contact.governing_pressure,
        **kind.known(design, results),
        reserve=results.contact_reserves[kind.code],
        warning=warning,
        at=results.peak,
    )


def in_disc(
    *,
    kind: Kind,
    results: Results,
    contact: HertzContact,
    pressure: float,
    limit: float,
    **more: Any,
) -> Check:
    """The pressure against a limit, with what the edge of the disc makes of it: near enough nothing
    passes.

    Parameters
    ----------
    kind : Kind
        The check.
    results : Results
        Results of the design.
    contact : HertzContact
        The contact that is judged.
    pressure, limit : float
        Its governing pressure and the limit of that, Pa.
    **more
        What `judged` is told besides.

    Returns
    -------
    Check
    """
    disc = results.disc_of(contact)
    error = (contact.conformal_error or 0.0) + 8 * contact.accuracy.relative_error
    if disc is not None:
        error += disc.params.get("error", 0.0)
        if disc.code == "disc_ovals" and pressure <= limit:
            said = {"reason": disc.code, "params": disc.params, "at": more.get("at", {})}
            return Check(kind, "not_checked", value=pressure, limit=limit, **said)
    rough = results.solved or bool(results.design.pin)
    return judged(kind, pressure, limit, error=error, rough=rough, **more)


def whence(limit: ContactLimit) -> dict[str, str]:
    """Where a limit of the pressure comes from.

    Parameters
    ----------
    limit : ContactLimit
        The limit.

    Returns
    -------
    dict
        Attributes of a check.
    """
    return {
        "limit_source": limit.source,
        "criterion": limit.criterion,
        "verified": limit.verified or "",
    }


def over_life(*, found: Check, limit: ContactLimit) -> Check:
    """A pressure against a limit, with how much of the life that has in it, where nothing else is
    said.

    Parameters
    ----------
    found : Check
        The pressure, judged.
    limit : ContactLimit
        The limit.

    Returns
    -------
    Check
    """
    if found.reason:
        return found
    try:
        _ = limit.life
    except NotKnown as why:
        return found._replace(reason=why.code, missing=why.missing)
    return found._replace(reason="life_of_teeth")


def static_limit(
    *, material: ElasticMaterial, missing: str, value: float, **known: Any
) -> tuple[float, dict[str, Any]]:
    """What a surface bears once: what it bears for ever it bears once too.

    Parameters
    ----------
    material : ElasticMaterial
        Of the surface.
    missing : str
        Core name of its limit.
    value : float
        Pressure that it is to bear, Pa.
    **known
        What else is known of the check.

    Returns
    -------
    tuple of float and dict
        The limit, Pa, and whence it is.

    Raises
    ------
    Unjudged
        If it is not known, as beyond a lasting limit.
    """
    if material.static_pressure is not None:
        return material.static_pressure, {}
    unknown = "plastic_limit_unknown" if material.plastic else "limit_unknown"
    lasting = judged_by(material.limit, unknown, missing, value=value, **known)
    if value > lasting.pressure:
        raise Unjudged("static_limit_unknown", value=value, **known)
    return float(lasting.pressure), whence(lasting)


def _pressure(body: Body) -> Kind:
    code = f"contact_pressure_{body}"

    def limit_of(design: Design, results: Results) -> ContactLimit:
        """That of the material, which has to have one."""
        return judged_by(
            design.lasting[body].limit,
            "plastic_limit_unknown" if body in design.plastics else "limit_unknown",
            f"contact.{body}_material.allowable_pressure",
            value=if_known(lambda: results.hertz.governing_pressure),
            at=if_known(lambda: results.peak) or {},
        )

    def known(design: Design, results: Results) -> dict[str, Any]:
        limit = limit_of(design, results)
        return {
            "limit": results.pressure_limits[code],
            "life_factor": limit.life_factor,
            **whence(limit),
        }

    @_check(
        code,
        unit="MPa",
        title=f"Contact pressure of the {body}",
        formula="p ≤ p_all·Z_NT/S",
        why=f"Above it the surface of the {body} pits within the life.",
        inputs=(*LOADED, *LIFE, "requirements.pitting_safety"),
        fixes=(*FIXES, f"contact.{body}_material"),
        source="yanchevsky_2018",
        known=known,
    )
    def pressure(design: Design, results: Results) -> Check:
        limit = limit_of(design, results)
        return over_life(found=_against_limit(pressure, results), limit=limit)

    return pressure


def _plastic(body: Body, name: str, warning: str = "", **said: str) -> Kind:
    """The pressure against one by the yield strength, where that governs."""
    code = f"contact_{name}_{body}"

    @_check(
        code,
        unit="MPa",
        inputs=(*LOADED, *SLIDING),
        fixes=(*FIXES, f"contact.{body}_material"),
        known=lambda design, results: {"limit": results.pressure_limits[code]},
        **said,
    )
    def plastic(design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if body in design.plastics:
            return Check(plastic, "not_applicable", reason="plastic_rules")
        if not material.yield_governs:
            return Check(plastic, "not_applicable", reason="tested_limit")
        judged_by(
            material.yield_strength,
            "yield_unknown",
            f"contact.{body}_material.yield_strength",
            status="not_asked"
            if f"{body}_material" in design.contact.own_limits
            else "not_checked",
        )
        found = _against_limit(plastic, results, warning)
        sliding, yielding = design.sliding_friction, results.pressure_limits
        if name == "yield" or sliding <= KNOWN_SLIDING or found.status == "fail":
            return found
        # between the pressure up to which nothing yields and the one from which it goes on
        if results.hertz.governing_pressure > yielding[f"contact_yield_{body}"]:
            return found._replace(status="marginal", reason="shakedown_unknown")
        return found

    return plastic


def _shakedown(body: Body) -> Kind:
    return _plastic(
        body,
        "shakedown",
        title=f"Shakedown of the {body}",
        formula="p ≤ (2.31 … 2.06)·R_e",
        why=f"Above it the surface of the {body} flows on with every turn.",
        source="johnson_shakedown",
    )


def _yield(body: Body) -> Kind:
    return _plastic(
        body,
        "yield",
        warning="plastic_first",
        title=f"First yield of the {body}",
        formula="p ≤ f(ν, μ)·R_e",
        why=f"Above it the {body} yields in the first turns.",
        source="johnson_yield",
    )


def _static(body: Body) -> Kind:
    @_check(
        f"contact_static_{body}",
        unit="MPa",
        title=f"Contact pressure of the {body} at the peak torque",
        formula="p(T_max) ≤ p_static",
        why=f"Above it the surface of the {body} is dented at once.",
        inputs=(*LOADED, "load.peak_torque"),
        requires={"load.peak_torque": "no_peak_torque"},
        demands=("load.peak_torque",),
        fixes=(*FIXES, f"contact.{body}_material", "load.peak_torque"),
        source="static_pressure",
    )
    def static(design: Design, results: Results) -> Check:
        material = design.lasting[body]
        if body in design.plastics and not material.limit:
            return Check(static, "not_applicable", reason="plastic_rules")
        contact = results.static_contact
        pressure = contact.governing_pressure
        missing = f"contact.{body}_material.allowable_pressure"
        limit, source = static_limit(material=material, missing=missing, value=pressure)
        return in_disc(
            kind=static,
            results=results,
            contact=contact,
            pressure=pressure,
            limit=limit,
            reserve=force_factor(
                contact=contact, contact_at=results.static_contact_at, limit=limit
            ),
            **source,
        )

    return static


@design_check(
    "contact_conformity",
    title="Width of the contact",
    group="contact",
    part="contact",
    formula="a/r ≤ 0.159",
    why="No check any more: wide contacts have a pressure of their own.",
    inputs=(),
    fixes=(),
    source="hertz",
    needs=("touching", "load"),
)
def contact_conformity(design: Design, results: Results) -> Check:
    """For one release."""
    return Check(contact_conformity, "not_applicable", reason="conformal_solution")


def life_considered(*, design: Design, body: Body) -> bool:
    """Whether the limit of the pressure of a body, if one is known, is that over the life.

    Parameters
    ----------
    design : Design
        The design.
    body : {"pin", "hole"}
        Whose surface.

    Returns
    -------
    bool
    """
    limit = design.lasting[body].limit
    return not limit or is_known(lambda: limit.life)


CONTACT = (
    *map(_pressure, BODIES),
    *map(_shakedown, BODIES),
    *map(_yield, BODIES),
    *map(_static, BODIES),
    contact_conformity,
)
