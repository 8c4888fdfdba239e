-- What does each scheduled trial contribute? One row a planned trial, whether or not it has an outcome.
-- A contribution is null while the trial is pending; an authoritative zero keeps its reason.
SELECT
    s.suite, s.suite_digest, s.policy, s.judge, s.engine, s.run_id, s.trial_id, s.configuration, s.client, s.ranked,
    s.setting, s.case_id, s.title, s.scene_id, s.repeat, s.operations, s.operation_group, s.difficulty,
    coalesce(o.status, 'pending') AS status,
    CASE WHEN o.status IS NULL OR o.status = 'pending' THEN NULL ELSE o.score END AS score,
    coalesce(o.reason, '') AS reason,
    o.* EXCLUDE (
        trial_id, run_id, suite, suite_digest, configuration, case_id, repeat, setting, scene_id, status, score, reason,
        retained_attempt, ranked, policy, judge, engine
    )
FROM schedule AS s
LEFT JOIN outcomes AS o USING (trial_id)
