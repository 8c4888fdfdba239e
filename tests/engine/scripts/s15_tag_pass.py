import unreal

unreal.EditorLevelLibrary.load_level("/Game/Maps/Start")
actors = unreal.EditorLevelLibrary.get_all_level_actors()

TAGS = {
    "Tree": ["vegetation", "static"],
    "House": ["building", "static"],
    "Rock": ["vegetation"],
}


def set_tags(actor, new_tags):
    current = list(actor.tags)
    merged = current + [
        unreal.Name(t) for t in new_tags if unreal.Name(t) not in current
    ]
    actor.set_editor_property("tags", merged)


for actor in actors:
    label = actor.get_actor_label()
    for token, tags in TAGS.items():
        if token in label:
            set_tags(actor, tags)
            set_tags(actor, tags)  # idempotent
    if actor.actor_has_tag("building"):
        arr = actor.get_editor_property("tags")
        arr.append("landmark")
        actor.set_editor_property("tags", arr)

static = unreal.GameplayStatics.get_all_actors_with_tag(
    unreal.EditorLevelLibrary.get_editor_world(), "static"
)
print("static:", sorted(a.get_actor_label() for a in static))
trees = unreal.EditorFilterLibrary.by_actor_label(
    actors, "tree_b", unreal.EditorScriptingStringMatchType.CONTAINS
)
seen = set()
for t in trees:
    loc = t.get_actor_location()
    key = (round(loc.x), round(loc.y), round(loc.z))
    if key in seen:
        unreal.log_warning(f"duplicate {t.get_actor_label()} removed")
        unreal.EditorLevelLibrary.destroy_actor(t)
    seen.add(key)
unreal.EditorLoadingAndSavingUtils.save_map(
    unreal.EditorLevelLibrary.get_editor_world(), "/Game/SavedScenes/s15_tag_pass"
)
