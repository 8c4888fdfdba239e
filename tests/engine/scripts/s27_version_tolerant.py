"""Runs on several engine versions: probes for names, falls back, reports which path was taken."""

import unreal

paths_taken = []


def get_actor_api():
    if hasattr(unreal, "EditorActorSubsystem"):
        paths_taken.append("subsystem")
        return unreal.get_editor_subsystem(unreal.EditorActorSubsystem)
    paths_taken.append("library")
    return unreal.EditorLevelLibrary


def get_asset_api():
    cls = getattr(unreal, "EditorAssetSubsystem", None)
    if cls is not None:
        return unreal.get_editor_subsystem(cls)
    return unreal.EditorAssetLibrary


def get_guid(actor):
    getter = getattr(actor, "get_actor_guid", None)
    guid = getter() if callable(getter) else actor.get_editor_property("actor_guid")
    return guid.to_string()


def set_location(actor, loc):
    try:
        actor.set_actor_location(loc)  # guess
        paths_taken.append("one-arg")
    except TypeError as exc:
        assert "required argument 'sweep' (pos 2) not found" in str(exc), exc
        actor.set_actor_location(loc, False, False)
        paths_taken.append("three-arg")


def prop(obj, *names):
    for name in names:
        try:
            return obj.get_editor_property(name)
        except Exception as exc:
            assert "Failed to find property" in str(exc), exc
    return None


api, assets = get_actor_api(), get_asset_api()
mesh = assets.load_asset("/Game/Props/SM_Post")
actor = api.spawn_actor_from_object(mesh, unreal.Vector(0, 0, 0))
actor.set_actor_label("Probe")
set_location(actor, unreal.Vector(10, 20, 30))
print(get_guid(actor), prop(actor, "actor_hidden", "hidden"), prop(actor, "bHidden"))
for name in ("get_socket_at", "get_static_mesh"):
    print(name, hasattr(actor, name))
try:
    unreal.Cube()
except AttributeError as exc:
    print(exc)
comp = unreal.StaticMeshComponent.cast(actor.root_component)
try:
    unreal.PointLight.cast(actor)
except TypeError as exc:
    print(exc)
major = int(unreal.SystemLibrary.get_engine_version().split(".")[0])
light = api.spawn_actor_from_class(unreal.PointLight, unreal.Vector(0, 0, 200))
lc = (
    light.get_editor_property("light_component")
    if major >= 5
    else light.light_component
)
lc.set_editor_property("Intensity", 1234.0)
light.set_actor_label("ProbeLight")
actor.call_method(
    "SetActorScale3D".lower()
    if hasattr(actor, "setactorscale3d")
    else "set_actor_scale3d",
    (unreal.Vector(1, 1, 2),),
)
assert paths_taken == ["subsystem", "three-arg"], paths_taken
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.get_editor_subsystem(unreal.UnrealEditorSubsystem).get_editor_world(),
    "/Game/SavedScenes/s27_version_tolerant",
)
