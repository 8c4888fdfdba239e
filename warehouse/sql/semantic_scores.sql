-- How well does a scene mean what its prompt asks for? One row a construction with an outcome: the semantic score
-- (Detailed and Overview Alignment as one, at their weights), its two halves, the requirement families, and how much of
-- the detailed half was decided. What was not measured is null; a trial without a valid submission has zeros.
SELECT
    t.suite, left(t.suite_digest, 12) AS build, t.configuration, t.case_id, t.repeat, o.status,
    max(c.value) FILTER (WHERE c.verifier = 'semantic') AS semantic,
    o.detailed, o.overview, o.known_coverage,
    max(c.value) FILTER (WHERE c.name = 'families.identity_environment') AS identity_environment,
    max(c.value) FILTER (WHERE c.name = 'families.content_quantity') AS content_quantity,
    max(c.value) FILTER (WHERE c.name = 'families.attributes_materials') AS attributes_materials,
    max(c.value) FILTER (WHERE c.name = 'families.spatial_composition') AS spatial_composition,
    max(c.value) FILTER (WHERE c.name = 'structural_integrity_score') AS structural_integrity
FROM outcomes AS o
JOIN trials AS t USING (trial_id)
LEFT JOIN components AS c USING (trial_id)
WHERE o.setting IN (SELECT setting FROM settings WHERE construction)
GROUP BY t.suite, t.suite_digest, t.configuration, t.configuration_digest, t.case_id, t.repeat, trial_id, o.status,
         o.detailed, o.overview, o.known_coverage
ORDER BY t.suite, t.suite_digest, semantic DESC NULLS LAST, t.configuration, t.configuration_digest, t.case_id, t.repeat
