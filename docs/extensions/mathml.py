"""Formulas as MathML, which browsers draw by themselves: pages need no script from the network."""

from docutils.utils.math.latex2mathml import tex2mathml


def _inline(translator, node):
    translator.body.append(_mathml(node, display=False))
    raise _skip()


def _block(translator, node):
    translator.body.append(f'<div class="math">{_mathml(node, display=True)}</div>')
    raise _skip()


def _mathml(node, display):
    return tex2mathml(node.astext(), as_block=display)


def _skip():
    from docutils.nodes import SkipNode

    return SkipNode()


def setup(app):
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
