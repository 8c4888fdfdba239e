"""Which ``set_<property>`` methods components have, by class: ``property=argument``, ``new_value`` where left out."""

from __future__ import annotations

SETTERS: dict[str, str] = {
    "PrimitiveComponent": """
        affect_distance_field_lighting=new_affect_distance_field_lighting
        affect_dynamic_indirect_lighting=new_affect_dynamic_indirect_lighting
        affect_indirect_lighting_while_hidden=new_affect_indirect_lighting_while_hidden
        cast_contact_shadow=cast_contact_shadow cast_hidden_shadow=new_cast_hidden_shadow
        cast_inset_shadow=cast_inset_shadow custom_depth_stencil_value=value
        emissive_light_source=new_emissive_light_source hidden_in_scene_capture=value holdout=new_holdout
        light_attachments_as_group=light_attachments_as_group only_owner_see=new_only_owner_see
        owner_no_see=new_owner_no_see receives_decals=new_receives_decals render_custom_depth=value
        render_in_depth_pass=value render_in_main_pass=value
        visible_in_ray_tracing=new_visible_in_ray_tracing visible_in_scene_capture_only=value
    """,
    "StaticMeshComponent": """
        distance_field_self_shadow_bias evaluate_world_position_offset forced_lod_model=new_forced_lod_model
        reverse_culling=reverse_culling world_position_offset_disable_distance
    """,
    "LightComponentBase": """
        affect_global_illumination affect_reflection cast_deep_shadow samples_per_pixel
    """,
    "LightComponent": """
        affect_translucent_lighting bloom_max_brightness bloom_scale bloom_threshold bloom_tint
        diffuse_scale enable_light_shaft_bloom force_cached_shadows_for_movable_primitives
        ies_brightness_scale light_function_fade_distance=new_light_function_fade_distance
        light_function_scale=new_light_function_scale shadow_bias shadow_slope_bias transmission
        use_ies_brightness use_ray_traced_distance_field_shadows
    """,
    "PointLightComponent": """
        inverse_exposure_blend=new_inverse_exposure_blend light_falloff_exponent=new_light_falloff_exponent
        soft_source_radius source_length use_inverse_squared_falloff
    """,
    "RectLightComponent": """
        barn_door_angle barn_door_length
    """,
    "DirectionalLightComponent": """
        atmosphere_sun_disk_color_scale atmosphere_sun_light_index cascade_distribution_exponent
        cascade_transition_fraction dynamic_shadow_cascades dynamic_shadow_distance_movable_light
        dynamic_shadow_distance_stationary_light enable_light_shaft_occlusion forward_shading_priority
        light_shaft_override_direction light_source_soft_angle occlusion_depth_range occlusion_mask_darkness
        shadow_amount shadow_cascade_bias_distribution shadow_distance_fadeout_fraction
        shadow_source_angle_factor
    """,
    "SkyLightComponent": """
        indirect_lighting_intensity=new_intensity lower_hemisphere_color=lower_hemisphere_color
        min_occlusion=min_occlusion occlusion_exponent=occlusion_exponent occlusion_tint=tint
        real_time_capture=real_time_capture source_cubemap_angle
        volumetric_scattering_intensity=new_intensity
    """,
    "ExponentialHeightFogComponent": """
        directional_inscattering_exponent=value directional_inscattering_start_distance=value
        end_distance=value fog_cutoff_distance=value fully_directional_inscattering_color_distance=value
        holdout=new_holdout inscattering_color_cubemap_angle=value inscattering_texture_tint=value
        non_directional_inscattering_color_distance=value render_in_main_pass=value
        sky_atmosphere_ambient_contribution_color_scale volumetric_fog_albedo volumetric_fog_distance
        volumetric_fog_emissive volumetric_fog_extinction_scale volumetric_fog_near_fade_in_distance
        volumetric_fog_scattering_distribution volumetric_fog_start_distance
    """,
    "SkyAtmosphereComponent": """
        aerial_perspective_start_depth aerial_pespective_view_distance_scale atmosphere_height bottom_radius
        ground_albedo height_fog_contribution holdout=new_holdout mie_absorption mie_absorption_scale
        mie_anisotropy mie_exponential_distribution mie_scattering mie_scattering_scale
        multi_scattering_factor other_absorption other_absorption_scale rayleigh_exponential_distribution
        rayleigh_scattering rayleigh_scattering_scale render_in_main_pass=value
        sky_and_aerial_perspective_luminance_factor sky_luminance_factor
        transmittance_min_light_elevation_angle
    """,
    "CameraComponent": """
        aspect_ratio=aspect_ratio post_process_blend_weight=post_process_blend_weight
    """,
}
