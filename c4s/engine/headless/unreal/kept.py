"""Editor properties that are kept and saved, and change nothing in the headless engine: it has no such effect.

They stand here by class so that scripts which set them run, and what they set can be read back.
"""

from __future__ import annotations

from typing import Any

from c4s.engine.headless.unreal.containers import Name
from c4s.engine.headless.unreal.core import Prop
from c4s.engine.headless.unreal.enums import SkyLightSourceType
from c4s.engine.headless.unreal.structs import Color, LinearColor, Vector


def _bools(value: bool, names: str) -> dict[str, Prop]:
    return {name: Prop("bool", value) for name in names.split()}


def _floats(**values: float) -> dict[str, Prop]:
    return {name: Prop("float", float(value)) for name, value in values.items()}


def _ints(**values: int) -> dict[str, Prop]:
    return {name: Prop("int", value) for name, value in values.items()}


def _made(kind: str, make: Any, *names: str) -> dict[str, Prop]:
    return {name: Prop(kind, make) for name in names}


def _white() -> LinearColor:
    return LinearColor(1, 1, 1, 1)


def _black() -> LinearColor:
    return LinearColor(0, 0, 0, 1)


KEPT: dict[str, dict[str, Prop]] = {
    "Actor": {
        **_bools(
            False,
            "always_relevant replicates only_relevant_to_owner auto_destroy_when_finished "
            "generate_overlap_events_during_level_streaming net_use_owner_relevancy",
        ),
        **_bools(True, "enable_auto_lod_generation find_camera_component_when_view_target"),
        **_floats(
            initial_life_span=0,
            net_update_frequency=100,
            min_net_update_frequency=2,
            net_priority=1,
            net_cull_distance_squared=225000000,
            sprite_scale=1,
        ),
        **_made("Vector", Vector, "pivot_offset"),
        **_made("Name", Name, "runtime_grid"),
    },
    "PrimitiveComponent": {
        **_bools(
            True,
            "cast_dynamic_shadow cast_static_shadow cast_contact_shadow affect_distance_field_lighting "
            "affect_dynamic_indirect_lighting allow_cull_distance_volume apply_impulse_on_damage "
            "receives_decals render_in_main_pass render_in_depth_pass visible_in_reflection_captures "
            "visible_in_real_time_sky_captures visible_in_ray_tracing enable_auto_lod_generation",
        ),
        **_bools(
            False,
            "cast_hidden_shadow cast_far_shadow cast_inset_shadow cast_shadow_as_two_sided "
            "cast_volumetric_translucent_shadow cast_cinematic_shadow emissive_light_source "
            "affect_indirect_lighting_while_hidden generate_overlap_events never_distance_cull "
            "owner_no_see only_owner_see render_custom_depth multi_body_overlap ignore_radial_impulse "
            "ignore_radial_force light_attachments_as_group treat_as_background_for_occlusion "
            "always_create_physics_state force_mip_streaming visible_in_scene_capture_only holdout",
        ),
        **_floats(min_draw_distance=0, ld_max_draw_distance=0, cached_max_draw_distance=0),
        **_ints(custom_depth_stencil_value=0, translucency_sort_priority=0),
    },
    "StaticMeshComponent": {
        **_bools(True, "evaluate_world_position_offset cast_distance_field_indirect_shadow"),
        **_bools(
            False,
            "disallow_nanite force_nanite_for_masked override_min_lod override_light_map_res "
            "override_wireframe_color reverse_culling sort_triangles "
            "ignore_instance_for_texture_streaming world_position_offset_writes_velocity",
        ),
        **_ints(forced_lod_model=0, min_lod=0, overridden_light_map_res=64, world_position_offset_disable_distance=0),
        **_floats(streaming_distance_multiplier=1, distance_field_self_shadow_bias=0),
    },
    "LightComponentBase": {
        **_bools(True, "affect_global_illumination affect_reflection affect_translucent_lighting"),
        **_bools(False, "cast_deep_shadow transmission"),
        **_ints(samples_per_pixel=1),
    },
    "LightComponent": {
        **_floats(
            bloom_max_brightness=100,
            bloom_scale=0.2,
            bloom_threshold=0,
            contact_shadow_casting_intensity=1,
            contact_shadow_length=0,
            contact_shadow_non_casting_intensity=0,
            diffuse_scale=1,
            disabled_brightness=0.5,
            ies_brightness_scale=1,
            light_function_fade_distance=100000,
            shadow_bias=0.5,
            shadow_resolution_scale=1,
            shadow_sharpen=0,
            shadow_slope_bias=0.5,
            ray_start_offset_depth_scale=0.003,
        ),
        **_bools(True, "allow_mega_lights"),
        **_bools(
            False,
            "cast_shadows_from_cinematic_objects_only cast_translucent_shadows contact_shadow_length_in_ws "
            "enable_light_shaft_bloom force_cached_shadows_for_movable_primitives use_ies_brightness "
            "use_ray_traced_distance_field_shadows",
        ),
        **_made("Color", lambda: Color(255, 255, 255, 255), "bloom_tint"),
        **_made("Vector", lambda: Vector(1024, 1024, 1024), "light_function_scale"),
    },
    "DirectionalLightComponent": {
        **_floats(
            dynamic_shadow_distance_movable_light=20000,
            dynamic_shadow_distance_stationary_light=0,
            cascade_distribution_exponent=3,
            cascade_transition_fraction=0.1,
            far_shadow_distance=300000,
            shadow_distance_fadeout_fraction=0.1,
            distance_field_shadow_distance=30000,
            trace_distance=10000,
            light_source_soft_angle=0,
            occlusion_mask_darkness=0.05,
            occlusion_depth_range=100000,
            cloud_shadow_strength=1,
            cloud_shadow_on_atmosphere_strength=1,
            cloud_shadow_on_surface_strength=1,
            cloud_shadow_depth_bias=0,
            cloud_shadow_extent=150,
            cloud_shadow_map_resolution_scale=1,
            cloud_shadow_ray_sample_count_scale=1,
            shadow_amount=1,
            shadow_cascade_bias_distribution=1,
            shadow_source_angle_factor=1,
        ),
        **_ints(
            dynamic_shadow_cascades=3,
            far_shadow_cascade_count=0,
            atmosphere_sun_light_index=0,
            forward_shading_priority=0,
        ),
        **_bools(True, "use_inset_shadows_for_movable_objects"),
        **_bools(
            False,
            "enable_light_shaft_occlusion cast_cloud_shadows cast_shadows_on_clouds "
            "cast_shadows_on_atmosphere per_pixel_atmosphere_transmittance cast_modulated_shadows",
        ),
        **_made("Vector", Vector, "light_shaft_override_direction"),
        **_made("Color", lambda: Color(128, 128, 128, 255), "modulated_shadow_color"),
        **_made("LinearColor", _white, "atmosphere_sun_disk_color_scale", "cloud_scattered_luminance_scale"),
    },
    "LocalLightComponent": _floats(inverse_exposure_blend=0),
    "SkyLightComponent": {
        **_bools(False, "capture_emissive_only cloud_ambient_occlusion"),
        **_ints(cubemap_resolution=128),
        **_floats(
            cloud_ambient_occlusion_strength=1,
            cloud_ambient_occlusion_extent=150,
            cloud_ambient_occlusion_map_resolution_scale=1,
            cloud_ambient_occlusion_aperture_scale=0.05,
            contrast=0,
            min_occlusion=0,
            occlusion_exponent=1,
            occlusion_max_distance=1000,
            sky_distance_threshold=150000,
            source_cubemap_angle=0,
        ),
        **_made("Color", lambda: Color(0, 0, 0, 255), "occlusion_tint"),
        "source_type": Prop("SkyLightSourceType", SkyLightSourceType.SLS_CAPTURED_SCENE),
    },
    "ExponentialHeightFogComponent": {
        **_floats(
            end_distance=0,
            directional_inscattering_start_distance=10000,
            fully_directional_inscattering_color_distance=100000,
            non_directional_inscattering_color_distance=1000,
            inscattering_color_cubemap_angle=0,
            volumetric_fog_distance=6000,
            volumetric_fog_extinction_scale=1,
            volumetric_fog_near_fade_in_distance=0,
            volumetric_fog_scattering_distribution=0.2,
            volumetric_fog_start_distance=0,
            volumetric_fog_static_lighting_scattering_intensity=1,
        ),
        **_bools(True, "render_in_main_pass visible_in_real_time_sky_captures visible_in_reflection_captures"),
        **_bools(False, "override_light_colors_with_fog_inscattering_colors holdout"),
        **_made("LinearColor", _black, "directional_inscattering_luminance", "volumetric_fog_emissive"),
        **_made("LinearColor", _white, "inscattering_texture_tint", "sky_atmosphere_ambient_contribution_color_scale"),
        **_made("Color", lambda: Color(255, 255, 255, 255), "volumetric_fog_albedo"),
    },
    "SkyAtmosphereComponent": {
        **_floats(
            aerial_perspective_start_depth=0.1,
            aerial_pespective_view_distance_scale=1,
            height_fog_contribution=1,
            mie_absorption_scale=0.000444,
            mie_anisotropy=0.8,
            mie_exponential_distribution=1.2,
            other_absorption_scale=0.001881,
            rayleigh_exponential_distribution=8,
            trace_sample_count_scale=1,
            transmittance_min_light_elevation_angle=-90,
        ),
        **_bools(True, "render_in_main_pass"),
        **_bools(False, "holdout"),
        **_made("Color", lambda: Color(170, 170, 170, 255), "ground_albedo"),
        **_made(
            "LinearColor", _white, "mie_absorption", "mie_scattering", "sky_and_aerial_perspective_luminance_factor"
        ),
        **_made("LinearColor", lambda: LinearColor(0.345561, 1, 0.045189, 1), "other_absorption"),
        **_made("LinearColor", lambda: LinearColor(0.175287, 0.409607, 1, 1), "rayleigh_scattering"),
    },
    "Material": _bools(
        False,
        "fully_rough used_with_instanced_static_meshes used_with_nanite used_with_skeletal_mesh "
        "used_with_particle_sprites used_with_morph_targets used_with_spline_meshes "
        "used_with_static_lighting",
    ),
}
