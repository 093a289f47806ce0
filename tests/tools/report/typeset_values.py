"""The values of typeset closed forms, worked out to as many digits as the argument says.

Each line of standard input: MathML of a number or of three in parentheses. Each line of
output: the doubles nearest to the values, as hexfloats. What is not well-formed, or holds anything
but numbers, roots, fractions, powers, products, sums and parentheses, ends the program with an error.
"""

import re
import sys
import xml.etree.ElementTree
from decimal import Context, Decimal, setcontext

setcontext(Context(prec=int(sys.argv[1]), Emin=-100000, Emax=100000))

OPERATORS = {"\u2212": "-", "+": "+", "\u2062": "*", "\u22c5": "*", "(": "(", ")": ")", ",": ","}


def of_mathml(element):
    """A Python expression."""
    parts = [of_mathml(child) for child in element]
    if element.tag == "mn":
        if not re.fullmatch("[0-9]+", element.text):
            raise ValueError(f"no number: {element.text}")
        return f"Decimal('{element.text}')"
    if element.tag == "mo":
        return OPERATORS[element.text]
    if element.text or any(child.tail for child in element):
        raise ValueError(f"text in <{element.tag}>")
    if element.tag == "mrow":
        return f"({''.join(parts)})"
    if element.tag == "msqrt":
        return f"({''.join(parts)}).sqrt()"
    first, second = parts
    return f"({first}){ {'mfrac': '/', 'msup': '**'}[element.tag]}({second})"


for line in sys.stdin:
    value = eval(of_mathml(xml.etree.ElementTree.fromstring(line)))
    print(*(float(x).hex() for x in (value if isinstance(value, tuple) else (value,))))
