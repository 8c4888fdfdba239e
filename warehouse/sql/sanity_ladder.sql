-- Does the evaluator put the baselines where they belong? The oracle saves the truth, noop edits nothing, vandal
-- deletes everything, planner and random build and edit without a model. On the latest build of each suite.
SELECT
    suite, policy, judge, judge_version, engine, configuration,
    count(*) FILTER (WHERE NOT construction) AS repair_cases,
    min(coalesce(repair_f1, 0)) FILTER (WHERE NOT construction AND score IS NOT NULL) AS lowest_f1,
    max(coalesce(repair_f1, 0)) FILTER (WHERE NOT construction AND score IS NOT NULL) AS highest_f1,
    min(score) FILTER (WHERE NOT construction) AS lowest_repair_score,
    max(score) FILTER (WHERE NOT construction) AS highest_repair_score,
    count(*) FILTER (WHERE construction) AS text_cases,
    avg(score) FILTER (WHERE construction) AS mean_text_score,
    count(*) FILTER (WHERE status IN ('measured', 'measured_with_missing_zero')) AS valid,
    count(*) AS trials
FROM case_scores JOIN settings USING (setting)
WHERE latest
GROUP BY suite, policy, judge, judge_version, engine, configuration, configuration_digest
ORDER BY suite, policy, judge, judge_version, engine, mean_text_score DESC NULLS LAST, configuration, configuration_digest
