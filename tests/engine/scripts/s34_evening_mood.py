"""Evening mood: sun, moon, sky, fog, local exposure by post-process volumes, street lamps, a camera with its own look."""

import unreal

actors = unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
editor = unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem)


def get_or_spawn(
    cls, label, location=unreal.Vector(0, 0, 0), rotation=unreal.Rotator(0, 0, 0)
):
    for actor in actors.get_all_level_actors():
        if isinstance(actor, cls) and actor.get_actor_label() == label:
            actor.set_actor_location_and_rotation(location, rotation, False, False)
            return actor
    actor = actors.spawn_actor_from_class(cls, location, rotation)
    actor.set_actor_label(label)
    actor.set_folder_path("/Lighting")
    return actor


def set_props(obj, **kwargs):
    for key, value in kwargs.items():
        try:
            obj.set_editor_property(key, value)
        except Exception as error:
            unreal.log_warning(f"{obj.get_name()}.{key}: {error}")
            raise


actors.spawn_actor_from_object(
    unreal.load_asset("/Engine/BasicShapes/Plane"), unreal.Vector(0, 0, 0)
).set_actor_scale3d(unreal.Vector(60, 60, 1))

sun = get_or_spawn(
    unreal.DirectionalLight,
    "Sun",
    unreal.Vector(0, 0, 800),
    unreal.Rotator(pitch=-8, yaw=-130, roll=0),
)
sun_c = sun.get_component_by_class(unreal.DirectionalLightComponent)
set_props(
    sun_c,
    intensity=3.5,
    temperature=3200.0,
    use_temperature=True,
    light_source_angle=1.0,
    cast_shadows=True,
    atmosphere_sun_light=True,
    mobility=unreal.ComponentMobility.MOVABLE,
)
moon = get_or_spawn(
    unreal.DirectionalLight, "Moon", rotation=unreal.Rotator(pitch=-40, yaw=60, roll=0)
)
moon_c = moon.get_component_by_class(unreal.DirectionalLightComponent)
moon_c.set_intensity(0.15)
moon_c.set_light_color(unreal.LinearColor(0.6, 0.7, 1.0))
moon_c.set_atmosphere_sun_light_index(1)
moon_c.set_cast_shadows(False)

sky = get_or_spawn(unreal.SkyLight, "SkyLight")
sky_c = sky.get_component_by_class(unreal.SkyLightComponent)
set_props(
    sky_c,
    intensity=0.8,
    real_time_capture=True,
    mobility=unreal.ComponentMobility.MOVABLE,
)
sky_c.recapture_sky()
atmosphere = get_or_spawn(unreal.SkyAtmosphere, "SkyAtmosphere")
fog = get_or_spawn(unreal.ExponentialHeightFog, "HeightFog", unreal.Vector(0, 0, -50))
set_props(
    fog.component,
    fog_density=0.035,
    fog_height_falloff=0.25,
    start_distance=400.0,
    enable_volumetric_fog=True,
)
fog.component.set_volumetric_fog_extinction_scale(0.6)
fog.component.set_fog_inscattering_color(unreal.LinearColor(0.9, 0.45, 0.2, 1))
clouds = get_or_spawn(unreal.VolumetricCloud, "Clouds")

ppv = get_or_spawn(unreal.PostProcessVolume, "PPV_Global")
ppv.set_editor_properties({"unbound": True, "priority": 0.0, "blend_weight": 1.0})
s = unreal.PostProcessSettings()
for key, value in {
    "auto_exposure_method": unreal.AutoExposureMethod.AEM_MANUAL,
    "auto_exposure_bias": -0.5,
    "bloom_intensity": 0.9,
    "vignette_intensity": 0.35,
    "white_temp": 5200.0,
    "color_saturation": unreal.Vector4(1.05, 1.0, 0.95, 1.0),
    "color_contrast": unreal.Vector4(1.1, 1.1, 1.1, 1.0),
    "film_grain_intensity": 0.1,
    "ambient_occlusion_intensity": 0.7,
}.items():
    s.set_editor_property("override_" + key, True)
    s.set_editor_property(key, value)
ppv.settings = s
indoor = get_or_spawn(unreal.PostProcessVolume, "PPV_Indoor", unreal.Vector(0, 0, 150))
indoor.set_actor_scale3d(unreal.Vector(3, 2, 1.5))
inner = indoor.settings
inner.override_auto_exposure_bias, inner.auto_exposure_bias = True, 1.0
indoor.settings = inner
set_props(indoor, priority=10.0, blend_radius=120.0, unbound=False)
assert (
    indoor.settings.auto_exposure_bias == 1.0
    and ppv.settings.bloom_intensity - 0.9 < 1e-6
)

for i in range(-2, 3):
    foot = unreal.Vector(i * 600.0, 300.0, 0.0)
    post = actors.spawn_actor_from_object(
        unreal.load_asset("/Game/Props/SM_Post"), foot
    )
    post.set_actor_label(f"LampPost_{i + 2}")
    lamp = get_or_spawn(
        unreal.SpotLight,
        f"LampHead_{i + 2}",
        foot + unreal.Vector(0, 0, 310),
        unreal.Rotator(roll=0.0, pitch=-90.0, yaw=0.0),
    )
    c = lamp.spot_light_component
    set_props(
        c,
        intensity_units=unreal.LightUnits.LUMENS,
        intensity=1800.0,
        attenuation_radius=1200.0,
        inner_cone_angle=25.0,
        outer_cone_angle=55.0,
        source_radius=6.0,
        light_color=unreal.Color(b=110, g=190, r=255),
    )
    lamp.attach_to_actor(
        post,
        "",
        unreal.AttachmentRule.KEEP_WORLD,
        unreal.AttachmentRule.KEEP_WORLD,
        unreal.AttachmentRule.KEEP_WORLD,
        False,
    )
window = get_or_spawn(
    unreal.RectLight, "Window", unreal.Vector(0, -600, 180), unreal.Rotator(yaw=90)
)
set_props(
    window.rect_light_component,
    source_width=240.0,
    source_height=140.0,
    barn_door_angle=60.0,
    intensity_units=unreal.LightUnits.CANDELAS,
    intensity=40.0,
)

eye, target = unreal.Vector(-1500, -900, 260), unreal.Vector(0, 100, 120)
look = unreal.MathLibrary.find_look_at_rotation(eye, target)
camera = get_or_spawn(unreal.CineCameraActor, "Cam_Hero", eye, look)
cine = camera.get_cine_camera_component()
cine.set_editor_property("current_focal_length", 28.0)
cine.set_editor_property("current_aperture", 2.8)
focus = cine.get_editor_property("focus_settings")
focus.set_editor_property("focus_method", unreal.CameraFocusMethod.MANUAL)
focus.set_editor_property("manual_focus_distance", (target - eye).length())
cine.set_editor_property("focus_settings", focus)
editor.set_level_viewport_camera_info(eye, look)
got = editor.get_level_viewport_camera_info()
print("viewport:", got)

lights = [a for a in actors.get_all_level_actors() if isinstance(a, unreal.Light)]
print(
    f"{len(lights)} lights, {sum(isinstance(a, unreal.SpotLight) for a in lights)} of them spots"
)
assert (
    get_or_spawn(
        unreal.DirectionalLight,
        "Sun",
        sun.get_actor_location(),
        sun.get_actor_rotation(),
    )
    == sun
)
unreal.EditorLoadingAndSavingUtils.save_map(
    editor.get_editor_world(), "/Game/SavedScenes/s34_evening_mood"
)
