"""What the stub does not tell: defaults of editor properties of objects, and of the settings of post-processing.

A property that is not named here begins as the zero of its type: 0, False, nothing, the first member of its enum, a
struct as its constructor makes it. Structs are their constructor's arguments (a ``Color`` is b, g, r, a).
"""

from __future__ import annotations

from typing import Any

_ONES = [1.0, 1.0, 1.0, 1.0]
_WHITE = [1.0, 1.0, 1.0, 1.0]
_RANGES = ("", "_shadows", "_midtones", "_highlights")


def _grey(value: float) -> list[float]:
    return [value, value, value, 1.0]


def _true(names: str) -> dict[str, Any]:
    return dict.fromkeys(names.split(), True)


def _ones(names: str) -> dict[str, Any]:
    return dict.fromkeys(names.split(), 1.0)


DEFAULTS: dict[str, dict[str, Any]] = {
    "PostProcessSettings": {
        **{
            f"color_{kind}{range_}": _ONES for kind in ("saturation", "contrast", "gamma", "gain") for range_ in _RANGES
        },
        "color_correction_shadows_max": 0.09,
        "color_correction_highlights_min": 0.5,
        "color_correction_highlights_max": 1.0,
        "blue_correction": 0.6,
        **_ones("expand_gamut tone_curve_amount color_grading_intensity"),
        "scene_color_tint": _WHITE,
        "film_slope": 0.88,
        "film_toe": 0.55,
        "film_shoulder": 0.26,
        "film_white_clip": 0.04,
        "ambient_cubemap_tint": _WHITE,
        "ambient_cubemap_intensity": 1.0,
        "bloom_threshold": -1.0,
        "bloom_size_scale": 4.0,
        "bloom1_tint": _grey(0.3465),
        "bloom2_tint": _grey(0.138),
        "bloom3_tint": _grey(0.1176),
        "bloom4_tint": _grey(0.066),
        "bloom5_tint": _grey(0.066),
        "bloom6_tint": _grey(0.061),
        "bloom1_size": 0.3,
        "bloom2_size": 1.0,
        "bloom3_size": 2.0,
        "bloom4_size": 10.0,
        "bloom5_size": 30.0,
        "bloom6_size": 64.0,
        **_ones("bloom_convolution_scatter_dispersion bloom_convolution_size"),
        "bloom_convolution_center_uv": [0.5, 0.5],
        "bloom_convolution_pre_filter_min": 7.0,
        "bloom_convolution_pre_filter_max": 15000.0,
        "bloom_convolution_pre_filter_mult": 15.0,
        "bloom_convolution_buffer_scale": 0.133,
        "bloom_dirt_mask_tint": _grey(0.5),
        "dynamic_global_illumination_method": "LUMEN",
        "reflection_method": "LUMEN",
        "indirect_lighting_color": _WHITE,
        "indirect_lighting_intensity": 1.0,
        **_ones(
            "lumen_scene_lighting_quality lumen_scene_detail lumen_scene_lighting_update_speed "
            "lumen_final_gather_quality lumen_final_gather_lighting_update_speed lumen_diffuse_color_boost "
            "lumen_surface_cache_resolution lumen_reflection_quality"
        ),
        "lumen_scene_view_distance": 20000.0,
        "lumen_max_trace_distance": 20000.0,
        "lumen_skylight_leaking_tint": _WHITE,
        "lumen_full_skylight_leaking_distance": 1000.0,
        "lumen_max_roughness_to_trace_reflections": 0.4,
        "lumen_max_reflection_bounces": 1,
        **_true("lumen_final_gather_screen_traces lumen_reflections_screen_traces mega_lights"),
        "screen_space_reflection_intensity": 100.0,
        "screen_space_reflection_quality": 50.0,
        "screen_space_reflection_max_roughness": 0.6,
        "ray_tracing_translucency_max_roughness": 0.6,
        "ray_tracing_translucency_refraction_rays": 3,
        "ray_tracing_translucency_samples_per_pixel": 1,
        "ray_tracing_translucency_max_primary_hit_events": 4,
        "ray_tracing_translucency_max_secondary_hit_events": 2,
        "ray_tracing_translucency_shadows": "HARD_SHADOWS",
        "ray_tracing_translucency_refraction": True,
        "ray_tracing_ao_samples_per_pixel": 1,
        "ray_tracing_ao_intensity": 1.0,
        "ray_tracing_ao_radius": 200.0,
        "path_tracing_max_bounces": 32,
        "path_tracing_samples_per_pixel": 2048,
        "path_tracing_max_path_intensity": 24.0,
        **_true(
            "path_tracing_enable_emissive_materials path_tracing_enable_denoiser path_tracing_include_emissive "
            "path_tracing_include_diffuse path_tracing_include_indirect_diffuse path_tracing_include_specular "
            "path_tracing_include_indirect_specular path_tracing_include_volume path_tracing_include_indirect_volume"
        ),
        "ambient_occlusion_radius": 200.0,
        "ambient_occlusion_static_fraction": 1.0,
        "ambient_occlusion_power": 2.0,
        "ambient_occlusion_bias": 3.0,
        "ambient_occlusion_quality": 50.0,
        "ambient_occlusion_mip_blend": 0.6,
        "ambient_occlusion_mip_scale": 1.7,
        "ambient_occlusion_mip_threshold": 0.01,
        "ambient_occlusion_fade_distance": 8000.0,
        "ambient_occlusion_fade_radius": 5000.0,
        "ambient_occlusion_temporal_blend_weight": 0.1,
        "camera_shutter_speed": 60.0,
        "camera_iso": 100.0,
        "auto_exposure_low_percent": 10.0,
        "auto_exposure_high_percent": 90.0,
        "auto_exposure_speed_up": 3.0,
        "auto_exposure_speed_down": 1.0,
        "histogram_log_min": -10.0,
        "histogram_log_max": 20.0,
        "local_exposure_method": "BILATERAL",
        **_ones(
            "local_exposure_highlight_contrast_scale local_exposure_shadow_contrast_scale "
            "local_exposure_detail_strength local_exposure_highlight_threshold_strength "
            "local_exposure_shadow_threshold_strength"
        ),
        "local_exposure_blurred_luminance_blend": 0.6,
        "local_exposure_blurred_luminance_kernel_size_percent": 50.0,
        "depth_of_field_fstop": 4.0,
        "depth_of_field_min_fstop": 1.2,
        "depth_of_field_blade_count": 5,
        "depth_of_field_sensor_width": 24.576,
        **_ones(
            "depth_of_field_squeeze_factor depth_of_field_depth_blur_amount depth_of_field_petzval_bokeh_falloff "
            "depth_of_field_aspect_ratio_scalar"
        ),
        "depth_of_field_barrel_radius": 5.0,
        "depth_of_field_near_transition_region": 300.0,
        "depth_of_field_far_transition_region": 500.0,
        "depth_of_field_near_blur_size": 15.0,
        "depth_of_field_far_blur_size": 15.0,
        "depth_of_field_occlusion": 0.4,
        "depth_of_field_vignette_size": 200.0,
        "lens_flare_tint": _WHITE,
        "lens_flare_tints": [1.0, 0.8, 0.4, 0.6],
        "lens_flare_bokeh_size": 3.0,
        "lens_flare_threshold": 8.0,
        **_ones(
            "film_grain_intensity_shadows film_grain_intensity_midtones film_grain_intensity_highlights "
            "film_grain_highlights_max film_grain_texel_size"
        ),
        "film_grain_shadows_max": 0.09,
        "film_grain_highlights_min": 0.5,
        "motion_blur_max": 5.0,
        "motion_blur_target_fps": 30,
    },
    "Actor": {
        **_true("relevant_for_level_bounds net_load_on_client call_pre_replication"),
        "net_dormancy": "DORM_AWAKE",
        "role": "ROLE_AUTHORITY",
        "default_update_overlaps_method_during_level_streaming": "ONLY_UPDATE_MOVABLE",
    },
    "ActorComponent": _true("editable_when_inherited"),
    "PrimitiveComponent": {
        "bounds_scale": 1.0,
        "can_character_step_up_on": "ECB_YES",
        "indirect_lighting_cache_quality": "ILCQ_POINT",
        "lighting_channels": [True, False, False],
        "ray_tracing_group_id": -1,
        "ray_tracing_group_culling_priority": "CP_4_DEFAULT",
        "virtual_texture_render_pass_type": "EXCLUSIVE",
        **_true("receive_mobile_csm_shadows replicate_physics_to_autonomous_proxy static_when_not_moveable"),
    },
    "ShapeComponent": {"shape_color": [157, 149, 223, 255], "use_system_default_obstacle_area_class": True},
    "CameraComponent": {
        "aspect_ratio_axis_constraint": "ASPECT_RATIO_MAINTAIN_XFOV",
        "first_person_field_of_view": 90.0,
        "first_person_scale": 1.0,
        "ortho_width": 1536.0,
        "ortho_far_clip_plane": 2097152.0,
        **_true(
            "auto_calculate_ortho_planes camera_mesh_hidden_in_game draw_frustum_allowed lock_to_hmd "
            "update_ortho_planes use_field_of_view_for_lod"
        ),
    },
    "DecalComponent": {"fade_screen_size": 0.01, "destroy_owner_after_fade": True},
    "LightComponentBase": {"deep_shadow_layer_distribution": 0.5, "cast_volumetric_shadow": True},
    "LightComponent": {"lighting_channels": [True, False, False]},
    "RectLightComponent": {"source_texture_scale": [1.0, 1.0]},
    "SkyAtmosphereComponent": {"other_tent_distribution": [25.0, 1.0, 15.0]},
    "VolumetricCloudComponent": {
        "ground_albedo": [170, 170, 170, 255],
        "shadow_tracing_distance": 15.0,
        "sky_light_cloud_bottom_occlusion": 0.5,
        "stop_tracing_transmittance_threshold": 0.005,
        "tracing_max_distance": 50.0,
        "tracing_start_max_distance": 350.0,
        **_ones(
            "view_sample_count_scale shadow_view_sample_count_scale reflection_view_sample_count_scale_value "
            "shadow_reflection_view_sample_count_scale_value"
        ),
        **_true("render_in_main_pass visible_in_real_time_sky_captures"),
    },
    "StaticMeshComponent": {
        "distance_field_indirect_shadow_min_visibility": 0.1,
        "wireframe_color_override": [255, 255, 255, 255],
    },
    "InstancedStaticMeshComponent": {"instance_lod_distance_scale": 1.0},
    "StaticMesh": {"light_map_resolution": 4, **_true("support_ray_tracing has_navigation_data")},
    "Material": {
        **_true(
            "automatically_set_usage_in_editor cast_ray_traced_shadows is_blendable tangent_space_normal "
            "use_lightmap_directionality use_translucency_vertex_fog"
        ),
        "blendable_location": "BL_SCENE_COLOR_AFTER_TONEMAPPING",
        "material_decal_response": "MDR_COLOR_NORMAL_ROUGHNESS",
        "opacity_mask_clip_value": 0.3333,
        "refraction_method": "RM_NONE",
        "shading_model": "MSM_DEFAULT_LIT",
        "stencil_compare": "MSC_EQUAL",
        "translucency_directional_lighting_intensity": 1.0,
        "translucency_pass": "MTP_AFTER_DOF",
        "translucent_backscattering_exponent": 30.0,
        "translucent_multiple_scattering_extinction": [1.0, 0.833, 0.588, 1.0],
        "translucent_self_shadow_density_scale": 2.0,
        "translucent_self_shadow_second_density_scale": 10.0,
        "translucent_shadow_density_scale": 0.5,
        "translucent_shadow_start_offset": 100.0,
        "user_texture_divisor": [1, 1],
    },
    "SceneCaptureComponent": {"lod_distance_factor": 1.0, "max_view_distance_override": -1.0},
    "SceneCaptureComponent2D": {
        "clip_plane_normal": [0.0, 0.0, 1.0],
        "first_person_field_of_view": 90.0,
        "first_person_scale": 1.0,
        "main_view_resolution_divisor": [1, 1],
        "num_x_tiles": 4,
        "num_y_tiles": 4,
        **_true("auto_calculate_ortho_planes update_ortho_planes"),
    },
}

