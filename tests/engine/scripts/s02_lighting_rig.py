import unreal

# Sun, sky, fog and a few lamps with explicit settings
LABEL_PREFIX = "Rig_"
eas = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
world = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world()


def spawn(cls, name, loc=(0, 0, 0), rot=None):
    rot = rot or unreal.Rotator(0, 0, 0)
    a = eas.spawn_actor_from_class(cls, unreal.Vector(loc[0], loc[1], loc[2]), rot)
    a.set_actor_label(LABEL_PREFIX + name)
    a.set_folder_path(unreal.Name("Lighting"))
    return a


sun = spawn(
    unreal.DirectionalLight,
    "Sun",
    (0, 0, 1000),
    unreal.Rotator(roll=0, pitch=-42, yaw=-35),
)
sun_comp = sun.get_component_by_class(unreal.DirectionalLightComponent)
sun_comp.set_intensity(7.5)
sun_comp.set_light_color(unreal.LinearColor(1.0, 0.93, 0.82, 1.0))
sun_comp.set_editor_property("atmosphere_sun_light", True)

sky = spawn(unreal.SkyLight, "Sky")
sky.light_component.set_editor_property("real_time_capture", True)
sky.light_component.set_intensity(1.2)

atmo = spawn(unreal.SkyAtmosphere, "Atmosphere")
fog = spawn(unreal.ExponentialHeightFog, "Fog")
fog_c = fog.component
fog_c.set_fog_density(0.015)
fog_c.set_editor_property("fog_max_opacity", 0.7)

for i, (x, color) in enumerate(
    [(-300, (1, 0.6, 0.3)), (0, (0.3, 0.6, 1)), (300, (0.5, 1, 0.5))]
):
    lamp = spawn(unreal.PointLight.static_class(), f"Lamp{i}", (x, 0, 250))
    c = lamp.point_light_component
    c.set_editor_property("intensity_units", unreal.LightUnits.CANDELAS)
    c.set_intensity(40.0 + 10 * i)
    c.set_light_color(unreal.LinearColor(*color))
    c.set_attenuation_radius(900)
    c.set_cast_shadows(i != 1)

spot = spawn(
    unreal.SpotLight,
    "Spot",
    (0, -400, 400),
    unreal.MathLibrary.find_look_at_rotation(
        unreal.Vector(0, -400, 400), unreal.Vector(0, 0, 0)
    ),
)
spot.spot_light_component.set_outer_cone_angle(30)
spot.spot_light_component.set_inner_cone_angle(15)

try:
    spot.spot_light_component.set_editor_property(
        "light_color", unreal.LinearColor(1, 0, 0, 1)
    )
except TypeError as e:
    # light_color is a Color, not a LinearColor
    unreal.log(str(e).splitlines()[0])
    spot.spot_light_component.set_editor_property(
        "light_color", unreal.LinearColor(1, 0, 0, 1).to_color()
    )

ppv = spawn(unreal.PostProcessVolume, "PPV")
ppv.set_editor_property("unbound", True)
settings = ppv.get_editor_property("settings")
settings.set_editor_property("override_auto_exposure_bias", True)
settings.set_editor_property("auto_exposure_bias", 0.5)
ppv.set_editor_property("settings", settings)

unreal.EditorLoadingAndSavingUtils.save_map(world, "/Game/SavedScenes/s02_lighting_rig")
