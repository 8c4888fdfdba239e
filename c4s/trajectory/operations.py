"""Which operations a Python submission attempts: eight families, told by the API names that it uses.

The paper ("Trajectory measurements") classifies parseable submissions by a fixed dictionary of API basenames into eight
families, which may co-occur, and prints neither; the names and the dictionary here are c4s's own. They are data: a name
belongs to one family, whatever object it is called on.
"""

from __future__ import annotations

import ast
from typing import Literal, TypeAlias, get_args

Family: TypeAlias = Literal[
    "catalog_lookup",
    "asset_loading",
    "scene_inspection",
    "actor_creation",
    "pose_editing",
    "actor_removal",
    "appearance_and_properties",
    "level_io",
]
FAMILIES: tuple[Family, ...] = get_args(Family)

_NAMES: dict[Family, str] = {
    "catalog_lookup": """
        find_asset_data find_package_referencers_for_asset get_all_assets get_all_cached_paths get_asset
        get_asset_by_object_path get_asset_registry get_assets get_assets_by_class get_assets_by_package_name
        get_assets_by_path get_assets_by_paths get_categories get_dependencies get_referencers get_sub_paths
        has_assets list_asset_by_tag_value list_assets search_all_assets search_assets does_asset_exist
        does_directory_exist does_directory_contain_assets get_asset_metadata scan_paths_synchronous
        search_asset""",
    "asset_loading": """
        load_asset load_blueprint_class load_class load_object load_package find_object find_asset load_assets
        sync_load_asset load_asset_blocking generated_class""",
    "scene_inspection": """
        find_actor_by_tag find_actors_by_name get_actor_array_average_location get_actor_array_bounds
        get_actor_bounds get_actor_forward_vector get_actor_guid get_actor_label get_actor_location
        get_actor_right_vector get_actor_rotation get_actor_scale3d get_actor_transform get_actor_up_vector
        get_actors_in_level get_all_actors_of_class get_all_actors_of_class_with_tag get_all_actors_with_tag
        get_all_child_actors get_all_level_actors get_all_level_actors_components get_attach_parent_actor
        get_attached_actors get_bounding_box get_bounds get_component_bounds get_component_by_class
        get_component_location get_components_by_class get_components_by_tag get_editor_world get_folder_path
        get_instance_count get_instance_transform get_level_actors get_local_bounds get_material get_materials
        get_num_materials get_overlapping_actors get_relative_transform get_selected_level_actors
        get_static_mesh get_world_location get_world_rotation get_world_transform line_trace_multi
        line_trace_multi_by_profile line_trace_multi_for_objects line_trace_single line_trace_single_by_profile
        line_trace_single_for_objects box_overlap_actors box_trace_single capsule_overlap_actors
        capsule_trace_single sphere_overlap_actors sphere_trace_multi sphere_trace_single
        sphere_trace_single_for_objects""",
    "actor_creation": """
        add_component_by_class add_instance add_instances add_instance_world_space add_new_subobject
        convert_actors create_blueprint_actor duplicate_actor duplicate_actors finish_spawning_actor spawn_actor
        spawn_actor_from_class spawn_actor_from_object spawn_blueprint_actor""",
    "pose_editing": """
        add_actor_local_offset add_actor_local_rotation add_actor_local_transform add_actor_world_offset
        add_actor_world_rotation add_actor_world_transform add_local_offset add_local_rotation
        add_relative_location add_relative_rotation add_world_offset add_world_rotation
        batch_update_instances_transforms set_actor_location set_actor_location_and_rotation
        set_actor_relative_location set_actor_relative_rotation set_actor_relative_scale3d
        set_actor_relative_transform set_actor_rotation set_actor_scale3d set_actor_transform
        set_relative_location set_relative_location_and_rotation set_relative_rotation set_relative_scale3d
        set_relative_transform set_world_location set_world_location_and_rotation set_world_rotation
        set_world_scale3d set_world_transform teleport teleport_to update_instance_transform""",
    "actor_removal": """
        clear_instances delete_actor delete_actors delete_all_spawned destroy_actor destroy_actors
        destroy_component k2_destroy_actor k2_destroy_component remove_instance remove_instances""",
    "appearance_and_properties": """
        attach_to_actor attach_to_component create_dynamic_material_instance detach_from_actor modify
        set_actor_enable_collision set_actor_hidden_in_game set_actor_label set_attenuation_radius
        set_cast_shadow set_collision_enabled set_collision_profile_name set_editor_properties
        set_editor_property set_fog_density set_folder_path set_inner_cone_angle set_intensity
        set_is_temporarily_hidden_in_editor set_light_color set_material set_material_by_name
        set_material_instance_parent set_material_instance_scalar_parameter_value
        set_material_instance_texture_parameter_value set_material_instance_vector_parameter_value set_mobility
        set_outer_cone_angle set_scalar_parameter_value set_static_mesh set_temperature
        set_texture_parameter_value set_use_temperature set_vector_parameter_value set_visibility
        replace_mesh_components_materials replace_mesh_components_materials_on_actors
        replace_mesh_components_meshes replace_mesh_components_meshes_on_actors""",
    "level_io": """
        checkout_asset create_asset delete_asset delete_directory duplicate_asset export_to_disk
        import_asset_tasks load_level load_map make_directory new_level new_level_from_template
        new_map_from_template rename_asset save_all_dirty_levels save_as save_asset save_current_level
        save_directory save_dirty_packages save_loaded_asset save_loaded_assets save_map save_packages""",
}

FAMILY_OF: dict[str, Family] = {name: family for family in FAMILIES for name in _NAMES[family].split()}
"""Family of each API basename."""


def api_names(script: str) -> frozenset[str] | None:
    """The names that a script refers to on an object, calls, or looks up by ``getattr``; None if it does not parse."""
    try:
        tree = ast.parse(script)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute):
            names.add(node.attr)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            names.add(node.func.id)
            if node.func.id == "getattr" and len(node.args) > 1 and isinstance(node.args[1], ast.Constant):
                names.add(str(node.args[1].value))
    return frozenset(names)


def families_of(script: str) -> tuple[Family, ...] | None:
    """The operation families of a script, in the order of ``FAMILIES``; None if it does not parse."""
    names = api_names(script)
    if names is None:
        return None
    found = {FAMILY_OF[name] for name in names if name in FAMILY_OF}
    return tuple(family for family in FAMILIES if family in found)
