"""The C that CasADi generates."""

import operations
from build import contents, fingerprint
from peer import HERE, MARCH, Offer, symbol

FACE = """
void {result}(const double* x, double* result) {{
  const double* arguments[] = {{x}};
  double* results[] = {{result}};
  static double work[{work}];
  casadi_{result}(arguments, results, 0, work, 0);
}}
"""


class Generated:
    name = "CasADi"

    def offers(self, model, shop, models):
        folder = self.write(model, shop, models)
        found = {}
        for path in sorted(folder.glob("*.c")):
            result = path.name.split(".")[0]
            count = operations.in_code(path.read_text())
            if result in found and found[result][0] <= count:
                continue
            found[result] = count, path
        offers = {}
        for result, (count, path) in found.items():
            built = shop.build("gcc", path, MARCH)
            offers[result] = Offer(symbol(built.path, result), count, built)
        return offers

    @staticmethod
    def write(model, shop, models):
        sources = [HERE / "tree_in_casadi.py", HERE / "bicycle_in_casadi.py", HERE / "with_casadi.py",
                   HERE / "requirements.txt", models / f"{model.name}.model"]
        folder = shop.folder / f"casadi-{model.name}-{fingerprint(contents(sources))}"
        if folder.exists():
            return folder
        import casadi as ca
        if model.is_tree:
            from tree_in_casadi import results
        else:
            from bicycle_in_casadi import results
        x, ways_of = results(model)
        unfinished = folder.with_suffix(".unfinished")
        unfinished.mkdir(exist_ok=True)
        for result, ways in ways_of.items():
            for i, way in enumerate(ways):
                function = ca.Function(f"casadi_{result}", [x], [ca.cse(ca.densify(way))])
                code = ca.CodeGenerator(f"{result}.c")
                code.add(function)
                face = FACE.format(result=result, work=max(1, function.sz_w()))
                (unfinished / f"{result}.{i}.c").write_text(code.dump() + face)
        unfinished.rename(folder)
        return folder
