import unreal

sub = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
unreal.get_editor_subsystem(unreal.LevelEditorSubsystem).load_level("/Game/Maps/Start")

for i in range(6):
    cls = unreal.PointLight if i % 2 == 0 else unreal.SpotLight
    l = sub.spawn_actor_from_class(
        cls, unreal.Vector(i * 200, 0, 300), unreal.Rotator(pitch=-90)
    )
    l.set_actor_label(f"Lamp_{i}")

changed = 0
for comp in sub.get_all_level_actors_components():
    if not isinstance(comp, unreal.LightComponent):
        continue
    owner = comp.get_owner()
    with unreal.ScopedEditorTransaction(f"Tune {owner.get_actor_label()}"):
        comp.modify()
        if isinstance(comp, unreal.DirectionalLightComponent):
            comp.set_intensity(3.0)
            owner.set_actor_rotation(unreal.Rotator(roll=0, pitch=-60, yaw=120), False)
        elif isinstance(comp, unreal.SpotLightComponent):
            comp.set_outer_cone_angle(25.0)
            comp.set_use_temperature(True)
            comp.set_temperature(3200)
        else:
            comp.set_editor_properties(
                {"intensity": 1500.0, "use_temperature": False, "source_radius": 8.0}
            )
            comp.set_light_color(unreal.LinearColor(r=1.0, g=0.8, b=0.6), True)
        changed += 1
unreal.log(f"edited {changed} lights")
lamp = next(a for a in sub.get_all_level_actors() if a.get_actor_label() == "Lamp_4")
lamp.set_light_color(unreal.LinearColor(0, 0, 1, 1))
lamp.set_enabled(False)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(),
    "/Game/SavedScenes/s28_batch_light_edit",
)
