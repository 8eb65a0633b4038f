"""Signatures of declarations as C++, from the XML of Doxygen, for the reference."""

import re

WIDTH = 92


def text_of(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def tidy(code):
    """Code as it is formatted in the sources."""
    code = re.sub(r"\bKANEXPR_\w+\b|\binline\b", "", code)
    code = code.replace("< ", "<").replace(" >", ">").replace(" &", "&").replace(" *", "*").replace("auto()", "auto")
    code = re.sub(r"\bkanexpr::(?=\w)", "", code)
    return " ".join(code.split())


def parameters_of(member):
    found = []
    for each in member.findall("param"):
        kind, name, default, array = (text_of(each.find(tag)) for tag in ("type", "declname", "defval", "array"))
        found.append(tidy(f"{kind} {name}{array}" + (f" = {default}" if default else "")))
    return found


def template_of(entity):
    listed = entity.find("templateparamlist")
    if listed is None:
        return ""
    found = []
    for each in listed:
        kind, name, default = (text_of(each.find(tag)) for tag in ("type", "declname", "defval"))
        found.append(tidy(f"{kind} {name}" + (f" = {default}" if default else "")))
    return f"template <{', '.join(found)}>"


def wrapped(start, parameters, end):
    """A call wrapped at WIDTH, with as many parameters in each line as fit."""
    line = f"{start}({', '.join(parameters)}){end}"
    if len(line) <= WIDTH:
        return line
    lines = [""]
    for each in [*(f"{each}, " for each in parameters[:-1]), *parameters[-1:]]:
        if lines[-1] and len(lines[-1]) + len(each) > WIDTH - 4:
            lines.append("")
        lines[-1] += each
    return f"{start}(\n    " + "\n    ".join(line.rstrip() for line in lines) + f"){end}"


def signature(member, name):
    kind, lines = member.get("kind"), [template_of(member)]
    if requires := text_of(member.find("requiresclause")):
        lines.append(f"  requires {tidy(requires)}")
    declared = tidy(text_of(member.find("type"))).removesuffix("()")
    if kind == "function":
        words = ["explicit"] * (member.get("explicit") == "yes") + ["static"] * (member.get("static") == "yes" and "static" not in declared)
        qualifiers = re.search(r"\)([^()]*)$", text_of(member.find("argsstring")))
        end = tidy(qualifiers.group(1).split("=")[0]) if qualifiers else ""
        lines.append(wrapped(" ".join([*words, declared, name]).strip(), parameters_of(member), f" {end}" if end else ""))
    elif kind == "typedef":
        lines.append(f"using {name} = {declared}")
    elif kind == "enum":
        lines.append(f"enum class {name}")
    else:
        start = tidy(text_of(member.find("initializer")))
        value = f" {start}" if re.fullmatch(r"= [-\w.+]+(?:::\w+)?", start) else ""
        is_static = member.get("static") == "yes" and not declared.startswith("static")
        lines.append(f"{'static ' * is_static}{declared} {name}{value}")
    return "\n".join(each for each in lines if each)
