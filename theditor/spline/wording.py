"""Known curves in words: equations and descriptions, with true minus signs."""

from collections.abc import Mapping, Sequence
from math import atanh, degrees, sqrt
from typing import Any

from theditor.spline.basis import Mode
from theditor.spline.kinds import Kind
from theditor.spline.numerals import indexed, number, position

_LEFT_SIDE = {2: "(x, y)", 3: "(x, y, z)"}


def equation(mode: Mode, coefficients: Sequence[Sequence[float]], tolerance: float) -> str:
    """Write the parametrisation with coefficients c0 … c3 in the functions of the mode."""
    terms = _trigonometric if mode is Mode.TRIGONOMETRIC else _hyperbolic
    sides = (
        _sum([(c0, ""), (c1, "t"), *terms(c2, c3, tolerance)], tolerance)
        for c0, c1, c2, c3 in zip(*coefficients, strict=True)
    )
    return f"{_LEFT_SIDE[len(coefficients[0])]} = ({', '.join(sides)}), t ∈ [0, 1]"


def straight(start: Sequence[float], end: Sequence[float], tolerance: float) -> str:
    """Write the line segment between two points."""
    sides = (_sum([(a, ""), (b - a, "s")], tolerance) for a, b in zip(start, end, strict=True))
    return f"{_LEFT_SIDE[len(start)]} = ({', '.join(sides)}), s ∈ [0, 1]"


def fixed(point: Sequence[float], tolerance: float) -> str:
    """Write the equation of a point."""
    return f"{_LEFT_SIDE[len(point)]} = {position(point, tolerance)}"


def suggestion(wrong: Sequence[tuple[int, float]], target: float, kind: Kind) -> str:
    """Say which λ, (control point, value), to set to what, and what for."""
    found = " and ".join(f"{indexed('λ', i)} = {_exact(value)}" for i, value in wrong)
    both = "both " if len(wrong) > 1 else ""
    return f"{found}: set {both}to {target:g} to make it {with_article(kind)}"


def with_article(kind: Kind) -> str:
    """Return the name as a sentence takes it: ``an ellipse arc``, ``a prolate trochoid``."""
    name = " ".join(reversed(kind.value.split(", ")))
    return f"{'an' if name[0] in 'aeiou' else 'a'} {name}"


def description(kind: Kind, parameters: Mapping[str, Any], tolerance: float) -> str:
    """Return one line: the kind with its measures and place."""
    p = parameters

    def size(key: str) -> str:
        return f"{key.replace('_', ' ')} {number(p[key])}"

    def at(key: str) -> str:
        return f"{key} {position(p[key], tolerance)}"

    match kind:
        case Kind.POINT:
            return f"point {position(p['position'], tolerance)}"
        case Kind.LINE:
            return f"line segment from {position(p['start'], tolerance)} to {position(p['end'], tolerance)}"
        case Kind.CIRCLE:
            return _joined(kind, at("centre"), size("radius"), *_plane(p), _angles(p))
        case Kind.ELLIPSE:
            return _joined(kind, at("centre"), _axes(p), *_plane(p), _angles(p))
        case Kind.HYPERBOLA:
            return _joined(kind, at("centre"), _axes(p), *_plane(p), _range(p))
        case Kind.SINE:
            return _joined(kind, size("amplitude"), size("wavelength"), at("origin"), *_plane(p), _angles(p))
        case Kind.CYCLOID:
            return _joined(kind, f"rolling {size('radius')}", at("origin"), *_plane(p), _angles(p))
        case Kind.PROLATE | Kind.CURTATE:
            wheel = f"rolling {size('radius')}", size("arm")
            return _joined(kind, *wheel, at("origin"), *_plane(p), _angles(p))
        case Kind.CATENARY:
            return _joined(kind, size("parameter"), at("vertex"), *_plane(p), _range(p))
        case Kind.EXPONENTIAL:
            return _joined(kind, size("amplitude"), size("length"), at("origin"), *_plane(p), _range(p))
        case Kind.HELIX:
            hand = "right-handed" if p["pitch"] > 0 else "left-handed"
            axis = f"axis through {position(p['centre'], tolerance)} along {position(p['axis'], 1e-9)}"
            return _joined(kind, size("radius"), f"pitch {number(abs(p['pitch']))}", hand, axis)
        case Kind.TRIGONOMETRIC:
            ratio = p["arm_to_radius"]
            image = "prolate" if ratio > 1 else "curtate"
            return f"{kind.value}, affine image of a {image} trochoid with arm : radius = {number(ratio)}"
    return _joined(kind)


def _joined(kind: Kind, *parts: str) -> str:
    return ", ".join([kind.value, *parts])


def _axes(p: Mapping[str, Any]) -> str:
    a, b = p["semi_axes"]
    return f"semi-axes {number(a)} and {number(b)}"


def _plane(p: Mapping[str, Any]) -> list[str]:
    """Return how the curve is turned, or lies in space."""
    if "normal" in p:
        return [f"first axis along {position(p['axis'], 1e-9)}, normal {position(p['normal'], 1e-9)}"]
    return [f"turned by {_degrees(p['rotation'])}"] if abs(p.get("rotation", 0.0)) > 1e-9 else []


def _angles(p: Mapping[str, Any]) -> str:
    return f"{_degrees(p['start'])}–{_degrees(p['end'])}"


def _range(p: Mapping[str, Any]) -> str:
    return f"from τ = {number(p['start'], 1e-9)} to {number(p['end'], 1e-9)}"


def _degrees(angle: float) -> str:
    return f"{number(degrees(angle), 1e-7)}°"


def _exact(value: float) -> str:
    return repr(value).removesuffix(".0").replace("-", "−")


def _trigonometric(c2: float, c3: float, tolerance: float) -> list[tuple[float, str]]:
    return [(c2, " cos(πt/2)"), (c3, " sin(πt/2)")]


def _hyperbolic(c2: float, c3: float, tolerance: float) -> list[tuple[float, str]]:
    """Return c2 cosh t + c3 sinh t as a single term."""
    even, odd = abs(c2), abs(c3)
    if min(even, odd) <= tolerance:
        return [(c2, " cosh t"), (c3, " sinh t")]
    if abs(even - odd) <= tolerance:
        return [(c2, " eᵗ" if c2 * c3 > 0 else " e⁻ᵗ")]
    size = sqrt(abs(even - odd) * (even + odd))
    if even > odd:
        shift = atanh(c3 / c2)
        return [(size if c2 > 0 else -size, f" cosh({_shifted(shift, mirrored=True)})")]
    return [(size if c3 > 0 else -size, f" sinh({_shifted(atanh(c2 / c3))})")]


def _shifted(shift: float, mirrored: bool = False) -> str:
    """Write t + shift, or, where only its size counts and the shift is negative, |shift| − t."""
    if shift > 0:
        return f"t + {number(shift)}"
    return f"{number(-shift)} − t" if mirrored else f"t − {number(-shift)}"


def _sum(terms: Sequence[tuple[float, str]], tolerance: float) -> str:
    """Write a sum of factors times functions, leaving out what is zero."""
    text = ""
    for factor, function in terms:
        if abs(factor) <= tolerance:
            continue
        size = number(abs(factor))
        body = function.lstrip() if function and size == "1" else size + function
        if text:
            text += f" − {body}" if factor < 0 else f" + {body}"
        else:
            text = f"−{body}" if factor < 0 else body
    return text or "0"
