"""Names as the block language spells them: in Unicode or in ASCII, with dots for rates."""

import re
import unicodedata

GREEK = dict(zip(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda lamda mu nu xi pi rho sigma "
    "tau upsilon phi chi psi omega".split(),
    "αβγδεζηθικλλμνξπρστυφχψω",
))
GREEK.update({
    "Gamma": "Γ", "Delta": "Δ", "Theta": "Θ", "Lambda": "Λ", "Lamda": "Λ", "Xi": "Ξ", "Pi": "Π",
    "Sigma": "Σ", "Phi": "Φ", "Psi": "Ψ", "Omega": "Ω",
})
LATIN = {letter: word for word, letter in GREEK.items() if word not in ("lambda", "Lambda")}
DOTS = {"\u0307": 1, "\u0308": 2, "\u20db": 3}


def canonical(name):
    """The one spelling of a name: Greek letters where a part spells one."""
    return "_".join(part_in_greek(part) for part in name.split("_"))


def part_in_greek(part):
    """`theta1` becomes `θ1`; everything else stays."""
    match = re.fullmatch(r"([A-Za-z]+)(\d*)", part)
    if match and match.group(1) in GREEK:
        return GREEK[match.group(1)] + match.group(2)
    return part


def without_dots(name):
    """A decomposed name without the dots above its first letter, and how many there were."""
    name = unicodedata.normalize("NFD", name)
    dots = sum(DOTS.get(letter, 0) for letter in name)
    return "".join(letter for letter in name if letter not in DOTS), dots
