"""Unreal's enums; ``str()`` gives ``<LightUnits.CANDELAS: 1>`` as in Unreal's Python."""

from __future__ import annotations

from enum import unique

from c4s.engine.headless.unreal.core import EnumBase, public


@public
@unique
class AttachmentRule(EnumBase):
    """How a part of the transform is treated on attachment."""

    KEEP_RELATIVE = 0
    KEEP_WORLD = 1
    SNAP_TO_TARGET = 2


@public
@unique
class DetachmentRule(EnumBase):
    """How a part of the transform is treated on detachment."""

    KEEP_RELATIVE = 0
    KEEP_WORLD = 1


@public
@unique
class MaterialParameterAssociation(EnumBase):
    """Whose parameter a name means; materials here have global ones only."""

    LAYER_PARAMETER = 0
    BLEND_PARAMETER = 1
    GLOBAL_PARAMETER = 2


@public
@unique
class MIDCreationFlags(EnumBase):
    """How a dynamic material instance is kept."""

    NONE = 0
    TRANSIENT = 1


@public
@unique
class ComponentMobility(EnumBase):
    """Whether a component may move in play."""

    STATIC = 0
    STATIONARY = 1
    MOVABLE = 2


@public
@unique
class CollisionEnabled(EnumBase):
    """What a component's collision takes part in."""

    NO_COLLISION = 0
    QUERY_ONLY = 1
    PHYSICS_ONLY = 2
    QUERY_AND_PHYSICS = 3
    PROBE_ONLY = 4
    QUERY_AND_PROBE = 5


@public
@unique
class LightUnits(EnumBase):
    """Units of a local light's intensity."""

    UNITLESS = 0
    CANDELAS = 1
    LUMENS = 2
    EV = 3
    NITS = 4


@public
@unique
class AutoExposureMethod(EnumBase):
    """How exposure is found."""

    AEM_HISTOGRAM = 0
    AEM_BASIC = 1
    AEM_MANUAL = 2


@public
@unique
class MaterialProperty(EnumBase):
    """Inputs of a material."""

    MP_EMISSIVE_COLOR = 0
    MP_OPACITY = 1
    MP_OPACITY_MASK = 2
    MP_BASE_COLOR = 5
    MP_METALLIC = 6
    MP_SPECULAR = 7
    MP_ROUGHNESS = 8
    MP_ANISOTROPY = 9
    MP_NORMAL = 10
    MP_TANGENT = 11
    MP_WORLD_POSITION_OFFSET = 12
    MP_SUBSURFACE_COLOR = 15
    MP_AMBIENT_OCCLUSION = 18
    MP_REFRACTION = 19
    MP_FRONT_MATERIAL = 30


@public
@unique
class BlendMode(EnumBase):
    """How a material is blended."""

    BLEND_OPAQUE = 0
    BLEND_MASKED = 1
    BLEND_TRANSLUCENT = 2
    BLEND_ADDITIVE = 3
    BLEND_MODULATE = 4
    BLEND_ALPHA_COMPOSITE = 5
    BLEND_ALPHA_HOLDOUT = 6
    BLEND_TRANSLUCENT_COLORED_TRANSMITTANCE = 7


@public
@unique
class CollisionTraceFlag(EnumBase):
    """Which geometry collides."""

    CTF_USE_DEFAULT = 0
    CTF_USE_SIMPLE_AND_COMPLEX = 1
    CTF_USE_SIMPLE_AS_COMPLEX = 2
    CTF_USE_COMPLEX_AS_SIMPLE = 3


@public
@unique
class DrawDebugTrace(EnumBase):
    """Drawing of traces (no drawing happens here)."""

    NONE = 0
    FOR_ONE_FRAME = 1
    FOR_DURATION = 2
    PERSISTENT = 3


@public
class TraceTypeQuery(EnumBase):
    """Trace channels: visibility and camera; also by Unreal 5.8's names."""

    TRACE_TYPE_QUERY1 = 0
    TRACE_TYPE_QUERY2 = 1
    ECC_VISIBILITY = 0
    ECC_CAMERA = 1


@public
@unique
class LevelVisibilityDirtyMode(EnumBase):
    """Whether showing a level marks it as edited."""

    MODIFY_ON_CHANGE = 0
    DONT_MODIFY = 1


@public
@unique
class EditorScriptingFilterType(EnumBase):
    """Whether what fits is kept or dropped."""

    INCLUDE = 0
    EXCLUDE = 1


@public
@unique
class EditorScriptingStringMatchType(EnumBase):
    """How names are compared."""

    CONTAINS = 0
    MATCHES_WILDCARD = 1
    EXACT_MATCH = 2


@public
@unique
class ComparisonTolerance(EnumBase):
    """How pictures are compared; none are here."""

    ZERO = 0
    LOW = 1
    MEDIUM = 2
    HIGH = 3
    CUSTOM = 4


@public
@unique
class SkyLightSourceType(EnumBase):
    """What a sky light shines with; here always what is drawn of the sky."""

    SLS_CAPTURED_SCENE = 0
    SLS_SPECIFIED_CUBEMAP = 1
