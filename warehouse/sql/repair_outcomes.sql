-- What became of each repair? One row a resolved trial: whether every target was recovered (`complete`), and how many
-- false positives there are, with the adopted, the strict and the relaxed tolerances; a trial without a valid submission
-- recovered nothing. `fp_kept` leaves out what saving alone explains, `fp_not_confined` what differs in references to
-- assets or materials only too.
WITH measured AS (
    SELECT trial_id, document->'$.measurements.profiles' AS profiles
    FROM verdicts WHERE json_exists(document, '$.measurements.profiles')
), changed AS (
    SELECT trial_id, count(*) FILTER (WHERE renamed_material) AS renamed,
           count(*) FILTER (WHERE renamed_material OR (confined AND kind = 'modified')) AS confined
    FROM repair_changes GROUP BY trial_id
)
SELECT
    c.suite, left(c.suite_digest, 12) AS build, c.configuration, c.ranked, c.setting, c.case_id, c.scene_id,
    c.visibility, c.repeat, c.trial_id,
    coalesce(CAST(m.profiles->>'$.nominal.tp' AS BIGINT), 0) AS tp,
    coalesce(CAST(m.profiles->>'$.nominal.fp' AS BIGINT), 0) AS fp,
    CAST(m.profiles->>'$.nominal.fn' AS BIGINT) AS fn,
    coalesce(fn = 0, false) AS complete,
    coalesce(CAST(m.profiles->>'$.strict.fn' AS BIGINT) = 0, false) AS complete_strict,
    coalesce(CAST(m.profiles->>'$.relaxed.fn' AS BIGINT) = 0, false) AS complete_relaxed,
    fp - coalesce(g.renamed, 0) AS fp_kept,
    fp - coalesce(g.confined, 0) AS fp_not_confined,
    coalesce(CAST(m.profiles->>'$.strict.fp' AS BIGINT), 0) - coalesce(g.renamed, 0) AS fp_strict,
    coalesce(CAST(m.profiles->>'$.relaxed.fp' AS BIGINT), 0) - coalesce(g.renamed, 0) AS fp_relaxed
FROM case_scores AS c
LEFT JOIN measured AS m USING (trial_id)
LEFT JOIN changed AS g USING (trial_id)
WHERE c.score IS NOT NULL AND c.setting IN (SELECT setting FROM settings WHERE NOT construction)
ORDER BY c.suite, c.suite_digest, c.configuration, c.case_id, c.repeat
