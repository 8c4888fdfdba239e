-- Which actors did a repair change that it should not have? One row a false positive, by kind: `added` without a target,
-- `modified`, `deleted` or `repurposed` although to be preserved, `target` in a state that is not the wanted one.
-- `confined` says that only references to assets or materials differ, `renamed_material` that saving alone explains it.
WITH rows AS (
    SELECT trial_id, unnest(json_extract(document, '$.measurements.false_positives[*]')) AS row
    FROM verdicts WHERE json_exists(document, '$.measurements.false_positives')
)
SELECT
    c.suite, left(c.suite_digest, 12) AS build, c.configuration, c.setting, c.case_id, c.scene_id, c.visibility, c.repeat,
    c.trial_id,
    CASE row->>'$.kind' WHEN 'added' THEN 'added' WHEN 'background_changed' THEN 'modified'
        WHEN 'background_lost' THEN 'deleted' WHEN 'background_repurposed' THEN 'repurposed' ELSE 'target' END AS kind,
    row->>'$.actor' AS actor,
    coalesce(CAST(row->'$.fields' AS VARCHAR[]), []) AS fields,
    len(fields) > 0 AND list_has_all(
        ['property.asset_path', 'property.component_asset_paths', 'property.material_paths',
         'property.component_material_slots'], fields) AS confined,
    coalesce(CAST(row->>'$.renamed_material' AS BOOLEAN), false) AS renamed_material
FROM rows JOIN case_scores AS c USING (trial_id)
ORDER BY c.suite, c.suite_digest, c.configuration, c.case_id, c.repeat, actor, kind
