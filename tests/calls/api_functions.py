# SPDX-License-Identifier: MIT
"""The functions and tokens of libOpenRT, or of librtut, as the public C headers declare them."""
import dataclasses
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
RTUT = {"rtut.h", "rtut_enums.h"}
NESTED = r"(?:[^()]|\((?:[^()]|\([^()]*\))*\))*"
DECLARATION = re.compile(r"\bRTAPI\b\s*([^;{}()]*?)\bRTAPIENTRY\s+(\w+)\s*\((" + NESTED + r")\)\s*;")


@dataclasses.dataclass
class Parameter:
    type: str  # as C spells it; arrays are pointers
    name: str

    @property
    def pointer(self):
        return "*" in self.type

    @property
    def base(self):
        return self.type.replace("const", "").replace("*", "").replace("struct ", "").strip()

    @property
    def constant(self):
        return self.type.startswith("const")


@dataclasses.dataclass
class Function:
    result: str
    name: str
    parameters: list
    left_out: bool = False  # by its header


def without_comments(text):
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL)


def split_parameters(text):
    depth, part = 0, ""
    for character in text:
        depth += {"(": 1, ")": -1}.get(character, 0)
        if character == "," and depth == 0:
            yield part
            part = ""
        else:
            part += character
    yield part


def parameter(text):
    text = " ".join(text.split())
    callback = re.match(r"(\w+) ?\((?:RTAPIENTRY )?\*(\w+)\)(\(.*\))$", text)
    if callback:
        return Parameter(f"{callback.group(1)}(RTAPIENTRY *){callback.group(3)}", callback.group(2))
    kind, name, array = re.match(r"(.*?)(\w+)(\[\d*\])?$", text).groups()
    return Parameter(kind.strip() + (" *" if array else ""), name)


def headers(rtut):
    return [path for path in sorted((ROOT / "include/openrt").glob("*.h"))
            if (path.name in RTUT) == rtut]


def left_out(text):
    """The functions below a comment, or in a section, that says so."""
    found, section, comment = set(), "", ""
    for part in re.split(r"(/\*.*?\*/)", text, flags=re.DOTALL):
        if part.startswith("/* ----"):
            section, comment = part, ""
        elif part.startswith("/*"):
            comment = part
        elif "Left out" in section or comment.startswith("/* Left out"):
            found |= {name for _, name, _ in DECLARATION.findall(part)}
    return found


def functions(rtut=False):
    found = {}
    for path in headers(rtut):
        whole = path.read_text(encoding="utf-8")
        lacking = left_out(whole)
        for result, name, parameters in DECLARATION.findall(without_comments(whole)):
            given = [] if parameters.strip() == "void" else list(split_parameters(parameters))
            found[name] = Function(" ".join(result.split()), name, [parameter(p) for p in given],
                                   name in lacking)
    return [found[name] for name in sorted(found)]


def tokens(rtut=False):
    """Name -> value of every RT_ and RTU_, or RTUT_, token that is a number; aliases too."""
    found = {}
    prefix = "RTUT" if rtut else "RTU?"
    for path in headers(rtut):
        text = without_comments(path.read_text(encoding="utf-8"))
        for name, value in re.findall(rf"^#\s*define\s+({prefix}_\w+)\s+(\w+)\s*$", text,
                                      re.MULTILINE):
            number = found.get(value)
            if number is None and re.fullmatch(r"0[xX][0-9a-fA-F]+|\d+", value):
                number = int(value, 0)
            if number is not None:
                found[name] = number
    return found
