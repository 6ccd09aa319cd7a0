"""A model's equations in JavaScript, translated from the generated Python module.

The generated functions are straight-line code: assignments of arithmetic and of calls of the namespace
`xp`, and one ``return``. With ``Math`` as the namespace each of these statements means in JavaScript
what it means in Python, with the same precedence, order and double precision, so results agree but for
the last bits of the sines. Whatever else is met is refused.
"""

import ast
from collections.abc import Iterable

from stridemap.solver.model.model import Model

NAMESPACE = "xp"
FUNCTIONS = frozenset(
    {"sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "exp", "log", "sqrt"}
)
"""Functions that NumPy and JavaScript's ``Math`` have under one name; the generator uses no others."""

_ALLOWED = (
    *(
        ast.Name,
        ast.Load,
        ast.Store,
        ast.Constant,
        ast.List,
        ast.Dict,
        ast.Subscript,
        ast.Call,
        ast.Attribute,
    ),
    *(ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.UnaryOp, ast.USub, ast.UAdd),
)

# Words that Python lets be names and JavaScript, in strict code, does not.
_RESERVED = frozenset(
    "arguments case catch const debugger default delete do enum eval export extends false function "
    "implements instanceof interface let new null package private protected public static super switch "
    "this throw true typeof undefined var void".split()
)


def equations(model: Model, names: Iterable[str]) -> str:
    """Return a JavaScript object literal of generated functions, which take ``Math`` first.

    Parameters
    ----------
    model : Model
    names : iterable of str
        The functions.

    Raises
    ------
    TypeError
        When a function holds anything but straight-line arithmetic.
    """
    module = ast.parse(model.path(f"{model.name}.py").read_text(encoding="utf-8"))
    known = {node.name: node for node in module.body if isinstance(node, ast.FunctionDef)}
    return "{\n" + ",\n".join(function(known[name]) for name in names) + "\n}"


def function(node: ast.FunctionDef) -> str:
    """Return one function as a method of a JavaScript object literal.

    Raises
    ------
    TypeError
        When it holds anything but straight-line arithmetic.
    """
    arguments = ", ".join(_name(argument.arg) for argument in node.args.args)
    body = node.body[1:] if ast.get_docstring(node) is not None else node.body
    return "\n".join([f"{node.name}({arguments}) {{", *(f"  {_statement(line)}" for line in body), "}"])


def _statement(node: ast.stmt) -> str:
    match node:
        case ast.Assign(targets=[ast.Name(id=name)], value=value):
            return f"const {_name(name)} = {_expression(value)};"
        case ast.Return(value=ast.Dict() as value):
            return f"return {_expression(value)};"
    raise TypeError(f"cannot write `{ast.unparse(node)}` in JavaScript: it is no assignment and no result")


def _expression(node: ast.expr) -> str:
    for part in ast.walk(node):
        if not isinstance(part, _ALLOWED) or not _means_the_same(part):
            raise TypeError(f"cannot write `{ast.unparse(node)}` in JavaScript")
    return ast.unparse(_Renamed().visit(node))


def _means_the_same(node: ast.AST) -> bool:
    match node:
        case ast.Constant(value=value):
            return type(value) in (int, float, str)
        case ast.Call(func=ast.Attribute(), args=[_], keywords=[]):
            return True
        case ast.Call():
            return False
        case ast.Attribute(value=ast.Name(id=name), attr=attribute):
            return name == NAMESPACE and attribute in FUNCTIONS | {"pi"}
        case ast.Attribute():
            return False
        case ast.Subscript(slice=index):
            return isinstance(index, ast.Constant) and type(index.value) is int
        case ast.Dict(keys=keys):
            return all(isinstance(key, ast.Constant) and type(key.value) is str for key in keys)
    return True


class _Renamed(ast.NodeTransformer):
    def visit_Attribute(self, node: ast.Attribute) -> ast.Attribute:
        name = "PI" if node.attr == "pi" else node.attr
        return ast.Attribute(value=node.value, attr=name, ctx=node.ctx)

    def visit_Name(self, node: ast.Name) -> ast.Name:
        return ast.Name(id=_name(node.id), ctx=node.ctx)


def _name(name: str) -> str:
    return f"{name}_" if name in _RESERVED else name
