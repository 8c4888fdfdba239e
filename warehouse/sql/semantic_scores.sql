-- How well does a scene mean what its prompt asks for? One row a construction with an outcome: the semantic score
-- (Detailed and Overview Alignment as one, at their weights), its two halves, the requirement families, and how much of
-- the detailed half was decided. What was not measured is null; a trial without a valid submission has zeros.
SELECT
    o.suite, o.configuration, o.case_id, o.repeat, o.status,
    max(c.value) FILTER (WHERE c.verifier = 'semantic') AS semantic,
    o.detailed, o.overview, o.known_coverage,
    max(c.value) FILTER (WHERE c.name = 'families.identity_environment') AS identity_environment,
    max(c.value) FILTER (WHERE c.name = 'families.content_quantity') AS content_quantity,
    max(c.value) FILTER (WHERE c.name = 'families.attributes_materials') AS attributes_materials,
    max(c.value) FILTER (WHERE c.name = 'families.spatial_composition') AS spatial_composition,
    max(c.value) FILTER (WHERE c.name = 'structural_integrity_score') AS structural_integrity
FROM outcomes AS o
LEFT JOIN components AS c USING (trial_id)
WHERE o.setting IN (SELECT setting FROM settings WHERE construction)
GROUP BY ALL
ORDER BY o.suite, semantic DESC NULLS LAST, o.configuration, o.case_id, o.repeat
