"""The model's equations for the page: a JavaScript object literal of its generated functions."""

import ast

from stridemap.solver.model.model import Model


def equations(model: Model) -> str:
    """An expression that gives an object of functions; each takes ``Math`` and then its own arguments."""
    # Once every model has its file <model>.js, this is `return model.text(f"{model.name}.js")` alone.
    if f"{model.name}.js" in model.spec.files:
        return model.text(f"{model.name}.js")
    from stridemap.derive.printers.javascript import function

    source = ast.parse(model.text(f"{model.name}.py"))
    methods = [function(node) for node in source.body if isinstance(node, ast.FunctionDef)]
    return "({\n" + ",\n".join(methods) + "\n})"
