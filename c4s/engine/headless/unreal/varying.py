"""Material expressions whose value differs from place to place: made and connected, and driving nothing here."""

from __future__ import annotations

from c4s.engine.headless.unreal.core import public
from c4s.engine.headless.unreal.expressions import MaterialExpression


@public
class MaterialExpressionTextureBase(MaterialExpression):
    """What has a texture; textures are no assets of their own here."""


@public
class MaterialExpressionTextureSample(MaterialExpressionTextureBase):
    """The colour of a texture."""

    _inputs = ("Coordinates", "TextureObject", "MipValue")


@public
class MaterialExpressionTextureSampleParameter(MaterialExpressionTextureSample):
    """Base of named textures."""


@public
class MaterialExpressionTextureSampleParameter2D(MaterialExpressionTextureSampleParameter):
    """The colour of a named texture."""


@public
class MaterialExpressionTextureCoordinate(MaterialExpression):
    """The texture coordinates of a place."""


@public
class MaterialExpressionWorldPosition(MaterialExpression):
    """The place in the world."""


@public
class MaterialExpressionVertexColor(MaterialExpression):
    """The colour of the mesh at a place."""


@public
class MaterialExpressionNoise(MaterialExpression):
    """Noise."""

    _inputs = ("Position", "FilterWidth")


@public
class MaterialExpressionFresnel(MaterialExpression):
    """How much a surface turns away from the eye."""

    _inputs = ("ExponentIn", "BaseReflectFractionIn", "Normal")


@public
class MaterialExpressionTime(MaterialExpression):
    """The time."""


@public
class MaterialExpressionSine(MaterialExpression):
    """A sine."""

    _inputs = ("Input",)


@public
class MaterialExpressionPanner(MaterialExpression):
    """Texture coordinates that move."""

    _inputs = ("Coordinate", "Time", "Speed")


@public
class MaterialExpressionParameter(MaterialExpression):
    """Base of named values."""


@public
class MaterialExpressionStaticBoolParameter(MaterialExpressionParameter):
    """A named switch."""


@public
class MaterialExpressionStaticSwitchParameter(MaterialExpressionStaticBoolParameter):
    """One of two values by a named switch."""

    _inputs = ("True", "False")
