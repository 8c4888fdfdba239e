-- What does each scheduled trial contribute? One row a planned trial, whether or not it has an outcome.
-- A contribution is null while the trial is pending; an authoritative zero keeps its reason.
SELECT
    t.suite, t.suite_digest, t.latest, t.policy, t.judge, t.judge_version, t.engine, t.run_id, t.trial_id, t.configuration,
    t.configuration_digest, t.client, t.ranked, t.setting, t.case_id, t.title, t.scene_id, t.repeat, t.operations,
    t.operation_group, t.difficulty, t.visibility,
    coalesce(o.status, 'pending') AS status,
    CASE WHEN o.status IS NULL OR o.status = 'pending' THEN NULL ELSE o.score END AS score,
    coalesce(o.reason, '') AS reason,
    o.* EXCLUDE (
        trial_id, run_id, suite, suite_digest, configuration, configuration_digest, case_id, repeat, setting, scene_id,
        status, score, reason, retained_attempt, ranked, policy, judge, judge_version, engine
    )
FROM trials AS t
LEFT JOIN outcomes AS o USING (trial_id)
