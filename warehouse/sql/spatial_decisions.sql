-- What did the judge say of each spatial requirement, and is everything there that it speaks of? One row a requirement and
-- trial. Answers are direct, before caps by parents. `kept`: every entity passes a separate affirmative existence check
-- without qualifiers; missing, contradictory and open checks leave it out.
WITH decisions AS (
    SELECT trial_id, unnest(json_extract(document, '$.measurements.decisions[*]')) AS decision
    FROM verdicts WHERE contains(document, '"existence"')
)
SELECT
    t.suite, t.suite_digest, t.policy, t.judge, t.judge_version, t.engine, t.configuration, t.ranked, t.trial_id,
    t.case_id, t.scene_id, t.setting, t.visibility, t.repeat,
    decision->>'$.node_id' AS node_id, decision->>'$.predicate_type' AS predicate_type,
    decision->>'$.status' AS answer, coalesce(CAST(decision->>'$.existence.pass' AS BOOLEAN), false) AS kept
FROM decisions JOIN trials AS t USING (trial_id)
WHERE json_type(decision, '$.existence') = 'OBJECT'