_ELSEWHERE = "the engine has it under functions of its own, and a kept value beside them would be another truth"
_WOULD_MOVE = "it changes where things are, which the engine does not do"

LEFT_OUT: dict[str, dict[str, str]] = {
    "": {
        "body_instance": _ELSEWHERE,
        "absolute_location": _WOULD_MOVE,
        "absolute_rotation": _WOULD_MOVE,
        "absolute_scale": _WOULD_MOVE,
    },
    "Actor": {"instigator": "there are no pawns"},
    "InstancedStaticMeshComponent": {"per_instance_sm_data": _ELSEWHERE},
    "SceneCaptureComponent": {
        "hidden_actors": "pictures show every actor",
        "show_only_actors": "pictures show every actor",
    },
    "TargetPoint": {
        "arrow_component": "there are no editor sprites",
        "sprite_component": "there are no editor sprites",
    },
    "World": {"extra_referenced_objects": _ELSEWHERE},
}
"""Properties that would not be true if they were only kept, by class (or of all), each with its reason."""

NAMED = (
    "JoinStaticMeshActorsOptions",
    "MergeStaticMeshActorsOptions",
    "ScalarParameterValue",
    "ScriptCollisionShapeType",
    "TextureParameterValue",
    "VectorParameterValue",
)
"""Types that the engine itself names, and no property of the table has."""
